// TestExpressionTypes COUNT FOLDER...: what is said of random expressions before a compiler sees them,
// against the driver's compiler. FOLDERs hold the chunks of GLSL that an expression needs.
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smShaderSource.h"
#include "smTesting.h"
#include "smUserExpression.h"
#include "vtkComputeContext.h"

#include "vtkNew.h"

#include <filesystem>
#include <iterator>

namespace
{
using namespace smtest;
using Random = std::mt19937_64;

/// Draws an expression of about the type "dI": I components, of doubles (d), whole numbers (i) or truths (b).
/// Now and then of another.
class Writer
{
public:
  explicit Writer(std::uint64_t seed)
    : Source(seed)
  {
  }

  std::string Write(char base, int size, int depth)
  {
    if (this->Below(12) == 0)
    {
      base = Choose({ "d", "d", "i", "b" })[0];
      size = 1 + this->Below(4);
    }
    const std::string type = GetType(base, size);
    if (depth <= 0 || this->Below(6) == 0)
    {
      return this->WriteLeaf(base, size);
    }
    const auto same = [&] { return this->Write(base, size, depth - 1); };
    const auto scalar = [&] { return this->Write(base, 1, depth - 1); };
    switch (this->Below(base == 'b' ? 6 : 12))
    {
      case 0:
        return "(" + same() + ")";
      case 1:
        return size == 1 ? "(" + this->Write('b', 1, depth - 1) + " ? " + same() + " : " + same() + ")"
                         : type + "(" + this->WriteComponents(base, size, depth) + ")";
      case 2:
        return type + "(" + scalar() + ")";
      case 3:
        return size == 1 && base != 'b'
          ? this->Write(base, 3, depth - 1) + this->Choose({ ".x", "[1]", ".z", ".w", "[2]", "[3]" })
          : this->Write(base, 4, depth - 1) + "." + std::string("xyzw").substr(0, size);
      default:
        break;
    }
    if (base == 'b')
    {
      return size == 1 ? this->WriteTruth(depth)
                       : this->Choose({ "lessThan", "greaterThanEqual", "equal", "notEqual" }) + "(" +
          this->Write('d', size, depth - 1) + ", " + this->Write('d', size, depth - 1) + ")";
    }
    if (base == 'i' || this->Below(2) == 0)
    {
      const std::string symbol =
        base == 'i' ? this->Choose({ "+", "-", "*", "/", "%" }) : this->Choose({ "+", "-", "*", "/", "*" });
      return same() + " " + symbol + " " + (this->Below(3) == 0 ? scalar() : same());
    }
    return this->WriteCall(size, depth);
  }

private:
  int Below(int count) { return static_cast<int>(this->Source() % static_cast<unsigned int>(count)); }

  std::string Choose(std::initializer_list<const char*> words)
  {
    return *(words.begin() + this->Below(static_cast<int>(words.size())));
  }

  static std::string GetType(char base, int size)
  {
    const std::string scalar = base == 'd' ? "double" : base == 'i' ? "int" : "bool";
    return size == 1 ? scalar : std::string(1, base) + "vec" + std::to_string(size);
  }

  std::string WriteLeaf(char base, int size)
  {
    if (this->Below(25) == 0)
    {
      return this->Choose({ "foo", "true", "2u", "0x1F", "sine(dA)", "dmat2(1)[0]", "double[2](1, 2)[1]",
        "double[](dA, 1)[0]", "mat", "-", "sin", "normal.length()" });
    }
    if (base == 'd' && size == 1)
    {
      return this->Choose({ "dA", "u", "v", "1", "0.5", "k", "meanCurvature", "2e-3" });
    }
    if (base == 'd' && size == 3)
    {
      return this->Choose({ "position", "normal", "unitNormal", "du", "dvv" });
    }
    const char* leaf = base == 'd' ? "0.25" : base == 'i' ? "int(3)" : "true";
    return size == 1 ? leaf : GetType(base, size) + "(" + leaf + ")";
  }

  std::string WriteComponents(char base, int size, int depth)
  {
    std::string text;
    for (int k = 0; k < size + (this->Below(15) == 0 ? 1 : 0); ++k)
    {
      text += (k == 0 ? "" : ", ") + this->Write(base, 1, depth - 2);
    }
    return text;
  }

  std::string WriteTruth(int depth)
  {
    switch (this->Below(4))
    {
      case 0:
        return "!" + this->Write('b', 1, 0);
      case 1:
        return "(" + this->Write('b', 1, depth - 1) + this->Choose({ " && ", " || ", " ^^ " }) +
          this->Write('b', 1, depth - 1) + ")";
      case 2:
        return this->Choose({ "any(", "all(" }) + this->Write('b', 3, depth - 1) + ")";
      default:
        return "(" + this->Write('d', 1, depth - 1) +
          this->Choose({ " < ", " > ", " <= ", " >= ", " == ", " != " }) + this->Write('d', 1, depth - 1) +
          ")";
    }
  }

