#include "Detail/smOffsetParts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace sm
{
namespace
{
/// Step on either side of a line, relative to the range of the parameter.
constexpr double SideStep = 1e-6;
/// Points of a line on each of its spans.
constexpr int LineNodes = 8;
/// Points of a border belong together if they are no farther apart, relative to the surface's size.
constexpr double SamePoint = 1e-9;
/// Ends of a crease at which others meet it: each adds at most so much to the integral of the curvatures'
/// product, in its angle.
constexpr double CreaseEnds = 6.0 * MaxOffsetWay * MaxOffsetWay;
/// Normals around a pole may differ from their mean by so much, as one less the product.
constexpr double SmoothPole = 1e-8;

/// Lines of a surface along which one parameter is constant.
class LineProbe
{
public:
  /// `direction` is that of the line.
  LineProbe(const NURBSSurface& surface, int direction)
    : Surface(surface)
    , Direction(direction)
    , Step(SideStep * (surface.GetDomainEnd(1 - direction) - surface.GetDomainStart(1 - direction)))
  {
    const std::vector<double> breaks = surface.GetSpanBreaks(direction);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      for (int i = 0; i < LineNodes; ++i)
      {
        this->Along.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * (i + 0.5) / LineNodes);
      }
    }
  }

  std::vector<Vector3> GetPoints(double at) const
  {
    std::vector<Vector3> points;
    for (const double along : this->Along)
    {
      points.push_back(this->Evaluate(along, at, nullptr));
    }
    return points;
  }

  /// Normals as they are on one side of the line, by extrapolation from two points there; `side` is 1 or -1.
  std::vector<Vector3> GetNormals(double at, double side) const
  {
    std::vector<Vector3> normals;
    for (const double along : this->Along)
    {
      Vector3 near;
      Vector3 far;
      this->Evaluate(along, at + side * this->Step, &near);
      this->Evaluate(along, at + 2.0 * side * this->Step, &far);
      for (int d = 0; d < 3; ++d)
      {
        near[d] = 2.0 * near[d] - far[d];
      }
      normals.push_back(Norm(near) > 0.0 ? Normalized(near) : Vector3{});
    }
    return normals;
  }

private:
  Vector3 Evaluate(double along, double at, Vector3* normal) const
  {
    Vector3 point;
    Vector3 du;
    Vector3 dv;
    this->Surface.Evaluate(this->Direction == 0 ? along : at, this->Direction == 0 ? at : along, point.data(),
      du.data(), dv.data());
    if (normal)
    {
      const Vector3 cross = Cross(du, dv);
      *normal = Norm(cross) > 0.0 ? Normalized(cross) : Vector3{};
    }
    return point;
  }

  const NURBSSurface& Surface;
  int Direction;
  double Step;
  std::vector<double> Along;
};

double GetExtent(const std::vector<Vector3>& points, const std::vector<Vector3>& others)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    largest = std::max(largest, Norm(Subtract(points[i], others[i])));
  }
  return largest;
}

/// Returns the largest angle between the normals on both sides; infinity where one is missing.
double GetMaxTurn(const std::vector<Vector3>& normals, const std::vector<Vector3>& others)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const double turn = std::atan2(Norm(Cross(normals[i], others[i])), Dot(normals[i], others[i]));
    if (!(Norm(normals[i]) > 0.0 && Norm(others[i]) > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::max(largest, turn);
  }
  return largest;
}

bool IsSmoothPole(const std::vector<Vector3>& normals)
{
  Vector3 sum{};
  for (const Vector3& normal : normals)
  {
    for (int d = 0; d < 3; ++d)
    {
      sum[d] += normal[d];
    }
  }
  const double size = Norm(sum);
  return size > 0.0 &&
    std::all_of(normals.begin(), normals.end(),
      [&](const Vector3& normal) { return Dot(normal, sum) >= (1.0 - SmoothPole) * size; });
}

