#include "Detail/smExpressionTypes.h"

#include "Detail/smExpressionFunctions.h"

#include <algorithm>
#include <map>

namespace sm
{
namespace
{
using Type = ExpressionType;
using Function = ExpressionFunction;
using Signature = Function::Signature;
constexpr Type Whole{ Type::Int, 1 };
constexpr Type Truth{ Type::Bool, 1 };
constexpr Type Real{ Type::Double, 1 };
// Compilers have limits of their own, of at least 256.
constexpr int MaxNesting = 200;

/// The type that a constructor makes; Unknown for other names.
Type FindConstructor(const std::string& name)
{
  static const std::map<std::string, Type> scalars = { { "double", Real }, { "int", Whole },
    { "uint", { Type::Uint, 1 } }, { "bool", Truth } };
  static const std::map<char, Type::BaseType> vectors = { { 'd', Type::Double }, { 'i', Type::Int },
    { 'u', Type::Uint }, { 'b', Type::Bool } };
  if (const auto scalar = scalars.find(name); scalar != scalars.end())
  {
    return scalar->second;
  }
  const bool isVector =
    name.size() == 5 && name.compare(1, 3, "vec") == 0 && name[4] >= '2' && name[4] <= '4';
  const auto vector = isVector ? vectors.find(name[0]) : vectors.end();
  return vector == vectors.end() ? Type{} : Type{ vector->second, name[4] - '0' };
}

bool IsMatrix(const std::string& name)
{
  return name.compare(0, 4, "dmat") == 0 && (name.size() == 5 || name.size() == 7);
}

/// Returns true when GLSL converts `from` to `to` by itself.
bool Converts(Type from, Type to)
{
  return from.Size == to.Size && (from.Base == to.Base || (from.IsNumeric() && from.Base < to.Base));
}

int GetPrecedence(const std::string& symbol)
{
  static const std::map<std::string, int> precedences = { { "||", 1 }, { "^^", 2 }, { "&&", 3 }, { "==", 4 },
    { "!=", 4 }, { "<", 5 }, { ">", 5 }, { "<=", 5 }, { ">=", 5 }, { "+", 6 }, { "-", 6 }, { "*", 7 },
    { "/", 7 }, { "%", 7 } };
  const auto found = precedences.find(symbol);
  return found == precedences.end() ? 0 : found->second;
}

/// Parses by recursive descent; the first mistake ends it.
class Checker
{
public:
  explicit Checker(const std::vector<ExpressionToken>& tokens)
    : Tokens(tokens)
  {
  }

  ExpressionMistake Check()
  {
    const Type type = this->ReadChoice();
    if (this->IsGood() && this->At < this->Tokens.size())
    {
      this->Unexpected();
    }
    if (this->IsGood() && type.IsKnown() && !Converts(type, Real))
    {
      this->Fail(0, "the expression is a " + type.GetName() + "; an integrand is a number");
    }
    return this->Mistake;
  }

private:
  bool IsGood() const { return this->Mistake.What.empty(); }

  Type Fail(std::size_t token, const std::string& what)
  {
    if (this->IsGood())
    {
      this->Mistake = { what, token };
    }
    return {};
  }

  /// The present token's text if it is a symbol.
  std::string PeekSymbol() const
  {
    const bool isSymbol =
      this->At < this->Tokens.size() && this->Tokens[this->At].Kind == ExpressionToken::Symbol;
    return isSymbol ? this->Tokens[this->At].Text : "";
  }

  Type Unexpected()
  {
    return this->Fail(this->At,
      this->At < this->Tokens.size() ? "'" + this->Tokens[this->At].Text + "' is unexpected here"
                                     : "unexpected end: an operand is missing");
  }

  bool Take(const char* symbol)
  {
    if (this->IsGood() && this->PeekSymbol() == symbol)
    {
      ++this->At;
      return true;
    }
    this->Unexpected();
    return false;
  }

  /// a ? b : c
  Type ReadChoice()
  {
    if (++this->Depth > MaxNesting)
    {
      return this->Fail(this->At, "the expression is nested too deeply");
    }
    Type type = this->ReadOperators(1);
    const std::size_t place = this->At;
    if (this->IsGood() && this->PeekSymbol() == "?")
    {
      ++this->At;
      if (type.IsKnown() && !(type.Base == Type::Bool && type.IsScalar()))
      {
        this->Fail(place, "the condition of '?' is a " + type.GetName() + " instead of a bool");
      }
      const Type first = this->ReadChoice();
      this->Take(":");
      const Type second = this->IsGood() ? this->ReadChoice() : Type{};
      type = Converts(first, second) ? second : first;
      if (!first.IsKnown() || !second.IsKnown())
      {
        type = {};
      }
      else if (!Converts(first, second) && !Converts(second, first))
      {
        this->Fail(place, "'?' chooses between a " + first.GetName() + " and a " + second.GetName());
      }
    }
    --this->Depth;
    return type;
  }

