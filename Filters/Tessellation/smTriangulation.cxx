#include "smTriangulation.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Share of the sum of absolute values that a determinant in double precision is certain to reach where its
/// sign is right.
constexpr double CertainShare = 1e-13;

}

Triangulation::Triangulation(const std::array<double, 2>& step, std::size_t points)
  : Step(step)
{
  this->Points.reserve(points + 4);
  this->VertexTriangle.reserve(points + 4);
  this->Triangles.reserve(2 * points + 2);
  this->Points = { { 0, 0 }, { Extent, 0 }, { Extent, Extent }, { 0, Extent } };
  this->VertexTriangle = { 0, 0, 0, 1 };
  this->Triangles.resize(2);
  this->Triangles[0].Vertex = { 0, 1, 2 };
  this->Triangles[1].Vertex = { 0, 2, 3 };
  this->Triangles[0].Sides[1].Neighbor = 1;
  this->Triangles[1].Sides[2].Neighbor = 0;
}

bool Triangulation::IsFlipBetter(int triangle, int side) const
{
  const Triangle& t = this->Triangles[triangle];
  const int other = t.Sides[side].Neighbor;
  if (other < 0 || t.Sides[side].Segment >= 0)
  {
    return false;
  }
  const Triangle& o = this->Triangles[other];
  int apex = 0;
  while (o.Sides[apex].Neighbor != triangle)
  {
    ++apex;
  }
  const GridPoint& d = this->Points[o.Vertex[apex]];
  double x[3];
  double y[3];
  double square[3];
  for (int i = 0; i < 3; ++i)
  {
    const GridPoint& p = this->Points[t.Vertex[i]];
    x[i] = static_cast<double>(p.X - d.X) * this->Step[0];
    y[i] = static_cast<double>(p.Y - d.Y) * this->Step[1];
    square[i] = x[i] * x[i] + y[i] * y[i];
  }
  double determinant = 0.0;
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double left = x[NextCorner(i)] * y[PreviousCorner(i)];
    const double right = x[PreviousCorner(i)] * y[NextCorner(i)];
    determinant += square[i] * (left - right);
    sum += square[i] * (std::abs(left) + std::abs(right));
  }
  if (!(determinant > CertainShare * sum))
  {
    return false;
  }
  const GridPoint& a = this->Points[t.Vertex[side]];
  return Orient(a, this->Points[t.Vertex[NextCorner(side)]], d) > 0 &&
    Orient(a, d, this->Points[t.Vertex[PreviousCorner(side)]]) > 0;
}

void Triangulation::SetNeighbor(int triangle, int from, int neighbor)
{
  if (triangle >= 0)
  {
    Triangle& t = this->Triangles[triangle];
    t.Sides[PreviousCorner(this->FindVertexIn(triangle, from))].Neighbor = neighbor;
  }
}

void Triangulation::Flip(int triangle, int side)
{
  ++this->NumberOfFlips;
  Triangle& t = this->Triangles[triangle];
  const int other = t.Sides[side].Neighbor;
  Triangle& o = this->Triangles[other];
  int m = 0;
  while (o.Sides[m].Neighbor != triangle)
  {
    ++m;
  }
  const int a = t.Vertex[side];
  const int b = t.Vertex[NextCorner(side)];
  const int c = t.Vertex[PreviousCorner(side)];
  const int d = o.Vertex[m];
  const Side ca = t.Sides[NextCorner(side)];
  const Side ab = t.Sides[PreviousCorner(side)];
  const Side bd = o.Sides[NextCorner(m)];
  const Side dc = o.Sides[PreviousCorner(m)];
  t.Vertex = { a, b, d };
  t.Sides = { bd, Side{ other, -1, 0 }, ab };
  o.Vertex = { a, d, c };
  o.Sides = { dc, ca, Side{ triangle, -1, 0 } };
  // In the neighbours the sides run the other way.
  this->SetNeighbor(bd.Neighbor, d, triangle);
  this->SetNeighbor(ca.Neighbor, a, other);
  this->VertexTriangle[a] = this->VertexTriangle[b] = this->VertexTriangle[d] = triangle;
  this->VertexTriangle[c] = other;
}

