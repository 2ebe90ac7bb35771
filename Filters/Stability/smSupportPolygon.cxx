#include "Detail/smSupportPolygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Twice the signed area of the triangle a, b, c.
long double GetTurn(const Point2& a, const Point2& b, const Point2& c)
{
  return (static_cast<long double>(b[0]) - a[0]) * (static_cast<long double>(c[1]) - a[1]) -
    (static_cast<long double>(b[1]) - a[1]) * (static_cast<long double>(c[0]) - a[0]);
}

double GetDistance(const Point2& a, const Point2& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// Distance of b from the line through a and c, where these differ.
double GetHeight(const Point2& a, const Point2& b, const Point2& c)
{
  const double base = GetDistance(a, c);
  return base > 0.0 ? static_cast<double>(std::fabs(GetTurn(a, b, c))) / base : GetDistance(a, b);
}

/// The point of the segment that is nearest to p.
Point2 GetFoot(const Point2& a, const Point2& b, const Point2& p)
{
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double squared = dx * dx + dy * dy;
  const double x =
    squared > 0.0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / squared, 0.0, 1.0) : 0.0;
  return { a[0] + x * dx, a[1] + x * dy };
}

std::vector<Point2> MakeConvexHull(std::vector<Point2> points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return points;
  }
  std::vector<Point2> hull;
  const auto add = [&hull](const Point2& p, std::size_t bottom)
  {
    while (hull.size() >= bottom + 2 && GetTurn(hull[hull.size() - 2], hull.back(), p) <= 0.0L)
    {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point2& p : points)
  {
    add(p, 0);
  }
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p)
  {
    add(*p, lower);
  }
  hull.pop_back();
  return hull;
}
}

SupportPolygon SupportPolygon::FromPoints(std::vector<Point2> points, double merge)
{
  SupportPolygon polygon;
  std::vector<Point2>& corners = polygon.Corners;
  for (const Point2& p : MakeConvexHull(std::move(points)))
  {
    if (corners.empty() || GetDistance(corners.back(), p) > merge)
    {
      corners.push_back(p);
    }
  }
  while (corners.size() > 1 && GetDistance(corners.front(), corners.back()) <= merge)
  {
    corners.pop_back();
  }
  if (corners.size() < 3)
  {
    return polygon;
  }
  // A polygon that is nearly a segment becomes the segment between its tips.
  const auto [one, other] = polygon.GetTips();
  if (std::all_of(corners.begin(), corners.end(),
        [&, a = one, b = other](const Point2& p) { return GetHeight(a, p, b) <= merge; }))
  {
    corners = { one, other };
    return polygon;
  }
  // Corners that are nearly straight are left out one at a time, so that they stay close to the line that is
  // kept.
  std::vector<Point2> kept;
  // Largest distance outside of the points since the last one that was kept.
  double left = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point2& before = kept.empty() ? corners.back() : kept.back();
    const Point2& after = corners[(i + 1) % corners.size()];
    left += GetHeight(before, corners[i], after);
    if (left > merge)
    {
      kept.push_back(corners[i]);
      left = 0.0;
    }
  }
  if (kept.size() > 2)
  {
    corners = std::move(kept);
  }
  return polygon;
}

double SupportPolygon::GetMargin(const Point2& point) const
{
  const std::size_t count = this->Corners.size();
  if (count == 0)
  {
    return -std::numeric_limits<double>::infinity();
  }
  bool inside = count > 2;
  double margin = std::numeric_limits<double>::infinity();
  double distance = margin;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point2& a = this->Corners[i];
    const Point2& b = this->Corners[(i + 1) % count];
    distance = std::min(distance, GetDistance(point, GetFoot(a, b, point)));
    if (count > 2)
    {
      const double side = static_cast<double>(GetTurn(a, b, point)) / GetDistance(a, b);
      inside = inside && side >= 0.0;
      margin = std::min(margin, side);
    }
  }
  return inside ? margin : -distance;
}

std::vector<Point2> SupportPolygon::GetCriticalDirections(const Point2& point, double range) const
{
  std::vector<Point2> directions;
  const std::size_t count = this->Corners.size();
  const double margin = this->GetMargin(point);
  if (margin < 0.0 || count < 3)
  {
    // The direction from the nearest point to the point; where both coincide, the one across the segment.
    for (std::size_t i = 0; i < count; ++i)
    {
      const Point2& a = this->Corners[i];
      const Point2& b = this->Corners[(i + 1) % count];
      const Point2 foot = GetFoot(a, b, point);
      const double distance = GetDistance(foot, point);
      if (distance <= -margin + range && distance > 0.0)
      {
        directions.push_back({ (point[0] - foot[0]) / distance, (point[1] - foot[1]) / distance });
      }
    }
  }
  for (std::size_t i = 0; i < count && count > 1; ++i)
  {
    const Point2& a = this->Corners[i];
    const Point2& b = this->Corners[(i + 1) % count];
    const double length = GetDistance(a, b);
    if (static_cast<double>(GetTurn(a, b, point)) / length <= std::max(margin, 0.0) + range)
    {
      directions.push_back({ (b[1] - a[1]) / length, (a[0] - b[0]) / length });
    }
  }
  return directions;
}

double SupportPolygon::GetSupport(const Point2& direction) const
{
  double support = -std::numeric_limits<double>::infinity();
  for (const Point2& p : this->Corners)
  {
    support = std::max(support, p[0] * direction[0] + p[1] * direction[1]);
  }
  return support;
}

std::array<Point2, 2> SupportPolygon::GetTips() const
{
  const auto farthest = [this](const Point2& from)
  {
    return *std::max_element(this->Corners.begin(), this->Corners.end(),
      [&from](const Point2& a, const Point2& b) { return GetDistance(from, a) < GetDistance(from, b); });
  };
  const Point2 one = farthest(this->Corners.front());
  return { one, farthest(one) };
}

double SupportPolygon::GetLength() const
{
  if (this->Corners.empty())
  {
    return 0.0;
  }
  const std::array<Point2, 2> tips = this->GetTips();
  return GetDistance(tips[0], tips[1]);
}

double SupportPolygon::GetWidth() const
{
  if (this->Corners.size() < 3)
  {
    return 0.0;
  }
  const std::array<Point2, 2> tips = this->GetTips();
  const double length = GetDistance(tips[0], tips[1]);
  double low = 0.0;
  double high = 0.0;
  for (const Point2& p : this->Corners)
  {
    const double side = static_cast<double>(GetTurn(tips[0], tips[1], p)) / length;
    low = std::min(low, side);
    high = std::max(high, side);
  }
  return high - low;
}
}
