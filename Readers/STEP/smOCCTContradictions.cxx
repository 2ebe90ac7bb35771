#include "smOCCTContradictions.h"

#include "smFormat.h"

#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Circle.hxx>
#include <StepGeom_CompositeCurve.hxx>
#include <StepGeom_ConicalSurface.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_Ellipse.hxx>
#include <StepGeom_Point.hxx>
#include <StepGeom_RectangularTrimmedSurface.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepGeom_ToroidalSurface.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_VertexLoop.hxx>
#include <StepShape_VertexPoint.hxx>
#include <gp_Ax3.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Loops may lead beyond a trimmed surface by this fraction of its width.
constexpr double Slack = 1e-6;

/// Distances below this, relative to the coordinates, are rounding of the numbers in the file.
constexpr double Rounding = 1e-14;

/// Largest depth of trimmed surfaces of trimmed surfaces that is examined.
constexpr int MostTrimmedSurfaces = 4;

/// Largest distance of a vertex from the apex of its cone, relative to the cone's size: that of a vertex from
/// its sphere or torus.
constexpr double ApexLimit = 2e-3;

bool GetCoordinates(const Handle(StepGeom_CartesianPoint) & point, gp_XYZ& xyz)
{
  if (point.IsNull() || point->NbCoordinates() != 3)
  {
    return false;
  }
  xyz.SetCoord(point->CoordinatesValue(1), point->CoordinatesValue(2), point->CoordinatesValue(3));
  return true;
}

/// Reads origin and axis of a placement, in the unit of the file.
bool GetFrame(const Handle(StepGeom_Axis2Placement3d) & placement, gp_Ax3& frame)
{
  gp_XYZ origin;
  if (placement.IsNull() || !GetCoordinates(placement->Location(), origin))
  {
    return false;
  }
  gp_XYZ axis(0.0, 0.0, 1.0);
  const Handle(StepGeom_Direction) direction = placement->HasAxis() ? placement->Axis() : nullptr;
  if (!direction.IsNull())
  {
    if (direction->NbDirectionRatios() != 3)
    {
      return false;
    }
    for (int c = 1; c <= 3; ++c)
    {
      axis.SetCoord(c, direction->DirectionRatiosValue(c));
    }
  }
  if (!(axis.Modulus() > 0.0))
  {
    return false;
  }
  frame = gp_Ax3(gp_Pnt(origin), gp_Dir(axis));
  return true;
}

/// Returns the radius of a circle, the first one of an ellipse; 0 for other curves.
double GetRadius(Handle(StepGeom_Curve) curve)
{
  const auto onSurface = Handle(StepGeom_SurfaceCurve)::DownCast(curve);
  curve = onSurface.IsNull() ? curve : onSurface->Curve3d();
  const auto circle = Handle(StepGeom_Circle)::DownCast(curve);
  const auto ellipse = Handle(StepGeom_Ellipse)::DownCast(curve);
  return !circle.IsNull() ? circle->Radius() : !ellipse.IsNull() ? ellipse->SemiAxis1() : 0.0;
}
}

bool IsWithoutEdges(const Handle(StepShape_FaceSurface) & face)
{
  for (int i = 1; i <= face->NbBounds(); ++i)
  {
    const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
    if (!bound.IsNull() && Handle(StepShape_VertexLoop)::DownCast(bound->Bound()).IsNull())
    {
      return false;
    }
  }
  return true;
}

Handle(StepGeom_Surface) GetBasisOfFace(const Handle(StepShape_FaceSurface) & face)
{
  Handle(StepGeom_Surface) surface = face.IsNull() ? nullptr : face->FaceGeometry();
  // A damaged trimmed surface may be its own basis. Faces that were removed for this reason are still
  // entities of the model.
  for (int depth = 0; depth < MostTrimmedSurfaces; ++depth)
  {
    const auto trimmed = Handle(StepGeom_RectangularTrimmedSurface)::DownCast(surface);
    surface = trimmed.IsNull() ? surface : trimmed->BasisSurface();
  }
  return surface;
}

bool GetPoint(const Handle(StepShape_Vertex) & vertex, gp_Pnt& position)
{
  const auto onPoint = Handle(StepShape_VertexPoint)::DownCast(vertex);
  const auto point = Handle(StepGeom_CartesianPoint)::DownCast(
    onPoint.IsNull() ? Handle(StepGeom_Point)() : onPoint->VertexGeometry());
  gp_XYZ xyz;
  const bool isFound = GetCoordinates(point, xyz);
  position = gp_Pnt(xyz);
  return isFound;
}

void CheckSpindleTori(const ModelEntities& entities, std::vector<std::string>& defects)
{
  const Handle(StepData_StepModel)& model = entities.GetModel();
  entities.ForEach<StepShape_FaceSurface>(
    [&](const Handle(StepShape_FaceSurface) & face)
    {
      const auto torus = Handle(StepGeom_ToroidalSurface)::DownCast(GetBasisOfFace(face));
      if (!torus.IsNull() && torus->MinorRadius() > std::abs(torus->MajorRadius()) && IsWithoutEdges(face))
      {
        defects.push_back("Face #" + std::to_string(model->IdentLabel(face)) +
          " of the file is a whole torus that crosses itself (#" + std::to_string(model->IdentLabel(torus)) +
          ", its minor radius exceeds the major one): both its outer and its inner part are taken.");
      }
    });
}

