#include "smReadingError.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Average over s of the bound below of |dS/ds| moved, over p d.
double GetSpread(const Patch& patch)
{
  const double ratio = patch.WeightRatio;
  return ratio > 1.0 ? 4.0 * ratio / (ratio - 1.0) * std::log(0.5 * (ratio + 1.0)) : 2.0;
}
}

/**
 * With control points moved by d_i, |d_i| <= d, and D the displacement here, a step w_(i+1) d_(i+1) - w_i d_i
 * - (w_(i+1) - w_i) D is at most 2 d max(w_i, w_(i+1)), and dS/ds is moved by at most p sum B_i^(p-1) of
 * these over w = sum B_i^(p-1) ((1-s) w_i + s w_(i+1)). With weights of neighbours up to q apart that is 2 p
 * d q / (1 + (q - 1) min(s, 1-s)), on average over s 4 p d q / (q - 1) ln((q + 1) / 2); without weights 2 p
 * d. A curve in r is no longer than its control polygon, at most 2 q rc. Sr likewise.
 */
double GetRotatedLength(const Patch& patch)
{
  const double length[2] = { std::min(patch.Stretch[0], 2.0 * patch.Degree[0] * patch.Radius),
    std::min(patch.Stretch[1], 2.0 * patch.Degree[1] * patch.Radius) };
  return GetSpread(patch) * (patch.Degree[0] * length[1] + patch.Degree[1] * length[0]);
}

ReadingError ReadingError::Make(const Face& face, const FacePanels& panels, double reach)
{
  ReadingError error;
  const std::array<double, 3>& d = face.Surface.Rounding;
  error.Moved = Norm(d);
  error.Reach = reach + error.Moved;
  if (!(error.Moved > 0.0))
  {
    return error;
  }
  // The part of the face beyond its patches, where the surface is continued.
  error.Swept = error.Moved * panels.Outside.Area;
  double rotated = 0.0;
  for (const Patch& patch : panels.Patches)
  {
    error.Swept += d[0] * patch.Normal[0] + d[1] * patch.Normal[1] + d[2] * patch.Normal[2];
    // |d_s| |d_r|: the bound of the one depends on s alone, that of the other on r.
    const double spread = GetSpread(patch);
    rotated += GetRotatedLength(patch) + error.Moved * spread * spread * patch.Degree[0] * patch.Degree[1];
  }
  // Second-order term: the change of the normals during the displacement.
  error.Swept += error.Moved * error.Moved * rotated;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      // The curve is no longer than its control polygon, of which either end moves.
      const std::vector<EdgeCurve::Point>& points = coedge.Use->Curve.Coefficients;
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        error.Border += Norm(Subtract(points[i], points[i - 1])) + 2.0 * error.Moved;
      }
    }
  }
  error.Area = error.Moved * (rotated + error.Border);
  return error;
}

double ReadingError::GetBound(const BoundClass& integrand, double area, double gaps) const
{
  if (!(this->Moved > 0.0))
  {
    return 0.0;
  }
  const double power = std::pow(this->Reach, integrand.Degree);
  switch (integrand.Kind)
  {
    case BoundClass::VolumeMoment:
    case BoundClass::HeightMoment:
      // Each of the two is a bound by itself. Both borders of a ribbon move independently, so it may also
      // widen by twice the displacement.
      return power *
        (std::fmin(this->Moved * (area + this->Area), this->Swept) +
          this->Moved * (gaps + 2.0 * this->Moved * this->Border));
    case BoundClass::AreaMoment:
      return power * this->Area +
        (integrand.Degree > 0
            ? integrand.Degree * this->Moved * std::pow(this->Reach, integrand.Degree - 1) * area
            : 0.0);
    default:
      // The vector area depends on the border alone.
      return this->Moved * this->Border;
  }
}
}
