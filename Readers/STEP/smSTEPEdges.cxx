#include "smSTEPEdges.h"

#include "Geometry/smCurveFoot.h"
#include "smSTEPGeometryReading.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// A parameter that lies this far before the start of a period, in radians, is the start.
constexpr double SameStart = 1e-9;

constexpr STEPAttribute SenseOfEdge = { "EDGE_CURVE", 1, 4, "sense" };

/// Finds the range of a curve between two vertices.
class EdgeRange
{
public:
  explicit EdgeRange(STEPEdge& edge)
    : Edge(edge)
    , Curve(*edge.Curve)
    , IsSame(Norm(Subtract(edge.End, edge.Start)) <= STEPEdges::SameVertex)
  {
  }

  /// `range` is what a trimmed curve leaves of it. Throws the reason if there is no part.
  void Find(const ParameterRange& range)
  {
    if (this->Curve.GetPeriod() > 0.0)
    {
      this->FindPeriodic();
    }
    else
    {
      const bool isEndless = !std::isfinite(range.Low) || !std::isfinite(range.High);
      this->Edge.First = this->Locate(this->Edge.Start, range);
      this->Edge.Last = this->Locate(this->Edge.End, range);
      if (!isEndless && this->IsClosed(range))
      {
        this->FindClosed(range);
      }
      else if (this->IsSame && this->Edge.First == this->Edge.Last)
      {
        throw STEPGeometryFailure{ "its vertices are the same, and its curve is not closed" };
      }
      else if (this->Edge.First > this->Edge.Last)
      {
        std::swap(this->Edge.First, this->Edge.Last);
        std::swap(this->Edge.Start, this->Edge.End);
        this->Edge.IsForward = !this->Edge.IsForward;
        this->Edge.IsTurned = true;
      }
    }
    if (!std::isfinite(this->Edge.First) || !(this->Edge.First < this->Edge.Last))
    {
      throw STEPGeometryFailure{ "its vertices do not state a part of its curve" };
    }
  }

private:
  /// The part of an ellipse, or of another periodic curve, begins in its first period.
  void FindPeriodic()
  {
    const double period = this->Curve.GetPeriod();
    this->Edge.First = FindCurveParameter<3>(this->Curve, this->Edge.Start);
    this->Edge.Last = FindCurveParameter<3>(this->Curve, this->Edge.End);
    const double low = this->Curve.GetDomain().Low;
    this->Edge.First -= std::floor((this->Edge.First - low) / period) * period;
    // A vertex at the start may be before it, by its digits.
    this->Edge.First -= low + period - this->Edge.First < SameStart ? period : 0.0;
    this->Edge.Last -= std::floor((this->Edge.Last - this->Edge.First) / period) * period;
    if (this->IsSame || this->Edge.Last <= this->Edge.First)
    {
      this->Edge.Last = this->Edge.First + period;
    }
  }

  bool IsClosed(const ParameterRange& range) const
  {
    const Vector3 gap = Subtract(this->Curve.Evaluate(range.Low), this->Curve.Evaluate(range.High));
    return Norm(gap) <= STEPEdges::SameVertex;
  }

  double Locate(const Vector3& vertex, const ParameterRange& range) const
  {
    for (const double end : { range.Low, range.High })
    {
      if (std::isfinite(end) && Norm(Subtract(this->Curve.Evaluate(end), vertex)) <= STEPEdges::SameVertex)
      {
        return end;
      }
    }
    return std::clamp(FindCurveParameter<3>(this->Curve, vertex), range.Low, range.High);
  }

  /// The seam of a closed curve is its first and its last parameter.
  void FindClosed(const ParameterRange& range)
  {
    STEPEdge& edge = this->Edge;
    edge.First = edge.First == range.High ? range.Low : edge.First;
    edge.Last = edge.Last == range.Low ? range.High : edge.Last;
    if (edge.First < edge.Last && !(this->IsSame && edge.First > range.Low))
    {
      return;
    }
    CompositeCurve<3> parts;
    parts.Segments.push_back({ edge.Curve, edge.First, range.High, range.High - edge.First });
    parts.Segments.push_back({ edge.Curve, range.Low, edge.Last, edge.Last - range.Low });
    std::string problem;
    edge.Curve = GeometricCurve<3>::Make(std::move(parts), problem);
    RequireGeometry(problem);
    edge.First = 0.0;
    edge.Last = edge.Curve->GetDomain().High;
  }

  STEPEdge& Edge;
  const GeometricCurve<3>& Curve;
  const bool IsSame;
};
}

STEPEdges::STEPEdges(
  const STEPAttributes& entities, const STEPUnitSizes& units, STEPGeometry& geometry, STEPLedger& ledger)
  : Entities(entities)
  , Units(units)
  , Geometry(geometry)
  , Ledger(ledger)
{
}

Vector3 STEPEdges::ReadVertex(Index vertex) const
{
  const Index point = this->Entities.Follow(this->Entities.Get(vertex, PointOfVertex));
  if (!this->Entities.Has(vertex, STEPRole::Vertex))
  {
    throw STEPGeometryFailure{ "one of its vertices is missing" };
  }
  return ReadGeometryPoint<3>(this->Entities, point, this->Units.Length);
}

STEPEdge STEPEdges::Make(Index entity)
{
  STEPEdge edge;
  edge.Id = this->Entities.File.GetId(entity);
  edge.Name = this->Entities.Get(entity, NameOfItem).Text;
  const STEPCurve<3>* curve =
    this->Geometry.GetCurve(this->Entities.Follow(this->Entities.Get(entity, CurveOfEdge)));
  if (!curve)
  {
    throw STEPGeometryFailure{ "its curve is missing or left out" };
  }
  edge.Curve = curve->Value;
  edge.Start = this->ReadVertex(this->Entities.Follow(this->Entities.Get(entity, StartOfEdge)));
  edge.End = this->ReadVertex(this->Entities.Follow(this->Entities.Get(entity, EndOfEdge)));
  const bool agrees = RequireLogical(this->Entities.Get(entity, SenseOfEdge), SenseOfEdge.Name);
  edge.IsForward = agrees == (curve->Parameter.Scale > 0.0);
  if (!edge.IsForward)
  {
    std::swap(edge.Start, edge.End);
  }
  EdgeRange(edge).Find(curve->Range);
  edge.Gap = std::max(Norm(Subtract(edge.Curve->Evaluate(edge.First), edge.Start)),
    Norm(Subtract(edge.Curve->Evaluate(edge.Last), edge.End)));
  return edge;
}

const STEPEdge* STEPEdges::GetEdge(Index entity)
{
  if (entity == Part21File::None)
  {
    return nullptr;
  }
  const auto [found, isNew] = this->Edges.try_emplace(entity);
  if (!isNew)
  {
    return found->second.get();
  }
  const Part21File& file = this->Entities.File;
  try
  {
    std::string_view record;
    if (file.IsDamaged(entity) || !this->Entities.FindRecord(entity, SenseOfEdge.Record, record))
    {
      throw STEPGeometryFailure{ "it is not an EDGE_CURVE, or is damaged" };
    }
    found->second = std::make_unique<STEPEdge>(this->Make(entity));
  }
  catch (const STEPGeometryFailure& failure)
  {
    this->Ledger.Rows.push_back(
      { file.GetId(entity), SenseOfEdge.Record, failure.Reason, "faces that it bounds are missing" });
  }
  return found->second.get();
}
}
