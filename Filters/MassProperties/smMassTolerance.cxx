#include "smMassTolerance.h"

#include "smBodyIntegrals.h"
#include "smBodyScales.h"
#include "smFormat.h"
#include "smMassPropertyNames.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// The ball has the smallest trace of inertia of all bodies of volume V: 6/5 (3 / (4 pi))^(2/3) V^(5/3) > 0.46
// V^(5/3).
constexpr double MinInertia = 0.46;
// The vector area is not a result. The closure residual is computed from it, and must show the openings of
// the model rather than the error of the quadrature.
constexpr double VectorAreaFactor = 1e-2;
}

std::vector<double> ShareTolerance(const MassTolerance& tolerance, vtkTrimmedNURBSModel& model)
{
  const double v = GetVolumeScale(model);
  const double length = std::cbrt(v);
  const double radius = std::max(GetRadius(model), length);
  const double inertia = tolerance.Inertia.Get(MinInertia * v * length * length);
  const double center = tolerance.Center.Get(length);
  // Let b, b_i, b_ij be the bounds of V, of first and of second moments, and |c| <= radius. The bound of the
  // centre is (b_i + |c| b) / V and that of the inertia at most 2 (b_ij + 2 |c| b_i + |c|^2 b), see
  // smMoments.h: no term gets more than half of its tolerance, so that together they remain below it.
  std::vector<double> tolerances(NumberOfMassIntegrands);
  tolerances[MassVolume] = std::min(
    { 0.5 * tolerance.Volume.Get(v), 0.25 * center * v / radius, 0.05 * inertia / (radius * radius) });
  for (int i = 0; i < 3; ++i)
  {
    tolerances[MassFirst + i] = std::min(0.4 * center * v, 0.05 * inertia / radius);
    tolerances[MassVectorArea + i] = VectorAreaFactor * tolerance.Volume.Get(v) / length;
  }
  for (int i = 0; i < 6; ++i)
  {
    tolerances[MassSecond + i] = 0.1 * inertia;
  }
  tolerances[MassArea] = 0.5 * tolerance.Area.Get(GetAreaScale(model));
  return tolerances;
}

std::string FindUnmet(const MassRow& row, const MassTolerance& tolerance, double radius)
{
  const MassProperties& p = row.Properties;
  // At a great distance from the origin, the roundoff of the centre's coordinates exceeds the tolerance that
  // follows from the body's size.
  const double length =
    std::max({ std::cbrt(p.Volume), radius, 1e-6 * std::hypot(p.Center[0], p.Center[1], p.Center[2]) });
  const struct
  {
    const char* Name;
    double Bound;
    double Scale;
    const Tolerance& Asked;
  } quantities[] = { { names::Volume, p.VolumeBound, p.Volume, tolerance.Volume },
    { names::SurfaceArea, row.AreaBound, row.Area, tolerance.Area },
    { names::CenterOfMass, p.CenterBound, length, tolerance.Center },
    { names::VolumeInertia, p.InertiaBound, p.Inertia[0] + p.Inertia[4] + p.Inertia[8], tolerance.Inertia } };
  std::string unmet;
  for (const auto& quantity : quantities)
  {
    const double scale = std::abs(quantity.Scale);
    if (!std::isnan(scale) && !(quantity.Bound <= quantity.Asked.Get(scale) && std::isfinite(quantity.Bound)))
    {
      const double ratio = quantity.Bound / scale;
      unmet += (unmet.empty() ? "" : ", ") + std::string(quantity.Name) + " " +
        (std::isfinite(ratio) ? FormatBound(ratio) : std::string("not bounded"));
    }
  }
  return unmet;
}
}
