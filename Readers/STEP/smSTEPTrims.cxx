#include "smSTEPTrims.h"

#include "smCatchFailure.h"
#include "smSTEPGeometryReading.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"

#include <algorithm>

namespace sm
{
namespace
{
constexpr STEPAttribute AssociatedGeometry = { "SURFACE_CURVE", 1, 2, "associated geometry" };
constexpr STEPAttribute MasterOfSurfaceCurve = { "SURFACE_CURVE", 2, 3, "master representation" };
constexpr STEPAttribute SurfaceOfTrim = { "PCURVE", 0, 1, "surface" };
constexpr STEPAttribute DefinitionOfTrim = { "PCURVE", 1, 2, "curve" };

/// Number of parts of an edge at whose ends its parameter curves are compared with it.
constexpr int TrimSamples = 24;

/// Returns true if the other curve of a seam is on the left of the first one, where the face is that a
/// forward edge bounds.
bool IsLeft(const STEPTrim& first, const STEPTrim& other)
{
  GeometricCurve<2>::Derivatives from;
  first.Curve->Evaluate(0.5 * (first.Range[0] + first.Range[1]), 1, from);
  const Point2 to = other.Curve->Evaluate(0.5 * (other.Range[0] + other.Range[1]));
  return from[1][0] * (to[1] - from[0][1]) - from[1][1] * (to[0] - from[0][0]) > 0.0;
}
}

/// Adds the parameter curves that the file has of an edge on a surface. An edge that a loop uses twice has
/// two.
void STEPTrims::Add(Index entity, int count, Index surfaceEntity, CoedgeShape& use)
{
  EdgeShape& edge = *use.Edge;
  const Index curve = this->Entities.Follow(this->Entities.Get(entity, CurveOfEdge));
  std::string_view record;
  if (!this->Entities.FindRecord(curve, AssociatedGeometry.Record, record) &&
    !this->Entities.FindRecord(curve, "SEAM_CURVE", record) &&
    !this->Entities.FindRecord(curve, "INTERSECTION_CURVE", record))
  {
    return;
  }
  std::vector<STEPTrim> trims;
  const STEPBodyGeometry::Surface& surface = this->Shared.GetSurface(surfaceEntity);
  bool isUsable = !FindElementary(*surface.Native, ElementarySurface::Type::Plane) && !surface.IsFlipped;
  Part21Values values(this->Entities.Get(curve, AssociatedGeometry).Text);
  for (Part21Value value; values.Next(value);)
  {
    const Index pcurve = this->Entities.Follow(value);
    if (pcurve != Part21File::None &&
      this->Entities.Follow(this->Entities.Get(pcurve, SurfaceOfTrim)) == surfaceEntity)
    {
      STEPTrim trim;
      isUsable = this->Read(pcurve, entity, surfaceEntity, edge, trim) && isUsable;
      trims.push_back(trim);
    }
  }
  if (!isUsable || trims.size() > 2 || static_cast<int>(trims.size()) != count)
  {
    return;
  }
  double tolerance = 0.0;
  for (const STEPTrim& trim : trims)
  {
    tolerance = std::max(tolerance, trim.Distance);
  }
  const bool isFirstForward = count == 1 || IsLeft(trims[0], trims[1]);
  const STEPTrim& own = trims[count == 1 || use.Reversed != isFirstForward ? 0 : 1];
  use.Trim = own.Curve;
  use.First = own.Range[0];
  use.Last = own.Range[1];
  edge.Tolerance = std::max(edge.Tolerance, tolerance);
  for (const VertexPointer& vertex : { edge.Start, edge.End })
  {
    vertex->Tolerance = std::max(vertex->Tolerance, tolerance);
  }
}

/// Reads a parameter curve; returns false if it is not that of the edge, as far as the file is accurate.
bool STEPTrims::Read(Index pcurve, Index entity, Index surfaceEntity, const EdgeShape& edge, STEPTrim& trim)
{
  const Index definition = this->Entities.Follow(this->Entities.Get(pcurve, DefinitionOfTrim));
  const std::vector<Index> items =
    ReadGeometryList(this->Entities, this->Entities.Get(definition, ItemsOfRepresentation));
  const Index spaceEntity = this->Entities.Follow(this->Entities.Get(entity, CurveOfEdge));
  const STEPCurve<2>* file = items.empty() ? nullptr : this->Shared.Values.GetPlaneCurve(items[0]);
  const STEPCurve<3>* space = this->Shared.Values.GetCurve(spaceEntity);
  // The parameters of curves of several parts are others.
  if (!file || !space || space->Value->GetIf<CompositeCurve<3>>() || edge.Curve->GetIf<CompositeCurve<3>>())
  {
    return false;
  }
  const STEPBodyGeometry::Surface& surface = this->Shared.GetSurface(surfaceEntity);
  std::string problem;
  STEPParameterCurve stated;
  stated.Curve = this->Shared.Values.MapToNatural(*file, *surface.Value, problem);
  if (!stated.Curve.Value || !(stated.Curve.Parameter.Scale * space->Parameter.Scale > 0.0))
  {
    return false;
  }
  const double ends[2] = { edge.First, edge.Last };
  const auto toTrim = [&](double t)
  { return stated.Curve.Parameter((t - space->Parameter.Offset) / space->Parameter.Scale); };
  double atEnds = 0.0;
  const std::string failure = CatchFailure(
    [&]
    {
      trim.Curve = stated.Curve.Value;
      for (int i = 0; i <= TrimSamples; ++i)
      {
        const double t = i == TrimSamples ? ends[1] : ends[0] + (ends[1] - ends[0]) * i / TrimSamples;
        const Point2 uv = trim.Curve->Evaluate(toTrim(t));
        const double distance = Norm(Subtract(surface.Native->Evaluate(uv[0], uv[1]), edge.Evaluate(t)));
        const bool isEnd = i == 0 || i == TrimSamples;
        atEnds = std::max(atEnds, isEnd ? distance : 0.0);
        trim.Distance = std::max(trim.Distance, distance);
      }
      trim.Range[0] = toTrim(ends[0]);
      trim.Range[1] = toTrim(ends[1]);
    });
  const Part21File& text = this->Entities.File;
  stated.Edge = text.GetId(entity);
  stated.Id = text.GetId(pcurve);
  stated.SpaceCurve = text.GetId(this->FindSpaceCurve(spaceEntity));
  stated.Surface = surface.Value->Value;
  stated.IsPreferred = this->Entities.Get(spaceEntity, MasterOfSurfaceCurve).Text != "CURVE_3D";
  stated.Angle = this->Shared.Units.Angle;
  for (std::size_t i = 0; i < stated.Points.size(); ++i)
  {
    const double t = ends[0] + STEPParameterCurve::Fractions[i] * (ends[1] - ends[0]);
    stated.Points[i] = edge.Evaluate(t);
    stated.Parameters[i] = toTrim(t);
  }
  if (!(stated.GetDistance() <= this->Precision))
  {
    stated.Finder = this->Shared.GetFinder(surfaceEntity);
    this->Others.push_back(std::move(stated));
  }
  return failure.empty() && atEnds <= this->Precision && trim.Distance <= 2.0 * this->Precision;
}

STEPTrims::Index STEPTrims::FindSpaceCurve(Index curve) const
{
  const Index space = this->Entities.Follow(this->Entities.Get(curve, CurveInSpace));
  return space == Part21File::None ? curve : space;
}
}
