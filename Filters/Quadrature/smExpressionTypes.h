/**
 * @file smExpressionTypes.h
 * @brief Names, arities and types of a user's expression, checked before a compiler sees it; not installed
 */
#ifndef smExpressionTypes_h
#define smExpressionTypes_h

#include <cstddef>
#include <string>
#include <vector>

namespace sm
{
/// A GLSL type of an expression: a scalar or a vector. Matrices are Unknown, and little is said of them.
struct ExpressionType
{
  enum BaseType
  {
    Unknown,
    Bool,
    Int,
    Uint,
    Double
  };
  BaseType Base = Unknown;
  int Size = 1;

  bool IsKnown() const { return this->Base != Unknown; }
  bool IsNumeric() const { return this->Base >= Int; }
  bool IsScalar() const { return this->Size == 1; }
  /// The name in GLSL: "double", "ivec3".
  std::string GetName() const;
};

/// One token of an expression.
struct ExpressionToken
{
  enum KindType
  {
    Symbol,
    Number,
    Name
  };
  KindType Kind = Symbol;
  /// The user's text.
  std::string Text;
  /// Type of a number, a quantity or a constant; Unknown for other names.
  ExpressionType Type;
};

/// A mistake, and the token where it is; the number of tokens for the end of the text.
struct ExpressionMistake
{
  std::string What;
  std::size_t Token = 0;
};

/// Finds the first mistake of an expression whose value has to be a number. `What` is empty if there is none,
/// or none in what is known: a driver may refuse more. What GLSL 4.3 with doubles accepts is not refused,
/// except what may have single precision: some functions, arrays, and columns of a matrix by an index that is
/// computed.
ExpressionMistake FindMistake(const std::vector<ExpressionToken>& tokens);
}

#endif
