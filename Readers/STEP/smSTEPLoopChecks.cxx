#include "smSTEPLoopChecks.h"

#include "smSTEPTopologyAttributes.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sm
{
namespace
{
/// Distance of a vertex from its edge's curve, relative to the extent of the body's edges, above which the
/// two contradict each other. It is twice the default limit of gaps; real files have up to 1.3e-3.
constexpr double VertexLimit = 2e-3;
/// The same for a closed circle or ellipse, relative to its smaller radius: its vertex only says where the
/// edge begins, which no area and no volume depends on. A wrong curve lies off the faces that it bounds,
/// which is found there.
constexpr double ClosedCurveLimit = 0.1;
/// The same in units of the file's stated uncertainty, which is added.
constexpr double UncertaintyLimit = 2.0;

/// Ends of edges that are closer than this, relative to the extent of the loop's vertices, are connected. A
/// wider gap is detected by the integrals, too.
constexpr double LoopTolerance = 1e-3;

/// An edge of a loop, as the loop runs along it.
struct LoopEdge
{
  std::uint64_t Id = 0;
  Vector3 Start{};
  Vector3 End{};
  bool Straight = false;
};

struct Extent
{
  Vector3 Low{ 1e300, 1e300, 1e300 };
  Vector3 High{ -1e300, -1e300, -1e300 };

  void Add(const Vector3& point, const Vector3& reach = {})
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], point[c] - reach[c]);
      this->High[c] = std::max(this->High[c], point[c] + reach[c]);
    }
  }
  double GetSize() const { return this->Low[0] <= this->High[0] ? GetDistance(this->Low, this->High) : 0.0; }
};

/// Finds the indices of the edges that run against the others if the first one is kept, or reversed. Returns
/// false if the edges form no loop in this order.
bool FindReversed(const std::vector<LoopEdge>& edges, double tolerance, bool isFirstReversed,
  std::vector<std::size_t>& reversed)
{
  reversed.clear();
  const Vector3& start = isFirstReversed ? edges[0].End : edges[0].Start;
  Vector3 at = start;
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const LoopEdge& edge = edges[k];
    const bool isReversed = k == 0 ? isFirstReversed : GetDistance(at, edge.Start) > tolerance;
    if (isReversed && GetDistance(at, edge.End) > tolerance)
    {
      return false;
    }
    if (isReversed)
    {
      reversed.push_back(k);
    }
    at = isReversed ? edge.Start : edge.End;
  }
  return GetDistance(at, start) <= tolerance;
}

/// Finds the edges that run against the others; none if the edges are a loop, or none in any direction.
std::vector<std::size_t> FindReversed(const std::vector<LoopEdge>& edges, double tolerance)
{
  std::vector<std::size_t> reversed;
  std::vector<std::size_t> others;
  const bool isLoop = FindReversed(edges, tolerance, false, reversed);
  if (isLoop && reversed.empty())
  {
    return reversed;
  }
  if (FindReversed(edges, tolerance, true, others) && (!isLoop || others.size() <= reversed.size()))
  {
    reversed = isLoop && others.size() == reversed.size() ? reversed : std::vector<std::size_t>();
    reversed.insert(reversed.end(), others.begin(), others.end());
    return reversed;
  }
  return isLoop ? reversed : std::vector<std::size_t>();
}

bool IsClosed(const STEPEdge& edge)
{
  return GetDistance(edge.Start, edge.End) <= STEPEdges::SameVertex;
}

/// Returns the curve of an edge if it is a circle or an ellipse, else null.
const ConicCurve<3>* FindEllipse(const STEPEdge& edge)
{
  const auto* conic = edge.Curve->GetIf<ConicCurve<3>>();
  return conic && conic->Kind == ConicCurve<3>::Type::Ellipse ? conic : nullptr;
}