void Triangulation::SplitTriangle(int triangle, int vertex)
{
  const Triangle t = this->Triangles[triangle];
  const int first = static_cast<int>(this->Triangles.size());
  this->Triangles.resize(first + 2);
  const int ids[3] = { triangle, first, first + 1 };
  for (int i = 0; i < 3; ++i)
  {
    // Between the new vertex and side i.
    Triangle& n = this->Triangles[ids[i]];
    n.Vertex = { vertex, t.Vertex[NextCorner(i)], t.Vertex[PreviousCorner(i)] };
    n.Sides = { t.Sides[i], Side{ ids[NextCorner(i)], -1, 0 }, Side{ ids[PreviousCorner(i)], -1, 0 } };
    n.Inside = t.Inside;
    if (i > 0)
    {
      this->SetNeighbor(t.Sides[i].Neighbor, t.Vertex[PreviousCorner(i)], ids[i]);
    }
    this->VertexTriangle[t.Vertex[NextCorner(i)]] = ids[i];
    this->Stack.push_back({ ids[i], 0 });
  }
  this->VertexTriangle[vertex] = triangle;
}

void Triangulation::SplitSide(int triangle, int side, int vertex)
{
  const Triangle t = this->Triangles[triangle];
  const int other = t.Sides[side].Neighbor;
  const Triangle o = this->Triangles[other];
  int m = 0;
  while (o.Sides[m].Neighbor != triangle)
  {
    ++m;
  }
  const int a = t.Vertex[side];
  const int b = t.Vertex[NextCorner(side)];
  const int c = t.Vertex[PreviousCorner(side)];
  const int d = o.Vertex[m];
  const Side bc = t.Sides[side];
  const int first = static_cast<int>(this->Triangles.size());
  this->Triangles.resize(first + 2);
  // Around the new vertex: (a b), (b d), (d c), (c a).
  const int ids[4] = { triangle, other, first, first + 1 };
  const int from[4] = { a, b, d, c };
  const int to[4] = { b, d, c, a };
  const Side outer[4] = { t.Sides[PreviousCorner(side)], o.Sides[NextCorner(m)], o.Sides[PreviousCorner(m)],
    t.Sides[NextCorner(side)] };
  const int owner[4] = { triangle, other, other, triangle };
  for (int i = 0; i < 4; ++i)
  {
    Triangle& n = this->Triangles[ids[i]];
    n.Vertex = { vertex, from[i], to[i] };
    n.Sides = { outer[i], Side{ ids[(i + 1) % 4], -1, 0 }, Side{ ids[(i + 3) % 4], -1, 0 } };
    n.Inside = owner[i] == triangle ? t.Inside : o.Inside;
    if (ids[i] != owner[i])
    {
      this->SetNeighbor(outer[i].Neighbor, to[i], ids[i]);
    }
    this->VertexTriangle[from[i]] = ids[i];
    this->Stack.push_back({ ids[i], 0 });
  }
  this->VertexTriangle[vertex] = triangle;
  // The two halves of a segment: from b to the vertex in (a b), from the vertex to c in (c a).
  const Side along{ -1, bc.Segment, bc.Winding };
  const Side against{ -1, bc.Segment, -bc.Winding };
  const auto set = [this](int id, int k, const Side& data)
  {
    this->Triangles[id].Sides[k].Segment = data.Segment;
    this->Triangles[id].Sides[k].Winding = data.Winding;
  };
  set(ids[0], 1, along);
  set(ids[1], 2, against);
  set(ids[2], 1, against);
  set(ids[3], 2, along);
}

void Triangulation::Legalize(std::vector<Place>& places)
{
  while (!places.empty())
  {
    const Place place = places.back();
    places.pop_back();
    this->Changed.push_back(place.Triangle);
    const int other = this->Triangles[place.Triangle].Sides[place.Side].Neighbor;
    if (this->IsFlipBetter(place.Triangle, place.Side))
    {
      this->Flip(place.Triangle, place.Side);
      places.push_back({ place.Triangle, 0 });
      places.push_back({ other, 0 });
    }
  }
}

