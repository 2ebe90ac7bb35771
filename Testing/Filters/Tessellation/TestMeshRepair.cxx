// The repair of a mesh: a fan in which every exchange of a diagonal makes a deviation 1.4 times as large.
#include "smMeshRepair.h"
#include "smTesting.h"

namespace
{
using namespace smtest;
using Corners = sm::MeshRepair::Corners;

constexpr int Count = 12;
constexpr double First = 2.0;
constexpr double Growth = 1.4;

/// Triangles at vertex 0 are inverted and err the more the farther their other corners are from each
/// other.
bool IsAtCenter(const Corners& t)
{
  return std::min({ t[0], t[1], t[2] }) == 0;
}

double GetDeviation(const Corners& t)
{
  const int low = std::max(std::min(t[0], t[1]), std::min(std::max(t[0], t[1]), t[2]));
  const int high = std::max({ t[0], t[1], t[2] });
  return IsAtCenter(t) ? First * std::pow(Growth, high - low - 1) : 0.0;
}
}

int TestMeshRepair(int, char*[])
{
  std::vector<sm::GridPoint> points;
  std::map<std::pair<int, int>, int> segments;
  std::vector<Corners> triangles;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / Count;
    points.push_back(
      { std::llround(1e8 * (2.0 + std::cos(angle))), std::llround(1e8 * (2.0 + std::sin(angle))) });
    segments[{ std::min(i, (i + 1) % Count), std::max(i, (i + 1) % Count) }] = i;
    if (i > 0 && i + 1 < Count)
    {
      triangles.push_back({ 0, i, i + 1 });
    }
  }
  const sm::MeshRepair::TriangleTests tests{ IsAtCenter, GetDeviation };
  sm::MeshRepair repair(triangles, points, segments, tests, 1.0);
  const std::size_t left = repair.Run().size();
  double largest = 0.0;
  std::int64_t area = 0;
  for (const Corners& t : triangles)
  {
    largest = std::max(largest, GetDeviation(t));
    area += sm::Orient(points[t[0]], points[t[1]], points[t[2]]);
  }
  std::int64_t whole = 0;
  for (int i = 0; i < Count; ++i)
  {
    whole += sm::Orient({ 0, 0 }, points[i], points[(i + 1) % Count]);
  }
  CheckEqual("area", whole, area);
  CheckRange("triangles that are left inverted", 1.0, static_cast<double>(left), 9.0, "of 10");
  CheckRange(
    "largest deviation", First, largest, 1.5 * First, "half as much again as before, whatever is repaired");
  return Finish();
}
