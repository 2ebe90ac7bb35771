#include "smSeamWay.h"

#include "smVector.h"

#include <cmath>

namespace sm
{
namespace
{
/// Number of segments that approximate a coedge's trim curve.
constexpr int TrimSegments = 8;

/// A point this close to the start of a line, relative to the line, is the start: a loop and its copy a
/// period away have different roundings.
constexpr double SamePoint = 1e-9;

/// Returns the sine of the angle between a line and the way from its start to a point.
double GetSide(const Point2& a, const Point2& b, const Point2& p)
{
  const double area = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double distance = std::hypot(p[0] - a[0], p[1] - a[1]);
  return distance > SamePoint * length ? area / (length * distance) : 0.0;
}

/// Returns true if the segment from c to d crosses the inside of the one from a to b; a point on the latter
/// counts as left of it.
bool AreCrossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  constexpr double limit = 1e-9;
  const double start = GetSide(c, d, a);
  const double end = GetSide(c, d, b);
  return (GetSide(a, b, c) > -limit) != (GetSide(a, b, d) > -limit) &&
    ((start > limit && end < -limit) || (start < -limit && end > limit));
}

/// Returns true if no loop, nor its copies in other periods, crosses the line.
bool IsFree(const DraftFace& face, const Point2& a, const Point2& b, int direction)
{
  const double period = face.Period[direction];
  for (const DraftLoop& loop : face.Loops)
  {
    for (const DraftCoedge& coedge : loop)
    {
      Point2 last{};
      for (int i = 0; i <= TrimSegments; ++i)
      {
        const double x = static_cast<double>(i) / TrimSegments;
        const Point2 p = coedge.Trim.Evaluate((1.0 - x) * coedge.Trim.First + x * coedge.Trim.Last);
        for (double k = -2.0; i > 0 && k <= 2.0; ++k)
        {
          Point2 from = last;
          Point2 to = p;
          from[direction] += k * period;
          to[direction] += k * period;
          if (AreCrossing(a, b, from, to))
          {
            return false;
          }
        }
        last = p;
      }
    }
  }
  return true;
}
}

std::vector<Point2> FindSeamWay(
  const DraftFace& face, const Point2& a, const Point2& b, int direction, bool isStraight)
{
  constexpr int detours = 8;
  std::vector<std::vector<Point2>> ways;
  if (isStraight)
  {
    ways.push_back({ a, b });
  }
  for (const double share : { 0.3, 0.1, 0.03 })
  {
    for (int k = 1; k < 2 * detours && !isStraight; ++k)
    {
      // Detours alternate between the two sides, the smaller ones first.
      const double aside = (k % 2 == 1 ? 0.5 : -0.5) * (k / 2 + k % 2) / detours * face.Period[direction];
      Point2 way[2];
      for (int i = 0; i < 2; ++i)
      {
        const double x = i == 0 ? share : 1.0 - share;
        way[i][1 - direction] = (1.0 - x) * a[1 - direction] + x * b[1 - direction];
        way[i][direction] = (1.0 - x) * a[direction] + x * b[direction] + aside;
      }
      ways.push_back({ a, way[0], way[1], b });
    }
  }
  for (const std::vector<Point2>& way : ways)
  {
    bool isFree = true;
    for (std::size_t i = 0; isFree && i + 1 < way.size(); ++i)
    {
      isFree = IsFree(face, way[i], way[i + 1], direction);
    }
    if (isFree)
    {
      return way;
    }
  }
  return {};
}
}