int Triangulation::Locate(const GridPoint& point)
{
  int at = this->Last;
  const std::size_t maximum = 4 * this->Triangles.size() + 100;
  for (std::size_t step = 0; step < maximum; ++step)
  {
    const Triangle& t = this->Triangles[at];
    int next = -1;
    for (int i = 0; i < 3 && next < 0; ++i)
    {
      // Another first side at each step: a walk that always prefers the same one may go round.
      const int k = static_cast<int>((step + i) % 3);
      if (Orient(this->Points[t.Vertex[NextCorner(k)]], this->Points[t.Vertex[PreviousCorner(k)]], point) < 0)
      {
        next = t.Sides[k].Neighbor;
      }
    }
    if (next < 0)
    {
      this->Last = at;
      return at;
    }
    at = next;
  }
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const auto& v = this->Triangles[i].Vertex;
    bool inside = true;
    for (int k = 0; k < 3; ++k)
    {
      inside = inside && Orient(this->Points[v[k]], this->Points[v[NextCorner(k)]], point) >= 0;
    }
    if (inside)
    {
      this->Last = static_cast<int>(i);
      break;
    }
  }
  return this->Last;
}

int Triangulation::Insert(const GridPoint& point, bool keepSegments)
{
  this->Changed.clear();
  const int at = this->Locate(point);
  const Triangle& t = this->Triangles[at];
  int onSide = -1;
  for (int k = 0; k < 3; ++k)
  {
    const GridPoint& p = this->Points[t.Vertex[k]];
    if (p.X == point.X && p.Y == point.Y)
    {
      return t.Vertex[k];
    }
    if (Orient(this->Points[t.Vertex[NextCorner(k)]], this->Points[t.Vertex[PreviousCorner(k)]], point) == 0)
    {
      onSide = k;
    }
  }
  if (onSide >= 0 && keepSegments && t.Sides[onSide].Segment >= 0)
  {
    return -1;
  }
  const int vertex = static_cast<int>(this->Points.size());
  this->Points.push_back(point);
  this->VertexTriangle.push_back(at);
  if (onSide >= 0)
  {
    this->SplitSide(at, onSide, vertex);
  }
  else
  {
    this->SplitTriangle(at, vertex);
  }
  this->Legalize(this->Stack);
  return vertex;
}

void Triangulation::MarkInside()
{
  std::vector<int> winding(this->Triangles.size(), 0);
  std::vector<char> known(this->Triangles.size(), 0);
  std::vector<int> open{ this->VertexTriangle[0] };
  known[open[0]] = 1;
  bool anyPositive = false;
  while (!open.empty())
  {
    const int at = open.back();
    open.pop_back();
    anyPositive = anyPositive || winding[at] > 0;
    for (const Side& side : this->Triangles[at].Sides)
    {
      if (side.Neighbor >= 0 && !known[side.Neighbor])
      {
        known[side.Neighbor] = 1;
        winding[side.Neighbor] = winding[at] - side.Winding;
        open.push_back(side.Neighbor);
      }
    }
  }
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    Triangle& t = this->Triangles[i];
    // Where a segment could not be inserted, winding numbers depend on the way, also of what lies outside all
    // loops.
    const bool isOutside = *std::min_element(t.Vertex.begin(), t.Vertex.end()) < 4;
    t.Inside = !isOutside && (anyPositive ? winding[i] > 0 : winding[i] < 0);
  }
  this->Improve();
}

void Triangulation::Improve()
{
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    for (int k = 0; this->Triangles[i].Inside && k < 3; ++k)
    {
      this->Stack.push_back({ static_cast<int>(i), k });
    }
  }
  while (!this->Stack.empty())
  {
    const Place place = this->Stack.back();
    this->Stack.pop_back();
    const int other = this->Triangles[place.Triangle].Sides[place.Side].Neighbor;
    if (this->IsFlipBetter(place.Triangle, place.Side))
    {
      this->Flip(place.Triangle, place.Side);
      this->Stack.insert(
        this->Stack.end(), { { place.Triangle, 0 }, { place.Triangle, 2 }, { other, 0 }, { other, 1 } });
    }
  }
}
}