void CheckApexes(const ModelEntities& entities, double unit, double angle, const EntityFilter& matters,
  std::vector<std::string>& defects)
{
  const Handle(StepData_StepModel)& model = entities.GetModel();
  entities.ForEach<StepShape_FaceSurface>(
    [&](const Handle(StepShape_FaceSurface) & face)
    {
      const auto cone = Handle(StepGeom_ConicalSurface)::DownCast(GetBasisOfFace(face));
      gp_Ax3 frame;
      if (cone.IsNull() || !matters(model->IdentLabel(face)) || !GetFrame(cone->Position(), frame))
      {
        return;
      }
      const gp_Pnt apex(frame.Location().XYZ() -
        cone->Radius() / std::tan(angle * cone->SemiAngle()) * frame.Direction().XYZ());
      for (int i = 1; i <= face->NbBounds(); ++i)
      {
        const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
        const auto loop =
          Handle(StepShape_VertexLoop)::DownCast(bound.IsNull() ? Handle(StepShape_Loop)() : bound->Bound());
        gp_Pnt vertex;
        if (loop.IsNull() || !GetPoint(loop->LoopVertex(), vertex))
        {
          continue;
        }
        const double distance = vertex.Distance(apex);
        const double size = std::max(cone->Radius(), frame.Location().Distance(apex));
        if (!(distance <= ApexLimit * size))
        {
          defects.push_back("Face #" + std::to_string(model->IdentLabel(face)) +
            " of the file: the vertex #" + std::to_string(model->IdentLabel(loop->LoopVertex())) +
            " of its loop is " + FormatDistance(distance * unit) + " mm away from the apex of its cone #" +
            std::to_string(model->IdentLabel(cone)) + ", which is taken. Export the file again.");
        }
      }
    });
}

void CheckShortArcs(const ModelEntities& entities, double unit, std::vector<std::string>& messages,
  std::vector<std::string>& defects)
{
  FirstOfSeveral found;
  const auto check = [&](const Handle(StepShape_EdgeCurve) & edge)
  {
    gp_Pnt start;
    gp_Pnt end;
    const double radius = GetRadius(edge->EdgeGeometry());
    if (radius == 0.0 || !GetPoint(edge->EdgeStart(), start) || !GetPoint(edge->EdgeEnd(), end))
    {
      return;
    }
    const double distance = start.Distance(end);
    const auto getName = [&]() { return "Edge #" + std::to_string(entities.GetModel()->IdentLabel(edge)); };
    if (distance * unit > Precision::Confusion() && distance <= Precision::PConfusion() * radius)
    {
      defects.push_back(getName() +
        " of the file is an arc of less than 1e-9 of its radius: OpenCASCADE takes the whole curve.");
    }
    else if (distance * unit <= Precision::Confusion() &&
      distance > Rounding * (start.XYZ().Modulus() + end.XYZ().Modulus()))
    {
      found.Add(
        [&]()
        {
          return getName() + " of the file is on a closed curve, between two vertices that are " +
            FormatDistance(distance * unit) +
            " mm apart: OpenCASCADE takes them as one and the curve as a whole. The short part between them "
            "may be meant.";
        });
    }
  };
  entities.ForEach<StepShape_EdgeCurve>(check);
  found.Report(messages);
}

void CheckCompositeEdges(
  const ModelEntities& entities, const EntityFilter& matters, std::vector<std::string>& messages)
{
  if (entities.Find({ STANDARD_TYPE(StepGeom_CompositeCurve) }).empty())
  {
    return;
  }
  FirstOfSeveral found;
  const auto check = [&](const Handle(StepShape_EdgeCurve) & edge)
  {
    Handle(StepGeom_Curve) curve = edge->EdgeGeometry();
    const auto onSurface = Handle(StepGeom_SurfaceCurve)::DownCast(curve);
    curve = onSurface.IsNull() ? curve : onSurface->Curve3d();
    if (!Handle(StepGeom_CompositeCurve)::DownCast(curve).IsNull() &&
      matters(entities.GetModel()->IdentLabel(edge)))
    {
      found.Add(
        [&]()
        {
          return "Edge #" + std::to_string(entities.GetModel()->IdentLabel(edge)) +
            " of the file is on a composite curve (#" +
            std::to_string(entities.GetModel()->IdentLabel(curve)) +
            "), of which OpenCASCADE makes nothing: its faces are left out. Export it with an edge for each "
            "segment, or with splines.";
        });
    }
  };
  entities.ForEach<StepShape_EdgeCurve>(check);
  found.Report(messages);
}

std::string DescribeOverstep(const DraftFace& face, const NativeBox& box)
{
  const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(face.Stored);
  if (trimmed.IsNull() || face.Loops.empty())
  {
    return {};
  }
  double low[2];
  double high[2];
  trimmed->Bounds(low[0], high[0], low[1], high[1]);
  for (int d = 0; d < 2; ++d)
  {
    const double slack = Slack * (high[d] - low[d]);
    const double period = face.Period[d];
    const double shift = period > 0.0 ? std::ceil((low[d] - slack - box.Low[d]) / period) * period : 0.0;
    if (box.Low[d] + shift < low[d] - slack || box.High[d] + shift > high[d] + slack)
    {
      return std::string("Its loops lead beyond its RECTANGULAR_TRIMMED_SURFACE in ") + (d == 0 ? "u" : "v") +
        "; the surface is taken without its borders.";
    }
  }
  return {};
}
}
