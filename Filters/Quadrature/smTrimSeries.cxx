#include "smTrimSeries.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Smallest half width of a box: it must have an interior, and a wider box gives valid bounds.
constexpr double MinHalfWidth = 5e-7;
}

void TrimSeries::Expand(const double* coefficients, int degree, const Patch& patch, double start, double end)
{
  const int n = degree + 1;
  std::array<double, 2> local[MaximumDegree + 1];
  std::array<double, 2> series[MaximumDegree + 1];
  for (int i = 0; i < n; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      local[i][d] = (coefficients[2 * i + d] - patch.Start[d]) / patch.Width[d];
    }
  }
  ExpandBernstein<double>(local[0].data(), 2, degree, start, end, series[0].data());
  for (int d = 0; d < 2; ++d)
  {
    this->Series[d].resize(n);
    this->Derivative[d].resize(n);
    for (int k = 0; k < n; ++k)
    {
      this->Series[d][k] = series[k][d];
    }
  }
  for (int d = 0; d < 2; ++d)
  {
    // A line of constant parameter stays one.
    if (std::all_of(local, local + n, [&](const auto& point) { return point[d] == local[0][d]; }))
    {
      this->Series[d].assign(n, 0.0);
      this->Series[d][0] = local[0][d];
    }
    DifferentiateChebyshev(this->Series[d].data(), this->Derivative[d].data(), n, 1);
    double reach = 0.0;
    for (int k = 1; k < n; ++k)
    {
      reach += std::abs(this->Series[d][k]);
    }
    this->Low[d] = this->Series[d][0] - reach;
    this->High[d] = this->Series[d][0] + reach;
    // From [-1,1] to [0,1].
    for (double& value : this->Derivative[d])
    {
      value *= 2.0;
    }
  }
}

bool TrimSeries::IsConstantInS() const
{
  return this->Low[0] == this->High[0];
}

bool TrimSeries::IsOnPatch(const Patch& patch) const
{
  const double factor = (patch.Degree[0] + patch.Degree[1]) * patch.WeightRatio;
  const double beyond = std::max({ -this->Low[0], -this->Low[1], this->High[0] - 1.0, this->High[1] - 1.0 });
  return factor * beyond <= 1e-3;
}

ParameterBox TrimSeries::GetBox(double xiStart, double xiEnd) const
{
  const double products[4] = { xiStart * this->Low[0], xiStart * this->High[0], xiEnd * this->Low[0],
    xiEnd * this->High[0] };
  const double low[2] = { *std::min_element(products, products + 4), this->Low[1] };
  const double high[2] = { *std::max_element(products, products + 4), this->High[1] };
  ParameterBox box;
  for (int d = 0; d < 2; ++d)
  {
    box.Middle[d] = 0.5 * (low[d] + high[d]);
    box.Half[d] = std::max(0.5 * (high[d] - low[d]), MinHalfWidth);
  }
  return box;
}

void TrimSeries::UpdateMajorants(const Ellipse& t, std::size_t count) const
{
  // An ellipse is asked for several times in a row.
  if (this->Majorants.size() != count || this->MajorantsAxis != t.GetHalfAxis())
  {
    t.GetMajorants(static_cast<int>(count), this->Majorants);
    this->MajorantsAxis = t.GetHalfAxis();
  }
}

Ellipse TrimSeries::Map(
  const Ellipse& t, int direction, const ParameterBox& box, double xiStart, double xiEnd) const
{
  const std::vector<double>& series = this->Series[direction];
  this->UpdateMajorants(t, series.size());
  // z = c0 + c1 t + ..: c0 + c1 t is in an ellipse around [c0 - |c1|, c0 + |c1|] whose sum of distances to
  // the ends is 2 |c1| T_1; to -1 and 1 it is at most 2 (1 - |c1|) more, and what sticks out of [-1,1] counts
  // twice.
  const double half = box.Half[direction];
  const double largest = direction == 0 ? std::max(std::abs(xiStart), std::abs(xiEnd)) : 1.0;
  double axis = 1.0;
  double slope = 0.0;
  for (std::size_t k = 1; k < series.size(); ++k)
  {
    const double c = largest * std::abs(series[k]) / half;
    axis += k == 1 ? c * (this->Majorants[1] - 1.0) : c * this->Majorants[k];
    slope += k == 1 ? c : 0.0;
  }
  const double ends[2] = { direction == 0 ? xiStart : 1.0, direction == 0 ? xiEnd : 1.0 };
  double outside = 0.0;
  for (const double xi : ends)
  {
    const double c0 = (xi * series[0] - box.Middle[direction]) / half;
    outside = std::max(outside, std::abs(c0) + slope - 1.0);
  }
  return Ellipse::FromHalfAxis(axis + outside);
}

double TrimSeries::GetMaxS(const Ellipse& t) const
{
  this->UpdateMajorants(t, this->Series[0].size());
  double sum = 0.0;
  for (std::size_t k = 0; k < this->Series[0].size(); ++k)
  {
    sum += std::abs(this->Series[0][k]) * this->Majorants[k];
  }
  return sum;
}

double TrimSeries::GetMaxSlope(const Ellipse& t, int direction) const
{
  const std::vector<double>& derivative = this->Derivative[direction];
  this->UpdateMajorants(t, derivative.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < derivative.size(); ++k)
  {
    sum += std::abs(derivative[k]) * this->Majorants[k];
  }
  return sum;
}
}
