// Translation of the user's expressions, and compilers' messages told in the user's columns.
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
  CheckTrue("functions are no constants",
    UserExpression("abs (dA) * abs", { { "abs", 0.5 } })
        .MakeFunction("f", false)
        .find("abs\n(\ndA\n)\n*\n(5.") != std::string::npos);
  CheckEqual("components are no constants", "position . k", Translate("position.k"));
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
  CheckEqual("arguments", "", UserExpression("pow(max(dA, (1)), double[2](1, 2)[1])", {}).GetError());
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
  CheckEqual("warnings are no errors", told,
    expression.Explain(
      "0(100001) : warning C7050: it may be\n0(100005) : error C1503: undefined variable \"foo\"\n"));
  CheckEqual("our names of functions", "column 6: no function sin(dvec3)",
    expression.Explain("0:100003(1): error: no function smUserSin(dvec3)\n"));
  CheckEqual("beyond the end", "column 14: unexpected ')'",
    expression.Explain("0:100007(1): error: unexpected ')'\n"));
  CheckEqual("of the whole", "column 1: could not convert",
    expression.Explain("0:12(1): error: could not convert, in function `f'\n"));
  CheckEqual("a line without end", "column 10: no f(dd",
    expression.Explain("0:100005(1): error: no f(" + std::string(200000, 'd') + "\n").substr(0, 18));
  CheckEqual("what is not understood", "internal trouble", expression.Explain("internal trouble"));
}
}

int TestUserExpression(int, char*[])
{
  CheckTranslation();
  CheckPlaces();
  return smtest::Finish();
}
