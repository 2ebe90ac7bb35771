// The assembler of shader sources: what it makes and what it refuses. Needs no GL.
#include "smTesting.h"

#include "smShaderSource.h"

using namespace smtest;

namespace
{
const char* const Shader = "layout(local_size_x = 1) in;\n"
                           "//SM::Define\n"
                           "//SM::Include outer\n"
                           "  //SM::Include inner\n"
                           "//SM::Body\n"
                           "end\n";

sm::ShaderSource Make(const char* text = Shader)
{
  sm::ShaderSource source("smAny", text);
  source.AddChunk("inner", "inner line\n");
  source.AddChunk("outer", "//SM::Include inner\nouter line");
  return source;
}

void CheckRefused(const std::string& what, sm::ShaderSource& source, const std::string& clue)
{
  const bool refused = !source.Assemble();
  CheckTrue(what + " is refused", refused);
  CheckTrue(what + ": source is empty", source.GetSource().empty());
  CheckTrue(what + ": message", source.GetError().find(clue) != std::string::npos, source.GetError());
}

void TestAssembly()
{
  sm::ShaderSource source = Make();
  source.Define("NAME", "value");
  source.Define("COUNT", 3);
  source.Define("SIZE", 4u);
  source.Replace("//SM::Body", "first\n//SM::Include inner\nsecond\n");
  CheckTrue("assembles", source.Assemble(), source.GetError());
  CheckEqual("source",
    "#version 430 core\n"
    "layout(local_size_x = 1) in;\n"
    "#define NAME value\n"
    "#define COUNT 3\n"
    "#define SIZE 4u\n"
    "// chunk outer\n"
    "// chunk inner\n"
    "inner line\n"
    "outer line\n"
    "first\n"
    "second\n"
    "end\n",
    source.GetSource());

  sm::ShaderSource own("smOwn", "//SM::Include smInvocation\n//SM::Include smErrorFree\n");
  CheckTrue("the module's own chunks are known", own.Assemble(), own.GetError());
  CheckTrue("smInvocationIndex", own.GetSource().find("uint smInvocationIndex()") != std::string::npos);
  CheckTrue("smTwoSum", own.GetSource().find("dvec2 smTwoSum(") != std::string::npos);
}

void TestRefusals()
{
  sm::ShaderSource left = Make();
  CheckRefused("a tag that is left", left, "smAny:5: the tag was not replaced: //SM::Body");

  sm::ShaderSource inChunk = Make();
  inChunk.AddChunk("inner", "fine\n//SM::Other\n");
  inChunk.Replace("//SM::Body", "");
  CheckRefused("a tag left in a chunk", inChunk, "inner:2: the tag was not replaced: //SM::Other");

  sm::ShaderSource inReplacement = Make();
  inReplacement.Replace("//SM::Body", "//SM::Other");
  CheckRefused(
    "a tag left in a replacement", inReplacement, "//SM::Body:1: the tag was not replaced: //SM::Other");

  sm::ShaderSource unknown = Make("//SM::Include nowhere\n");
  CheckRefused("an unknown chunk", unknown, "smAny:1: unknown chunk nowhere");

  sm::ShaderSource noPlace = Make("void main() {}\n");
  noPlace.Define("NAME", "1");
  CheckRefused("a definition without place", noPlace, "//SM::Define");

  sm::ShaderSource noTag = Make("void main() {}\n");
  noTag.Replace("//SM::Boddy", "");
  CheckRefused("a replacement without place", noTag, "//SM::Boddy");

  sm::ShaderSource itself = Make();
  itself.Replace("//SM::Body", "//SM::Body\n");
  CheckRefused("a tag in itself", itself, "contains itself");

  sm::ShaderSource version = Make("#version 450\nvoid main() {}\n");
  CheckRefused("a second #version", version, "smAny:1: #version");

  sm::ShaderSource midLine = Make("int a; //SM::Body\n");
  midLine.Replace("//SM::Body", "");
  CheckRefused("a tag behind code", midLine, "smAny:1: a tag must be alone");
}
}

int TestComputeShaderSource(int, char*[])
{
  TestAssembly();
  TestRefusals();
  CheckEqual("numbered lines", "    1 | a\n    2 | \n    3 | b\n", sm::ShaderSource::NumberLines("a\n\nb\n"));
  return Finish();
}