/// Extends a box by the vertices of an edge, and by a circle or an ellipse that begins and ends at one.
void AddExtent(const STEPEdge& edge, Extent& extent)
{
  extent.Add(edge.Start);
  extent.Add(edge.End);
  const ConicCurve<3>* ellipse = FindEllipse(edge);
  if (ellipse && IsClosed(edge))
  {
    Vector3 reach;
    for (std::size_t c = 0; c < 3; ++c)
    {
      reach[c] = std::hypot(ellipse->Radii[0] * ellipse->X[c], ellipse->Radii[1] * ellipse->Y[c]);
    }
    extent.Add(ellipse->Center, reach);
  }
}
}

void STEPLoopChecks::Add(CensusDefect defect, Index entity, std::uint64_t other, const char* place)
{
  this->Census.AddProblem(defect, this->Entities.File.GetId(entity), other, place);
}

void STEPLoopChecks::AddLoop(const STEPFaceLoop& loop, STEPEdges& edges)
{
  if (!this->Known.insert(loop.Entity).second)
  {
    return;
  }
  std::vector<LoopEdge> found;
  Extent extent;
  for (const STEPFaceLoop::Use& use : loop.Uses)
  {
    const STEPEdge& edge = *edges.GetEdge(use.Edge);
    // Start and End are in the order of the curve.
    LoopEdge each{ edge.Id, edge.Start, edge.End, edge.Curve->GetIf<LineCurve<3>>() != nullptr };
    if (use.IsForward != edge.IsForward)
    {
      std::swap(each.Start, each.End);
    }
    extent.Add(each.Start);
    extent.Add(each.End);
    found.push_back(each);
    if (this->Known.insert(use.Edge).second)
    {
      this->Edges.emplace_back(use.Edge, &edge);
    }
  }
  const std::vector<std::size_t> reversed =
    found.size() < 2 ? std::vector<std::size_t>() : FindReversed(found, LoopTolerance * extent.GetSize());
  // A straight edge has the same points in both directions, but a closed curve has two different parts
  // between two points.
  const auto curved =
    std::find_if(reversed.begin(), reversed.end(), [&found](std::size_t k) { return !found[k].Straight; });
  if (!reversed.empty())
  {
    const bool isCurved = curved != reversed.end();
    this->Add(isCurved ? CensusDefect::ReversedEdge : CensusDefect::ReversedLine, loop.Entity,
      found[isCurved ? *curved : reversed.front()].Id, EdgesOfLoop.Name);
  }
}

void STEPLoopChecks::CheckEdge(Index entity, const STEPEdge& edge, double limit)
{
  const Index given = this->Entities.Follow(this->Entities.Get(entity, CurveOfEdge));
  std::string_view record;
  const Index curve = this->Entities.FindRecord(given, CurveInSpace.Record, record)
    ? this->Entities.Follow(this->Entities.Get(given, CurveInSpace))
    : given;
  const ConicCurve<3>* ellipse = FindEllipse(edge);
  const double most = ellipse && IsClosed(edge)
    ? std::max(limit, ClosedCurveLimit * std::min(ellipse->Radii[0], ellipse->Radii[1]))
    : limit;
  if ((ellipse || edge.Curve->GetIf<LineCurve<3>>()) && edge.Gap > most)
  {
    this->Add(CensusDefect::CurveOffVertex, entity, this->Entities.File.GetId(curve), "curve");
  }
  else if (edge.IsTurned && GetDistance(edge.Start, edge.End) > limit)
  {
    this->Add(CensusDefect::ReversedLine, entity, this->Entities.File.GetId(curve), "curve");
  }
}

void STEPLoopChecks::FinishBody(double uncertainty)
{
  Extent extent;
  for (const auto& [entity, edge] : this->Edges)
  {
    AddExtent(*edge, extent);
  }
  // The vertices of a body with one vertex have no extent.
  const double size = extent.GetSize();
  const double limit = VertexLimit * size + UncertaintyLimit * uncertainty;
  for (const auto& [entity, edge] : this->Edges)
  {
    if (size > 0.0)
    {
      this->CheckEdge(entity, *edge, limit);
    }
  }
  this->Edges.clear();
}
}
