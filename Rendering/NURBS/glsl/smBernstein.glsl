// Bernstein polynomials and polynomial pieces in Bernstein form: sums of products of like sign on [0,1].
// Needs: SM_BASIS_SIZE (entries of a basis array), double smCoefficient(uint index).

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

// A trim piece: u, v pairs from index `first` on. The point is relative to `origin`, taken off the coefficients, so that what
// is rounded is the distance from there; `reach` is the largest of these.
void smTrimEvaluate(uint first, int degree, double x, dvec2 origin, SM_OUT(dvec2) point, SM_OUT(dvec2) derivative,
  SM_OUT(dvec2) reach)
{
  double y = 1.0LF - x;
  double binomial = 1.0LF;
  double power = 1.0LF;
  double powerBefore = 0.0LF;
  dvec2 before = dvec2(0.0LF);
  point = dvec2(0.0LF);
  derivative = dvec2(0.0LF);
  reach = dvec2(0.0LF);
  for (int i = 0; i <= degree; ++i)
  {
    uint at = first + 2u * uint(i);
    dvec2 c = dvec2(smCoefficient(at), smCoefficient(at + 1u));
    point = y * point + binomial * power * (c - origin);
    reach = max(reach, abs(c - origin));
    derivative = y * derivative + double(i) * binomial * powerBefore * (c - before);
    binomial = binomial * double(degree - i) / double(i + 1);
    powerBefore = power;
    power *= x;
    before = c;
  }
}

// An edge piece: x, y, z triples from index `first` on, relative to `origin` likewise.
void smEdgeEvaluate(
  uint first, int degree, double x, dvec3 origin, SM_OUT(dvec3) point, SM_OUT(dvec3) derivative)
{
  double y = 1.0LF - x;
  double binomial = 1.0LF;
  double power = 1.0LF;
  double powerBefore = 0.0LF;
  dvec3 before = dvec3(0.0LF);
  point = dvec3(0.0LF);
  derivative = dvec3(0.0LF);
  for (int i = 0; i <= degree; ++i)
  {
    uint at = first + 3u * uint(i);
    dvec3 c = dvec3(smCoefficient(at), smCoefficient(at + 1u), smCoefficient(at + 2u));
    point = y * point + binomial * power * (c - origin);
    derivative = y * derivative + double(i) * binomial * powerBefore * (c - before);
    binomial = binomial * double(degree - i) / double(i + 1);
    powerBefore = power;
    power *= x;
    before = c;
  }
}
