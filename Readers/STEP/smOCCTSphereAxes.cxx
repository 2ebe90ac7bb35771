#include "smOCCTSphereAxes.h"

#include <BRep_Tool.hxx>

#include <array>
#include <cmath>

namespace sm
{
namespace
{
using Point2 = std::array<double, 2>;

/// Returns twice the signed area of a loop in the parameters, of its curves at some points.
double GetLoopArea(const DraftLoop& loop)
{
  constexpr int segments = 16;
  const Point2 origin = loop[0].GetStartPoint();
  Point2 last = origin;
  double area = 0.0;
  for (const DraftCoedge& coedge : loop)
  {
    for (int i = 0; i <= segments; ++i)
    {
      const double x = static_cast<double>(coedge.Reversed ? segments - i : i) / segments;
      const Point2 p = coedge.Trim.Evaluate((1.0 - x) * coedge.Trim.First + x * coedge.Trim.Last);
      area += (last[0] - origin[0]) * (p[1] - origin[1]) - (last[1] - origin[1]) * (p[0] - origin[0]);
      last = p;
    }
  }
  return area;
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
  return largest < 0.0;
}

std::vector<gp_Dir> ListSphereAxes(const DraftFace& face, const Handle(Geom_SphericalSurface) & sphere)
{
  const gp_Ax3& frame = sphere->Position();
  std::vector<gp_Dir> axes;
  for (const DraftLoop& loop : face.Loops)
  {
    gp_Dir axis;
    if (axes.size() < 4 && FindLoopAxis(face, frame.Location(), loop, axis))
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
