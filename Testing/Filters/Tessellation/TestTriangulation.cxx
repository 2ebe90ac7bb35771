// The constrained triangulation against exact areas: polygons with holes, lines through vertices, and lines
// that cross.
#include "smTesting.h"
#include "smTriangulation.h"

#include <algorithm>
#include <random>

namespace
{
using namespace smtest;

constexpr std::int64_t Middle = sm::Triangulation::Extent / 2;

/// Twice the area inside; -1 where a triangle is not counter-clockwise or the neighbours contradict each
/// other.
std::int64_t GetInnerArea(const sm::Triangulation& mesh)
{
  std::int64_t area = 0;
  const auto& points = mesh.GetPoints();
  for (std::size_t i = 0; i < mesh.GetTriangles().size(); ++i)
  {
    const auto& t = mesh.GetTriangles()[i];
    const std::int64_t own = sm::Orient(points[t.Vertex[0]], points[t.Vertex[1]], points[t.Vertex[2]]);
    for (int k = 0; k < 3; ++k)
    {
      const int other = t.Sides[k].Neighbor;
      bool back = other < 0;
      for (int m = 0; !back && m < 3; ++m)
      {
        const auto& o = mesh.GetTriangles()[other];
        back = o.Sides[m].Neighbor == static_cast<int>(i) && o.Vertex[(m + 1) % 3] == t.Vertex[(k + 2) % 3] &&
          o.Vertex[(m + 2) % 3] == t.Vertex[(k + 1) % 3];
      }
      if (own <= 0 || !back)
      {
        return -1;
      }
    }
    area += t.Inside ? own : 0;
  }
  return area;
}

/// Inserts a closed polygon; returns twice its area, or 0 where a side was refused.
std::int64_t AddPolygon(sm::Triangulation& mesh, const std::vector<sm::GridPoint>& polygon, bool split)
{
  std::vector<int> ids;
  for (const sm::GridPoint& p : polygon)
  {
    ids.push_back(mesh.Insert(p, false));
  }
  std::int64_t area = 0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const std::size_t next = (i + 1) % ids.size();
    if (mesh.InsertSegment(ids[i], ids[next], static_cast<int>(i), split) != -1)
    {
      return 0;
    }
    area += sm::Orient({ Middle, Middle }, polygon[i], polygon[next]);
  }
  return area;
}

/// Around the middle, counter-clockwise, with spikes.
std::vector<sm::GridPoint> MakeStar(int count, double minimum, double maximum, std::mt19937& random)
{
  std::vector<sm::GridPoint> star;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    const double radius = std::uniform_real_distribution<double>(minimum, maximum)(random);
    star.push_back(
      { Middle + std::llround(radius * std::cos(angle)), Middle + std::llround(radius * std::sin(angle)) });
  }
  return star;
}

void CheckStars()
{
  std::mt19937 random(7);
  for (const int count : { 3, 8, 50, 1000 })
  {
    sm::Triangulation mesh({ 1.0, 0.3 });
    const auto outer = MakeStar(count, 2e8, 4e8, random);
    auto hole = MakeStar(count, 1e7, 1e8, random);
    std::reverse(hole.begin(), hole.end());
    const std::int64_t area = AddPolygon(mesh, outer, false) + AddPolygon(mesh, hole, false);
    mesh.MarkInside();
    CheckEqual("area of a star of " + std::to_string(count) + " with a hole", area, GetInnerArea(mesh));
    int refused = 0;
    for (int i = 0; i < 500; ++i)
    {
      std::uniform_int_distribution<std::int64_t> place(Middle - 400000000, Middle + 400000000);
      refused += mesh.Insert({ place(random), place(random) }, true) < 0 ? 1 : 0;
    }
    CheckEqual("and with points in it", area, GetInnerArea(mesh));
    CheckTrue("no point of 500 fell on a segment", refused < 3);
  }
}

void CheckCrossing()
{
  const std::int64_t a = 100000000;
  // A bow tie: its halves wind in opposite directions.
  const std::vector<sm::GridPoint> tie{ { Middle - a, Middle - a }, { Middle + a, Middle + a },
    { Middle + a, Middle - a }, { Middle - a, Middle + a } };
  sm::Triangulation whole({ 1.0, 1.0 });
  CheckEqual("a side that crosses another is refused", std::int64_t(0), AddPolygon(whole, tie, false));
  sm::Triangulation mesh({ 1.0, 1.0 });
  AddPolygon(mesh, tie, true);
  mesh.MarkInside();
  CheckEqual("the half that winds once", 2 * a * a, GetInnerArea(mesh));
  // A line through a vertex becomes two.
  sm::Triangulation through({ 1.0, 1.0 });
  through.Insert({ Middle, Middle }, false);
  const std::vector<sm::GridPoint> triangle{ { Middle - a, Middle }, { Middle + a, Middle },
    { Middle, Middle + a } };
  const std::int64_t area = AddPolygon(through, triangle, false);
  through.MarkInside();
  CheckEqual("a side through a vertex", area, GetInnerArea(through));
}

/// Sides without the rest of their loop give no winding numbers that hold; whatever these are, nothing
/// outside all points is inside.
void CheckOpenChains()
{
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int64_t> place(Middle - 400000000, Middle + 400000000);
  int outside = 0;
  int inside = 0;
  for (int chain = 0; chain < 50; ++chain)
  {
    sm::Triangulation mesh({ 1.0, 1.0 });
    for (int i = 0; i < 20; ++i)
    {
      const int a = mesh.Insert({ place(random), place(random) }, false);
      const int b = mesh.Insert({ place(random), place(random) }, false);
      mesh.InsertSegment(a, b, i, false);
    }
    mesh.MarkInside();
    for (const auto& t : mesh.GetTriangles())
    {
      outside += t.Inside && *std::min_element(t.Vertex.begin(), t.Vertex.end()) < 4 ? 1 : 0;
      inside += t.Inside ? 1 : 0;
    }
  }
  CheckEqual("triangles at corners of the square that are inside", 0, outside);
  CheckTrue("others are", inside > 0);
}
}

int TestTriangulation(int, char*[])
{
  CheckStars();
  CheckCrossing();
  CheckOpenChains();
  return Finish();
}
