/**
 * @file TestPart21File.cxx
 * @brief The text of STEP files: every kind of token, every kind of damage, and that time does not grow with
 * nesting
 */
#include "smPart21File.h"
#include "smTextEncoding.h"

#include "smTesting.h"

#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace
{
using smtest::CheckEqual;
using smtest::CheckTrue;
using Index = sm::Part21File::Index;
using Kind = sm::Part21Kind;
using Defect = sm::Part21Defect;

std::string Wrap(const std::string& data)
{
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 }','SECOND'));\nENDSEC;\nDATA;\n" +
    data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

sm::Part21File Parse(const std::string& data)
{
  sm::Part21File file;
  file.Parse(Wrap(data));
  return file;
}

/// Kinds of problems with their numbers, "" for none.
std::string GetProblems(const sm::Part21File& file)
{
  std::string text;
  for (std::size_t k = 0; k < static_cast<std::size_t>(Defect::Count); ++k)
  {
    const std::size_t count = file.GetNumberOfProblems(static_cast<Defect>(k));
    if (count > 0)
    {
      text += (text.empty() ? "" : ", ") + std::string(sm::Part21File::GetName(static_cast<Defect>(k))) +
        " " + std::to_string(count);
    }
  }
  return text;
}

std::vector<sm::Part21Value> GetValues(std::string_view text)
{
  std::vector<sm::Part21Value> result;
  sm::Part21Values values(text);
  for (sm::Part21Value value; values.Next(value);)
  {
    result.push_back(value);
  }
  return result;
}

void CheckValues()
{
  const sm::Part21File file =
    Parse("#1=A($,*,12,-3,+4,1.5E-07,-2.,.5,'it''s "
          "\\X2\\00E4\\X0\\','',\"0FF\",.MILLI.,#2,(1,(2,3),()),LENGTH_MEASURE(25.4),"
          "/*c,(*/ 7 /* '*/ , <http://x#y>,!OWN(1));\n#2=B();\n");
  CheckEqual("values: problems", "", GetProblems(file));
  const std::vector<sm::Part21Value> values = GetValues(file.GetParameters(0));
  const struct
  {
    Kind What;
    const char* Text;
  } expected[] = { { Kind::Omitted, "$" }, { Kind::Derived, "*" }, { Kind::Integer, "12" },
    { Kind::Integer, "-3" }, { Kind::Integer, "+4" }, { Kind::Real, "1.5E-07" }, { Kind::Real, "-2." },
    { Kind::Real, ".5" }, { Kind::String, "it''s \\X2\\00E4\\X0\\" }, { Kind::String, "" },
    { Kind::Binary, "0FF" }, { Kind::Enumeration, "MILLI" }, { Kind::Reference, "#2" },
    { Kind::List, "1,(2,3),()" }, { Kind::Typed, "25.4" }, { Kind::Integer, "7" },
    { Kind::Resource, "http://x#y" }, { Kind::Typed, "1" } };
  CheckEqual(
    "values: number", static_cast<long long>(std::size(expected)), static_cast<long long>(values.size()));
  for (std::size_t i = 0; i < std::size(expected) && i < values.size(); ++i)
  {
    CheckEqual("values: text " + std::to_string(i), expected[i].Text, std::string(values[i].Text));
    CheckEqual("values: kind " + std::to_string(i), static_cast<int>(expected[i].What),
      static_cast<int>(values[i].Kind));
  }
  double number = 0.0;
  std::int64_t integer = 0;
  CheckTrue("values: real", values[5].GetNumber(number) && number == 1.5e-7);
  CheckTrue("values: sign of a real", values[4].GetNumber(number) && number == 4.0);
  CheckTrue("values: integer", values[3].GetInteger(integer) && integer == -3);
  CheckTrue("values: a real is not an integer", !values[6].GetInteger(integer));
  CheckTrue("values: a string is not a number", !values[8].GetNumber(number));
  CheckEqual("values: name of a type", "LENGTH_MEASURE", std::string(values[14].TypeName));
  CheckEqual("values: own type", "!OWN", std::string(values[17].TypeName));
  CheckEqual(
    "values: by index", "(2,3)", "(" + std::string(sm::GetPart21Value(values[13].Text, 1).Text) + ")");
  CheckTrue("values: beyond the last", sm::GetPart21Value("1,2", 2).Kind == Kind::Malformed);
  sm::Part21Value huge;
  sm::Part21Values numbers("1.E400,99999999999999999999");
  CheckTrue("values: 1.E400 is not a number", numbers.Next(huge) && !huge.GetNumber(number));
  CheckTrue("values: 20 digits are not integer", numbers.Next(huge) && !huge.GetInteger(integer));
  for (const char* text : { "1 2", ",", "1,", "nan", ".T", "'a", "(1", "#", "--1", "1.E", "\"1", "<a" })
  {
    sm::Part21Values broken(text);
    sm::Part21Value value;
    while (broken.Next(value))
    {
    }
    CheckTrue(std::string("values: malformed ") + text, broken.IsMalformed());
  }
}

void CheckGraph()
{
  const sm::Part21File file =
    Parse("/* first */ #10 = POINT('',(1.,2.)) ;\r\n"
          "#18446744073709551615=(A(#10,(#20))B()/**/C(#10,$));#20=lower_Case(#10 , #10);\n"
          "#0=\n\tPOINT\n(\n#20\n)\n;\n");
  CheckEqual("graph: problems", "", GetProblems(file));
  CheckEqual("graph: instances", 4, file.GetNumberOfInstances());
  const Index complex = file.Find(18446744073709551615ull);
  CheckEqual("graph: largest number", 1, complex);
  CheckEqual("graph: records", 3, static_cast<long long>(file.GetNumberOfRecords(complex)));
  CheckEqual("graph: third record", "C", file.GetTypeNames()[file.GetType(complex, 2)]);
  CheckEqual("graph: its parameters", "#10,$", std::string(file.GetParameters(complex, 2)));
  CheckEqual("graph: second has none", "", std::string(file.GetParameters(complex, 1)));
  CheckTrue("graph: complex", file.IsComplex(complex) && !file.IsComplex(0));
  const auto references = file.GetReferences(complex);
  CheckEqual("graph: references", 3, static_cast<long long>(references.size()));
  CheckTrue("graph: in order", references[0] == 0 && references[1] == 2 && references[2] == 0);
  CheckEqual("graph: capitals", "LOWER_CASE", file.GetTypeNames()[file.GetType(2)]);
  CheckTrue("graph: one type", file.GetType(0) == file.GetType(3));
  CheckTrue("graph: number 0", file.Find(0) == 3 && file.Find(11) == sm::Part21File::None);
  CheckEqual("graph: text", "#10 = POINT('',(1.,2.)) ;", std::string(file.GetText(0)));
  CheckEqual("graph: line", 8, static_cast<long long>(file.GetLine(file.GetOffset(0))));
  CheckEqual("graph: schemas", 2, static_cast<long long>(file.GetSchemas().size()));
  CheckEqual("graph: schema", "AUTOMOTIVE_DESIGN { 1 0 10303 }", file.GetSchemas()[0]);
}

void CheckSections()
{
  sm::Part21File file;
  file.Parse("\n /* before */ ISO-10303-21;HEADER;FILE_SCHEMA(('X'));ENDSEC;\nANCHOR;<a>=#1;ENDSEC;\n"
             "REFERENCE;\n#5=<other.stp#x>;\nENDSEC;\nDATA('one',('X'));#1=A();ENDSEC;\n"
             "DATA;\n#2=A(#1);\nENDSEC;\nSIGNATURE;\nabc\nENDSEC;\nEND-ISO-10303-21;\ntrailing #3=A();");
  CheckEqual("sections: problems", "instance behind the end 1", GetProblems(file));
  CheckEqual("sections: instances", 2, file.GetNumberOfInstances());
  CheckTrue("sections: across", file.GetReferences(1)[0] == 0);

  // Brackets that the header opens and the data closes.
  CheckTrue("open header: read",
    file.Parse("ISO-10303-21;HEADER;FILE_NAME('',((A('b')\n;ENDSEC;DATA;\n#1=A(2)));\n#2=A();\nENDSEC;\nEND-"
               "ISO-10303-21;"));
  CheckEqual("open header: problems", "syntax error 2", GetProblems(file));
  CheckEqual("open header: instances", 2, file.GetNumberOfInstances());

  CheckTrue("junk: read", file.Parse("x" + Wrap("#1=A();\n")));
  CheckEqual("junk: problems", "junk before the header 1", GetProblems(file));
  CheckTrue("junk: too much", !file.Parse(std::string(1 << 16, 'x') + Wrap("")));
  CheckEqual("junk: no header", "no header 1", GetProblems(file));
  CheckTrue("empty: not read", !file.Parse(""));
  CheckEqual("empty: problems", "empty 1", GetProblems(file));
  CheckEqual("empty: instances", 0, file.GetNumberOfInstances());
  CheckTrue("missing: not read", !file.Read("no/such/file.step"));
  CheckEqual("missing: problems", "cannot be opened 1", GetProblems(file));
  CheckTrue("folder: not read", !file.Read("."));
  CheckTrue("header only: read", file.Parse("ISO-10303-21;HEADER;ENDSEC;END-ISO-10303-21;"));
  CheckEqual("header only: problems", "no data section 1", GetProblems(file));
}

struct Damaged
{
  const char* Name;
  std::string Data;
  const char* Problems;
  /// Instances that are found, and those that are damaged, as numbers.
  const char* Found;
  const char* Broken;
};

void CheckDamage()
{
  const std::string last = "#9=Z();\n";
  const Damaged cases[] = {
    { "undefined reference", "#1=A(#2,#9,#3);\n" + last, "undefined reference 2", "1 9", "1" },
    { "number used twice", "#1=A();\n#1=B(#9);\n" + last, "number used twice 1", "1 1 9", "1 1" },
    { "missing semicolon", "#1=A()\n#2=B();\n" + last, "syntax error 1", "1 2 9", "1" },
    { "missing bracket", "#1=A((1,2);\n" + last, "syntax error 1", "1 9", "1" },
    { "bracket too many", "#1=A(1));\n" + last, "syntax error 1", "1 9", "1" },
    { "missing value", "#1=A(1,,2);\n" + last, "syntax error 1", "1 9", "1" },
    { "comma at the end", "#1=A(1,);\n" + last, "syntax error 1", "1 9", "1" },
    { "missing comma", "#1=A(1 2);\n" + last, "syntax error 1", "1 9", "1" },
    { "no number", "#1=A(nan);\n" + last, "syntax error 1", "1 9", "1" },
    { "two points", "#1=A(1.2.3);\n" + last, "syntax error 1", "1 9", "1" },
    { "no record", "#1=;\n" + last, "syntax error 1", "1 9", "1" },
    { "no name", "#1=(1,2);\n" + last, "syntax error 1", "1 9", "1" },
    { "empty complex", "#1=();\n" + last, "syntax error 1", "1 9", "1" },
    { "string without end", "#1=A('text);\n#2=B('x');\n" + last, "syntax error 1", "1 2 9", "1" },
    { "string over lines", "#1=A('te\nxt ; #7 = (');\n" + last, "", "1 9", "" },
    { "enumeration without end", "#1=A(.T,2);\n" + last, "syntax error 1", "1 9", "1" },
    { "no equals sign", "#1 A();\n" + last, "text outside of instances 1, skipped instance 1", "9", "" },
    { "no number sign", "1=A();\n" + last, "text outside of instances 1, skipped instance 1", "9", "" },
    { "an instance in an anchor", "ENDSEC;\nANCHOR;\n#1=A();\nENDSEC;\nDATA;\n" + last, "skipped instance 1",
      "9", "" },
    { "words", "hello;\nworld;\n" + last, "text outside of instances 1", "9", "" },
    { "too large a number", "#18446744073709551616=A();\n" + last, "number too large 1, skipped instance 1",
      "9", "" },
    { "too large a reference", "#1=A(#99999999999999999999);\n" + last, "syntax error 1, number too large 1",
      "1 9", "1" },
    { "null byte between", std::string("#1=A(1,\0 2);\n", 13) + last, "control characters 1", "1 9", "" },
    { "null byte in a name", std::string("#1=A\0A(1);\n", 11) + last, "syntax error 1, control characters 1",
      "1 9", "1" },
    { "bytes above 127", "#1=A(\xff\xfe);\n" + last, "syntax error 1", "1 9", "1" },
    { "two on a line after damage", "#1=A(((;#2=B();#3=C(;#4=D();\n" + last, "syntax error 2", "1 2 3 4 9",
      "1 3" },
    { "damage in a complex one", "#1=(A(1)B(,)C(2));\n" + last, "syntax error 1", "1 9", "1" },
    { "comment without end", "#1=A();\n#2=B(/* ;\n" + last, "no end", "1 2", "2" },
    { "truncated in a list", "#1=A();\n#2=B((1,", "no end", "1 2", "2" },
  };
  for (const Damaged& damaged : cases)
  {
    sm::Part21File file;
    const bool ends = std::string(damaged.Problems) != "no end";
    file.Parse(ends ? Wrap(damaged.Data) : Wrap("").substr(0, Wrap("").find("ENDSEC;\nEND")) + damaged.Data);
    std::string found;
    std::string broken;
    for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
    {
      const std::string id = std::to_string(file.GetId(i));
      found += (i > 0 ? " " : "") + id;
      broken += file.IsDamaged(i) ? (broken.empty() ? "" : " ") + id : "";
    }
    const std::string name = std::string("damage: ") + damaged.Name;
    if (ends)
    {
      CheckEqual(name, damaged.Problems, GetProblems(file));
    }
    else
    {
      CheckTrue(name,
        file.GetNumberOfProblems(Defect::Truncated) == 1 && file.GetNumberOfProblems(Defect::Syntax) == 1);
    }
    CheckEqual(name + ", found", damaged.Found, found);
    CheckEqual(name + ", damaged", damaged.Broken, broken);
  }
}

void CheckProblemPlaces()
{
  std::string data;
  for (int i = 1; i <= 1000; ++i)
  {
    data += "#" + std::to_string(i) + "=A(#5000);\n";
  }
  const sm::Part21File file = Parse(data);
  CheckEqual(
    "places: counted", 1000, static_cast<long long>(file.GetNumberOfProblems(Defect::UndefinedReference)));
  CheckEqual("places: listed", static_cast<long long>(sm::Part21File::ProblemLimit),
    static_cast<long long>(file.GetProblems().size()));
  const sm::Part21Problem& second = file.GetProblems()[1];
  CheckEqual("places: number", 2, static_cast<long long>(second.Id));
  CheckEqual("places: other", 5000, static_cast<long long>(second.Other));
  CheckEqual("places: line", 9, static_cast<long long>(file.GetLine(second.Offset)));
}

/// Every prefix of a file, and the file with each byte replaced: no crash, and instances never overlap or
/// leave the text.
void CheckEveryByte()
{
  const std::string whole = Wrap("#1=(A(#2)B((1.E-3,'x''y'),$));\n#2=C(.T.,*,\"1\",LENGTH_MEASURE(1.),/* c "
                                 "*/#1);\n#3=D(((1),(2)),'\n');\n");
  std::size_t files = 0;
  std::size_t wrong = 0;
  const auto check = [&files, &wrong](const std::string& text)
  {
    sm::Part21File file;
    file.Parse(text);
    ++files;
    std::size_t end = 0;
    for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
    {
      const std::string_view part = file.GetText(i);
      wrong += file.GetOffset(i) < end || part.empty() || part[0] != '#' ? 1 : 0;
      end = file.GetOffset(i) + part.size();
      for (std::size_t k = 0; k < file.GetNumberOfRecords(i); ++k)
      {
        wrong += !file.IsDamaged(i) && file.GetTypeNames()[file.GetType(i, k)].empty() ? 1 : 0;
        sm::Part21Values values(file.GetParameters(i, k));
        sm::Part21Value value;
        while (values.Next(value))
        {
        }
        // The parser accepts what the values can be read from, and the reverse.
        wrong += values.IsMalformed() && !file.IsDamaged(i) ? 1 : 0;
      }
    }
    wrong += end > file.GetText().size() ? 1 : 0;
  };
  for (std::size_t k = 0; k <= whole.size(); ++k)
  {
    check(whole.substr(0, k));
    for (const char c : std::string("\0#'\"(),;=*$/.\n0A \xff", 18))
    {
      std::string changed = whole;
      if (k < whole.size())
      {
        changed[k] = c;
        check(changed);
      }
      changed = whole;
      changed.insert(k, 1, c);
      check(changed);
    }
  }
  CheckTrue("every byte: files", files > 9000, std::to_string(files));
  CheckEqual("every byte: contradictions", 0, static_cast<long long>(wrong));
}

/// A million brackets, strings and half-begun instances. A parser that recurses crashes; one that goes back
/// runs for hours, and the test's time limit ends it.
void CheckDepth()
{
  const int n = 1000000;
  std::string open(n, '(');
  const std::string close(n, ')');
  CheckEqual("depth: balanced", "", GetProblems(Parse("#1=A(" + open + close + ");\n")));
  CheckEqual("depth: open", "syntax error 1", GetProblems(Parse("#1=A(" + open + ";\n")));
  std::string types;
  std::string quotes = "#1=A(";
  std::string starts;
  std::string comments = "#1=A(";
  for (int i = 0; i < n; ++i)
  {
    types += "T(";
    quotes += "'\n";
    starts += "#1=A('\n";
    comments += "/*";
  }
  CheckEqual("depth: types", "", GetProblems(Parse("#1=A(" + types + close + ");\n")));
  CheckTrue("depth: quotes", !GetProblems(Parse(quotes)).empty());
  const sm::Part21File lines = Parse(starts);
  CheckEqual("depth: lines", n, lines.GetNumberOfInstances());
  CheckEqual("depth: all damaged", n, static_cast<long long>(lines.GetNumberOfProblems(Defect::Syntax)));
  CheckTrue("depth: comments", !GetProblems(Parse(comments)).empty());
}

/// Numbers that are far apart cost no table of their size.
void CheckSparse()
{
  std::string data;
  for (std::uint64_t i = 0; i < 1000; ++i)
  {
    data += "#" + std::to_string(i * 10000000000000ull + 7) + "=A(#" +
      std::to_string((999 - i) * 10000000000000ull + 7) + ");\n";
  }
  const sm::Part21File file = Parse(data);
  CheckEqual("sparse: problems", "", GetProblems(file));
  std::size_t wrong = 0;
  for (Index i = 0; i < 1000; ++i)
  {
    wrong += file.GetReferences(i)[0] == 999 - i && file.Find(file.GetId(i)) == i ? 0 : 1;
  }
  CheckEqual("sparse: wrong", 0, static_cast<long long>(wrong));
}

/// Everything that is read of a file, as text.
std::string Dump(const sm::Part21File& file)
{
  std::string text = GetProblems(file) + "\n";
  for (const sm::Part21Problem& problem : file.GetProblems())
  {
    text += std::to_string(static_cast<int>(problem.Defect)) + " " + std::to_string(problem.Offset) + " " +
      std::to_string(problem.Id) + " " + std::to_string(problem.Other) + "\n";
  }
  for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    text += std::string(file.GetText(i)) + (file.IsDamaged(i) ? " damaged" : "") +
      (file.IsMalformed(i) ? " malformed" : "");
    for (std::size_t k = 0; k < file.GetNumberOfRecords(i); ++k)
    {
      text += " " + file.GetTypeNames()[file.GetType(i, k)] + std::string(file.GetParameters(i, k));
    }
    for (const Index reference : file.GetReferences(i))
    {
      text += " " + std::to_string(reference);
    }
    text += "\n";
  }
  for (const std::string& type : file.GetTypeNames())
  {
    text += type + "\n";
  }
  return text;
}

