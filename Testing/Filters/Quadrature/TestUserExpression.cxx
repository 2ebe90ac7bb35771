// Translation of the user's expressions, and compilers' messages reported in the user's columns.
#include "smTesting.h"
#include "smUserExpression.h"

namespace
{
using sm::UserExpression;
using smtest::CheckEqual;
using smtest::CheckTrue;

/// The tokens as the shader gets them, one blank apart.
std::string Translate(const std::string& text)
{
  const std::string function = UserExpression(text, { { "k", 0.5 } }).MakeFunction("f", false);
  const std::string start = "return (\n";
  std::string tokens = function.substr(function.find(start) + start.size());
  tokens.erase(tokens.rfind("\n);"));
  for (char& c : tokens)
  {
    c = c == '\n' ? ' ' : c;
  }
  return tokens;
}

void CheckTranslation()
{
  CheckEqual(
    "numbers are doubles", "1.0LF / smDivisor( 3.0LF) + .5LF - 2.LF * 1e-3LF", Translate("1/3+.5-2.*1e-3"));
  CheckEqual("suffixes stay", "1u + 0x1F + 2.5LF", Translate("1u + 0x1F + 2.5LF"));
  CheckEqual("an index is whole", "normal [ 1 ]", Translate("normal[1]"));
  CheckEqual(
    "a number in a call in an index is none", "normal [ int ( 1.0LF ) ]", Translate("normal[int(1)]"));
  CheckEqual("functions are ours", "smUserSin ( smUserPow ( dA , 2.0LF ) ) + abs ( dA )",
    Translate("sin(pow(dA,2))+abs(dA)"));
  CheckEqual("divisors in a row", "dA / smDivisor( u) / smDivisor( v) * 2.0LF", Translate("dA/u/v*2"));
  CheckEqual(
    "divisors in divisors", "dA / smDivisor( ( u / smDivisor( v) )) + 1.0LF", Translate("dA/(u/v)+1"));
  CheckEqual("signs, calls, indices and components", "u / smDivisor( - ! cross ( du , dv ) [ 1 ] . x) - v",
    Translate("u/-!cross(du,dv)[1].x-v"));
  CheckEqual("remainders", "int ( u ) % smDivisor( 2u)", Translate("int(u)%2u"));
  CheckEqual("constants", "(5.00000000000000000e-01LF) * dA", Translate("k * dA"));
  CheckTrue("functions are not constants",
    UserExpression("abs (dA) * abs", { { "abs", 0.5 } })
        .MakeFunction("f", false)
        .find("abs\n(\ndA\n)\n*\n(5.") != std::string::npos);
  CheckEqual("components are not constants", "position . k", Translate("position.k"));
  CheckEqual("pairs stay together", "dA <= 1.0LF && ! ( dA != 2.0LF ) ? 1.0LF : - 1.0LF",
    Translate("dA<=1&&!(dA!=2)?1:-1"));

  CheckEqual("detail of nothing", 0, UserExpression("dA", {}).GetDetail());
  CheckEqual("detail of u", 1, UserExpression("u * dA", {}).GetDetail());
  CheckEqual("detail of dv", 2, UserExpression("dv.x", {}).GetDetail());
  CheckEqual("detail of a curvature", 3, UserExpression("u * meanCurvature", {}).GetDetail());
  CheckEqual("detail of a component", 0, UserExpression("position.u", {}).GetDetail());
  CheckTrue("kinks of ?:", UserExpression("dA > 1 ? 1 : 2", {}).MayHaveKinks());
  for (const char* text : { "double(lessThan(position, normal).x)", "double(ivec3(position).x)",
         "faceforward(normal, position, normal).z" })
  {
    CheckTrue(std::string("kinks or steps of ") + text, UserExpression(text, {}).MayHaveKinks());
  }
  CheckTrue("no kinks of a polynomial", !UserExpression("position.x * dA", {}).MayHaveKinks());
}

void CheckPlaces()
{
  CheckEqual("what may not stand there", "column 4", UserExpression("dA ; 1", {}).GetError().substr(0, 8));
  CheckEqual(
    "brackets that cross", "column 5: the bracket was not opened", UserExpression("([dA)]", {}).GetError());
  CheckEqual("lines", "line 2, column 3: 'gl_x' is reserved", UserExpression("dA *\n  gl_x", {}).GetError());
  CheckEqual("nothing", "the expression is empty", UserExpression(" \n", {}).GetError());

  CheckEqual("a decimal comma", "column 2: ','", UserExpression("1,5 * dA", {}).GetError().substr(0, 13));
  CheckEqual("a single-precision number", "column 6: '0.1f'",
    UserExpression("dA * 0.1f", {}).GetError().substr(0, 16));
  CheckEqual("a number of wide suffix", "", UserExpression("dA * 0.1lf * 0xfu", {}).GetError());
  CheckEqual("a single-precision function", "column 8: 'float'",
    UserExpression("double(float(dA))", {}).GetError().substr(0, 17));
  CheckEqual("a sequence", "column 11: ','", UserExpression("(barrier(), dA)", {}).GetError().substr(0, 14));
  CheckEqual("arguments", "", UserExpression("pow(max(dA, (1)), 2)", {}).GetError());
  CheckEqual("characters of several bytes", "column 3: '\xcf\x80' cannot",
    UserExpression("1*\xcf\x80", {}).GetError().substr(0, 21));
  CheckTrue("a number without end", !UserExpression(std::string(200000, '1'), {}).GetError().empty());
  CheckTrue("a name without end", !UserExpression(std::string(200000, 'x'), {}).GetError().empty());

  const UserExpression expression("dA * sin(foo)", {});
  CheckTrue("lines are numbered for messages",
    expression.MakeFunction("f", true).find("#line 100001\ndA\n*\nsmUserSin\n(\nfoo\n") != std::string::npos);
  const std::string told = "column 10: undefined variable \"foo\"";
  CheckEqual("Mesa", told, expression.Explain("0:100005(1): error: undefined variable \"foo\"\n"));
  CheckEqual("NVIDIA", told, expression.Explain("0(100005) : error C1503: undefined variable \"foo\"\n"));
  CheckEqual("others", told, expression.Explain("ERROR: 0:100005: undefined variable \"foo\"\n"));
  CheckEqual("glslang, ANGLE", "column 10: 'foo' : undeclared identifier",
    expression.Explain(
      "ERROR: 0:100005: 'foo' : undeclared identifier \nERROR: 0:12: '' : compilation terminated \n"
      "ERROR: 2 compilation errors.  No code generated.\n\n"));
  CheckEqual("AMD", "column 10: Undeclared identifier: foo",
    expression.Explain("ERROR: 0:100005: error(#143) Undeclared identifier: foo\r\nERROR: error(#273) 1 "
                       "compilation errors.  No code "
                       "generated\r\n"));
  CheckEqual("NVIDIA, several lines",
    "column 6: unable to find compatible overloaded function \"sin(dvec3)\"; column 10: undefined variable "
    "\"foo\"",
    expression.Explain(
      "0(100003) : error C1115: unable to find compatible overloaded function \"smUserSin(dvec3)\"\n"
      "0(100005) : error C1503: undefined variable \"foo\"\n0(12) : error C0000: syntax error\n"));
  CheckEqual("Mesa, with candidates",
    "column 6: no matching function for call to `cross(dvec3, dvec2)'; candidates are:",
    expression.Explain(
      "0:100003(1): error: no matching function for call to `cross(dvec3, dvec2)'; candidates are:\n"
      "0:100003(1): error:    vec3 cross(vec3, vec3)\n"));
  CheckEqual("warnings are not errors", told,
    expression.Explain(
      "0(100001) : warning C7050: it may be\n0:100001(1): warning: it may be\nWARNING: 0:100001: it may be\n"
      "0(100005) : error C1503: undefined variable \"foo\"\n"));
  CheckEqual("a word of a message is not a severity", "column 10: undefined variable \"warning\"",
    expression.Explain("0(100005) : error C1503: undefined variable \"warning\"\n"));
  CheckEqual("our names of functions", "column 6: no function sin(dvec3)",
    expression.Explain("0:100003(1): error: no function smUserSin(dvec3)\n"));
  CheckEqual("beyond the end", "column 14: unexpected ')'",
    expression.Explain("0:100007(1): error: unexpected ')'\n"));
  CheckEqual("of the whole", "column 1: could not convert",
    expression.Explain("0:12(1): error: could not convert, in function `f'\n"));
  CheckEqual("a line without end", "column 10: no f(dd",
    expression.Explain("0:100005(1): error: no f(" + std::string(200000, 'd') + "\n").substr(0, 18));
  const std::string number = "0:99999999999999999999(1): error: no line\n";
  CheckEqual("a number of a line without end", number, expression.Explain(number));
  CheckEqual("what is not understood", "internal trouble", expression.Explain("internal trouble"));
}

/// Mistakes that are found without a compiler.
void CheckMistakes()
{
  const std::pair<const char*, const char*> mistakes[] = {
    { "dA * sine", "column 6: 'sine' is not defined" },
    { "dA * sine(1)", "column 6: 'sine' is not a function" },
    { "dA * cos", "column 6: 'cos' is a function and needs arguments in parentheses" },
    { "dA * u(1)", "column 6: 'u' is not a function" },
    { "dA * cos(normal)", "column 6: 'cos' has no version for (dvec3)" },
    { "dA * asin(u)", "column 6: 'asin' has single precision only, which no bound here includes" },
    { "dA * pow(u)", "column 6: 'pow' takes 2 arguments, not 1" },
    { "dA * sqrt(u, v)", "column 6: 'sqrt' takes 1 argument, not 2" },
    { "dA * cos()", "column 6: 'cos' takes 1 argument, not 0" },
    { "max(1, normal).x", "column 1: 'max' has no version for (double, dvec3)" },
    { "cross(normal, dvec2(1)).x", "column 1: 'cross' has no version for (dvec3, dvec2)" },
    { "dot(normal, dvec4(1))", "column 1: 'dot' has no version for (dvec3, dvec4)" },
    { "dA + normal", "column 1: the expression is a dvec3; an integrand is a number" },
    { "dA > 1", "column 1: the expression is a bool; an integrand is a number" },
    { "normal + dvec2(1)", "column 8: '+' has no version for a dvec3 and a dvec2" },
    { "dA % 2", "column 4: '%' has no version for a double and a double" },
    { "dA * (u && v ? 1 : 2)", "column 9: '&&' has no version for a double and a double" },
    { "dA * (u ? 1 : 2)", "column 9: the condition of '?' is a double instead of a bool" },
    { "u > v ? normal : dA", "column 7: '?' chooses between a dvec3 and a double" },
    { "-(u > v) * dA", "column 1: '-' has no version for a bool" },
    { "dA * !u", "column 6: '!' has no version for a double" },
    { "normal < position ? dA : 1", "column 8: '<' has no version for a dvec3 and a dvec3" },
    { "normal.q * dA", "column 8: a dvec3 has no component 'q'" },
    { "normal.xg", "column 8: a dvec3 has no component 'xg'" },
    { "normal.w", "column 8: a dvec3 has no component 'w'" },
    { "normal[3]", "column 8: a dvec3 has no component 3" },
    { "normal[u]", "column 8: an index is a whole number, not a double" },
    { "dA * double[2](1, 2)[1]",
      "column 6: 'double[ ]' makes an array, which some drivers keep in single precision" },
    { "dA * dmat3(1)[int(u)].x",
      "column 15: the index of a matrix is a number here: some drivers keep its columns in single precision "
      "otherwise" },
    { "dA[0]", "column 3: a double has no components to choose by '[ ]'" },
    { "dvec3(1, 2) .x * dA", "column 1: 'dvec3' needs 3 components, not 2" },
    { "dvec2(1, 2, 3).x * dA", "column 1: 'dvec2' has more arguments than components" },
    { "dA *", "column 5: unexpected end: an operand is missing" },
    { "dA * * 2", "column 6: '*' is unexpected here" },
    { "dA 2", "column 4: '2' is unexpected here" },
    { "(dA", "column 1: the bracket is not closed" },
    { "dA * (u > v ? 1)", "column 16: ')' is unexpected here" },
    { "max(dA,)", "column 8: ')' is unexpected here" },
    { "dA *\n  (1 +\n  none)", "line 3, column 3: 'none' is not defined" },
  };
  for (const auto& [text, message] : mistakes)
  {
    CheckEqual(std::string("mistake in ") + text, message, UserExpression(text, {}).GetError());
  }
  for (const char* text :
    { "dA * (u > v ? 1 : 2)", "-+-dA * double(!(u > v))", "normal.zyx.xy[1]", "normal.x.x", "normal[int(u)]",
      "dot(normal, cross(du, dv).bgr)", "dA * dmat3(1)[0].x", "dA * double(3u % 2u)",
      "dA * double(int(u) / 2)", "dA * k", "true ? dA : 1", "dA * mix(u, v, u > v)", "clamp(normal, 0, 1).x",
      "step(0, normal).x", "dA * double(normal.length())", "dA * dvec4(normal, 1).w", "dA * dvec2(normal).x",
      "dA * double(all(lessThan(du, dv)))", "dA * double(ivec2(u, v).y)",
      "dA * (isnan(u) ^^ u == v ? 1 : 0.5)", "dA * abs(int(u)) * max(2u, 1u)" })
  {
    CheckEqual(std::string("no mistake in ") + text, "", UserExpression(text, { { "k", 1.0 } }).GetError());
  }
  const auto nest = [](int depth)
  { return UserExpression(std::string(depth, '(') + "dA" + std::string(depth, ')'), {}).GetError(); };
  CheckEqual("brackets in brackets", "", nest(150));
  CheckEqual("too many", "column 201: the expression is nested too deeply", nest(100000));
}
}

int TestUserExpression(int, char*[])
{
  CheckTranslation();
  CheckPlaces();
  CheckMistakes();
  return smtest::Finish();
}
