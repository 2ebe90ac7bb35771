#include "smFaceMesher.h"

#include "smTriangulation.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Parameters = std::array<double, 2>;

/// Grid steps across the face, and where it begins on the grid.
constexpr double GridWidth = 536870912.0;
constexpr std::int64_t GridStart = std::int64_t(1) << 28;

/// Part of the deflection that a regular triangle may take; others are larger.
constexpr double RegularShare = 0.8;
/// Largest ratio of the sides of triangles that are to be well shaped, where the surface is straight one way.
constexpr double LongestShape = 10.0;
/// Inner points that would be nearer to a corner or to the boundary, in steps, are left out.
constexpr double LeastGap = 0.4;
/// Points that rows may have in all, and points that refinement may add to n.
constexpr double MostRowPoints = 2e6;
constexpr double MostRows = 1e4;
constexpr std::size_t MostRefinement = 20000;
/// Points that refinement may add to a quarter of n to turn triangles over, and the part of the deflection that they must err by.
constexpr std::size_t MostTurns = 50;
constexpr double TurnShare = 1e-2;
/// Part of the deflection that the gap of a corner may take before its triangles are no longer made smaller for it.
constexpr double LargestGapShare = 0.5;
/// |S_u x S_v| has no direction below this part of the largest |S_u| |S_v|.
constexpr double LeastNormal = 1e-10;
/// A triangle is a line where twice its area is below this part of the square of its longest side.
constexpr double LineShare = 1e-7;

/// Distances between points in u and v that the deflection, the angle and the size of the face allow.
Parameters GetSteps(const SurfaceBlocks::Block& b, const Parameters& size, const MeshLimits& limits)
{
  double h[2];
  for (int d = 0; d < 2; ++d)
  {
    h[d] = b.Turn[d] * size[d] > limits.Angle ? limits.Angle / b.Turn[d] : size[d];
  }
  const double budget = 8.0 * RegularShare * limits.Deflection;
  const auto sum = [&]() { return b.Uu * h[0] * h[0] + 2.0 * b.Uv * h[0] * h[1] + b.Vv * h[1] * h[1]; };
  if (sum() > budget)
  {
    const double m[2] = { b.Uu, b.Vv };
    double other[2];
    for (int d = 0; d < 2; ++d)
    {
      other[d] = m[1 - d] * h[1 - d] * h[1 - d];
    }
    for (int d = 0; d < 2; ++d)
    {
      // Half of it, or what the other direction leaves.
      const double share = std::max(0.5 * budget, budget - other[d]);
      if (m[d] * h[d] * h[d] > share)
      {
        h[d] = std::sqrt(share / m[d]);
      }
    }
    const double rest = sum();
    if (rest > budget)
    {
      const double scale = std::sqrt(budget / rest);
      h[0] *= scale;
      h[1] *= scale;
    }
  }
  return { h[0], h[1] };
}

/// A density of points along a line, constant on strips.
class Density
{
public:
  Density(const std::vector<double>& breaks, const std::vector<double>& values, double low, double high)
  {
    this->At.push_back(low);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double from = std::max(breaks[i], low);
      const double to = i + 1 == values.size() ? high : std::min(breaks[i + 1], high);
      if (to > from)
      {
        this->At.push_back(to);
        this->Sum.push_back(this->Sum.back() + (to - from) * values[i]);
      }
    }
  }
  double GetTotal() const { return this->Sum.back(); }
  int GetSteps() const
  {
    return std::max(static_cast<int>(std::ceil(std::min(this->GetTotal(), MostRows) - 1e-3)), 1);
  }
  /// Point k of n equal steps.
  double GetPoint(int k, int n)
  {
    const double target = this->GetTotal() * k / n;
    this->Place = k <= 1 ? 1 : this->Place;
    while (this->Place + 1 < this->At.size() && this->Sum[this->Place] < target)
    {
      ++this->Place;
    }
    const std::size_t i = this->Place;
    const double share = (target - this->Sum[i - 1]) / (this->Sum[i] - this->Sum[i - 1]);
    return this->At[i - 1] + share * (this->At[i] - this->At[i - 1]);
  }
  /// Points per unit at the last point.
  double GetValue() const
  {
    const std::size_t i = this->Place;
    return (this->Sum[i] - this->Sum[i - 1]) / (this->At[i] - this->At[i - 1]);
  }

