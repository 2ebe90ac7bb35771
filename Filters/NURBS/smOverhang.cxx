#include "smOverhang.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sm
{
namespace
{
// A curve is divided into so many parts, whose control points bound its extent.
constexpr int Parts = 16;

/// Distance of x from the interval [low, high]; 0 inside.
double GetBeyond(double x, double low, double high)
{
  return std::max({ low - x, x - high, 0.0 });
}

/// The coefficients on [start,end], by de Casteljau's scheme.
std::vector<Point2> Restrict(const BernsteinPiece<2>& curve, double start, double end)
{
  std::vector<Point2> b(curve.Coefficients, curve.Coefficients + curve.Degree + 1);
  const auto cut = [&b](double x, bool keepLeft)
  {
    const std::size_t n = b.size();
    for (std::size_t level = 1; level < n; ++level)
    {
      for (std::size_t k = 0; k + level < n; ++k)
      {
        // On the way to the left part the finished coefficients are the first ones, else the last ones.
        const std::size_t i = keepLeft ? n - 1 - k : k;
        const Point2& one = keepLeft ? b[i - 1] : b[i];
        const Point2& other = keepLeft ? b[i] : b[i + 1];
        b[i] = { one[0] + x * (other[0] - one[0]), one[1] + x * (other[1] - one[1]) };
      }
    }
  };
  cut(end, true);
  cut(end > 0.0 ? start / end : 0.0, false);
  return b;
}

/// Bounds of |S_s| and |S_r| on the patch continued by a in s and b in r.
Point2 BoundDerivatives(const Patch& patch, const std::array<double, 4>* points, const Point2& beyond)
{
  const int row = patch.Degree[0] + 1;
  const int count = row * (patch.Degree[1] + 1);
  double weight = std::numeric_limits<double>::infinity();
  double position = 0.0;
  double step[2] = { 0.0, 0.0 };
  double turn[2] = { 0.0, 0.0 };
  for (int i = 0; i < count; ++i)
  {
    const std::array<double, 4>& p = points[i];
    weight = std::min(weight, p[3]);
    position = std::max(position, std::hypot(p[0], p[1], p[2]));
    for (int d = 0; d < 2; ++d)
    {
      if (d == 0 ? i % row + 1 < row : i + row < count)
      {
        const std::array<double, 4>& q = points[d == 0 ? i + 1 : i + row];
        step[d] = std::max(step[d], patch.Degree[d] * std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
        turn[d] = std::max(turn[d], patch.Degree[d] * std::abs(q[3] - p[3]));
      }
    }
  }
  const double growth =
    std::pow(1.0 + 2.0 * beyond[0], patch.Degree[0]) * std::pow(1.0 + 2.0 * beyond[1], patch.Degree[1]);
  weight -= growth * (turn[0] * beyond[0] + turn[1] * beyond[1]);
  Point2 bounds;
  for (int d = 0; d < 2; ++d)
  {
    bounds[d] = weight > 0.0 ? growth * (step[d] + growth * position * turn[d] / weight) / weight
                             : std::numeric_limits<double>::infinity();
  }
  if (weight > 0.0)
  {
    const double degree = std::max(patch.Degree[0], patch.Degree[1]);
    const double fastest = std::max(bounds[0], bounds[1]);
    const double turns = std::max(turn[0], turn[1]);
    const double second = 2.0 * growth / weight *
      (degree * std::max(step[0], step[1]) + turns * fastest + degree * turns * growth * position / weight);
    for (int d = 0; d < 2; ++d)
    {
      bounds[d] = std::min(bounds[d], patch.Stretch[d] + second * (beyond[0] + beyond[1]));
    }
  }
  return bounds;
}
}

void Overhang::Add(const Overhang& other)
{
  this->Distance = std::max(this->Distance, other.Distance);
  this->Area += other.Area;
  this->Squared += other.Squared;
}

Overhang BoundOverhang(const Patch& patch, const std::array<double, 4>* points,
  const BernsteinPiece<2>& curve, double start, double end, const Point2& low, const Point2& high)
{
  Overhang sum;
  const bool inside = std::all_of(curve.Coefficients, curve.Coefficients + curve.Degree + 1,
    [&](const Point2& c)
    { return GetBeyond(c[0], low[0], high[0]) <= 0.0 && GetBeyond(c[1], low[1], high[1]) <= 0.0; });
  for (int part = 0; part < Parts && !inside; ++part)
  {
    const double step = (end - start) / Parts;
    const std::vector<Point2> b = Restrict(curve, start + part * step, start + (part + 1) * step);
    Point2 beyond{ 0.0, 0.0 };
    Point2 path{ 0.0, 0.0 };
    for (std::size_t i = 0; i < b.size(); ++i)
    {
      for (int d = 0; d < 2; ++d)
      {
        beyond[d] = std::max(beyond[d], GetBeyond(b[i][d], low[d], high[d]) / patch.Width[d]);
        path[d] += i > 0 ? std::abs(b[i][d] - b[i - 1][d]) / patch.Width[d] : 0.0;
      }
    }
    if (beyond[0] == 0.0 && beyond[1] == 0.0)
    {
      continue;
    }
    const Point2 speed = BoundDerivatives(patch, points, beyond);
    const auto measure = [&speed](const Point2& by)
    { return (by[0] > 0.0 ? by[0] * speed[0] : 0.0) + (by[1] > 0.0 ? by[1] * speed[1] : 0.0); };
    const double distance = measure(beyond);
    const double length = measure(path);
    const bool moves = path[0] > 0.0 || path[1] > 0.0;
    sum.Add({ distance, moves ? distance * length : 0.0, moves ? distance * distance * length : 0.0 });
  }
  return sum;
}

Face MoveTrimsInside(const Face& face)
{
  Face moved = face;
  const Point2 low{ face.Surface.GetSpanBreaks(0).front(), face.Surface.GetSpanBreaks(1).front() };
  const Point2 high{ face.Surface.GetSpanBreaks(0).back(), face.Surface.GetSpanBreaks(1).back() };
  for (Loop& loop : moved.Loops)
  {
    for (Coedge& coedge : loop.Coedges)
    {
      for (TrimCurve::Point& c : coedge.Curve.Coefficients)
      {
        c = { std::clamp(c[0], low[0], high[0]), std::clamp(c[1], low[1], high[1]) };
      }
    }
  }
  return moved;
}
}
