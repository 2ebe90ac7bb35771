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
  Wide slopeS[MaximumDegree + 1];
  for (int i = 0; i <= p; ++i)
  {
    slopeS[i] = p * ((i > 0 ? lowerS[i - 1] : 0) - (i < p ? lowerS[i] : 0));
  }
  std::fill(&h[0][0], &h[0][0] + 12, Wide(0));
  for (int j = 0; j <= q; ++j)
  {
    const Wide slope = q * ((j > 0 ? lowerR[j - 1] : 0) - (j < q ? lowerR[j] : 0));
    for (int c = 0; c < 4; ++c)
    {
      // Sums in registers: storing a wide number costs more than adding one.
      Wide value = 0;
      Wide change = 0;
      for (int i = 0; i <= p; ++i)
      {
        const double coordinate = points[i + (p + 1) * j][c];
        value += basisS[i] * coordinate;
        change += slopeS[i] * coordinate;
      }
      h[0][c] += basisR[j] * value;
      h[1][c] += basisR[j] * change;
      h[2][c] += slope * value;
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