  Type ReadOperators(int lowest)
  {
    Type left = this->ReadUnary();
    while (this->IsGood())
    {
      const std::string symbol = this->PeekSymbol();
      const int precedence = GetPrecedence(symbol);
      if (precedence < lowest || precedence == 0)
      {
        break;
      }
      const std::size_t place = this->At++;
      const Type right = this->ReadOperators(precedence + 1);
      left = this->Combine(symbol, left, right, place);
    }
    return left;
  }

  Type Combine(const std::string& symbol, Type left, Type right, std::size_t place)
  {
    const bool isLogical = symbol == "&&" || symbol == "||" || symbol == "^^";
    const bool isEquality = symbol == "==" || symbol == "!=";
    const bool isOrder = symbol[0] == '<' || symbol[0] == '>';
    if (!left.IsKnown() || !right.IsKnown())
    {
      return isLogical || isEquality || isOrder ? Truth : Type{};
    }
    const auto refuse = [&]
    {
      return this->Fail(
        place, "'" + symbol + "' has no version for a " + left.GetName() + " and a " + right.GetName());
    };
    if (isLogical)
    {
      return left.Base == Type::Bool && right.Base == Type::Bool && left.IsScalar() && right.IsScalar()
        ? Truth
        : refuse();
    }
    if (isEquality)
    {
      return Converts(left, right) || Converts(right, left) ? Truth : refuse();
    }
    if (isOrder)
    {
      return left.IsNumeric() && right.IsNumeric() && left.IsScalar() && right.IsScalar() ? Truth : refuse();
    }
    const bool isInteger = left.Base != Type::Double && right.Base != Type::Double;
    const bool fits = left.Size == right.Size || left.IsScalar() || right.IsScalar();
    if (!left.IsNumeric() || !right.IsNumeric() || !fits || (symbol == "%" && !isInteger))
    {
      return refuse();
    }
    return { std::max(left.Base, right.Base), std::max(left.Size, right.Size) };
  }

  Type ReadUnary()
  {
    const std::size_t first = this->At;
    while (this->PeekSymbol() == "-" || this->PeekSymbol() == "+" || this->PeekSymbol() == "!")
    {
      ++this->At;
    }
    const std::size_t last = this->At;
    Type type = this->ReadPostfix();
    for (std::size_t sign = last; this->IsGood() && sign > first; --sign)
    {
      const std::string& symbol = this->Tokens[sign - 1].Text;
      const bool fits = symbol == "!" ? type.Base == Type::Bool && type.IsScalar() : type.IsNumeric();
      if (type.IsKnown() && !fits)
      {
        this->Fail(sign - 1, "'" + symbol + "' has no version for a " + type.GetName());
      }
    }
    return type;
  }

  Type ReadPostfix()
  {
    Type type = this->ReadPrimary();
    while (this->IsGood())
    {
      const std::string symbol = this->PeekSymbol();
      if (symbol == ".")
      {
        ++this->At;
        type = this->ReadComponents(type);
      }
      else if (symbol == "[")
      {
        type = this->ReadIndex(type);
      }
      else
      {
        break;
      }
    }
    return type;
  }

  Type ReadComponents(Type type)
  {
    if (this->At >= this->Tokens.size() || this->Tokens[this->At].Kind != ExpressionToken::Name)
    {
      return this->Unexpected();
    }
    const std::size_t place = this->At;
    const std::string& name = this->Tokens[this->At++].Text;
    if (name == "length" && this->PeekSymbol() == "(")
    {
      ++this->At;
      this->Take(")");
      return Whole;
    }
    if (!type.IsKnown())
    {
      return {};
    }
    for (const char* set : { "xyzw", "rgba", "stpq" })
    {
      const std::string letters(set, set + type.Size);
      if (name.size() <= 4 && name.find_first_not_of(letters) == std::string::npos)
      {
        return { type.Base, static_cast<int>(name.size()) };
      }
    }
    return this->Fail(place, "a " + type.GetName() + " has no component '" + name + "'");
  }

