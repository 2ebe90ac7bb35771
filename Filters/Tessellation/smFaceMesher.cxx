#include "smFaceMesher.h"

#include "Detail/smFaceMeshWriter.h"
#include "Detail/smMeshRepair.h"
#include "Detail/smMeshSteps.h"
#include "Detail/smTriangleJudge.h"
#include "Detail/smTriangulation.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sm
{
namespace
{
using Parameters = std::array<double, 2>;
using Corners = MeshRepair::Corners;

/// Grid steps across the face, and where it begins on the grid.
constexpr double GridWidth = 536870912.0;
constexpr std::int64_t GridStart = std::int64_t(1) << 28;

/// Inner points that would be nearer to a corner or to the boundary, in steps, are left out.
constexpr double MinGap = 0.4;
/// Points that refinement may add to n.
constexpr std::size_t MaxRefinement = 20000;
/// Points that refinement may add to a quarter of n to turn triangles over, and the part of the deflection
/// that they must err by.
constexpr std::size_t MaxTurns = 300;
constexpr double TurnShare = 1e-2;
/// Part of the deflection that the gap of a corner may take before its triangles are no longer made smaller
/// for it.
constexpr double MaxGapShare = 0.5;
/// Exchanged diagonals, in all and for each point, after which no more points are inserted: triangles are
/// needles then, and each point changes a large part of them. Usual faces need about ten for each point.
constexpr std::size_t MaxFlips = 1000000;
constexpr std::size_t MaxFlipsOfPoint = 100;
/// |S_u x S_v| has no direction below this part of the largest |S_u| |S_v|.
constexpr double MinNormal = 1e-10;
/// Loops that are narrower than this part of their parameters, some 50 neighbouring doubles, are lines.
constexpr double MinWidth = 1e-14;
/// Shapes of triangles that are tried where some are inverted, on faces of no more than so many triangles.
constexpr std::size_t MaxMetrics = 3;
constexpr std::size_t MaxTriangles = 3000;

class Mesher
{
public:
  /// `metric`: densities in u and v, relative to each other, in which triangles are to be well shaped; 0:
  /// those of the whole face.
  Mesher(const Face& face, const SurfaceBlocks& blocks, const std::vector<BoundaryLoop>& loops,
    const MeshLimits& limits, const Parameters& metric)
    : Source(face)
    , Blocks(blocks)
    , Loops(loops)
    , Limits(limits)
    , Walker(face.Surface)
    , Box(FindBox(loops))
    , Size{ Box.High[0] - Box.Low[0], Box.High[1] - Box.Low[1] }
    , Steps(blocks, Box, limits)
    , Mesh(this->GetGridMetric(metric), CountPoints(loops))
    , Judge(blocks, Vertices, Walker)
  {
  }

  FaceMesh Run(std::vector<std::pair<int, int>>* halve)
  {
    FaceMesh result;
    if (!this->HasWidth(0) || !this->HasWidth(1))
    {
      // Chords of curves that bend away from each other may lie on one line.
      result.Reason = "Its boundary encloses no area.";
      this->HalveAll(halve);
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
    if (!this->Blocks.IsFlat(this->Limits.Deflection, this->Limits.Angle))
    {
      this->Steps.LayRows(
        [this](const Parameters& at, const Parameters& scale) { this->AddInner(at, scale); });
      this->Refine();
    }
    const std::vector<Corners> kept = this->Repair(halve, result);
    WriteFaceMesh(kept,
      { this->Source, this->Blocks, this->Box, this->Vertices, this->Judge,
        [this](const Parameters& at) { return this->FindNormal(at); } },
      result);
    if (halve && !halve->empty())
    {
      return result;
    }
    result.IsUnproved = this->IsUnfinished && result.Deviation > this->Limits.Deflection;
    if (result.Triangles.empty())
    {
      result.Reason = "Its boundary runs back along itself.";
      this->HalveAll(halve);
    }
    return result;
  }

  /// |S_u| and |S_v| in the middle of the triangles that are inverted after Run(), less those that edges
  /// off the surface turn.
  const std::vector<Parameters>& GetInvertedSpeeds() const { return this->InvertedSpeeds; }

private:
  /// The loops take up more than rounding in a direction.
  bool HasWidth(int d) const
  {
    const double largest = std::max(std::abs(this->Box.Low[d]), std::abs(this->Box.High[d]));
    return std::isfinite(this->Size[d]) && this->Size[d] > MinWidth * largest;
  }

  /// Lengths of a grid step in which triangles are to be well shaped.
  Parameters GetGridMetric(const Parameters& wanted) const
  {
    const Parameters metric = wanted[0] > 0.0 && wanted[1] > 0.0 ? wanted : this->Steps.GetMetric();
    return { metric[0] * this->Size[0] / GridWidth, metric[1] * this->Size[1] / GridWidth };
  }

  GridPoint ToGrid(const Parameters& at) const
  {
    const auto map = [&](int d)
    { return GridStart + std::llround((at[d] - this->Box.Low[d]) / this->Size[d] * GridWidth); };
    return { map(0), map(1) };
  }

  MeshVertex Evaluate(const Parameters& at)
  {
    MeshVertex v;
    v.At = at;
    auto& [du, dv] = v.Derivatives;
    this->Walker.Evaluate(at[0], at[1], v.Position.data(), du.data(), dv.data());
    // At a pole a derivative is rounding, and so would be the normal.
    const Vector3 normal = Cross(du, dv);
    if (Norm(normal) > MinNormal * this->Steps.GetSpeed()[0] * this->Steps.GetSpeed()[1])
    {
      v.Normal = Normalized(normal);
    }
    return v;
  }

  /// Stores a vertex of the triangulation; the first one at a place stays.
  void Store(int id, const MeshVertex& vertex)
  {
    if (id >= static_cast<int>(this->Vertices.size()))
    {
      this->Vertices.resize(id + 1);
      this->Vertices[id] = vertex;
    }
  }

  void AddBoundary(std::vector<std::pair<int, int>>* halve, FaceMesh& result)
  {
    const std::size_t count = CountPoints(this->Loops);
    std::vector<int> ids;
    ids.reserve(count);
    this->Starts.reserve(count);
    this->Vertices.reserve(count + 4);
    this->Vertices.resize(4);
    for (const BoundaryLoop& loop : this->Loops)
    {
      for (const BoundaryPoint& p : loop)
      {
        MeshVertex v = this->Evaluate(p.Parameters);
        v.Shared = p.Shared;
        v.Gap = Norm(Subtract(v.Position, p.Position));
        v.Position = p.Position;
        ids.push_back(this->Mesh.Insert(this->ToGrid(p.Parameters), false));
        this->Starts.push_back(&p);
        this->Store(ids.back(), v);
      }
    }
    const auto ask = [&](int segment) { this->AskToHalve(segment, halve); };
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

  void AskToHalve(int segment, std::vector<std::pair<int, int>>* halve) const
  {
    const BoundaryPoint& start = *this->Starts[segment];
    if (halve && start.Edge >= 0)
    {
      halve->push_back({ start.Edge, start.Chord });
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

  /// Adds a point unless it is outside, or too near to a corner or to the boundary, by `scale` points per
  /// unit.
  void AddInner(const Parameters& at, const Parameters& scale)
  {
    if (this->IsExhausted())
    {
      return;
    }
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
      if (std::hypot(x[k], y[k]) < MinGap)
      {
        return;
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const int a = (k + 1) % 3;
      const int b = (k + 2) % 3;
      const double length = std::hypot(x[b] - x[a], y[b] - y[a]);
      if (t.Sides[k].Segment >= 0 && std::abs(x[a] * y[b] - x[b] * y[a]) < MinGap * length)
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

  /// Largest error of a triangle between its corners that is allowed: the deflection less the gap of a
  /// corner. Where a corner's gap takes most of the deflection, no number of points keeps the promise.
  double GetAllowed(const Triangulation::Triangle& t) const
  {
    const double gap = this->Judge.GetGap(t.Vertex);
    return gap > MaxGapShare * this->Limits.Deflection ? this->Limits.Deflection
                                                       : this->Limits.Deflection - gap;
  }

  bool IsExhausted() const
  {
    return this->Mesh.GetNumberOfFlips() > MaxFlips + MaxFlipsOfPoint * this->Vertices.size();
  }

  /// Inserts points until all triangles are good, or no more can be done.
  void Refine()
  {
    std::vector<int> open;
    open.reserve(2 * this->Mesh.GetTriangles().size());
    for (std::size_t i = this->Mesh.GetTriangles().size(); i-- > 0;)
    {
      open.push_back(static_cast<int>(i));
    }
    const std::size_t maximum = 2 * this->Vertices.size() + MaxRefinement;
    std::size_t turns = MaxTurns + this->Vertices.size() / 4;
    while (!open.empty() && this->Vertices.size() < maximum && !this->IsExhausted())
    {
      const Triangulation::Triangle& t = this->Mesh.GetTriangles()[open.back()];
      open.pop_back();
      if (!t.Inside || this->Judge.IsCollapsed(t.Vertex))
      {
        continue;
      }
      const double error = this->Judge.GetError(t.Vertex);
      const double allowed = this->GetAllowed(t);
      if (error <= allowed)
      {
        // A triangle may be inverted where the surface bends, but also where edges lie off it: that no
        // point mends.
        if (turns == 0 || error < TurnShare * allowed || !this->Judge.IsAgainstCorners(t.Vertex) ||
          !this->Judge.IsFolded(t.Vertex))
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
    this->IsUnfinished = !open.empty();
  }

  /// The middle of the side that adds most to the error and is not a segment; of the triangle where all are.
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

  /// The triangles, as few inverted as can be had. Asks to halve chords next to those that are left.
  std::vector<Corners> Repair(std::vector<std::pair<int, int>>* halve, FaceMesh& result)
  {
    std::vector<Corners> triangles;
    triangles.reserve(this->Mesh.GetTriangles().size());
    bool any = false;
    for (const Triangulation::Triangle& t : this->Mesh.GetTriangles())
    {
      if (t.Inside && !this->Judge.IsCollapsed(t.Vertex))
      {
        triangles.push_back(t.Vertex);
        any = any || this->Judge.IsInverted(t.Vertex);
      }
    }
    if (!any)
    {
      return triangles;
    }
    const std::map<std::pair<int, int>, int> segments = MeshRepair::FindSegments(this->Mesh);
    const MeshRepair::TriangleTests tests{ [this](const Corners& t) { return this->Judge.IsInverted(t); },
      [this](const Corners& t)
      { return this->Judge.IsCollapsed(t) ? HUGE_VAL : this->Judge.GetDeviation(t); } };
    const std::vector<Corners> left =
      MeshRepair(triangles, this->Mesh.GetPoints(), segments, tests, this->Limits.Deflection).Run();
    std::set<int> corners;
    for (const Corners& t : left)
    {
      // Points on the edges do not mend what edges off the surface turn over.
      if (this->Judge.GetHeight(t) > this->Judge.GetGap(t))
      {
        corners.insert(t.begin(), t.end());
      }
    }
    for (const auto& [side, segment] : segments)
    {
      if (corners.count(side.first) > 0 || corners.count(side.second) > 0)
      {
        this->AskToHalve(segment, halve);
      }
    }
    result.InvertedTriangles = static_cast<int>(left.size());
    for (const Corners& t : left)
    {
      if (this->Judge.IsFolded(t))
      {
        this->InvertedSpeeds.push_back(this->Judge.GetSpeeds(t));
      }
    }
    const bool isFolded = this->InvertedSpeeds.size() == left.size();
    if (!left.empty() && result.Reason.empty())
    {
      result.Reason = isFolded
        ? "Triangles are inverted, because the face is too narrow for its bent parameter lines."
        : "Triangles are inverted, because edges lie off the surface.";
    }
    return triangles;
  }

  /// The normal of a point where Su x Sv vanishes: of one next to it, else 0.
  Vector3 FindNormal(const Parameters& at)
  {
    for (const double step : { 1e-6, 1e-3 })
    {
      Parameters beside;
      for (int d = 0; d < 2; ++d)
      {
        beside[d] = (1.0 - step) * at[d] + step * 0.5 * (this->Box.Low[d] + this->Box.High[d]);
      }
      const MeshVertex v = this->Evaluate(beside);
      if (Dot(v.Normal, v.Normal) > 0.0)
      {
        return v.Normal;
      }
    }
    return { 0.0, 0.0, 0.0 };
  }

  const Face& Source;
  const SurfaceBlocks& Blocks;
  const std::vector<BoundaryLoop>& Loops;
  const MeshLimits& Limits;
  NURBSSurface::Walker Walker;
  ParameterBox Box;
  Parameters Size{};
  MeshSteps Steps;
  Triangulation Mesh;
  std::vector<MeshVertex> Vertices;
  TriangleJudge Judge;
  /// Refinement ended before all triangles were good.
  bool IsUnfinished = false;
  std::vector<Parameters> InvertedSpeeds;
  /// The point at which each segment starts.
  std::vector<const BoundaryPoint*> Starts;
};
}

FaceMesh MeshFace(const Face& face, const SurfaceBlocks& blocks, const std::vector<BoundaryLoop>& loops,
  const MeshLimits& limits, std::vector<std::pair<int, int>>* halve)
{
  std::vector<std::pair<int, int>> asked;
  Mesher mesher(face, blocks, loops, limits, {});
  FaceMesh best = mesher.Run(halve ? &asked : nullptr);
  // A neck may need other shapes of triangles than the rest of the face.
  const std::vector<Parameters>& speeds = mesher.GetInvertedSpeeds();
  const std::size_t metrics = best.Triangles.size() > MaxTriangles ? 0 : std::min(MaxMetrics, speeds.size());
  for (std::size_t i = 0; i < metrics && best.InvertedTriangles > 0; ++i)
  {
    std::vector<std::pair<int, int>> askedNow;
    const std::size_t k = i * (speeds.size() - 1) / std::max(metrics - 1, std::size_t(1));
    FaceMesh other = Mesher(face, blocks, loops, limits, speeds[k]).Run(halve ? &askedNow : nullptr);
    if (!other.Triangles.empty() && other.InvertedTriangles < best.InvertedTriangles &&
      other.Deviation <= std::max(best.Deviation, limits.Deflection))
    {
      best = std::move(other);
      asked = std::move(askedNow);
    }
  }
  if (halve)
  {
    halve->insert(halve->end(), asked.begin(), asked.end());
  }
  return best;
}
}
