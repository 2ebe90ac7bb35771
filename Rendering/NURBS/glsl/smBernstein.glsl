// Bernstein polynomials and polynomial pieces in Bernstein form: sums of products of like sign on [0,1].
// Needs: SM_BASIS_SIZE (entries of a basis array), double smCoefficient(uint index); as C++ smErrorFree.

//SM::Include smErrorFree

// B_i^degree(x) for i = 0 .. degree, by the triangular recurrence.
void smBernsteinBasis(int degree, double x, SM_OUT_DOUBLES(basis, SM_BASIS_SIZE))
{
  SM_SET_DOUBLE(basis, 0, 1.0LF);
  for (int k = 1; k <= degree; ++k)
  {
    double carried = 0.0LF;
    for (int j = 0; j < k; ++j)
    {
      double term = SM_DOUBLE(basis, j);
      SM_SET_DOUBLE(basis, j, carried + (1.0LF - x) * term);
      carried = x * term;
    }
    SM_SET_DOUBLE(basis, k, carried);
  }
}

// Polynomial pieces sum_i C(n,i) x^i (1-x)^(n-i) c_i and their derivatives sum_i i C(n,i) x^(i-1) (1-x)^(n-i)
// (c_i - c_{i-1}), nested in (1-x): each coefficient is read once.

// sum = y sum + factor (a - b), where every operand is a double and its accumulated rounding error (…Low).
void smNest(double y, double yLow, double factor, double factorLow, double a, double b, SM_INOUT(double) sum,
  SM_INOUT(double) sumLow)
{
  precise double value = a - b;
  precise double valueLow = smSumError(a, -b, value);
  precise double term = factor * value;
  precise double termLow = smProductError(factor, value, term) + (factorLow * value + factor * valueLow);
  precise double carried = y * sum;
  precise double carriedLow = smProductError(y, sum, carried) + (yLow * sum + y * sumLow);
  precise double next = carried + term;
  sumLow = smSumError(carried, term, next) + (carriedLow + termLow);
  sum = next;
}

// product = a b, where a and the product are each a double and its rounding error (…Low), and b is a double.
void smScale(double a, double aLow, double b, SM_OUT(double) product, SM_OUT(double) productLow)
{
  precise double scaled = a * b;
  precise double scaledLow = smProductError(a, b, scaled) + aLow * b;
  product = scaled;
  productLow = scaledLow;
}

// Roundings of a trim piece's point in units of u and its reach: the compensated sum, the cell's width, the
// division by it.
SM_CONSTANT double smTrimRoundings = 3.0LF;

// A trim piece: u, v pairs from index `first` on. The point is relative to `origin`; `reach` is the largest
// distance of a coefficient from there. Both sums are compensated, because errors of the trim curve move the
// boundary of the region of integration.
void smTrimEvaluate(uint first, int degree, double x, dvec2 origin, SM_OUT(dvec2) point,
  SM_OUT(dvec2) derivative, SM_OUT(dvec2) reach)
{
  precise double y = 1.0LF - x;
  double yLow = smSumError(1.0LF, -x, y);
  // C(n,i), x^i, i C(n,i) x^(i-1).
  double binomial = 1.0LF;
  double power = 1.0LF;
  double powerLow = 0.0LF;
  double slopeFactor = 0.0LF;
  double slopeFactorLow = 0.0LF;
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
    double factor;
    double factorLow;
    smScale(power, powerLow, binomial, factor, factorLow);
    smNest(y, yLow, factor, factorLow, c.x, origin.x, point.x, pointLow.x);
    smNest(y, yLow, factor, factorLow, c.y, origin.y, point.y, pointLow.y);
    smNest(y, yLow, slopeFactor, slopeFactorLow, c.x, before.x, derivative.x, derivativeLow.x);
    smNest(y, yLow, slopeFactor, slopeFactorLow, c.y, before.y, derivative.y, derivativeLow.y);
    before = c;
    // (i+1) C(n,i+1) x^i = (n-i) C(n,i) x^i.
    smScale(factor, factorLow, double(degree - i), slopeFactor, slopeFactorLow);
    binomial = binomial * double(degree - i) / double(i + 1);
    smScale(power, powerLow, x, power, powerLow);
  }
  point += pointLow;
  derivative += derivativeLow;
}

// An edge piece: x, y, z triples from index `first` on, relative to `origin`; the point is compensated
// likewise.
void smEdgeEvaluate(
  uint first, int degree, double x, dvec3 origin, SM_OUT(dvec3) point, SM_OUT(dvec3) derivative)
{
  precise double y = 1.0LF - x;
  double yLow = smSumError(1.0LF, -x, y);
  double binomial = 1.0LF;
  double power = 1.0LF;
  double powerLow = 0.0LF;
  double slopeFactor = 0.0LF;
  dvec3 before = dvec3(0.0LF);
  dvec3 pointLow = dvec3(0.0LF);
  point = dvec3(0.0LF);
  derivative = dvec3(0.0LF);
  for (int i = 0; i <= degree; ++i)
  {
    uint at = first + 3u * uint(i);
    dvec3 c = dvec3(smCoefficient(at), smCoefficient(at + 1u), smCoefficient(at + 2u));
    double factor;
    double factorLow;
    smScale(power, powerLow, binomial, factor, factorLow);
    smNest(y, yLow, factor, factorLow, c.x, origin.x, point.x, pointLow.x);
    smNest(y, yLow, factor, factorLow, c.y, origin.y, point.y, pointLow.y);
    smNest(y, yLow, factor, factorLow, c.z, origin.z, point.z, pointLow.z);
    derivative = y * derivative + slopeFactor * (c - before);
    before = c;
    slopeFactor = double(degree - i) * factor;
    binomial = binomial * double(degree - i) / double(i + 1);
    smScale(power, powerLow, x, power, powerLow);
  }
  point = point + pointLow;
}
