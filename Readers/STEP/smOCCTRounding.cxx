#include "smOCCTRounding.h"

#include "smOCCTSurface.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Roundings of a coordinate as it stands in the file: its decimals, and the subtraction of the origin.
constexpr int Plain = 2;
// By another output unit, and its factor.
constexpr int Scaled = 2;
// By a rotation: entries of the matrix, which come from normalized directions and products of placements, and three products each.
constexpr int Rotated = 16;
// By a profile's distance from its axis, or an offset.
constexpr int Profiled = 6;
// Of lengths seen from a frame: directions are normalized, made orthogonal, mapped, and multiplied by sines and cosines.
constexpr int Framed = 16;
// Of distances between control points, when weights are rounded.
constexpr int Weighted = 4;

Vector3 GetPoint(const std::array<double, 4>& h)
{
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

/// The point from which the surface is built, where there is one.
bool GetFrame(const Handle(Geom_Surface) & surface, const AffineMap& map, Vector3& location)
{
  if (const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface))
  {
    location = map.MapPoint(elementary->Location().XYZ());
    return true;
  }
  if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
  {
    location = map.MapPoint(revolution->Location().XYZ());
    return true;
  }
  return false;
}

bool IsRotated(const AffineMap& map)
{
  const double scale = std::abs(map.Linear[0][0]);
  bool rotated = false;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      rotated = rotated || map.Linear[i][j] != (i == j ? scale : 0.0);
    }
  }
  return rotated;
}

/**
 * A bound of sum_j |dS/dt_j| over the knots t_j of one direction. The derivative by a knot is a B-spline whose coefficients are
 * differences (P_(i+1) - P_i) / (t_(i+p+1) - t_(i+1)) of neighbours, at most p of them for a knot, and p knots before and after a
 * point matter to it; with weights, of homogeneous points seen from the surface, over the least weight.
 */
double GetKnotSlope(const NURBSSurface& surface, int direction, double diameter)
{
  const int p = surface.Degree[direction];
  const int count = surface.NumberOfControlPoints[direction];
  const std::size_t stride = direction == 0 ? 1 : static_cast<std::size_t>(surface.NumberOfControlPoints[0]);
  const std::vector<double>& knots = surface.Knots[direction];
  double least = surface.ControlPoints[0][3];
  for (const std::array<double, 4>& h : surface.ControlPoints)
  {
    least = std::min(least, h[3]);
  }
  double slope = 0.0;
  for (std::size_t k = 0; k + stride < surface.ControlPoints.size(); ++k)
  {
    const int i = static_cast<int>(k / stride) % count;
    const double width = i + 1 < count ? knots[i + p + 1] - knots[i + 1] : 0.0;
    if (width > 0.0)
    {
      const std::array<double, 4>& a = surface.ControlPoints[k];
      const std::array<double, 4>& b = surface.ControlPoints[k + stride];
      const double step = b[3] * Norm(Subtract(GetPoint(b), GetPoint(a))) + std::abs(b[3] - a[3]) * diameter;
      slope = std::max(slope, step / (least * width));
    }
  }
  return 2.0 * p * slope;
}

/// What rounding of weights and knots moves a spline by, in u.
double GetSplineRounding(const NURBSSurface& surface, double diameter)
{
  double rounding = surface.Rational ? Weighted * diameter : 0.0;
  for (int d = 0; d < 2; ++d)
  {
    const double knot = std::max(std::abs(surface.Knots[d].front()), std::abs(surface.Knots[d].back()));
    rounding += knot * GetKnotSlope(surface, d, diameter);
  }
  return rounding;
}
}

std::array<double, 3> GetReadingRounding(const Handle(Geom_Surface) & source, const AffineMap& map,
  const double origin[3], int roundings, const NURBSSurface& converted)
{
  const Handle(Geom_Surface) surface = GetBasisSurface(source);
  Vector3 location{};
  const bool framed = GetFrame(surface, map, location);
  Vector3 reach{};
  Vector3 low = GetPoint(converted.ControlPoints[0]);
  Vector3 high = low;
  double fromFrame = 0.0;
  for (const std::array<double, 4>& h : converted.ControlPoints)
  {
    const Vector3 point = GetPoint(h);
    fromFrame = framed ? std::max(fromFrame, Norm(Subtract(point, location))) : 0.0;
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], point[c]);
      high[c] = std::max(high[c], point[c]);
    }
  }
  const bool spline =
    surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) || surface->IsKind(STANDARD_TYPE(Geom_BezierSurface));
  const bool rotated = IsRotated(map);
  const int steps = Plain + roundings + (map.GetScale() != 1.0 ? Scaled : 0) + (rotated ? Rotated : 0) +
    (spline || surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface)) ? 0 : Profiled);
  for (int c = 0; c < 3; ++c)
  {
    reach[c] = std::max(std::abs(low[c] + origin[c]), std::abs(high[c] + origin[c]));
    reach[c] = std::max(reach[c], framed ? std::abs(location[c] + origin[c]) : 0.0);
    // A point may come from the other side of its placement's translation.
    reach[c] += 2.0 * std::abs(map.Translation[c] + origin[c]);
  }
  const double far = Norm(reach);
  const double near =
    Framed * fromFrame + (spline ? GetSplineRounding(converted, Norm(Subtract(high, low))) : 0.0);
  Vector3 rounding;
  for (int c = 0; c < 3; ++c)
  {
    rounding[c] = UnitRoundoff * (steps * (rotated ? far : reach[c]) + near);
  }
  return rounding;
}
}
