#include "smPart21Parser.h"

#include <algorithm>

namespace sm
{
namespace
{
char ToCapital(char c)
{
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Hash of the length and the first and last eight characters, in capitals.
std::size_t GetHash(std::string_view name)
{
  char ends[16] = {};
  const std::size_t size = std::min<std::size_t>(name.size(), 8);
  if (size > 0)
  {
    std::memcpy(ends, name.data(), size);
    std::memcpy(ends + 8, name.data() + name.size() - size, size);
  }
  std::uint64_t words[2];
  std::memcpy(words, ends, sizeof(words));
  // Letters differ from their capitals in one bit.
  constexpr std::uint64_t capitals = 0xdfdfdfdfdfdfdfdfu;
  const std::uint64_t mixed = ((words[0] & capitals) * 0x9e3779b97f4a7c15u) ^
    ((words[1] & capitals) * 0xc2b2ae3d27d4eb4fu) ^ (name.size() * 0x165667b19e3779f9u);
  return static_cast<std::size_t>(mixed ^ (mixed >> 29) ^ (mixed >> 47));
}

bool IsSame(std::string_view name, const std::string& capitals)
{
  return name == capitals ||
    (name.size() == capitals.size() &&
      std::equal(
        name.begin(), name.end(), capitals.begin(), [](char a, char b) { return ToCapital(a) == b; }));
}

bool BeginsWith(const Part21Cursor& cursor, std::string_view word)
{
  return static_cast<std::size_t>(cursor.End - cursor.At) >= word.size() &&
    std::string_view(cursor.At, word.size()) == word;
}
}

Part21Parser::Part21Parser(Part21File& file, std::size_t chunk)
  : File(file)
  , Start(file.Text.data())
  , Cursor{ file.Text.data(), file.Text.data() + file.Text.size() }
  , ChunkSize(chunk)
{
}

Part21Parser::Part21Parser(Part21File& result, const char* start, Part21Cursor cursor)
  : File(result)
  , Start(start)
  , Cursor(cursor)
{
}

bool Part21Parser::SkipBlanks()
{
  if (this->Cursor.SkipBlanks())
  {
    return true;
  }
  this->File.Add(Part21Defect::UnterminatedText, this->GetOffset(this->Cursor.At));
  this->Cursor.At = this->Cursor.End;
  return false;
}

void Part21Parser::Parse(std::size_t start)
{
  this->Cursor.At += start;
  this->File.Instances.clear();
  bool data = false;
  while (!this->Ended && this->SkipBlanks() && !this->Cursor.IsAtEnd())
  {
    data = this->ParseSection() || data;
  }
  this->File.Instances.push_back({ 0, 0, 0, static_cast<std::uint32_t>(this->File.Records.size()),
    static_cast<std::uint32_t>(this->References.size()) });
  if (!data)
  {
    this->File.Add(Part21Defect::NoData, this->File.Text.size());
  }
  if (!this->Ended)
  {
    this->File.Add(Part21Defect::Truncated, this->File.Text.size());
  }
  this->FindInstanceBehindEnd();
}

void Part21Parser::FindInstanceBehindEnd()
{
  const std::size_t end = this->GetOffset(this->Cursor.At);
  const std::string_view text = this->File.Text;
  for (std::size_t at = text.find('#', end); at != std::string_view::npos; at = text.find('#', at + 1))
  {
    if (IsInstanceStart(text.data() + at, text.data() + text.size()))
    {
      this->File.Add(Part21Defect::BehindEnd, at);
      return;
    }
  }
}

bool Part21Parser::ParseSection()
{
  if (BeginsWith(this->Cursor, "ISO-10303-21"))
  {
    this->Recover();
    return false;
  }
  if (BeginsWith(this->Cursor, "END-ISO-10303-21"))
  {
    this->Ended = true;
    return false;
  }
  const char* at = this->Cursor.At;
  std::string word(this->Cursor.SkipKeyword());
  std::transform(word.begin(), word.end(), word.begin(), ToCapital);
  if (word == "DATA")
  {
    // A section may have a name and its schema: DATA('NAME',('SCHEMA'));
    this->SkipBlanks();
    if (this->Cursor.Peek() == '(' && !this->Cursor.SkipBrackets())
    {
      this->Recover();
    }
    this->SkipBlanks();
    this->Cursor.At += this->Cursor.Peek() == ';' ? 1 : 0;
    this->ParseInstances();
    return true;
  }
  if (word == "HEADER")
  {
    this->ParseHeader();
  }
  else if (word == "ANCHOR" || word == "REFERENCE" || word == "SIGNATURE")
  {
    this->SkipSection();
  }
  else
  {
    this->File.Add(Part21Defect::NotAnInstance, this->GetOffset(at));
    this->Recover();
    this->ReportSkipped(at, false);
  }
  return false;
}

void Part21Parser::SkipSection()
{
  const std::string_view rest(this->Cursor.At, static_cast<std::size_t>(this->Cursor.End - this->Cursor.At));
  const std::size_t end = rest.find("ENDSEC");
  this->Cursor.At = end == std::string_view::npos ? this->Cursor.End : this->Cursor.At + end;
  this->ReportSkipped(rest.data(), true);
  this->Recover();
}

namespace
{
/// Returns true if an instance begins here that is not the name of one in another file, #1=<...>.
bool IsOwnInstanceStart(const char* at, const char* end)
{
  if (!IsInstanceStart(at, end))
  {
    return false;
  }
  at = std::find(at, end, '=') + 1;
  while (at != end && (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\n'))
  {
    ++at;
  }
  return at == end || *at != '<';
}
}

void Part21Parser::ReportSkipped(const char* begin, bool startsOnly)
{
  const char* const end = this->Cursor.At;
  for (const char* at = begin; at != end; ++at)
  {
    const bool isNumber = *at == '#' && at + 1 != end && at[1] >= '0' && at[1] <= '9';
    if (startsOnly ? IsOwnInstanceStart(at, end) : isNumber || *at == '=')
    {
      this->File.Add(Part21Defect::UnreadInstance, this->GetOffset(begin));
      return;
    }
  }
}

void Part21Parser::ParseHeader()
{
  this->Cursor.At += this->Cursor.Peek() == ';' ? 1 : 0;
  while (this->SkipBlanks() && !this->Cursor.IsAtEnd())
  {
    // If the end of the header is missing, the data are found nevertheless.
    if (BeginsWith(this->Cursor, "DATA") || BeginsWith(this->Cursor, "END-ISO"))
    {
      return;
    }
    const char* at = this->Cursor.At;
    const std::string_view word = this->Cursor.SkipKeyword();
    if (word == "ENDSEC")
    {
      this->Recover();
      return;
    }
    const bool opened = !word.empty() && this->SkipBlanks() && this->Cursor.Peek() == '(';
    const char* begin = this->Cursor.At;
    if (!opened || !this->Cursor.SkipBrackets())
    {
      this->File.Add(Part21Defect::Syntax, this->GetOffset(at));
      this->Recover();
      this->ReportSkipped(at, false);
      continue;
    }
    if (word == "FILE_SCHEMA")
    {
      const std::string_view all(begin + 1, static_cast<std::size_t>(this->Cursor.At - begin) - 2);
      Part21Values names(GetPart21Value(all, 0).Text);
      for (Part21Value name; names.Next(name);)
      {
        this->File.Schemas.emplace_back(name.Text);
      }
    }
    this->Recover();
  }
}

void Part21Parser::ParseInstances()
{
  this->IsLost = false;
  if (this->ParseChunks())
  {
    this->ParseInstancesTo(this->Cursor.End);
  }
}

bool Part21Parser::ParseInstancesTo(const char* stop)
{
  while (this->SkipBlanks() && !this->Cursor.IsAtEnd())
  {
    if (this->Cursor.At >= stop)
    {
      return true;
    }
    if (this->Cursor.Peek() == '#')
    {
      this->IsLost = false;
      this->ParseInstance();
      continue;
    }
    if (BeginsWith(this->Cursor, "ENDSEC"))
    {
      this->Recover();
      return false;
    }
    if (BeginsWith(this->Cursor, "END-ISO"))
    {
      return false;
    }
    // Consecutive text that belongs to no instance is one problem.
    const char* at = this->Cursor.At;
    if (!this->IsLost)
    {
      this->File.Add(Part21Defect::NotAnInstance, this->GetOffset(at));
    }
    this->IsLost = true;
    this->Recover();
    this->ReportSkipped(at, false);
  }
  return false;
}

void Part21Parser::ParseInstance()
{
  const char* begin = this->Cursor.At;
  std::uint64_t id = 0;
  bool fits = true;
  const bool numbered = this->Cursor.SkipReference(id, fits);
  if (!numbered || !fits || !this->SkipBlanks() || this->Cursor.Peek() != '=')
  {
    this->File.Add(
      numbered && !fits ? Part21Defect::NumberTooLarge : Part21Defect::NotAnInstance, this->GetOffset(begin));
    // The cursor must advance even if the text here looks like an instance.
    this->Cursor.At = std::max(this->Cursor.At, begin + 1);
    this->Recover();
    this->ReportSkipped(begin, false);
    return;
  }
  ++this->Cursor.At;
  this->File.Instances.push_back(
    { id, this->GetOffset(begin), 0, static_cast<std::uint32_t>(this->File.Records.size()),
      static_cast<std::uint32_t>(this->References.size()) });
  this->File.Damaged.push_back(0);
  const bool valid =
    this->SkipBlanks() && this->ParseRecords() && this->SkipBlanks() && this->Cursor.Peek() == ';';
  this->FinishInstance(valid);
}

void Part21Parser::FinishInstance(bool valid)
{
  Part21File::Instance& instance = this->File.Instances.back();
  if (valid)
  {
    instance.End = this->GetOffset(++this->Cursor.At);
    return;
  }
  this->File.Damaged.back() = Part21File::Malformed;
  this->File.Add(Part21Defect::Syntax, this->GetOffset(this->Cursor.At), instance.Id);
  // If only the semicolon is missing, the cursor is at the next instance already.
  if (!IsInstanceStart(this->Cursor.At, this->Cursor.End))
  {
    const char* at = this->Cursor.At;
    this->Recover();
    this->ReportSkipped(at, true);
  }
  instance.End = this->GetOffset(this->Cursor.At);
  // Every instance has at least one record. If no record was read, it gets one with an empty type name.
  if (this->File.Records.size() == instance.FirstRecord)
  {
    this->File.Records.push_back({ this->FindType({}), instance.End, instance.End });
  }
}

bool Part21Parser::ParseRecords()
{
  if (this->Cursor.Peek() != '(')
  {
    return this->ParseRecord();
  }
  ++this->Cursor.At;
  std::size_t records = 0;
  while (this->SkipBlanks() && this->Cursor.Peek() != ')')
  {
    ++records;
    if (!this->ParseRecord())
    {
      return false;
    }
  }
  if (this->Cursor.IsAtEnd() || records == 0)
  {
    return false;
  }
  ++this->Cursor.At;
  return true;
}

bool Part21Parser::ParseRecord()
{
  const std::string_view name = this->Cursor.SkipKeyword();
  if (name.empty() || IsPart21(name[0], Part21Digit) || !this->SkipBlanks() || this->Cursor.Peek() != '(')
  {
    return false;
  }
  const std::size_t record = this->File.Records.size();
  const std::uint32_t begin = this->GetOffset(this->Cursor.At) + 1;
  this->File.Records.push_back({ this->FindType(name), begin, begin });
  const bool valid = this->ParseParameters();
  this->File.Records[record].End = std::max(begin, this->GetOffset(this->Cursor.At) - (valid ? 1 : 0));
  return valid;
}

bool Part21Parser::ParseParameters()
{
  ++this->Cursor.At;
  std::size_t depth = 1;
  // A list may be empty, but a comma must be followed by a value.
  bool opened = true;
  bool expected = true;
  while (this->SkipBlanks() && !this->Cursor.IsAtEnd())
  {
    const char c = this->Cursor.Peek();
    if (c == ')' && (opened || !expected))
    {
      ++this->Cursor.At;
      opened = false;
      expected = false;
      if (--depth == 0)
      {
        return true;
      }
    }
    else if (c == ',' && !expected)
    {
      ++this->Cursor.At;
      opened = false;
      expected = true;
    }
    else if (expected)
    {
      opened = false;
      if (!this->ParseValue(depth, opened))
      {
        return false;
      }
      expected = opened;
    }
    else
    {
      return false;
    }
  }
  return false;
}

/// Parses one value. `nested` is set to true if it is an opening bracket, whose values follow.
bool Part21Parser::ParseValue(std::size_t& depth, bool& nested)
{
  Part21Cursor& cursor = this->Cursor;
  const char c = cursor.Peek();
  bool real = false;
  switch (c)
  {
    case '(':
      ++cursor.At;
      ++depth;
      nested = true;
      return true;
    case '#':
      return this->ParseReference();
    case '\'':
      return cursor.SkipString();
    case '$':
    case '*':
      ++cursor.At;
      return true;
    case '"':
      return cursor.SkipBinary();
    case '<':
      return cursor.SkipResource();
    case '.':
      return cursor.End - cursor.At > 1 && IsPart21(cursor.At[1], Part21Digit) ? cursor.SkipNumber(real)
                                                                               : cursor.SkipEnumeration();
    default:
      return IsPart21(c, Part21Letter) || c == '!' ? this->ParseTyped(depth, nested)
                                                   : cursor.SkipNumber(real);
  }
}

bool Part21Parser::ParseTyped(std::size_t& depth, bool& nested)
{
  this->Cursor.SkipKeyword();
  if (!this->SkipBlanks() || this->Cursor.Peek() != '(')
  {
    return false;
  }
  ++this->Cursor.At;
  ++depth;
  nested = true;
  return true;
}

bool Part21Parser::ParseReference()
{
  std::uint64_t id = 0;
  bool fits = true;
  const char* at = this->Cursor.At;
  if (!this->Cursor.SkipReference(id, fits))
  {
    return false;
  }
  if (!fits)
  {
    this->File.Add(Part21Defect::NumberTooLarge, this->GetOffset(at), this->File.Instances.back().Id);
    return false;
  }
  this->References.push_back(id);
  return true;
}

void Part21Parser::Recover()
{
  const char* end = this->Cursor.End;
  const char* at = this->Cursor.At;
  while (at != end && *at != ';')
  {
    if (*at++ != '\n')
    {
      continue;
    }
    const char* line = at;
    while (line != end && (*line == ' ' || *line == '\t'))
    {
      ++line;
    }
    Part21Cursor cursor{ line, end };
    if (IsInstanceStart(line, end) || BeginsWith(cursor, "ENDSEC") || BeginsWith(cursor, "END-ISO"))
    {
      this->Cursor.At = line;
      return;
    }
  }
  this->Cursor.At = at == end ? end : at + 1;
}

std::uint32_t Part21Parser::FindType(std::string_view name)
{
  std::vector<std::string>& names = this->File.TypeNames;
  const std::size_t mask = this->TypeTable.size() - 1;
  for (std::size_t slot = GetHash(name) & mask;; slot = (slot + 1) & mask)
  {
    const std::uint32_t found = this->TypeTable[slot];
    if (found == 0)
    {
      this->TypeTable[slot] = static_cast<std::uint32_t>(names.size()) + 1;
      names.emplace_back(name);
      std::transform(names.back().begin(), names.back().end(), names.back().begin(), ToCapital);
      if (2 * names.size() > this->TypeTable.size())
      {
        this->GrowTypes();
      }
      return static_cast<std::uint32_t>(names.size()) - 1;
    }
    if (IsSame(name, names[found - 1]))
    {
      return found - 1;
    }
  }
}

void Part21Parser::GrowTypes()
{
  const std::vector<std::string>& names = this->File.TypeNames;
  this->TypeTable.assign(2 * this->TypeTable.size(), 0);
  const std::size_t mask = this->TypeTable.size() - 1;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::size_t slot = GetHash(names[i]) & mask;
    while (this->TypeTable[slot] != 0)
    {
      slot = (slot + 1) & mask;
    }
    this->TypeTable[slot] = static_cast<std::uint32_t>(i) + 1;
  }
}
}
