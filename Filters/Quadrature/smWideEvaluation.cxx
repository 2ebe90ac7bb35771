#include "smWideEvaluation.h"

#include "smBezierPatch.h"

#include <algorithm>

namespace sm
{
namespace
{
/// B_i^degree(x), and those of one degree less.
void EvaluateBasis(int degree, Wide x, Wide* basis, Wide* lower)
{
  basis[0] = 1;
  for (int k = 1; k <= degree; ++k)
  {
    if (k == degree)
    {
      std::copy(basis, basis + degree, lower);
    }
    Wide carried = 0;
    for (int j = 0; j < k; ++j)
    {
      const Wide term = basis[j];
      basis[j] = carried + (1 - x) * term;
      carried = x * term;
    }
    basis[k] = carried;
  }
}
}

void EvaluatePatch(const std::array<double, 4>* points, int p, int q, Wide s, Wide r, Wide h[3][4])
{
  Wide basisS[MaximumDegree + 1];
  Wide lowerS[MaximumDegree + 1];
  Wide basisR[MaximumDegree + 1];
  Wide lowerR[MaximumDegree + 1];
  EvaluateBasis(p, s, basisS, lowerS);
  EvaluateBasis(q, r, basisR, lowerR);
  std::fill(&h[0][0], &h[0][0] + 12, Wide(0));
  for (int j = 0; j <= q; ++j)
  {
    Wide line[2][4] = {};
    for (int i = 0; i <= p; ++i)
    {
      const Wide slope = p * ((i > 0 ? lowerS[i - 1] : 0) - (i < p ? lowerS[i] : 0));
      const std::array<double, 4>& point = points[i + (p + 1) * j];
      for (int c = 0; c < 4; ++c)
      {
        line[0][c] += basisS[i] * point[c];
        line[1][c] += slope * point[c];
      }
    }
    const Wide slope = q * ((j > 0 ? lowerR[j - 1] : 0) - (j < q ? lowerR[j] : 0));
    for (int c = 0; c < 4; ++c)
    {
      h[0][c] += basisR[j] * line[0][c];
      h[1][c] += basisR[j] * line[1][c];
      h[2][c] += slope * line[0][c];
    }
  }
}

void EvaluatePiece(
  const double* coefficients, int size, int degree, Wide t, const double* origin, Wide* point)
{
  Wide basis[MaximumDegree + 1];
  Wide lower[MaximumDegree + 1];
  EvaluateBasis(degree, t, basis, lower);
  for (int d = 0; d < size; ++d)
  {
    point[d] = 0;
    for (int i = 0; i <= degree; ++i)
    {
      point[d] += basis[i] * (static_cast<Wide>(coefficients[size * i + d]) - origin[d]);
    }
  }
}
}
