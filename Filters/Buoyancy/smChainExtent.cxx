#include "Detail/smChainExtent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sm
{
namespace
{
/// Range of heights above the plane.
struct HeightSpan
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  void Add(double height)
  {
    this->Low = std::min(this->Low, height);
    this->High = std::max(this->High, height);
  }
  /// Returns 1 or -1 if all heights are above or below the plane by more than the distance, else 0.
  int GetSide(double distance) const { return this->Low > distance ? 1 : this->High < -distance ? -1 : 0; }
};

/// Returns the side of the plane on which a patch is, see HeightSpan.
int FindSide(const FacePanels& panels, const Patch& patch, const HeightPlane& plane, double distance)
{
  const double middle = plane.GetHeight({ patch.Center[0], patch.Center[1], patch.Center[2] });
  if (std::abs(middle) > 2.0 * patch.Radius + distance)
  {
    return middle > 0.0 ? 1 : -1;
  }
  HeightSpan span;
  for (int i = 0; i < (patch.Degree[0] + 1) * (patch.Degree[1] + 1); ++i)
  {
    const std::array<double, 4>& p = panels.Points[patch.FirstPoint + i];
    span.Add(middle + (plane.Up[0] * p[0] + plane.Up[1] * p[1] + plane.Up[2] * p[2]) / p[3]);
  }
  return span.GetSide(distance);
}
}

double GetReach(const FacePanels& panels, const std::array<double, 3>& center)
{
  double reach = 0.0;
  const auto add = [&](const double* p, double radius)
  { reach = std::max(reach, std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]) + radius); };
  for (const Patch& patch : panels.Patches)
  {
    add(patch.Center, patch.Radius);
  }
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    for (int i = 0; i <= ribbon.EdgeDegree; ++i)
    {
      add(panels.Coefficients.data() + ribbon.Edge + 3 * i, 0.0);
    }
  }
  for (const Cap& cap : panels.Caps)
  {
    add(cap.Apex.data(), 0.0);
    add(cap.From.data(), 0.0);
    add(cap.To.data(), 0.0);
  }
  return reach;
}

double GetMaxArea(const FacePanels& panels, double stripArea)
{
  double area = stripArea;
  for (const Patch& patch : panels.Patches)
  {
    area += patch.Stretch[0] * patch.Stretch[1];
  }
  return area;
}

bool MayTouch(const FacePanels& panels, const HeightPlane& plane, double distance)
{
  std::vector<int> sides;
  for (const Patch& patch : panels.Patches)
  {
    sides.push_back(FindSide(panels, patch, plane, distance));
    if (sides.back() == 0)
    {
      return true;
    }
  }
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    HeightSpan span;
    for (int i = 0; i <= ribbon.EdgeDegree; ++i)
    {
      const double* p = panels.Coefficients.data() + ribbon.Edge + 3 * i;
      span.Add(plane.GetHeight({ p[0], p[1], p[2] }));
    }
    if (span.GetSide(distance) != sides[ribbon.Patch])
    {
      return true;
    }
  }
  return std::any_of(panels.Caps.begin(), panels.Caps.end(),
    [&](const Cap& cap)
    {
      HeightSpan span;
      span.Add(plane.GetHeight(cap.Apex));
      span.Add(plane.GetHeight(cap.From));
      span.Add(plane.GetHeight(cap.To));
      return span.GetSide(distance) == 0;
    });
}
}
