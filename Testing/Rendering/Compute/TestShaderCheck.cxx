// The check of assembled shaders refuses every form in which NVIDIA's compiler keeps doubles as floats or
// does not link, with name and line, and nothing else.
#include "Detail/smShaderCheck.h"
#include "smShaderSource.h"
#include "smTesting.h"

namespace
{
using namespace smtest;

struct Form
{
  const char* What;
  const char* Text;
  /// The name and the line of the complaint; null: the text is right.
  const char* Name;
  int Line;
};

const Form Forms[] = {
  { "a local array", "void main()\n{\n  double v[26];\n}\n", "v", 3 },
  { "a local array of dvec2", "void main() { dvec2 v[4]; }", "v", 1 },
  { "a local array of dvec3", "void main() { dvec3 v[4]; }", "v", 1 },
  { "a local array of dvec4", "void main() { dvec4 v[4]; }", "v", 1 },
  { "a size before the name", "void main()\n{\n  double[4] w;\n}", "w", 3 },
  { "the second variable", "void main()\n{\n  double a = max(1.0LF, 2.0LF),\n    b[3];\n}", "b", 4 },
  { "a global array", "int n;\ndouble total[26];\n", "total", 2 },
  { "a constant", "const double K[2] = double[2](0.7LF, 0.7LF);\n", "K", 1 },
  { "an array without a name", "double f(int i)\n{\n  return double[2](0.5LF, 0.7LF)[i];\n}", "double", 3 },
  { "an output parameter", "void F(double p, int n, out double v[26]) { }", "v", 1 },
  { "a parameter", "double F(int n,\n  const dvec4 v[26]) { return v[n].x; }", "v", 2 },
  { "a copy", "void main()\n{\n  double u[26] = v;\n}", "u", 3 },
  { "a member of a structure", "struct S\n{\n  double q[4];\n};", "q", 3 },
  { "an array of structures", "struct S\n{\n  double q;\n};\nvoid main()\n{\n  S s[26];\n}", "s", 7 },
  { "structures in structures", "struct S { dvec2 q; };\nstruct T { int i; S s; };\nvoid main() { T t[2]; }",
    "t", 3 },
  { "columns of a matrix", "void main()\n{\n  dmat4 m = dmat4(0.0LF);\n}", "dmat4", 3 },
  { "a component by a variable",
    "void main()\n{\n  dvec3 v;\n  for (int i = 0; i < 3; ++i)\n  {\n    v[i] = 1.0LF;\n  }\n}", "v", 6 },
  { "added to a component", "void F(inout dvec3 v, int i)\n{\n  v[i + 1] += 1.0LF;\n}", "v", 3 },
  { "a component of a member",
    "struct S\n{\n  dvec3 p;\n};\nvoid F(inout S s, int i)\n{\n  s.p[i] = 0.0LF;\n}", "p", 7 },
  { "a macro for the type", "#define REAL double\nvoid main()\n{\n  REAL v[26];\n}", "v", 4 },
  { "the text of a macro", "int n;\n#define ROW(name) \\\n  dvec4 name[4]\n", "name", 3 },
  { "after a comment of lines", "/* one\n two */ double v[2]; // three", "v", 2 },

  { "arrays of floats and uints", "float f[4];\nvoid main() { uvec4 u[26]; int n[2] = int[2](1, 2); }",
    nullptr, 0 },
  { "buffers",
    "layout(std430, binding = 0) readonly buffer B\n{\n  dvec4 points[];\n} b;\ndouble f(uint i) { return "
    "b.points[i].x; }",
    nullptr, 0 },
  { "uniform arrays", "uniform double U[2];\nuniform Block { dvec2 p[4]; };", nullptr, 0 },
  { "shared arrays", "shared double s[32 * 26];\nshared dvec4 t[8];", nullptr, 0 },
  { "one structure", "struct S { dvec4 q; };\nbuffer B { S all[]; };\nvoid main() { S s = all[1]; }", nullptr,
    0 },
  { "a component read", "double F(dvec3 v, int i) { return v[i] == 1.0LF ? v[i] : -v[i]; }", nullptr, 0 },
  { "a component by a number", "void main() { dvec3 v; v[0] = 1.0LF; }", nullptr, 0 },
  { "another variable of that name",
    "void F(dvec3 row) { }\nvoid G(int i) { uvec2 row[2]; row[i] = uvec2(0u); }", nullptr, 0 },
  { "functions and constructors", "double f(double x, dvec3 y) { return double(x) + dvec2(x, 1.0LF).y; }",
    nullptr, 0 },
  { "a comment", "// double v[26];\n/* dmat4 m; */ int n;", nullptr, 0 },
};
}

int TestShaderCheck(int, char*[])
{
  for (const Form& form : Forms)
  {
    const std::string complaint = sm::FindUnsafeConstruct(form.Text);
    const std::string expected =
      form.Name ? "line " + std::to_string(form.Line) + ": " + form.Name + " " : std::string();
    CheckTrue(form.What, form.Name ? complaint.rfind(expected, 0) == 0 : complaint.empty(),
      "expected \"" + expected + "\", found \"" + complaint + "\"");
  }

  // The assembler refuses such a text, with the line of the assembled source.
  sm::ShaderSource source("smTestArrayCS", "//SM::Include chunk\nvoid main()\n{\n}\n");
  source.AddChunk("chunk", "dvec4 rows[26];\n");
  CheckTrue("the assembler refuses it", !source.Assemble() && source.GetSource().empty());
  CheckTrue(
    "it says where", source.GetError().rfind("smTestArrayCS: line 3: rows ", 0) == 0, source.GetError());
  source.SetUnchecked();
  CheckTrue("the probe's texts are not checked", source.Assemble(), source.GetError());
  return Finish();
}
