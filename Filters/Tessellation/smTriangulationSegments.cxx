#include "smTriangulation.h"

#include <cmath>
#include <deque>

namespace sm
{
namespace
{
/// Crossings of one line with segments that are resolved one after another.
constexpr int MaxCrossings = 64;
}

Triangulation::Place Triangulation::FindSide(int from, int to) const
{
  // Counter-clockwise about `from`, and about a corner of the square clockwise, too.
  const int start = this->VertexTriangle[from];
  for (const bool clockwise : { false, true })
  {
    int at = start;
    do
    {
      const int k = this->FindVertexIn(at, from);
      if (this->Triangles[at].Vertex[NextCorner(k)] == to)
      {
        return { at, PreviousCorner(k) };
      }
      at = this->Triangles[at].Sides[clockwise ? PreviousCorner(k) : NextCorner(k)].Neighbor;
    } while (at != start && at >= 0);
  }
  return { -1, -1 };
}

Triangulation::Crossing Triangulation::Walk(int a, int b) const
{
  Crossing found;
  const GridPoint& p = this->Points[a];
  const GridPoint& q = this->Points[b];
  const int start = this->VertexTriangle[a];
  int at = start;
  int right = -1;
  int left = -1;
  do
  {
    const Triangle& t = this->Triangles[at];
    const int k = this->FindVertexIn(at, a);
    const int v = t.Vertex[NextCorner(k)];
    const int w = t.Vertex[PreviousCorner(k)];
    const GridPoint& r = this->Points[v];
    const std::int64_t side = Orient(p, q, r);
    if (v == b || (side == 0 && (q.X - p.X) * (r.X - p.X) + (q.Y - p.Y) * (r.Y - p.Y) > 0))
    {
      found.End = v;
      return found;
    }
    if (side < 0 && Orient(p, q, this->Points[w]) > 0)
    {
      right = v;
      left = w;
      at = t.Sides[k].Neighbor;
      found.Segment = t.Sides[k].Segment;
      break;
    }
    at = t.Sides[NextCorner(k)].Neighbor;
  } while (at != start && at >= 0);
  while (right >= 0 && at >= 0)
  {
    found.Sides.push_back({ right, left });
    if (found.Segment >= 0)
    {
      return found;
    }
    const Triangle& t = this->Triangles[at];
    // The side from left to right belongs to this triangle as (left, right) reversed.
    int k = 0;
    while (t.Vertex[k] == right || t.Vertex[k] == left)
    {
      ++k;
    }
    const int apex = t.Vertex[k];
    const std::int64_t side = Orient(p, q, this->Points[apex]);
    if (apex == b || side == 0)
    {
      found.End = apex;
      return found;
    }
    // The line leaves opposite the vertex that stays behind.
    const int behind = side > 0 ? left : right;
    (side > 0 ? left : right) = apex;
    const Side& out = t.Sides[this->FindVertexIn(at, behind)];
    found.Segment = out.Segment;
    at = out.Neighbor;
  }
  return found;
}

bool Triangulation::FlipAway(int a, int b, std::vector<std::pair<int, int>>& sides)
{
  const GridPoint& p = this->Points[a];
  const GridPoint& q = this->Points[b];
  std::deque<std::pair<int, int>> queue(sides.begin(), sides.end());
  sides.clear();
  std::size_t left = 64 + 16 * queue.size() * queue.size();
  while (!queue.empty() && left-- > 0)
  {
    const auto [x, y] = queue.front();
    queue.pop_front();
    const Place place = this->FindSide(x, y);
    if (place.Triangle < 0)
    {
      return false;
    }
    const Triangle& t = this->Triangles[place.Triangle];
    const int other = t.Sides[place.Side].Neighbor;
    const int c = t.Vertex[place.Side];
    int m = 0;
    while (this->Triangles[other].Sides[m].Neighbor != place.Triangle)
    {
      ++m;
    }
    const int d = this->Triangles[other].Vertex[m];
    if (Orient(this->Points[c], this->Points[x], this->Points[d]) <= 0 ||
      Orient(this->Points[c], this->Points[d], this->Points[y]) <= 0)
    {
      queue.push_back({ x, y });
      continue;
    }
    this->Flip(place.Triangle, place.Side);
    const std::int64_t first = Orient(p, q, this->Points[c]);
    const std::int64_t second = Orient(p, q, this->Points[d]);
    if ((first > 0 && second < 0) || (first < 0 && second > 0))
    {
      queue.push_back({ c, d });
    }
    else
    {
      sides.push_back({ c, d });
    }
  }
  return queue.empty();
}

void Triangulation::AddSegment(int a, int b, int segment, int winding)
{
  const Place place = this->FindSide(a, b);
  const Place back = this->FindSide(b, a);
  Side& side = this->Triangles[place.Triangle].Sides[place.Side];
  Side& other = this->Triangles[back.Triangle].Sides[back.Side];
  side.Segment = other.Segment = segment;
  side.Winding += winding;
  other.Winding -= winding;
}

int Triangulation::InsertSegment(int a, int b, int segment, bool split)
{
  return this->InsertPart(a, b, segment, 1, split, 0);
}

int Triangulation::InsertPart(int a, int b, int segment, int winding, bool split, int depth)
{
  if (depth > MaxCrossings)
  {
    return -2;
  }
  while (a != b)
  {
    Crossing found = this->Walk(a, b);
    if (found.Segment >= 0)
    {
      if (!split)
      {
        return found.Segment;
      }
      // Both lines get a vertex where they cross, to the nearest point of the grid.
      const auto [x, y] = found.Sides.back();
      const GridPoint& p = this->Points[a];
      const GridPoint& q = this->Points[b];
      const GridPoint& r = this->Points[x];
      const GridPoint& s = this->Points[y];
      const double share = static_cast<double>(Orient(p, q, r)) /
        (static_cast<double>(Orient(p, q, r)) - static_cast<double>(Orient(p, q, s)));
      const GridPoint cross{ r.X + std::llround(share * static_cast<double>(s.X - r.X)),
        r.Y + std::llround(share * static_cast<double>(s.Y - r.Y)) };
      const Place place = this->FindSide(x, y);
      Side& side = this->Triangles[place.Triangle].Sides[place.Side];
      const Place back = this->FindSide(y, x);
      Side& other = this->Triangles[back.Triangle].Sides[back.Side];
      const Side old = side;
      side.Segment = other.Segment = -1;
      side.Winding = other.Winding = 0;
      const int middle = this->Insert(cross, false);
      if (middle < 0 || this->InsertPart(x, middle, old.Segment, old.Winding, true, depth + 1) != -1 ||
        this->InsertPart(middle, y, old.Segment, old.Winding, true, depth + 1) != -1 ||
        this->InsertPart(a, middle, segment, winding, true, depth + 1) != -1)
      {
        return -2;
      }
      a = middle;
      ++depth;
      if (depth > MaxCrossings)
      {
        return -2;
      }
      continue;
    }
    if (found.End < 0)
    {
      return -2;
    }
    if (!found.Sides.empty())
    {
      if (!this->FlipAway(a, found.End, found.Sides))
      {
        return -2;
      }
    }
    this->AddSegment(a, found.End, segment, winding);
    a = found.End;
  }
  return -1;
}
}
