#include "Detail/smMassSpread.h"

#include "smBodyIntegrals.h"
#include "smClosingSpread.h"
#include "smMassIntegrands.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
MassSpread::MassSpread()
{
  this->Volume = this->Center = this->Inertia = this->Principal = std::numeric_limits<double>::quiet_NaN();
}

MassSpread MassSpread::GetWeighted(double factor) const
{
  MassSpread weighted;
  if (factor > 0.0)
  {
    weighted.Volume = factor * this->Volume;
    weighted.Center = this->Center;
    weighted.Inertia = factor * this->Inertia;
    weighted.Principal = factor * this->Principal;
  }
  return weighted;
}

Moments GetSpreadMoments(const BodyIntegrals& body)
{
  Moments moments;
  moments.VolumeBound = std::numeric_limits<double>::quiet_NaN();
  if (!body.Spread)
  {
    return moments;
  }
  Vector3 center;
  for (int d = 0; d < 3; ++d)
  {
    center[d] = body.Value[MassFirst + d] / body.Value[MassVolume];
    moments.Reference[d] = body.Model->GetOrigin()[d] + center[d];
  }
  const SpreadSums sums = SumSpread(*body.Spread, body.Sides, center);
  moments.VolumeBound = sums.Volume;
  std::copy_n(sums.First, 3, moments.FirstBound.begin());
  std::copy_n(sums.Second, 6, moments.SecondBound.begin());
  moments.Place(body.Placement.data());
  // What rounding of the placement does is part of the numerical bound.
  moments.ReferenceBound = 0.0;
  return moments;
}

MassSpread ComputeSpread(
  const std::vector<Moments>& spreads, double volume, const std::array<double, 3>& center)
{
  // Values are 0, so that moving the reference rounds nothing.
  Moments spread;
  spread.Reference = center;
  for (const Moments& body : spreads)
  {
    spread.Add(body);
  }
  MassSpread result;
  result.Volume = spread.VolumeBound;
  // Otherwise the volume may be 0, and nothing bounds the centre.
  if (!(spread.VolumeBound < std::abs(volume)))
  {
    return result;
  }
  // About a centre that is known, the moments change by their bounds alone; then the centre moves
  // (Bounds.md).
  double shift[3];
  for (int i = 0; i < 3; ++i)
  {
    shift[i] = spread.FirstBound[i] / (std::abs(volume) - spread.VolumeBound);
  }
  result.Center = std::max({ shift[0], shift[1], shift[2] });
  const double largest = std::abs(volume) + spread.VolumeBound;
  const auto get = [&](int packed, int i, int j)
  { return spread.SecondBound[packed] + largest * shift[i] * shift[j]; };
  const double xx = get(0, 0, 0);
  const double yy = get(1, 1, 1);
  const double zz = get(2, 2, 2);
  const double xy = get(3, 0, 1);
  const double yz = get(4, 1, 2);
  const double xz = get(5, 0, 2);
  result.Inertia = std::max({ yy + zz, xx + zz, xx + yy, xy, yz, xz });
  // Weyl: an eigenvalue moves by at most the largest sum of a row of the change.
  result.Principal = std::max({ yy + zz + xy + xz, xx + zz + xy + yz, xx + yy + xz + yz });
  return result;
}
}
