// Bernstein polynomials and polynomial pieces in Bernstein form: sums of products of like sign on [0,1].
// Needs: SM_BASIS_SIZE (entries of a basis array), double smCoefficient(uint index); as C++ smErrorFree.

//SM::Include smErrorFree

// B_i^degree(x) for i = 0 .. degree, by the triangular recurrence.
void smBernsteinBasis(int degree, double x, SM_OUT_ARRAY(double, basis, SM_BASIS_SIZE))
{
  basis[0] = 1.0LF;
  for (int k = 1; k <= degree; ++k)
  {
    double carried = 0.0LF;
    for (int j = 0; j < k; ++j)
    {
      double term = basis[j];
      basis[j] = carried + (1.0LF - x) * term;
      carried = x * term;
    }
    basis[k] = carried;
  }
}

// Polynomial pieces sum_i C(n,i) x^i (1-x)^(n-i) c_i and their derivatives sum_i i C(n,i) x^(i-1) (1-x)^(n-i)
// (c_i - c_{i-1}), nested in (1-x): each coefficient is read once.

// sum = y sum + factor (a - b), each with what it lacks: the roundings are carried along.
void smNest(dvec2 y, dvec2 yLow, dvec2 factor, dvec2 factorLow, dvec2 a, dvec2 b, SM_INOUT(dvec2) sum,
  SM_INOUT(dvec2) sumLow)
{
  precise dvec2 value = a - b;
  precise dvec2 valueLow = smSumError(a, -b, value);
  precise dvec2 term = factor * value;
  precise dvec2 termLow = smProductError(factor, value, term) + (factorLow * value + factor * valueLow);
  precise dvec2 carried = y * sum;
  precise dvec2 carriedLow = smProductError(y, sum, carried) + (yLow * sum + y * sumLow);
  precise dvec2 next = carried + term;
  sumLow = smSumError(carried, term, next) + (carriedLow + termLow);
  sum = next;
}

// Roundings of a trim piece's point in units of u and its reach: the compensated sum, the cell's width, the division by it.
SM_CONSTANT double smTrimRoundings = 3.0LF;

// A trim piece: u, v pairs from index `first` on. The point is relative to `origin`; `reach` is the largest distance of a
// coefficient from there. Both sums are compensated: the trim moves the boundary of all that is integrated.
void smTrimEvaluate(uint first, int degree, double x, dvec2 origin, SM_OUT(dvec2) point, SM_OUT(dvec2) derivative,
  SM_OUT(dvec2) reach)
{
  precise dvec2 y = dvec2(1.0LF - x);
  dvec2 yLow = smSumError(dvec2(1.0LF), dvec2(-x), y);
  // C(n,i), i C(n,i), and x^i and x^(i-1) with what they lack.
  double binomial = 1.0LF;
  dvec2 power = dvec2(1.0LF);
  dvec2 powerLow = dvec2(0.0LF);
  dvec2 slopeFactor = dvec2(0.0LF);
  dvec2 slopeFactorLow = dvec2(0.0LF);
  dvec2 before = dvec2(0.0LF);
  dvec2 pointLow = dvec2(0.0LF);
  dvec2 derivativeLow = dvec2(0.0LF);
  point = dvec2(0.0LF);
  derivative = dvec2(0.0LF);
  reach = dvec2(0.0LF);
  for (int i = 0; i <= degree; ++i)
  {
    uint at = first + 2u * uint(i);
    dvec2 c = dvec2(smCoefficient(at), smCoefficient(at + 1u));
    reach = max(reach, abs(c - origin));
    precise dvec2 factor = binomial * power;
    dvec2 factorLow = smProductError(dvec2(binomial), power, factor) + binomial * powerLow;
    smNest(y, yLow, factor, factorLow, c, origin, point, pointLow);
    smNest(y, yLow, slopeFactor, slopeFactorLow, c, before, derivative, derivativeLow);
    before = c;
    // (i+1) C(n,i+1) x^i = (n-i) C(n,i) x^i.
    precise dvec2 slope = double(degree - i) * factor;
    slopeFactorLow = smProductError(dvec2(double(degree - i)), factor, slope) + double(degree - i) * factorLow;
    slopeFactor = slope;
    binomial = binomial * double(degree - i) / double(i + 1);
    precise dvec2 next = power * x;
    powerLow = smProductError(power, dvec2(x), next) + powerLow * x;
    power = next;
  }
  point += pointLow;
  derivative += derivativeLow;
}

// An edge piece: x, y, z triples from index `first` on, relative to `origin`; the point is compensated likewise.
void smEdgeEvaluate(
  uint first, int degree, double x, dvec3 origin, SM_OUT(dvec3) point, SM_OUT(dvec3) derivative)
{
  precise dvec2 y = dvec2(1.0LF - x);
  dvec2 yLow = smSumError(dvec2(1.0LF), dvec2(-x), y);
  double binomial = 1.0LF;
  dvec2 power = dvec2(1.0LF);
  dvec2 powerLow = dvec2(0.0LF);
  double slopeFactor = 0.0LF;
  dvec3 before = dvec3(0.0LF);
  dvec2 xy = dvec2(0.0LF);
  dvec2 xyLow = dvec2(0.0LF);
  dvec2 z = dvec2(0.0LF);
  dvec2 zLow = dvec2(0.0LF);
  derivative = dvec3(0.0LF);
  for (int i = 0; i <= degree; ++i)
  {
    uint at = first + 3u * uint(i);
    dvec3 c = dvec3(smCoefficient(at), smCoefficient(at + 1u), smCoefficient(at + 2u));
    precise dvec2 factor = binomial * power;
    dvec2 factorLow = smProductError(dvec2(binomial), power, factor) + binomial * powerLow;
    smNest(y, yLow, factor, factorLow, dvec2(c.x, c.y), dvec2(origin.x, origin.y), xy, xyLow);
    smNest(y, yLow, factor, factorLow, dvec2(c.z), dvec2(origin.z), z, zLow);
    derivative = y.x * derivative + slopeFactor * (c - before);
    before = c;
    slopeFactor = double(degree - i) * factor.x;
    binomial = binomial * double(degree - i) / double(i + 1);
    precise dvec2 next = power * x;
    powerLow = smProductError(power, dvec2(x), next) + powerLow * x;
    power = next;
  }
  point = dvec3(xy + xyLow, z.x + zLow.x);
}