/// The result does not depend on the chunks, wherever these begin: in strings and comments that contain lines
/// like instances, in instances longer than a chunk, and next to damage.
void CheckChunks()
{
  std::mt19937 random(20261128);
  const char* const lines[] = { "#%=A(#@,'x',$);\n", "#%=TYPE%(1.5,(#@,#@));\n",
    "#%=(A(#@)B('a\n b''c',*)C());\n", "/* a comment\n#%=B(#@);\n*/\n",
    "#%=D('two\n lines; #1 = of text');\n", "#%=E(/* ;\n#7=F(); */#@);\n", "  #%  =  G ( .T. , \"0F\" ) ;\n",
    "#%=H(#@);#9%=I();\n" };
  const char* const damage[] = { "#%=A('open;\n", "#%=B(#@\n", "lost text\n", "#%=C(1,,2);\n",
    "#99999999999999999999999=A();\n", "ENDSEC;\nDATA;\n", "'", "/*", "#%=J(" };
  std::size_t different = 0;
  std::size_t files = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    std::string data;
    for (int k = 1; k <= 120; ++k)
    {
      const bool isDamage = trial % 3 == 2 && random() % 40 == 0;
      std::string line = isDamage ? damage[random() % 9] : lines[random() % 8];
      for (std::size_t at = 0; at < line.size(); ++at)
      {
        const bool isOwn = line[at] == '%';
        if (isOwn || line[at] == '@')
        {
          line.replace(at, 1, std::to_string(isOwn ? k : 1 + static_cast<int>(random() % 121)));
        }
      }
      data += line;
      if (random() % 50 == 0)
      {
        data += "#" + std::to_string(1000 + k) + "=LONG('" + std::string(random() % 3000, 'x') + "');\n";
      }
    }
    sm::Part21File whole;
    whole.Parse(Wrap(data), 0);
    const std::string expected = Dump(whole);
    for (const std::size_t chunk : { 256, 300, 1000, 2500 })
    {
      sm::Part21File file;
      file.Parse(Wrap(data), chunk);
      different += Dump(file) != expected ? 1 : 0;
      ++files;
    }
  }
  CheckEqual("chunks: files that differ of " + std::to_string(files), 0, static_cast<long long>(different));
}