private:
  std::vector<double> At;
  std::vector<double> Sum{ 0.0 };
  std::size_t Place = 1;
};

struct Vertex
{
  Parameters At{};
  Vector3 Position{};
  /// Along Su x Sv; 0 where that vanishes.
  Vector3 Normal{};
  int Shared = -1;
  /// Distance from the surface.
  double Gap = 0.0;
};

class Mesher
{
public:
  Mesher(const Face& face, const SurfaceBlocks& blocks, const std::vector<BoundaryLoop>& loops,
    const MeshLimits& limits)
    : Source(face)
    , Blocks(blocks)
    , Loops(loops)
    , Limits(limits)
    , Walker(face.Surface)
    , Mesh(this->MakeMetric())
  {
  }

  FaceMesh Run(std::vector<std::pair<int, int>>* halve)
  {
    FaceMesh result;
    if (!(this->Size[0] > 0.0) || !(this->Size[1] > 0.0) || !std::isfinite(this->Size[0] + this->Size[1]))
    {
      result.Reason = "Its boundary encloses no area.";
      return result;
    }
    this->AddBoundary(halve, result);
    if (halve && !halve->empty())
    {
      return result;
    }
    this->Mesh.MarkInside();
    const auto& triangles = this->Mesh.GetTriangles();
    if (std::none_of(triangles.begin(), triangles.end(), [](const auto& t) { return t.Inside; }))
    {
      result.Reason = result.Reason.empty() ? "Its boundary encloses no area." : result.Reason;
      this->HalveAll(halve);
      return result;
    }
    this->AddRows();
    this->Refine();
    this->Write(result);
    return result;
  }

private:
  /// Lengths of a grid step in which triangles are to be well shaped.
  std::array<double, 2> MakeMetric()
  {
    bool first = true;
    for (const BoundaryLoop& loop : this->Loops)
    {
      for (const BoundaryPoint& p : loop)
      {
        this->Box = first ? ParameterBox{ p.Parameters, p.Parameters } : this->Box;
        this->Box.Add(p.Parameters);
        first = false;
      }
    }
    Parameters density{ 0.0, 0.0 };
    Parameters speed{ 0.0, 0.0 };
    double count = 0.0;
    for (int d = 0; d < 2; ++d)
    {
      this->Size[d] = this->Box.High[d] - this->Box.Low[d];
    }
    for (std::size_t j = 0; j + 1 < this->Blocks.GetBreaks(1).size(); ++j)
    {
      for (std::size_t i = 0; i + 1 < this->Blocks.GetBreaks(0).size(); ++i)
      {
        const SurfaceBlocks::Block& b = this->Blocks.GetBlock(i, j);
        this->Steps.push_back(GetSteps(b, this->Size, this->Limits));
        count += 1.0;
        for (int d = 0; d < 2; ++d)
        {
          density[d] += 1.0 / this->Steps.back()[d];
          speed[d] += b.Speed[d];
          this->Speed[d] = std::max(this->Speed[d], b.Speed[d]);
        }
      }
    }
    bool curved = false;
    for (int d = 0; d < 2; ++d)
    {
      density[d] /= count;
      speed[d] = std::max(speed[d] / count, 1e-300);
      curved = curved || density[d] * this->Size[d] > 1.0 + 1e-9;
    }
    const double longest = curved ? LongestShape : 1.0;
    const Parameters plain = density;
    for (int d = 0; d < 2; ++d)
    {
      density[d] = std::max(plain[d], plain[1 - d] * speed[d] / speed[1 - d] / longest);
    }
    return { density[0] * this->Size[0] / GridWidth, density[1] * this->Size[1] / GridWidth };
  }

