#include "Detail/smPatchJump.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// No less than |A' / w - (A / w) (w' / w)| on [0,1], where A, w are `side` and A', w' are `slope`: the
/// numerator A' w - A w' has twice the degree, and its Bernstein coefficients are sums of products.
double BoundQuotientDerivative(const Homogeneous* side, const Homogeneous* slope, int degree)
{
  // Row `degree` of Pascal's triangle, and row 2 degree.
  double once[MaximumDegree + 1] = { 1.0 };
  double twice[2 * MaximumDegree + 1] = { 1.0 };
  for (int i = 1; i <= 2 * degree; ++i)
  {
    twice[i] = twice[i - 1] * (2 * degree - i + 1) / i;
    if (i <= degree)
    {
      once[i] = once[i - 1] * (degree - i + 1) / i;
    }
  }
  Vector3 sums[2 * MaximumDegree + 1] = {};
  const Vector3 center = Project(side[degree / 2]);
  double lightest = HUGE_VAL;
  for (int i = 0; i <= degree; ++i)
  {
    lightest = std::min(lightest, std::max(side[i][3], 1e-100));
    for (int j = 0; j <= degree; ++j)
    {
      for (int c = 0; c < 3; ++c)
      {
        // About the center, so that less is rounded.
        const double value = (slope[i][c] - slope[i][3] * center[c]) * side[j][3] -
          (side[j][c] - side[j][3] * center[c]) * slope[i][3];
        sums[i + j][c] += once[i] * once[j] / twice[i + j] * value;
      }
    }
  }
  double largest = 0.0;
  for (int k = 0; k <= 2 * degree; ++k)
  {
    largest = std::max(largest, Norm(sums[k]));
  }
  return largest / (lightest * lightest);
}
}

double BoundJump(const BernsteinNet& before, const BernsteinNet& after, int direction,
  const double (&width)[2], double& scale)
{
  const int degree = direction == 0 ? before.P : before.Q;
  const int rows = direction == 0 ? before.Q : before.P;
  const auto get = [&](const BernsteinNet& net, int i, int row) -> const Homogeneous&
  { return direction == 0 ? net.At(i, row) : net.At(row, i); };
  // Position along the side, and the derivatives across it, as polynomials.
  Homogeneous side[MaximumDegree + 1];
  Homogeneous slope[MaximumDegree + 1];
  Homogeneous jump[MaximumDegree + 1];
  for (int row = 0; row <= rows; ++row)
  {
    side[row] = get(after, 0, row);
    for (int c = 0; c < 4; ++c)
    {
      slope[row][c] = degree * (get(before, degree, row)[c] - get(before, degree - 1, row)[c]) / width[0];
      jump[row][c] = degree * (get(after, 1, row)[c] - get(after, 0, row)[c]) / width[1] - slope[row][c];
    }
  }
  scale = BoundQuotientDerivative(side, slope, rows);
  return BoundQuotientDerivative(side, jump, rows);
}
}