/// Adds a line at which normals turn by no more than `turn`.
void AddTurn(OffsetFace& face, double turn, double length)
{
  // The kite has the area t^2 tan(turn / 2), which is half of t^2 turn except for 0.01 %. The largest turn at
  // points counts one and a half times.
  face.MeanError += 1.5 * turn * length;
  face.GaussError += 3.0 * CreaseEnds * turn;
}

/// Returns no less than the length of any line in this direction: that of a rational curve with positive
/// weights is at most that of its control polygon, whose points are in the hulls of the rows.
double GetLineLength(const NURBSSurface& surface, int direction)
{
  const int n = surface.NumberOfControlPoints[0];
  const auto get = [&](int i, int j)
  {
    const auto& h = surface.ControlPoints[static_cast<std::size_t>(direction == 0 ? i + j * n : j + i * n)];
    return Vector3{ h[0] / h[3], h[1] / h[3], h[2] / h[3] };
  };
  double sum = 0.0;
  for (int i = 0; i + 1 < surface.NumberOfControlPoints[direction]; ++i)
  {
    double longest = 0.0;
    for (int j = 0; j < surface.NumberOfControlPoints[1 - direction]; ++j)
    {
      for (int k = 0; k < surface.NumberOfControlPoints[1 - direction]; ++k)
      {
        longest = std::max(longest, Norm(Subtract(get(i + 1, k), get(i, j))));
      }
    }
    sum += longest;
  }
  return sum;
}

/// Checks the borders of a face without loops across a direction.
void CheckBorders(const NURBSSurface& surface, int direction, OffsetFace& face)
{
  const int other = 1 - direction;
  const LineProbe probe(surface, direction);
  const double ends[2] = { surface.GetDomainStart(other), surface.GetDomainEnd(other) };
  const std::vector<Vector3> lines[2] = { probe.GetPoints(ends[0]), probe.GetPoints(ends[1]) };
  const std::vector<Vector3> middle = probe.GetPoints(0.5 * (ends[0] + ends[1]));
  const double size = std::max(
    GetExtent(middle, lines[0]), GetExtent(middle, std::vector<Vector3>(middle.size(), middle.front())));
  const auto isPole = [&](const std::vector<Vector3>& line)
  { return GetExtent(line, std::vector<Vector3>(line.size(), line.front())) <= SamePoint * size; };
  const bool poles[2] = { isPole(lines[0]), isPole(lines[1]) };
  if (!poles[0] && !poles[1] && GetExtent(lines[0], lines[1]) <= SamePoint * size)
  {
    const double turn = GetMaxTurn(probe.GetNormals(ends[0], 1.0), probe.GetNormals(ends[1], -1.0));
    face.IsCreased = face.IsCreased || !(turn <= MaxCrease);
    AddTurn(face, std::min(turn, MaxCrease), GetLineLength(surface, direction));
    return;
  }
  for (int i = 0; i < 2; ++i)
  {
    face.IsCreased =
      face.IsCreased || !poles[i] || !IsSmoothPole(probe.GetNormals(ends[i], i == 0 ? 1.0 : -1.0));
  }
}
}

void FindCreases(const Face& source, OffsetFace& face)
{
  const NURBSSurface& surface = source.Surface;
  for (int direction = 0; direction < 2; ++direction)
  {
    const int across = 1 - direction;
    if (source.Loops.empty())
    {
      CheckBorders(surface, direction, face);
    }
    const std::vector<double> breaks = surface.GetSpanBreaks(across);
    const LineProbe probe(surface, direction);
    for (std::size_t k = 1; !face.IsFlat && k + 1 < breaks.size(); ++k)
    {
      const auto count = std::count(surface.Knots[across].begin(), surface.Knots[across].end(), breaks[k]);
      if (count >= surface.Degree[across])
      {
        const double turn = GetMaxTurn(probe.GetNormals(breaks[k], -1.0), probe.GetNormals(breaks[k], 1.0));
        face.IsCreased = face.IsCreased || !(turn <= MaxCrease);
        AddTurn(face, std::min(turn, MaxCrease), GetLineLength(surface, direction));
      }
    }
  }
}
}
