#include "smSTEPTrims.h"

#include "smOCCTFailure.h"
#include "smOCCTMakeGeometry.h"
#include "smSTEPGeometryReading.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

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
  gp_Pnt2d from;
  gp_Vec2d along;
  first.Curve->D1(0.5 * (first.Range[0] + first.Range[1]), from, along);
  const gp_Pnt2d to = other.Curve->Value(0.5 * (other.Range[0] + other.Range[1]));
  return along.Crossed(gp_Vec2d(from, to)) > 0.0;
}
}

/// Adds the parameter curves that the file has of an edge on a surface. An edge that a loop uses twice has
/// two.
void STEPTrims::Add(
  Index entity, int count, Index surfaceEntity, const TopoDS_Edge& edge, const TopoDS_Face& face)
{
  const Index curve = this->Entities.Follow(this->Entities.Get(entity, CurveOfEdge));
  std::string_view record;
  if (!this->Entities.FindRecord(curve, AssociatedGeometry.Record, record) &&
    !this->Entities.FindRecord(curve, "SEAM_CURVE", record) &&
    !this->Entities.FindRecord(curve, "INTERSECTION_CURVE", record))
  {
    return;
  }
  std::vector<STEPTrim> trims;
  const STEPKernelGeometry::Surface& surface = this->Shared.GetSurface(surfaceEntity);
  bool isUsable = !surface.Kernel->IsKind(STANDARD_TYPE(Geom_Plane)) && !surface.IsFlipped;
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
  double tolerance = 0.0;
  for (const STEPTrim& trim : trims)
  {
    tolerance = std::max(tolerance, trim.Distance);
  }
  if (isUsable && trims.size() == 2 && count == 2)
  {
    const bool isFirstForward = IsLeft(trims[0], trims[1]);
    const STEPTrim& forward = trims[isFirstForward ? 0 : 1];
    const STEPTrim& backward = trims[isFirstForward ? 1 : 0];
    this->Builder.UpdateEdge(edge, forward.Curve, backward.Curve, face, tolerance);
    this->Builder.Range(edge, face, forward.Range[0], forward.Range[1]);
  }
  else if (isUsable && trims.size() == 1 && count == 1)
  {
    this->Builder.UpdateEdge(edge, trims[0].Curve, face, tolerance);
    this->Builder.Range(edge, face, trims[0].Range[0], trims[0].Range[1]);
  }
  else
  {
    return;
  }
  for (TopoDS_Iterator it(edge); it.More(); it.Next())
  {
    this->Builder.UpdateVertex(TopoDS::Vertex(it.Value()), tolerance);
  }
}

/// Reads a parameter curve; returns false if it is not that of the edge, as far as the file is accurate.
bool STEPTrims::Read(Index pcurve, Index entity, Index surfaceEntity, const TopoDS_Edge& edge, STEPTrim& trim)
{
  const Index definition = this->Entities.Follow(this->Entities.Get(pcurve, DefinitionOfTrim));
  const std::vector<Index> items =
    ReadGeometryList(this->Entities, this->Entities.Get(definition, ItemsOfRepresentation));
  const Index spaceEntity = this->Entities.Follow(this->Entities.Get(entity, CurveOfEdge));
  const STEPCurve<2>* file = items.empty() ? nullptr : this->Shared.Values.GetPlaneCurve(items[0]);
  const STEPCurve<3>* space = this->Shared.Values.GetCurve(spaceEntity);
  // A curve of several parts is joined with other parameters.
  if (!file || !space || space->Value->GetIf<CompositeCurve<3>>())
  {
    return false;
  }
  const STEPKernelGeometry::Surface& surface = this->Shared.GetSurface(surfaceEntity);
  std::string problem;
  STEPParameterCurve stated;
  stated.Curve = this->Shared.Values.MapToNatural(*file, *surface.Value, problem);
  if (!stated.Curve.Value || !(stated.Curve.Parameter.Scale * space->Parameter.Scale > 0.0))
  {
    return false;
  }
  double ends[2] = { 0.0, 0.0 };
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, ends[0], ends[1]);
  const auto toTrim = [&](double t)
  { return stated.Curve.Parameter((t - space->Parameter.Offset) / space->Parameter.Scale); };
  double atEnds = 0.0;
  const std::string failure = CatchFailure(
    [&]
    {
      trim.Curve = MakeKernelCurve(*stated.Curve.Value);
      for (int i = 0; i <= TrimSamples; ++i)
      {
        const double t = i == TrimSamples ? ends[1] : ends[0] + (ends[1] - ends[0]) * i / TrimSamples;
        const gp_Pnt2d uv = trim.Curve->Value(toTrim(t));
        const double distance = surface.Kernel->Value(uv.X(), uv.Y()).Distance(curve->Value(t));
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
    const gp_Pnt point = curve->Value(t);
    stated.Points[i] = { point.X(), point.Y(), point.Z() };
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