  GridPoint ToGrid(const Parameters& at) const
  {
    const auto map = [&](int d)
    { return GridStart + std::llround((at[d] - this->Box.Low[d]) / this->Size[d] * GridWidth); };
    return { map(0), map(1) };
  }

  Vertex Evaluate(const Parameters& at)
  {
    Vertex v;
    v.At = at;
    Vector3 du;
    Vector3 dv;
    this->Walker.Evaluate(at[0], at[1], v.Position.data(), du.data(), dv.data());
    // At a pole a derivative is rounding, and so would be the normal.
    const Vector3 normal = Cross(du, dv);
    if (Norm(normal) > LeastNormal * this->Speed[0] * this->Speed[1])
    {
      v.Normal = Normalized(normal);
    }
    return v;
  }

  /// Stores a vertex of the triangulation; the first one at a place stays.
  void Store(int id, const Vertex& vertex)
  {
    if (id >= static_cast<int>(this->Vertices.size()))
    {
      this->Vertices.resize(id + 1);
      this->Vertices[id] = vertex;
    }
  }

  void AddBoundary(std::vector<std::pair<int, int>>* halve, FaceMesh& result)
  {
    this->Vertices.resize(4);
    std::vector<int> ids;
    std::vector<const BoundaryPoint*> points;
    for (const BoundaryLoop& loop : this->Loops)
    {
      for (const BoundaryPoint& p : loop)
      {
        Vertex v = this->Evaluate(p.Parameters);
        v.Shared = p.Shared;
        v.Gap = Norm(Subtract(v.Position, p.Position));
        v.Position = p.Position;
        ids.push_back(this->Mesh.Insert(this->ToGrid(p.Parameters), false));
        points.push_back(&p);
        this->Store(ids.back(), v);
      }
    }
    const auto ask = [&](int segment)
    {
      if (points[segment]->Edge >= 0)
      {
        halve->push_back({ points[segment]->Edge, points[segment]->Chord });
      }
    };
    std::size_t first = 0;
    for (const BoundaryLoop& loop : this->Loops)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const int segment = static_cast<int>(first + i);
        const int next = ids[first + (i + 1) % loop.size()];
        const int crossed = this->Mesh.InsertSegment(ids[segment], next, segment, halve == nullptr);
        if (crossed >= 0)
        {
          ask(segment);
          ask(crossed);
        }
        else if (crossed == -2)
        {
          result.Reason = "Its loops cross each other.";
        }
      }
      first += loop.size();
    }
    // Vertices at crossings.
    for (std::size_t i = this->Vertices.size(); i < this->Mesh.GetPoints().size(); ++i)
    {
      result.Reason = "Its loops cross each other.";
      const GridPoint& p = this->Mesh.GetPoints()[i];
      this->Store(static_cast<int>(i),
        this->Evaluate({ this->Box.Low[0] + static_cast<double>(p.X - GridStart) / GridWidth * this->Size[0],
          this->Box.Low[1] + static_cast<double>(p.Y - GridStart) / GridWidth * this->Size[1] }));
    }
  }

  void HalveAll(std::vector<std::pair<int, int>>* halve) const
  {
    for (const BoundaryLoop& loop : this->Loops)
    {
      for (const BoundaryPoint& p : loop)
      {
        if (halve && p.Edge >= 0)
        {
          halve->push_back({ p.Edge, p.Chord });
        }
      }
    }
  }

  const Parameters& GetStep(std::size_t i, std::size_t j) const
  {
    return this->Steps[i + j * (this->Blocks.GetBreaks(0).size() - 1)];
  }

  /// Largest density in direction d in strip `i` of that direction, over strips [first, last] of the other.
  double GetDensity(int d, std::size_t i, std::size_t first, std::size_t last) const
  {
    double largest = 0.0;
    for (std::size_t j = first; j <= last; ++j)
    {
      largest = std::max(largest, 1.0 / (d == 0 ? this->GetStep(i, j) : this->GetStep(j, i))[d]);
    }
    return largest;
  }

  /// The direction that is constant on a row: rows have different numbers of points.
  int ChooseRows() const
  {
    double spread[2];
    for (int d = 0; d < 2; ++d)
    {
      const std::size_t here = this->Blocks.GetBreaks(d).size() - 1;
      const std::size_t other = this->Blocks.GetBreaks(1 - d).size() - 1;
      double most = 0.0;
      double least = 1e300;
      for (std::size_t i = 0; i < here; ++i)
      {
        const double x = this->GetDensity(1 - d, 0, i, i);
        double along = x;
        for (std::size_t k = 1; k < other; ++k)
        {
          along = std::max(along, this->GetDensity(1 - d, k, i, i));
        }
        most = std::max(most, along);
        least = std::min(least, along);
      }
      spread[d] = most / least;
    }
    return spread[0] > spread[1] ? 0 : 1;
  }

  void AddRows()
  {
    const int d = this->ChooseRows();
    const std::vector<double>& breaks = this->Blocks.GetBreaks(d);
    const std::vector<double>& across = this->Blocks.GetBreaks(1 - d);
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      values.push_back(this->GetDensity(d, i, 0, across.size() - 2));
    }
    Density rows(breaks, values, this->Box.Low[d], this->Box.High[d]);
    const int count = rows.GetSteps();
    double total = 0.0;
    for (int k = 1; k < count && total < MostRowPoints; ++k)
    {
      const double here = rows.GetPoint(k, count);
      const double step = 1.0 / rows.GetValue();
      std::size_t first = 0;
      std::size_t last = 0;
      while (first + 2 < breaks.size() && breaks[first + 1] <= here - step)
      {
        ++first;
      }
      last = first;
      while (last + 2 < breaks.size() && breaks[last + 1] < here + step)
      {
        ++last;
      }
      std::vector<double> along;
      for (std::size_t i = 0; i + 1 < across.size(); ++i)
      {
        along.push_back(this->GetDensity(1 - d, i, first, last));
      }
      Density points(across, along, this->Box.Low[1 - d], this->Box.High[1 - d]);
      const int steps = points.GetSteps();
      total += steps;
      std::vector<std::array<double, 2>> row;
      for (int i = 1; i < steps; ++i)
      {
        const double x = points.GetPoint(i, steps);
        row.push_back({ x, points.GetValue() });
      }
      // Back and forth, so that each point is found near the one before.
      if (k % 2 == 0)
      {
        std::reverse(row.begin(), row.end());
      }
      for (const auto& [x, density] : row)
      {
        Parameters at;
        Parameters scale;
        at[d] = here;
        at[1 - d] = x;
        scale[d] = 1.0 / step;
        scale[1 - d] = density;
        this->AddInner(at, scale);
      }
    }
  }

  /// Adds a point unless it is outside, or too near to a corner or to the boundary, by `scale` points per unit.
  void AddInner(const Parameters& at, const Parameters& scale)
  {
    const GridPoint p = this->ToGrid(at);
    const Triangulation::Triangle& t = this->Mesh.GetTriangles()[this->Mesh.Locate(p)];
    if (!t.Inside)
    {
      return;
    }
    double x[3];
    double y[3];
    for (int k = 0; k < 3; ++k)
    {
      const Parameters& corner = this->Vertices[t.Vertex[k]].At;
      x[k] = (corner[0] - at[0]) * scale[0];
      y[k] = (corner[1] - at[1]) * scale[1];
      if (std::hypot(x[k], y[k]) < LeastGap)
      {
        return;
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const int a = (k + 1) % 3;
      const int b = (k + 2) % 3;
      const double length = std::hypot(x[b] - x[a], y[b] - y[a]);
      if (t.Sides[k].Segment >= 0 && std::abs(x[a] * y[b] - x[b] * y[a]) < LeastGap * length)
      {
        return;
      }
    }
    const int id = this->Mesh.Insert(p, true);
    if (id >= static_cast<int>(this->Vertices.size()))
    {
      this->Store(id, this->Evaluate(at));
    }
  }

  bool IsCollapsed(const Triangulation::Triangle& t) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = this->Vertices[t.Vertex[k]].Shared;
      if (a >= 0 && a == this->Vertices[t.Vertex[(k + 1) % 3]].Shared)
      {
        return true;
      }
    }
    return false;
  }

  double GetError(const Triangulation::Triangle& t) const
  {
    ParameterBox box{ this->Vertices[t.Vertex[0]].At, this->Vertices[t.Vertex[0]].At };
    box.Add(this->Vertices[t.Vertex[1]].At);
    box.Add(this->Vertices[t.Vertex[2]].At);
    return this->Blocks.GetError(box);
  }

  bool IsInverted(const Triangulation::Triangle& t) const
  {
    const Vertex* v[3];
    Vector3 mean{ 0.0, 0.0, 0.0 };
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      v[k] = &this->Vertices[t.Vertex[k]];
      const Vector3 side = Subtract(v[k]->Position, this->Vertices[t.Vertex[(k + 1) % 3]].Position);
      longest = std::max(longest, Dot(side, side));
      for (int c = 0; c < 3; ++c)
      {
        mean[c] += v[k]->Normal[c];
      }
    }
    const Vector3 normal =
      Cross(Subtract(v[1]->Position, v[0]->Position), Subtract(v[2]->Position, v[0]->Position));
    return Dot(normal, mean) < 0.0 && Norm(normal) > LineShare * longest;
  }

  /// What a triangle may err by between its corners: the deflection less the gap of a corner. Where a corner's gap takes most of the
  /// deflection, no number of points keeps the promise.
  double GetAllowed(const Triangulation::Triangle& t) const
  {
    double gap = 0.0;
    for (const int corner : t.Vertex)
    {
      gap = std::max(gap, this->Vertices[corner].Gap);
    }
    return gap > LargestGapShare * this->Limits.Deflection ? this->Limits.Deflection
                                                           : this->Limits.Deflection - gap;
  }

  /// Inserts points until all triangles are good, or no more can be done.
  void Refine()
  {
    std::vector<int> open;
    for (std::size_t i = this->Mesh.GetTriangles().size(); i-- > 0;)
    {
      open.push_back(static_cast<int>(i));
    }
    const std::size_t most = 2 * this->Vertices.size() + MostRefinement;
    std::size_t turns = MostTurns + this->Vertices.size() / 4;
    while (!open.empty() && this->Vertices.size() < most)
    {
      const Triangulation::Triangle& t = this->Mesh.GetTriangles()[open.back()];
      open.pop_back();
      if (!t.Inside || this->IsCollapsed(t))
      {
        continue;
      }
      const double error = this->GetError(t);
      const double allowed = this->GetAllowed(t);
      if (error <= allowed)
      {
        // A triangle may be turned over where the surface bends, but also where edges lie off it: that no point mends.
        if (turns == 0 || error < TurnShare * allowed || !this->IsInverted(t))
        {
          continue;
        }
        --turns;
      }
      const Parameters at = this->ChooseSplit(t);
      const int id = this->Mesh.Insert(this->ToGrid(at), true);
      if (id >= static_cast<int>(this->Vertices.size()))
      {
        this->Store(id, this->Evaluate(at));
        open.insert(open.end(), this->Mesh.GetChanged().begin(), this->Mesh.GetChanged().end());
      }
    }
  }

  /// The middle of the side that adds most to the error and is no segment; of the triangle where all are.
  Parameters ChooseSplit(const Triangulation::Triangle& t) const
  {
    double largest = 0.0;
    Parameters at{ 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      const Parameters& a = this->Vertices[t.Vertex[(k + 1) % 3]].At;
      const Parameters& b = this->Vertices[t.Vertex[(k + 2) % 3]].At;
      if (largest == 0.0)
      {
        at[0] += this->Vertices[t.Vertex[k]].At[0] / 3.0;
        at[1] += this->Vertices[t.Vertex[k]].At[1] / 3.0;
      }
      if (t.Sides[k].Segment >= 0)
      {
        continue;
      }
      ParameterBox box{ a, a };
      box.Add(b);
      const double measure = this->Blocks.GetError(box) + 1e-300;
      if (measure > largest)
      {
        largest = measure;
        at = { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) };
      }
    }
    return at;
  }

  /// The normal of a point where Su x Sv vanishes: of one beside it, else 0.
  Vector3 FindNormal(const Parameters& at)
  {
    for (const double step : { 1e-6, 1e-3 })
    {
      Parameters beside;
      for (int d = 0; d < 2; ++d)
      {
        beside[d] = (1.0 - step) * at[d] + step * 0.5 * (this->Box.Low[d] + this->Box.High[d]);
      }
      const Vertex v = this->Evaluate(beside);
      if (Dot(v.Normal, v.Normal) > 0.0)
      {
        return v.Normal;
      }
    }
    return { 0.0, 0.0, 0.0 };
  }

  void Write(FaceMesh& result)
  {
    std::vector<int> place(this->Vertices.size(), -1);
    double farthest = 0.0;
    for (const Triangulation::Triangle& t : this->Mesh.GetTriangles())
    {
      if (!t.Inside || this->IsCollapsed(t))
      {
        continue;
      }
      std::array<int, 3> corners;
      double gap = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        Vertex& v = this->Vertices[t.Vertex[k]];
        int& index = place[t.Vertex[k]];
        if (index < 0)
        {
          index = static_cast<int>(result.Points.size());
          result.Points.push_back(v.Position);
          result.Parameters.push_back(v.At);
          Vector3 normal = Dot(v.Normal, v.Normal) > 0.0 ? v.Normal : this->FindNormal(v.At);
          if (this->Source.Reversed)
          {
            normal = { -normal[0], -normal[1], -normal[2] };
          }
          result.Normals.push_back(normal);
          farthest =
            std::max({ farthest, std::abs(v.Position[0]), std::abs(v.Position[1]), std::abs(v.Position[2]) });
        }
        corners[k] = index;
        gap = std::max(gap, v.Gap);
      }
      if (this->Source.Reversed)
      {
        std::swap(corners[1], corners[2]);
      }
      result.Triangles.push_back(corners);
      const double deviation = this->GetError(t) + gap;
      // Not std::max, which loses a NaN.
      result.Deviation = deviation <= result.Deviation ? result.Deviation
        : std::isnan(deviation)                        ? HUGE_VAL
                                                       : deviation;
    }
    // Positions are rounded, and so are parameters.
    const SurfaceBlocks::Block all = this->Blocks.GetLargest(this->Blocks.GetCovered());
    for (int d = 0; d < 2; ++d)
    {
      farthest += all.Speed[d] * std::max(std::abs(this->Box.Low[d]), std::abs(this->Box.High[d]));
    }
    result.Deviation += 64.0 * UnitRoundoff * farthest;
    this->FillNormals(result);
  }

  /// Points without a normal of the surface get that of their triangles.
  static void FillNormals(FaceMesh& mesh)
  {
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      const Vector3 n =
        Cross(Subtract(mesh.Points[t[1]], mesh.Points[t[0]]), Subtract(mesh.Points[t[2]], mesh.Points[t[0]]));
      for (const int k : t)
      {
        if (Dot(mesh.Normals[k], mesh.Normals[k]) == 0.0 && Dot(n, n) > 0.0)
        {
          mesh.Normals[k] = Normalized(n);
        }
      }
    }
  }

  const Face& Source;
  const SurfaceBlocks& Blocks;
  const std::vector<BoundaryLoop>& Loops;
  const MeshLimits& Limits;
  NURBSSurface::Walker Walker;
  ParameterBox Box;
  Parameters Size{};
  /// Largest |S_u| and |S_v|.
  Parameters Speed{ 0.0, 0.0 };
  /// Steps of each block.
  std::vector<Parameters> Steps;
  Triangulation Mesh;
  std::vector<Vertex> Vertices;
};
}

FaceMesh MeshFace(const Face& face, const SurfaceBlocks& blocks, const std::vector<BoundaryLoop>& loops,
  const MeshLimits& limits, std::vector<std::pair<int, int>>* halve)
{
  return Mesher(face, blocks, loops, limits).Run(halve);
}
}