  Type ReadIndex(Type type)
  {
    const std::size_t place = this->At++;
    const bool isLiteral = this->At + 1 < this->Tokens.size() &&
      this->Tokens[this->At].Kind == ExpressionToken::Number && this->Tokens[this->At + 1].Text == "]";
    const std::string literal = isLiteral ? this->Tokens[this->At].Text : "";
    const Type index = this->ReadChoice();
    this->Take("]");
    if (!this->IsGood())
    {
      return {};
    }
    if (index.IsKnown() && !(index.IsScalar() && (index.Base == Type::Int || index.Base == Type::Uint)))
    {
      return this->Fail(place + 1, "an index is a whole number, not a " + index.GetName());
    }
    if (!type.IsKnown())
    {
      return isLiteral ? Type{}
                       : this->Fail(place + 1,
                           "the index of a matrix is a number here: some drivers keep its columns in single "
                           "precision otherwise");
    }
    if (type.IsScalar())
    {
      return this->Fail(place, "a " + type.GetName() + " has no components to choose by '[ ]'");
    }
    const bool isDecimal = !literal.empty() && literal.find_first_not_of("0123456789") == std::string::npos;
    if (isDecimal && literal.find_first_not_of('0') != std::string::npos &&
      (literal.size() > 9 || std::stoi(literal) >= type.Size))
    {
      return this->Fail(place + 1, "a " + type.GetName() + " has no component " + literal);
    }
    return { type.Base, 1 };
  }

  Type ReadPrimary()
  {
    if (this->At >= this->Tokens.size())
    {
      return this->Unexpected();
    }
    const ExpressionToken& token = this->Tokens[this->At];
    if (token.Kind == ExpressionToken::Number)
    {
      ++this->At;
      return token.Type;
    }
    if (token.Kind == ExpressionToken::Symbol)
    {
      if (token.Text != "(")
      {
        return this->Unexpected();
      }
      ++this->At;
      const Type type = this->ReadChoice();
      this->Take(")");
      return type;
    }
    const std::size_t place = this->At++;
    const bool isConstructor = FindConstructor(token.Text).IsKnown() || IsMatrix(token.Text);
    if (this->PeekSymbol() == "(")
    {
      return this->ReadCall(token.Text, place);
    }
    if (isConstructor && this->PeekSymbol() == "[")
    {
      return this->Fail(
        place, "'" + token.Text + "[ ]' makes an array, which some drivers keep in single precision");
    }
    if (token.Type.IsKnown())
    {
      return token.Type;
    }
    const bool isFunction = GetExpressionFunctions().count(token.Text) > 0 || isConstructor;
    return this->Fail(place,
      "'" + token.Text +
        (isFunction ? "' is a function and needs arguments in parentheses" : "' is not defined"));
  }

  /// The arguments of a call, with the parentheses.
  std::vector<Type> ReadArguments()
  {
    std::vector<Type> types;
    this->Take("(");
    if (this->PeekSymbol() == ")")
    {
      ++this->At;
      return types;
    }
    do
    {
      types.push_back(this->ReadChoice());
    } while (this->IsGood() && this->PeekSymbol() == "," && this->Take(","));
    this->Take(")");
    return types;
  }

  Type ReadCall(const std::string& name, std::size_t place)
  {
    const auto found = GetExpressionFunctions().find(name);
    const Type made = FindConstructor(name);
    const bool isKnown = found != GetExpressionFunctions().end() || made.IsKnown() || IsMatrix(name);
    if (!isKnown)
    {
      return this->Fail(place,
        "'" + name +
          (HasSinglePrecisionOnly(name) ? "' has single precision only, which no bound here includes"
                                        : "' is not a function"));
    }
    const std::vector<Type> types = this->ReadArguments();
    if (!this->IsGood())
    {
      return {};
    }
    if (found != GetExpressionFunctions().end() && static_cast<int>(types.size()) != found->second.Arguments)
    {
      return this->Fail(place,
        "'" + name + "' takes " + std::to_string(found->second.Arguments) +
          (found->second.Arguments == 1 ? " argument, not " : " arguments, not ") +
          std::to_string(types.size()));
    }
    const bool areKnown =
      std::all_of(types.begin(), types.end(), [](const Type& type) { return type.IsKnown(); });
    if (made.IsKnown())
    {
      return this->Construct(made, types, areKnown, place);
    }
    if (found == GetExpressionFunctions().end())
    {
      return {};
    }
    if (!areKnown)
    {
      const Signature kind = found->second.Kind;
      return kind == Signature::Scalars ? Real : kind == Signature::AnyAll ? Truth : Type{};
    }
    return this->Apply(name, found->second, types, place);
  }

