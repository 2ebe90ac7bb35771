#include "smWideEvaluation.h"

#include <algorithm>

namespace sm
{
void FillWideBasis(int degree, Wide t, Wide* basis)
{
  Wide power = 1;
  double binomial = 1.0;
  for (int i = 0; i <= degree; ++i)
  {
    basis[i] = power * binomial;
    power *= t;
    // An integer below 2^53 up to degree 25.
    binomial = binomial * (degree - i) / (i + 1);
  }
  power = 1;
  for (int i = degree; i-- > 0;)
  {
    power *= 1 - t;
    basis[i] *= power;
  }
}

void EvaluatePatch(const std::array<double, 4>* points, int p, int q, Wide s, Wide r, Wide h[4])
{
  Wide basisS[MaximumDegree + 1];
  Wide basisR[MaximumDegree + 1];
  FillWideBasis(p, s, basisS);
  FillWideBasis(q, r, basisR);
  std::fill(h, h + 4, Wide(0));
  for (int j = 0; j <= q; ++j)
  {
    for (int c = 0; c < 4; ++c)
    {
      // Sums in registers: storing a wide number costs more than adding one.
      Wide value = 0;
      for (int i = 0; i <= p; ++i)
      {
        value += basisS[i] * points[i + (p + 1) * j][c];
      }
      h[c] += basisR[j] * value;
    }
  }
}
}
