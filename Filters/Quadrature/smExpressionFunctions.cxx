#include "Detail/smExpressionFunctions.h"

#include <set>

namespace sm
{
const std::map<std::string, ExpressionFunction>& GetExpressionFunctions()
{
  using Signature = ExpressionFunction::Signature;
  static const std::map<std::string, ExpressionFunction> functions = {
    { "sin", { Signature::Scalars, 1 } },
    { "cos", { Signature::Scalars, 1 } },
    { "tan", { Signature::Scalars, 1 } },
    { "exp", { Signature::Scalars, 1 } },
    { "log", { Signature::Scalars, 1 } },
    { "pow", { Signature::Scalars, 2 } },
    { "sqrt", { Signature::Same, 1 } },
    { "inversesqrt", { Signature::Same, 1 } },
    { "normalize", { Signature::Same, 1 } },
    { "abs", { Signature::Same, 1, true } },
    { "sign", { Signature::Same, 1, true } },
    { "floor", { Signature::Same, 1 } },
    { "trunc", { Signature::Same, 1 } },
    { "round", { Signature::Same, 1 } },
    { "roundEven", { Signature::Same, 1 } },
    { "ceil", { Signature::Same, 1 } },
    { "fract", { Signature::Same, 1 } },
    { "fma", { Signature::Same, 3 } },
    { "faceforward", { Signature::Same, 3 } },
    { "reflect", { Signature::Same, 2 } },
    { "mod", { Signature::LastScalar, 2 } },
    { "min", { Signature::LastScalar, 2, true } },
    { "max", { Signature::LastScalar, 2, true } },
    { "clamp", { Signature::LastScalar, 3, true } },
    { "step", { Signature::FirstScalar, 2 } },
    { "smoothstep", { Signature::FirstScalar, 3 } },
    { "mix", { Signature::Mix, 3 } },
    { "length", { Signature::Product, 1 } },
    { "distance", { Signature::Product, 2 } },
    { "dot", { Signature::Product, 2 } },
    { "cross", { Signature::Cross, 2 } },
    { "isnan", { Signature::Classify, 1 } },
    { "isinf", { Signature::Classify, 1 } },
    { "lessThan", { Signature::Compare, 2 } },
    { "lessThanEqual", { Signature::Compare, 2 } },
    { "greaterThan", { Signature::Compare, 2 } },
    { "greaterThanEqual", { Signature::Compare, 2 } },
    { "equal", { Signature::Equal, 2 } },
    { "notEqual", { Signature::Equal, 2 } },
    { "any", { Signature::AnyAll, 1 } },
    { "all", { Signature::AnyAll, 1 } },
    { "not", { Signature::Not, 1 } },
    { "refract", { Signature::Other, 3 } },
    { "ldexp", { Signature::Other, 2 } },
    { "matrixCompMult", { Signature::Matrix, 2 } },
    { "outerProduct", { Signature::Other, 2 } },
    { "transpose", { Signature::Matrix, 1 } },
    { "determinant", { Signature::Matrix, 1 } },
    { "inverse", { Signature::Matrix, 1 } },
    { "packDouble2x32", { Signature::Other, 1 } },
    { "bitfieldExtract", { Signature::Other, 3 } },
    { "bitfieldInsert", { Signature::Other, 4 } },
    { "bitfieldReverse", { Signature::Other, 1 } },
    { "bitCount", { Signature::Other, 1 } },
    { "findLSB", { Signature::Other, 1 } },
    { "findMSB", { Signature::Other, 1 } },
    { "floatBitsToInt", { Signature::Other, 1 } },
    { "floatBitsToUint", { Signature::Other, 1 } },
  };
  return functions;
}

bool HasSinglePrecisionOnly(const std::string& name)
{
  static const std::set<std::string> names = { "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh",
    "acosh", "atanh", "exp2", "log2", "radians", "degrees" };
  return names.count(name) > 0;
}
}