  Type Construct(Type made, const std::vector<Type>& types, bool areKnown, std::size_t place)
  {
    int components = 0;
    for (const Type& type : types)
    {
      // An argument behind the last component that is used.
      if (areKnown && components >= made.Size)
      {
        return this->Fail(place, "'" + made.GetName() + "' has more arguments than components");
      }
      components += type.Size;
    }
    const bool isFilled = types.size() == 1 && types[0].IsScalar();
    if (types.empty() || (areKnown && components < made.Size && !isFilled))
    {
      return this->Fail(place,
        "'" + made.GetName() + "' needs " + std::to_string(made.Size) +
          (made.Size == 1 ? " component, not " : " components, not ") + std::to_string(components));
    }
    return made;
  }

  /// The result of a function for arguments of known types.
  Type Apply(
    const std::string& name, const Function& function, const std::vector<Type>& types, std::size_t place)
  {
    std::string list;
    for (const Type& type : types)
    {
      list += (list.empty() ? "" : ", ") + type.GetName();
    }
    const auto refuse = [&] { return this->Fail(place, "'" + name + "' has no version for (" + list + ")"); };
    const Type& first = types.front();
    const Type& last = types.back();
    const bool areNumbers =
      std::all_of(types.begin(), types.end(), [](const Type& type) { return type.IsNumeric(); });
    const bool isInteger = areNumbers &&
      std::all_of(types.begin(), types.end(), [](const Type& type) { return type.Base != Type::Double; });
    const bool isSame =
      std::all_of(types.begin(), types.end(), [&](const Type& type) { return type.Size == first.Size; });
    switch (function.Kind)
    {
      case Signature::Scalars:
        return areNumbers && isSame && first.IsScalar() ? Real : refuse();
      case Signature::Compare:
        return areNumbers && isSame && !first.IsScalar() ? Type{ Type::Bool, first.Size } : refuse();
      case Signature::Equal:
      {
        const bool fits = areNumbers || (first.Base == Type::Bool && last.Base == Type::Bool);
        return fits && isSame && !first.IsScalar() ? Type{ Type::Bool, first.Size } : refuse();
      }
      case Signature::AnyAll:
      case Signature::Not:
        return first.Base != Type::Bool || first.IsScalar() ? refuse()
          : function.Kind == Signature::Not                 ? first
                                                            : Truth;
      case Signature::Matrix:
        return refuse();
      case Signature::Other:
        return {};
      case Signature::Mix:
        if (last.Base == Type::Bool)
        {
          return isSame && Converts(types[0], types[1]) && types[1].Base == Type::Double ? types[1] : Type{};
        }
        break;
      default:
        break;
    }
    if (!areNumbers)
    {
      return refuse();
    }
    if (function.Kind == Signature::Classify)
    {
      return { Type::Bool, first.Size };
    }
    if (isInteger)
    {
      // With whole numbers alone there may be versions of single precision, too, which GLSL prefers.
      return function.HasIntegers && isSame &&
          std::all_of(types.begin(), types.end(), [&](const Type& type) { return type.Base == first.Base; })
        ? first
        : Type{};
    }
    const std::size_t count = types.size();
    const auto areScalars = [&](std::size_t begin, std::size_t end)
    {
      return std::all_of(
        types.begin() + begin, types.begin() + end, [](const Type& type) { return type.IsScalar(); });
    };
    switch (function.Kind)
    {
      case Signature::LastScalar:
        return isSame || areScalars(1, count) ? Type{ Type::Double, first.Size } : refuse();
      case Signature::FirstScalar:
        return isSame || areScalars(0, count - 1) ? Type{ Type::Double, last.Size } : refuse();
      case Signature::Mix:
        return types[0].Size == types[1].Size && (isSame || last.IsScalar())
          ? Type{ Type::Double, first.Size }
          : refuse();
      case Signature::Product:
        return isSame ? Real : refuse();
      case Signature::Cross:
        return isSame && first.Size == 3 ? Type{ Type::Double, 3 } : refuse();
      default:
        return isSame ? Type{ Type::Double, first.Size } : refuse();
    }
  }

  const std::vector<ExpressionToken>& Tokens;
  std::size_t At = 0;
  int Depth = 0;
  ExpressionMistake Mistake;
};
}

std::string ExpressionType::GetName() const
{
  static const char* const scalars[] = { "value", "bool", "int", "uint", "double" };
  static const char* const vectors[] = { "value", "bvec", "ivec", "uvec", "dvec" };
  return this->IsScalar() ? scalars[this->Base] : vectors[this->Base] + std::to_string(this->Size);
}

ExpressionMistake FindMistake(const std::vector<ExpressionToken>& tokens)
{
  return Checker(tokens).Check();
}
}
