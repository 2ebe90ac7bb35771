// Bounds that follow from the series of a ribbon: their differences from the curves, tangents of the patch,
// and majorants on ellipses.
#include "Detail/smGapSeries.h"

#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
GapSeries::Remainder GapSeries::GetRemainder(const Majorants& real) const
{
  // Coefficients are rounded to doubles.
  SeriesNoise curve =
    SeriesNoise::OfPolynomial(this->CurveNoise, static_cast<double>(this->Curve.size()) - 1.0);
  for (std::size_t k = 0; k < this->Curve.size(); ++k)
  {
    curve.Add(k, UnitRoundoff * Norm(this->Curve[k].data()));
  }
  SeriesNoise gap = SeriesNoise::OfPolynomial(this->Noise, static_cast<double>(this->Gap.size()) - 1.0);
  gap.Add(SeriesNoise::OfPolynomial(this->Tail, this->GapDegree));
  SeriesNoise weight = this->WeightNoise;
  for (std::size_t k = 0; k < this->Gap.size(); ++k)
  {
    gap.Add(k, UnitRoundoff * Norm(this->Gap[k].data()));
    weight.Add(k, UnitRoundoff * std::abs(this->Gap[k][3]));
  }
  // With U and w off by e and f, G = U/w is off by d = (e + f |G|) / w, and G' = (U' - G w') / w by (e' + f'
  // |G| + d |w'| + f |G'|) / w, except for products of these.
  const double off = (gap.Value + weight.Value * real.Gap) / real.Weight;
  return { curve.Value, curve.Slope, off,
    (gap.Slope + weight.Slope * (real.Gap + off) + off * real.WeightSlope + weight.Value * real.GapSlope) /
      real.Weight };
}

bool GapSeries::BoundTangents(const Patch& patch)
{
  const bool onPatch = this->Trim.IsOnPatch(patch);
  const double growth = onPatch ? TrimSeries::OnPatchGrowth : 0.0;
  for (int d = 0; d < 2; ++d)
  {
    this->Stretch[d] = growth * patch.Stretch[d];
    this->TrimSlope[d] = this->Trim.GetMaxSlope(Ellipse::FromRadius(1.0), d);
  }
  this->NormalLength = growth * growth * Norm(patch.Normal);
  return onPatch;
}

void GapSeries::SampleTangents(const Ribbon& ribbon, const std::array<double, 2>& at)
{
  double position[3];
  double tangent[2][3];
  EvaluatePatch(this->Panels.Patches[ribbon.Patch], this->GetPoints(ribbon), at[0], at[1], position,
    tangent[0], tangent[1]);
  for (int d = 0; d < 2; ++d)
  {
    this->Stretch[d] = std::max(this->Stretch[d], 2.0 * Norm(tangent[d]));
  }
  this->NormalLength = std::max(this->NormalLength, 2.0 * Norm(Cross(tangent[0], tangent[1]).data()));
}

void GapSeries::Summarize()
{
  this->Sums.assign(std::max(this->Gap.size(), this->Curve.size()), {});
  const auto add = [this](std::size_t count, int value, const auto& norm)
  {
    // |T_k'| <= k T_k(A) .. is too small near the foci, so the coefficients of the derivative are summed:
    // d_(k-1) = d_(k+1) + 2 k c_k, all taken positive; times 2 from [-1,1] to [0,1].
    double odd = 0.0;
    double even = 0.0;
    for (std::size_t k = count; k-- > 1;)
    {
      double& d = k % 2 ? odd : even;
      const double size = norm(k);
      this->Sums[k][value] = size;
      d += 2.0 * static_cast<double>(k) * size;
      this->Sums[k - 1][value + 1] = (k == 1 ? 1.0 : 2.0) * d;
    }
  };
  add(this->Curve.size(), 0, [this](std::size_t k) { return Norm(this->Curve[k].data()); });
  add(this->Gap.size(), 2, [this](std::size_t k) { return Norm(this->Gap[k].data()); });
  add(this->Gap.size(), 4, [this](std::size_t k) { return std::abs(this->Gap[k][3]); });
  this->Sums[0][0] = this->CurveDistance;
  this->Sums[0][2] = Norm(this->Gap[0].data());
}

bool GapSeries::Evaluate(const Ellipse& t, Majorants& majorants) const
{
  t.GetMajorants(static_cast<int>(this->Sums.size()), this->Powers);
  double sums[6] = {};
  for (std::size_t k = 0; k < this->Sums.size(); ++k)
  {
    for (int i = 0; i < 6; ++i)
    {
      sums[i] += this->Powers[k] * this->Sums[k][i];
    }
  }
  const double weight = this->Gap[0][3] - sums[4];
  majorants = { sums[0], sums[1], 0.0, 0.0, weight, sums[5] };
  if (!(weight > 1e-9 * this->Gap[0][3]))
  {
    return false;
  }
  majorants.Gap = sums[2] / weight;
  majorants.GapSlope = (sums[3] + sums[5] * majorants.Gap) / weight;
  return true;
}
}