  std::string WriteCall(int size, int depth)
  {
    const auto same = [&] { return this->Write('d', size, depth - 1); };
    const auto scalar = [&] { return this->Write('d', 1, depth - 1); };
    switch (this->Below(8))
    {
      case 0:
        return this->Choose({ "sin", "cos", "tan", "exp", "log", "asin", "atan" }) + "(" + same() + ")";
      case 1:
        return this->Choose({ "pow", "mod", "max", "min", "dot", "distance", "step", "reflect" }) + "(" +
          same() + ", " + (this->Below(3) == 0 ? scalar() : same()) + ")";
      case 2:
        return this->Choose({ "clamp", "mix", "smoothstep", "fma", "faceforward" }) + "(" + same() + ", " +
          same() + ", " + (this->Below(3) == 0 ? scalar() : same()) + ")";
      case 3:
        return "cross(" + this->Write('d', 3, depth - 1) + ", " + this->Write('d', 3, depth - 1) + ")";
      case 4:
        return this->Choose({ "length", "isnan", "isinf", "not", "determinant" }) + "(" + same() + ")";
      case 5:
        return this->Choose({ "step", "smoothstep" }) + "(" + scalar() + ", " + same() + ")";
      default:
        return this->Choose({ "sqrt", "abs", "floor", "sign", "fract", "normalize", "inversesqrt", "round",
                 "ceil", "trunc" }) +
          "(" + same() + (this->Below(20) == 0 ? ", 1" : "") + ")";
    }
  }

  Random Source;
};

class Compiler
{
public:
  Compiler(vtkComputeContext* context, int count, char* folders[])
    : Context(context)
  {
    for (int i = 0; i < count; ++i)
    {
      for (const auto& entry : std::filesystem::directory_iterator(folders[i]))
      {
        std::ifstream file(entry.path());
        this->Chunks[entry.path().stem()] = std::string(std::istreambuf_iterator<char>(file), {});
      }
    }
  }

  /// Returns true when the driver takes the expression; `log` has what it says otherwise.
  bool Accepts(const sm::UserExpression& expression, std::string& log)
  {
    sm::ShaderSource source("smExpressionCS", this->Chunks["smExpressionCS"].c_str());
    for (const auto& [name, text] : this->Chunks)
    {
      source.AddChunk(name, text.c_str());
    }
    // What the assembler would refuse, the compiler is to see.
    source.SetUnchecked();
    source.Define("SM_SAMPLE_DETAIL", 0);
    source.Replace("//SM::UserFunctions",
      "//SM::Include smSample\n//SM::Include smUserFunctions\n" + expression.MakeFunction("smUser0", true));
    sm::ComputeProgram program;
    const bool assembled = source.Assemble();
    // The assembler refuses arrays.
    const bool accepted = assembled && program.Build(this->Context, source.GetName(), source.GetSource());
    log = source.GetError() + program.GetLog();
    return accepted;
  }

private:
  vtkComputeContext* Context;
  std::map<std::string, std::string> Chunks;
};

/// A text of the kind that only the compiler judges, and one that it has to accept.
void CheckCompiler(Compiler& compiler)
{
  std::string log;
  CheckTrue("a sound expression compiles", compiler.Accepts(sm::UserExpression("dA * u", {}), log), log);
  const sm::UserExpression matrix("dA * cross(dmat3(1)[0], dmat2(1)[0]).x", {});
  CheckEqual("what is not modelled is left to the compiler", "", matrix.GetError());
  CheckTrue("which refuses it", !compiler.Accepts(matrix, log));
  CheckTrue("and its place is found: " + matrix.Explain(log),
    matrix.Explain(log).find("column ") == 0 && matrix.Explain(log).find("cross") != std::string::npos);
}

void CheckRandom(Compiler& compiler, int count)
{
  int accepted = 0;
  int refused = 0;
  int onlyCompiler = 0;
  for (int seed = 0; seed < count; ++seed)
  {
    const std::string text = Writer(static_cast<std::uint64_t>(seed)).Write('d', 1, 4);
    const sm::UserExpression expression(text, { { "k", 0.5 } });
    std::string error = expression.GetError();
    error = error.find("no area element") != std::string::npos ? "" : error;
    if (error.find("single precision") != std::string::npos)
    {
      continue;
    }
    std::string log;
    const bool compiles = compiler.Accepts(expression, log);
    accepted += error.empty() && compiles;
    refused += !error.empty() && !compiles;
    if (!error.empty() && compiles)
    {
      CheckTrue("what the compiler accepts is not refused: " + text, false, error);
    }
    if (error.empty() && !compiles)
    {
      ++onlyCompiler;
      std::printf("only the compiler refuses %s\n  %s\n", text.c_str(), expression.Explain(log).c_str());
    }
  }
  std::printf(
    "%d accepted and %d refused by both, %d by the compiler alone\n", accepted, refused, onlyCompiler);
  CheckTrue("there are sound expressions among them", accepted > count / 5, std::to_string(accepted));
  CheckTrue("and wrong ones", refused > count / 5, std::to_string(refused));
  CheckTrue("few are left to the compiler", onlyCompiler * 50 <= count, std::to_string(onlyCompiler));
}
}

int TestExpressionTypes(int argc, char* argv[])
{
  RequireUsage(argc >= 3, "TestExpressionTypes COUNT FOLDER...");
  vtkNew<vtkComputeContext> context;
  CheckEqual("context", static_cast<int>(vtkComputeContext::READY), context->Start());
  Compiler compiler(context, argc - 2, argv + 2);
  CheckCompiler(compiler);
  CheckRandom(compiler, std::atoi(argv[1]));
  return Finish();
}
