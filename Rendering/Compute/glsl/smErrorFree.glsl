// Error-free transformations. Error of a sum: Knuth, TAOCP 2, 4.2.2, theorem B; of a product: Dekker 1971
// (operands below 2^996), because GLSL does not guarantee that fma() of doubles is fused. Where it is,
// SM_FUSED(a, b, c) is defined and used instead. Both are exact, barring overflow and underflow, so that
// results have the same bits.

// a + b - sum, where sum = fl(a + b).
double smSumError(double a, double b, double sum)
{
  precise double part = sum - a;
  precise double error = (a - (sum - part)) + (b - part);
  return error;
}

// a b - product, where product = fl(a b).
double smProductError(double a, double b, double product)
{
#ifdef SM_FUSED
  return SM_FUSED(a, b, -product);
#else
  precise double splitA = 134217729.0LF * a;
  precise double highA = splitA - (splitA - a);
  precise double lowA = a - highA;
  precise double splitB = 134217729.0LF * b;
  precise double highB = splitB - (splitB - b);
  precise double lowB = b - highB;
  precise double error = lowA * lowB - (((product - highA * highB) - lowA * highB) - highA * lowB);
  return error;
#endif
}

// (s, e) with s = fl(a + b) and s + e = a + b.
dvec2 smTwoSum(double a, double b)
{
  precise double s = a + b;
  return dvec2(s, smSumError(a, b, s));
}
