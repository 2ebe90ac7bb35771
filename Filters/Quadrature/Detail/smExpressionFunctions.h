/**
 * @file smExpressionFunctions.h
 * @brief The built-in functions of a user's expression, by name; not installed
 */
#ifndef smExpressionFunctions_h
#define smExpressionFunctions_h

#include <map>
#include <string>

namespace sm
{
struct ExpressionFunction
{
  /// How a built-in function takes its arguments. A "gen" argument is a scalar or a vector of doubles.
  enum class Signature
  {
    /// Functions of this program for doubles.
    Scalars,
    /// One or more gen arguments of one type.
    Same,
    /// Like Same; all but the first may be scalars.
    LastScalar,
    /// Like Same; all but the last may be scalars.
    FirstScalar,
    Mix,
    /// Two arguments of one type, a number as result.
    Product,
    Cross,
    Classify,
    Compare,
    Equal,
    AnyAll,
    Not,
    /// Matrices as arguments.
    Matrix,
    /// The result, and arguments that differ from these, are not modelled.
    Other
  };

  Signature Kind;
  int Arguments;
  /// There are versions for whole numbers.
  bool HasIntegers = false;
};

const std::map<std::string, ExpressionFunction>& GetExpressionFunctions();

/// Returns true for functions that have no version for doubles. With a whole number as argument they would
/// compute in single precision.
bool HasSinglePrecisionOnly(const std::string& name);
}

#endif
