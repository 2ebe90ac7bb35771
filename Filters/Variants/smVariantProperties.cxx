#include "smVariantPolynomial.h"

#include "smMoments.h"

#include <algorithm>

namespace sm
{
VariantProperties DeriveProperties(
  const double* values, const double* bounds, const std::array<double, 3>& reference)
{
  Moments moments;
  moments.Reference = reference;
  moments.Volume = values[0];
  moments.VolumeBound = bounds[0];
  std::copy(values + 1, values + 4, moments.First.begin());
  std::copy(values + 4, values + 10, moments.Second.begin());
  std::copy(bounds + 1, bounds + 4, moments.FirstBound.begin());
  std::copy(bounds + 4, bounds + 10, moments.SecondBound.begin());
  if (moments.Volume < 0.0)
  {
    moments.Negate();
  }
  const MassProperties derived = ComputeMassProperties(moments);
  return { derived.Volume, derived.VolumeBound, derived.Center, derived.CenterBound, derived.Inertia,
    derived.InertiaBound, derived.Principal, derived.PrincipalBound };
}
}
