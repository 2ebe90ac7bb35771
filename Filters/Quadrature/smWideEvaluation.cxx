#include "smWideEvaluation.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Pascal's triangle: integers below 2^53.
const std::array<std::array<double, MaximumDegree + 1>, MaximumDegree + 1> Binomials = []()
{
  std::array<std::array<double, MaximumDegree + 1>, MaximumDegree + 1> rows{};
  for (int n = 0; n <= MaximumDegree; ++n)
  {
    rows[n][0] = 1.0;
    for (int i = 1; i <= n; ++i)
    {
      rows[n][i] = rows[n - 1][i - 1] + rows[n - 1][i];
    }
  }
  return rows;
}();
}

void FillWideBasis(int degree, Wide t, Wide* basis)
{
  Wide power = 1;
  for (int i = 0; i <= degree; ++i)
  {
    basis[i] = power * Binomials[degree][i];
    power *= t;
  }
  power = 1;
  for (int i = degree; i-- > 0;)
  {
    power *= 1 - t;
    basis[i] *= power;
  }
}

WidePatch::WidePatch(const std::array<double, 4>* points, int p, int q, const Wide* s, const Wide* r)
  : Points(points)
  , Degree{ p, q }
  , Constant{ s != nullptr, !s && r }
{
  if (!s && !r)
  {
    return;
  }
  const int along = s ? 1 : 0;
  const int across = 1 - along;
  const std::size_t step = along == 1 ? 1 : p + 1;
  const std::size_t next = along == 1 ? p + 1 : 1;
  Wide basis[MaximumDegree + 1];
  FillWideBasis(this->Degree[across], s ? *s : *r, basis);
  for (int j = 0; j <= this->Degree[along]; ++j)
  {
    for (int c = 0; c < 4; ++c)
    {
      Wide value = 0;
      for (int i = 0; i <= this->Degree[across]; ++i)
      {
        value += basis[i] * points[next * j + step * i][c];
      }
      this->Curve[j][c] = value;
    }
  }
}

void WidePatch::Evaluate(Wide s, Wide r, Wide h[4]) const
{
  Wide basis[2][MaximumDegree + 1];
  if (this->Constant[0] || this->Constant[1])
  {
    const int degree = this->Degree[this->Constant[0] ? 1 : 0];
    FillWideBasis(degree, this->Constant[0] ? r : s, basis[0]);
    for (int c = 0; c < 4; ++c)
    {
      Wide value = 0;
      for (int i = 0; i <= degree; ++i)
      {
        value += basis[0][i] * this->Curve[i][c];
      }
      h[c] = value;
    }
    return;
  }
  const auto [p, q] = this->Degree;
  FillWideBasis(p, s, basis[0]);
  FillWideBasis(q, r, basis[1]);
  std::fill(h, h + 4, Wide(0));
  for (int j = 0; j <= q; ++j)
  {
    for (int c = 0; c < 4; ++c)
    {
      // Sums in registers: storing a wide number costs more than adding one.
      Wide value = 0;
      for (int i = 0; i <= p; ++i)
      {
        value += basis[0][i] * this->Points[i + (p + 1) * j][c];
      }
      h[c] += basis[1][j] * value;
    }
  }
}
}
