// Error-free transformations. Error of a sum: Knuth, TAOCP 2, 4.2.2, theorem B; of a product: Dekker 1971 (operands below
// 2^996), for double fma() is not fused everywhere. Exact, barring overflow.

// a + b - sum, where sum = fl(a + b).
double smSumError(double a, double b, double sum)
{
  precise double part = sum - a;
  precise double error = (a - (sum - part)) + (b - part);
  return error;
}

dvec2 smSumError(dvec2 a, dvec2 b, dvec2 sum)
{
  return dvec2(smSumError(a.x, b.x, sum.x), smSumError(a.y, b.y, sum.y));
}

// a b - product, where product = fl(a b).
double smProductError(double a, double b, double product)
{
  precise double splitA = 134217729.0LF * a;
  precise double highA = splitA - (splitA - a);
  precise double lowA = a - highA;
  precise double splitB = 134217729.0LF * b;
  precise double highB = splitB - (splitB - b);
  precise double lowB = b - highB;
  precise double error = lowA * lowB - (((product - highA * highB) - lowA * highB) - highA * lowB);
  return error;
}

dvec2 smProductError(dvec2 a, dvec2 b, dvec2 product)
{
  return dvec2(smProductError(a.x, b.x, product.x), smProductError(a.y, b.y, product.y));
}

// (s, e) with s = fl(a + b) and s + e = a + b.
dvec2 smTwoSum(double a, double b)
{
  precise double s = a + b;
  return dvec2(s, smSumError(a, b, s));
}
