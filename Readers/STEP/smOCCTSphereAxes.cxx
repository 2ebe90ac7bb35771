#include "smOCCTSphereAxes.h"

#include <BRep_Tool.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
namespace
{
using Point2 = std::array<double, 2>;

/// Part of the square of a loop's length in the parameters below which its area is rounding.
constexpr double NoArea = 1e-9;

/// Distance of the ends of a seam from opposite points of its sphere, relative to the radius.
constexpr double SeamTolerance = 1e-6;

/// Returns twice the signed area of a loop in the parameters, of its curves at some points; 0 if that may be
/// rounding, as for a seam whose both sides have the same place.
double GetLoopArea(const DraftLoop& loop)
{
  constexpr int segments = 16;
  const Point2 origin = loop[0].GetStartPoint();
  Point2 last = origin;
  double area = 0.0;
  double length = 0.0;
  for (const DraftCoedge& coedge : loop)
  {
    for (int i = 0; i <= segments; ++i)
    {
      const double x = static_cast<double>(coedge.Reversed ? segments - i : i) / segments;
      const Point2 p = coedge.Trim.Evaluate((1.0 - x) * coedge.Trim.First + x * coedge.Trim.Last);
      area += (last[0] - origin[0]) * (p[1] - origin[1]) - (last[1] - origin[1]) * (p[0] - origin[0]);
      length += std::hypot(p[0] - last[0], p[1] - last[1]);
      last = p;
    }
  }
  return std::abs(area) > NoArea * length * length ? area : 0.0;
}

/// Returns true if a loop has a seam from one point of a sphere to the opposite one, and sets the axis
/// through them.
bool FindSeamAxis(
  const DraftFace& face, const Handle(Geom_SphericalSurface) & sphere, const DraftLoop& loop, gp_Dir& axis)
{
  const gp_Pnt center = sphere->Location();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const DraftCoedge& coedge = loop[i];
    const bool isSeam = std::any_of(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, loop.end(),
      [&coedge](const DraftCoedge& other) { return other.EdgeIndex == coedge.EdgeIndex; });
    if (isSeam && !coedge.Start.IsNull() && !coedge.End.IsNull())
    {
      const gp_Trsf placement = face.Location.Inverted();
      const gp_Vec start(center, BRep_Tool::Pnt(coedge.Start).Transformed(placement));
      const gp_Vec end(center, BRep_Tool::Pnt(coedge.End).Transformed(placement));
      if ((start + end).Magnitude() <= SeamTolerance * sphere->Radius() && start.Magnitude() > 0.0)
      {
        axis = gp_Dir(start);
        return true;
      }
    }
  }
  return false;
}

/// Returns the direction of a loop's vector area; it is the axis of a loop that is a circle.
bool FindLoopAxis(const DraftFace& face, const gp_Pnt& center, const DraftLoop& loop, gp_Dir& axis)
{
  constexpr int segments = 16;
  gp_XYZ area(0.0, 0.0, 0.0);
  gp_XYZ first;
  gp_XYZ last;
  bool isFirst = true;
  for (const DraftCoedge& coedge : loop)
  {
    TopLoc_Location location;
    double range[2];
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(coedge.Edge, location, range[0], range[1]);
    if (curve.IsNull())
    {
      continue;
    }
    const gp_Trsf placement = face.Location.Inverted() * location.Transformation();
    for (int i = 0; i <= segments; ++i)
    {
      const double x = static_cast<double>(coedge.Reversed ? segments - i : i) / segments;
      const gp_XYZ p =
        curve->Value((1.0 - x) * range[0] + x * range[1]).Transformed(placement).XYZ() - center.XYZ();
      first = isFirst ? p : first;
      area += isFirst ? gp_XYZ(0.0, 0.0, 0.0) : (last - first).Crossed(p - first);
      last = p;
      isFirst = false;
    }
  }
  if (!(area.Modulus() > 0.0))
  {
    return false;
  }
  axis = gp_Dir(area);
  return true;
}
}

Handle(Geom_Surface) TurnSphere(const Handle(Geom_SphericalSurface) & sphere, const gp_Dir& axis)
{
  const gp_Ax3& from = sphere->Position();
  gp_Ax3 frame(from.Location(), axis);
  if (!from.Direct())
  {
    frame.YReverse();
  }
  return new Geom_SphericalSurface(frame, sphere->Radius());
}

bool HasOnlyHoles(const DraftFace& face)
{
  double largest = 0.0;
  for (const DraftLoop& loop : face.Loops)
  {
    const double area = GetLoopArea(loop);
    largest = std::abs(area) > std::abs(largest) ? area : largest;
  }
  return !face.Loops.empty() && largest <= 0.0;
}

std::vector<gp_Dir> ListSphereAxes(const DraftFace& face, const Handle(Geom_SphericalSurface) & sphere)
{
  const gp_Ax3& frame = sphere->Position();
  std::vector<gp_Dir> axes;
  for (const DraftLoop& loop : face.Loops)
  {
    gp_Dir axis;
    if (FindSeamAxis(face, sphere, loop, axis))
    {
      axes.insert(axes.begin(), axis);
    }
    else if (axes.size() < 4 && FindLoopAxis(face, frame.Location(), loop, axis))
    {
      axes.push_back(axis);
    }
  }
  for (const auto& [x, y, z] :
    { std::array<double, 3>{ 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 1 }, { -1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 } })
  {
    axes.emplace_back(
      x * frame.XDirection().XYZ() + y * frame.YDirection().XYZ() + z * frame.Direction().XYZ());
  }
  return axes;
}
}
