#include "smMeshRepair.h"

#include <algorithm>
#include <iterator>

namespace sm
{
namespace
{
/// A repair may turn others over, which are repaired in the next pass.
constexpr int MaxPasses = 6;
/// A repair may make the deviation that is not allowed so much larger.
constexpr double WorseShare = 1.5;
/// Triangles that are judged at most: with weights of 1e20 thousands are inverted, and nothing mends them.
constexpr std::size_t MaxTrials = 200000;
/// A triangle that is no more.
constexpr MeshRepair::Corners Gone{ -1, -1, -1 };

std::pair<int, int> MakeSide(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

bool Has(const MeshRepair::Corners& t, int vertex)
{
  return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}
}

std::map<std::pair<int, int>, int> MeshRepair::FindSegments(const Triangulation& mesh)
{
  std::map<std::pair<int, int>, int> segments;
  for (const Triangulation::Triangle& t : mesh.GetTriangles())
  {
    for (int k = 0; k < 3; ++k)
    {
      if (t.Sides[k].Segment >= 0)
      {
        segments[MakeSide(t.Vertex[(k + 1) % 3], t.Vertex[(k + 2) % 3])] = t.Sides[k].Segment;
      }
    }
  }
  return segments;
}

MeshRepair::MeshRepair(std::vector<Corners>& triangles, const std::vector<GridPoint>& points,
  const std::map<std::pair<int, int>, int>& segments, const TriangleTests& tests, double allowed)
  : Triangles(triangles)
  , Points(points)
  , Segments(segments)
  , Tests(tests)
  , Allowed(allowed)
  , Maximum(allowed)
  , Stars(points.size())
{
  for (const auto& segment : segments)
  {
    this->Fixed.insert({ segment.first.first, segment.first.second });
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (const int v : triangles[i])
    {
      this->Stars[v].push_back(i);
    }
    this->Maximum = std::max(this->Maximum, WorseShare * tests.GetDeviation(triangles[i]));
  }
}

std::vector<MeshRepair::Corners> MeshRepair::Run()
{
  std::vector<Corners> left;
  bool changed = true;
  for (int pass = 0; changed && pass < MaxPasses; ++pass)
  {
    changed = false;
    left.clear();
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      if (this->Triangles[i] != Gone && this->Tests.IsInverted(this->Triangles[i]))
      {
        const bool mended = this->Trials < MaxTrials && (this->Flip(i) || this->Merge(i));
        changed = changed || mended;
        if (!mended)
        {
          left.push_back(this->Triangles[i]);
        }
      }
    }
  }
  this->Triangles.erase(
    std::remove(this->Triangles.begin(), this->Triangles.end(), Gone), this->Triangles.end());
  if (changed)
  {
    // The last pass may have mended what it had called inverted.
    left.clear();
    std::copy_if(
      this->Triangles.begin(), this->Triangles.end(), std::back_inserter(left), this->Tests.IsInverted);
  }
  return left;
}

bool MeshRepair::Replace(const std::vector<std::size_t>& before, const std::vector<Corners>& after)
{
  this->Trials += before.size() + after.size();
  std::size_t inverted[2] = { 0, 0 };
  double allowed = this->Allowed;
  for (const std::size_t i : before)
  {
    inverted[0] += this->Tests.IsInverted(this->Triangles[i]) ? 1 : 0;
    const double deviation = this->Tests.GetDeviation(this->Triangles[i]);
    allowed = deviation > this->Allowed ? std::max(allowed, std::min(WorseShare * deviation, this->Maximum))
                                        : allowed;
  }
  for (const Corners& t : after)
  {
    if (Orient(this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]) <= 0)
    {
      return false;
    }
    inverted[1] += this->Tests.IsInverted(t) ? 1 : 0;
    if (inverted[1] >= inverted[0] || !(this->Tests.GetDeviation(t) <= allowed))
    {
      return false;
    }
  }
  for (const std::size_t i : before)
  {
    for (const int v : this->Triangles[i])
    {
      std::vector<std::size_t>& star = this->Stars[v];
      star.erase(std::remove(star.begin(), star.end(), i), star.end());
    }
    this->Triangles[i] = Gone;
  }
  for (std::size_t k = 0; k < after.size(); ++k)
  {
    this->Triangles[before[k]] = after[k];
    for (const int v : after[k])
    {
      this->Stars[v].push_back(before[k]);
    }
  }
  return true;
}

bool MeshRepair::Flip(std::size_t triangle)
{
  for (int k = 0; k < 3; ++k)
  {
    const Corners t = this->Triangles[triangle];
    const int a = t[k];
    const int b = t[(k + 1) % 3];
    const int c = t[(k + 2) % 3];
    if (this->Segments.count(MakeSide(b, c)) > 0)
    {
      continue;
    }
    for (const std::size_t other : this->Stars[b])
    {
      const Corners& o = this->Triangles[other];
      if (other == triangle || !Has(o, c))
      {
        continue;
      }
      const int d = o[0] + o[1] + o[2] - b - c;
      if (this->Replace({ triangle, other }, { { a, b, d }, { a, d, c } }))
      {
        return true;
      }
      break;
    }
  }
  return false;
}

bool MeshRepair::Merge(std::size_t triangle)
{
  const Corners corners = this->Triangles[triangle];
  for (const int v : corners)
  {
    if (this->IsOnSegment(v))
    {
      continue;
    }
    const std::vector<std::size_t> star = this->Stars[v];
    for (const std::size_t at : star)
    {
      const Corners& t = this->Triangles[at];
      // Every neighbour of v follows it in one triangle.
      const int to = t[0] == v ? t[1] : (t[1] == v ? t[2] : t[0]);
      std::vector<Corners> after;
      for (const std::size_t i : star)
      {
        Corners n = this->Triangles[i];
        if (!Has(n, to))
        {
          std::replace(n.begin(), n.end(), v, to);
          after.push_back(n);
        }
      }
      if (this->Trials >= MaxTrials)
      {
        return false;
      }
      if (this->Replace(star, after))
      {
        return true;
      }
    }
  }
  return false;
}
}
