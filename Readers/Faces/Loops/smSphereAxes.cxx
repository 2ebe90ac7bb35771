#include "smSphereAxes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
namespace
{
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
  const DraftFace& face, const ElementarySurface& sphere, const DraftLoop& loop, Vector3& axis)
{
  const Placement toSurface = Invert(face.Location);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const DraftCoedge& coedge = loop[i];
    const bool isSeam = std::any_of(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, loop.end(),
      [&coedge](const DraftCoedge& other) { return other.EdgeIndex == coedge.EdgeIndex; });
    if (isSeam && coedge.Start && coedge.End)
    {
      const Vector3 start = Subtract(toSurface.MapPoint(coedge.Start->Point), sphere.Frame.Origin);
      const Vector3 end = Subtract(toSurface.MapPoint(coedge.End->Point), sphere.Frame.Origin);
      if (Norm(Sum(start, end)) <= SeamTolerance * sphere.Radii[0] && Norm(start) > 0.0)
      {
        axis = Normalized(start);
        return true;
      }
    }
  }
  return false;
}

/// Returns the direction of a loop's vector area; it is the axis of a loop that is a circle.
bool FindLoopAxis(const DraftFace& face, const Vector3& center, const DraftLoop& loop, Vector3& axis)
{
  constexpr int segments = 16;
  const Placement toSurface = Invert(face.Location);
  Vector3 area{};
  Vector3 first{};
  Vector3 last{};
  bool isFirst = true;
  for (const DraftCoedge& coedge : loop)
  {
    for (int i = 0; i <= segments && coedge.Edge && coedge.Edge->Curve; ++i)
    {
      const double x = static_cast<double>(coedge.Reversed ? segments - i : i) / segments;
      const Vector3 p = Subtract(toSurface.MapPoint(coedge.Edge->EvaluateAt(x)), center);
      first = isFirst ? p : first;
      area = isFirst ? area : Sum(area, Cross(Subtract(last, first), Subtract(p, first)));
      last = p;
      isFirst = false;
    }
  }
  if (!(Norm(area) > 0.0))
  {
    return false;
  }
  axis = Normalized(area);
  return true;
}
}

SurfacePointer TurnSphere(const ElementarySurface& sphere, const Vector3& axis)
{
  ElementarySurface rotated = sphere;
  // X is normal to the two components of the axis that are larger in magnitude.
  const double a = std::abs(axis[0]);
  const double b = std::abs(axis[1]);
  const double c = std::abs(axis[2]);
  Vector3 x = b <= a && b <= c
    ? (a > c ? Vector3{ -axis[2], 0.0, axis[0] } : Vector3{ axis[2], 0.0, -axis[0] })
    : a <= b && a <= c ? (b > c ? Vector3{ 0.0, -axis[2], axis[1] } : Vector3{ 0.0, axis[2], -axis[1] })
                       : (a > b ? Vector3{ -axis[1], axis[0], 0.0 } : Vector3{ axis[1], -axis[0], 0.0 });
  x = Normalized(x);
  const double sign = Dot(Cross(sphere.Frame.Axes[0], sphere.Frame.Axes[1]), sphere.Frame.Axes[2]);
  rotated.Frame.Axes = { x, Multiply(sign > 0.0 ? 1.0 : -1.0, Cross(axis, x)), axis };
  std::string problem;
  return GeometricSurface::Make(rotated, problem);
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

std::vector<Vector3> ListSphereAxes(const DraftFace& face, const ElementarySurface& sphere)
{
  const std::array<Vector3, 3>& frame = sphere.Frame.Axes;
  std::vector<Vector3> axes;
  for (const DraftLoop& loop : face.Loops)
  {
    Vector3 axis;
    if (FindSeamAxis(face, sphere, loop, axis))
    {
      axes.insert(axes.begin(), axis);
    }
    else if (axes.size() < 4 && FindLoopAxis(face, sphere.Frame.Origin, loop, axis))
    {
      axes.push_back(axis);
    }
  }
  for (const auto& [x, y, z] :
    { std::array<double, 3>{ 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 1 }, { -1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 } })
  {
    axes.push_back(Normalized(Sum(Sum(Multiply(x, frame[0]), Multiply(y, frame[1])), Multiply(z, frame[2]))));
  }
  return axes;
}
}