void CheckEncodings()
{
  const std::string umlaut = "Geh\xc3\xa4use";
  CheckEqual("ASCII", "a;b\n", sm::ToUTF8("a;b\n"));
  CheckEqual("nothing", "", sm::ToUTF8(""));
  CheckEqual("UTF-8 of two, three and four bytes", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x94\xa9",
    sm::ToUTF8("\xc3\xa4\xe2\x82\xac\xf0\x9f\x94\xa9"));
  CheckEqual("ISO 8859-1", umlaut, sm::ToUTF8("Geh\xe4use"));
  CheckEqual("both", umlaut + "\xc3\x98" + umlaut, sm::ToUTF8(umlaut + "\xd8" + "Geh\xe4use"));
  CheckEqual("at the end", "a\xc3\xbf", sm::ToUTF8("a\xff"));
  CheckEqual("an unfinished letter", "\xc3\xa2\xc2\x82", sm::ToUTF8("\xe2\x82"));
  // Not UTF-8: a longer form than needed, a half of a pair, beyond the last letter.
  CheckEqual("overlong", "\xc3\x80\xc2\xaf", sm::ToUTF8("\xc0\xaf"));
  CheckEqual("overlong, three bytes", "\xc3\xa0\xc2\x80\xc2\xaf", sm::ToUTF8("\xe0\x80\xaf"));
  CheckEqual("surrogate", "\xc3\xad\xc2\xa0\xc2\x80", sm::ToUTF8("\xed\xa0\x80"));
  CheckEqual("beyond", "\xc3\xb4\xc2\x90\xc2\x80\xc2\x80", sm::ToUTF8("\xf4\x90\x80\x80"));
  // Escapes of strings.
  CheckEqual("apostrophe and backslash", "it's \\", sm::DecodePart21Text("it''s \\\\"));
  CheckEqual("8 bits", umlaut, sm::DecodePart21Text("Geh\\X\\E4use"));
  CheckEqual("line breaks", umlaut, sm::DecodePart21Text("Ge\r\nh\\X2\\00\nE4\\X0\\u\\N\\s\\F\\e\n"));
  CheckEqual("a line of its own", "a\nb", sm::DecodePart21Text("a\\X2\\000A\\X0\\b"));
  CheckEqual("page", umlaut, sm::DecodePart21Text("Geh\\S\\duse"));
  CheckEqual("16 bits", "\xc5\xa1\xe2\x82\xac!", sm::DecodePart21Text("\\X2\\016120AC\\X0\\!"));
  CheckEqual("a pair", "\xf0\x9f\x94\xa9", sm::DecodePart21Text("\\X2\\D83DDD29\\X0\\"));
  CheckEqual("32 bits", "\xf0\x9f\x94\xa9", sm::DecodePart21Text("\\X4\\0001F529\\X0\\"));
  CheckEqual("half a pair", "\xef\xbf\xbd", sm::DecodePart21Text("\\X2\\D83D\\X0\\"));
  CheckEqual("an unfinished escape", "\\X2\\01", sm::DecodePart21Text("\\X2\\01"));
  const sm::Part21File file = Parse("#1=A('Geh\xe4use');\n#2=B('" + umlaut + "');\n");
  CheckEqual("in a file: ISO 8859-1", "'" + umlaut + "'", std::string(file.GetParameters(0)));
  CheckEqual("in a file: UTF-8", "'" + umlaut + "'", std::string(file.GetParameters(1)));
  CheckEqual("in a file: problems", "", GetProblems(file));
}

void CheckFromDisk(const std::string& folder)
{
  const std::string path = folder + "/part21_file.step";
  std::ofstream(path, std::ios::binary) << Wrap("#1=A();\n#2=B(#1);\n");
  sm::Part21File file;
  CheckTrue("disk: read", file.Read(path));
  CheckEqual("disk: instances", 2, file.GetNumberOfInstances());
  CheckTrue("disk: again after a failure",
    !file.Read(path + ".none") && file.GetNumberOfInstances() == 0 && file.Read(path));
  CheckEqual("disk: problems", "", GetProblems(file));
  // A copy does not point into the text of the first.
  const sm::Part21File copy = file;
  file.Parse("");
  CheckEqual("disk: copy", "#2=B(#1);", std::string(copy.GetText(1)));
  std::remove(path.c_str());
}
}

int TestPart21File(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: TestPart21File OUTDIR\n");
    return 1;
  }
  CheckValues();
  CheckGraph();
  CheckSections();
  CheckDamage();
  CheckProblemPlaces();
  CheckEveryByte();
  CheckDepth();
  CheckSparse();
  CheckChunks();
  CheckEncodings();
  CheckFromDisk(argv[1]);
  return smtest::Finish();
}
