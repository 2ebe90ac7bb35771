#include "smOCCTTrimmedCurves.h"

#include "smOCCTCompatibility.h"
#include "smOCCTContradictions.h"
#include "smOCCTFailure.h"

#include <vtkMath.h>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Conic.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <StepGeom_Circle.hxx>
#include <StepGeom_Ellipse.hxx>
#include <StepGeom_HArray1OfTrimmingSelect.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepGeom_TrimmingSelect.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TCollection_HAsciiString.hxx>
#include <gp_Lin.hxx>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace sm
{
namespace
{
/// Largest distance of the centre from the axis, relative to the radius, or in OpenCASCADE's units.
constexpr double LargestDistance = 1e-6;

bool IsConic(const Handle(StepGeom_Curve) & curve)
{
  return !Handle(StepGeom_Circle)::DownCast(curve).IsNull() ||
    !Handle(StepGeom_Ellipse)::DownCast(curve).IsNull();
}

/// A surface of revolution whose axis passes the centre of the revolved conic.
struct RevolvedConic
{
  Handle(StepGeom_SurfaceOfRevolution) Entity;
  /// Parameter of the pole at which the half begins that has outer normals.
  double OuterHalf = 0.0;
  /// True if all faces on the surface are without edges, and whether they have its normals.
  bool IsWhole = false;
  bool HasSameSense = true;
  /// The sum of the directions of the middles of the parameter curves on the surface, which may be whole
  /// turns apart.
  double Direction[2] = { 0.0, 0.0 };
};

/// Returns true if the axis of a revolved circle or ellipse passes its centre, in its plane.
bool FindConic(const EntityGeometry& geometry, RevolvedConic& result)
{
  const auto surface = Handle(Geom_SurfaceOfRevolution)::DownCast(geometry.MakeSurface(result.Entity));
  // As it is in the file: MakeSurface() may have moved the origin of its parameter.
  const auto conic = Handle(Geom_Conic)::DownCast(geometry.MakeCurve(result.Entity->SweptCurve()));
  if (surface.IsNull() || conic.IsNull())
  {
    return false;
  }
  const gp_Pnt center = conic->Location();
  const gp_Dir axis = surface->Axis().Direction();
  const gp_Dir side = conic->Axis().Direction();
  const double radius = center.Distance(conic->Value(0.0));
  if (!(gp_Lin(surface->Axis()).Distance(center) <= LargestDistance * std::max(1.0, radius)) ||
    !axis.IsNormal(side, LargestDistance))
  {
    return false;
  }
  // The part from a pole on has outer normals if it lies on this side of the axis and runs along it, or on
  // the other side against it.
  const gp_Vec across = gp_Vec(side).Crossed(gp_Vec(axis));
  const double x = gp_Vec(center, conic->Value(0.0)).Dot(across);
  const double y = gp_Vec(center, conic->Value(0.5 * vtkMath::Pi())).Dot(across);
  result.OuterHalf = std::atan2(-x, y);
  const gp_Vec start(center, conic->Value(result.OuterHalf));
  result.OuterHalf += start.Dot(gp_Vec(axis)) > 0.0 ? vtkMath::Pi() : 0.0;
  return true;
}

/// Finds v of a parameter curve that has one value, or one in the middle, whatever its edge. Lines along v
/// depend on the edge's parameters.
bool FindMiddle(const EntityGeometry& geometry, const Handle(StepGeom_Pcurve) & entity, double& v)
{
  const Handle(StepRepr_DefinitionalRepresentation) representation = entity->ReferenceToCurve();
  const auto item = Handle(StepGeom_Curve)::DownCast(
    representation.IsNull() || representation->NbItems() < 1 ? nullptr : representation->ItemsValue(1));
  const Handle(Geom2d_Curve) curve = item.IsNull() ? nullptr : geometry.MakePlaneCurve(item);
  const auto line = Handle(Geom2d_Line)::DownCast(curve);
  if (!line.IsNull() && std::abs(line->Direction().Y()) < 1e-9)
  {
    v = line->Location().Y();
    return true;
  }
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve))
  {
    v = spline->Value(0.5 * (spline->FirstParameter() + spline->LastParameter())).Y();
    return true;
  }
  return false;
}

Handle(StepGeom_HArray1OfTrimmingSelect) MakeTrim(double parameter)
{
  StepGeom_TrimmingSelect select;
  select.SetParameterValue(parameter);
  return new StepGeom_HArray1OfTrimmingSelect(1, 1, select);
}

/// Returns false if the end is stated by a point only.
bool FindParameter(const Handle(StepGeom_HArray1OfTrimmingSelect) & trim, double& parameter)
{
  for (int i = 1; !trim.IsNull() && i <= trim->Length(); ++i)
  {
    if (trim->Value(i).CaseMember() > 0)
    {
      parameter = trim->Value(i).ParameterValue();
      return true;
    }
  }
  return false;
}
}

void KeepRevolvedConics(const ModelEntities& entities, double angle)
{
  const EntityGeometry geometry(angle);
  std::unordered_map<const Standard_Transient*, RevolvedConic> conics;
  entities.ForEach<StepGeom_SurfaceOfRevolution>(
    [&](const Handle(StepGeom_SurfaceOfRevolution) & surface)
    {
      RevolvedConic conic;
      conic.Entity = surface;
      bool isFound = false;
      CatchFailure([&] { isFound = IsConic(surface->SweptCurve()) && FindConic(geometry, conic); });
      if (isFound)
      {
        conics.emplace(surface.get(), conic);
      }
    });
  if (conics.empty())
  {
    return;
  }
  entities.ForEach<StepShape_FaceSurface>(
    [&](const Handle(StepShape_FaceSurface) & face)
    {
      const auto found = conics.find(GetBasisOfFace(face).get());
      if (found != conics.end())
      {
        found->second.IsWhole = IsWithoutEdges(face);
        found->second.HasSameSense = face->SameSense();
      }
    });
  entities.ForEach<StepGeom_Pcurve>(
    [&](const Handle(StepGeom_Pcurve) & curve)
    {
      const auto found = conics.find(curve->BasisSurface().get());
      double v = 0.0;
      bool isFound = false;
      CatchFailure([&] { isFound = found != conics.end() && FindMiddle(geometry, curve, v); });
      if (isFound)
      {
        found->second.Direction[0] += std::cos(angle * v);
        found->second.Direction[1] += std::sin(angle * v);
      }
    });
  constexpr double half = vtkMath::Pi();
  for (const auto& [key, conic] : conics)
  {
    double range[2] = { 0.0, 2.0 * half };
    if (conic.IsWhole)
    {
      range[0] = conic.OuterHalf + (conic.HasSameSense ? 0.0 : half);
      range[1] = range[0] + half;
    }
    else if (conic.Direction[0] != 0.0 || conic.Direction[1] != 0.0)
    {
      range[0] = std::atan2(conic.Direction[1], conic.Direction[0]) + half;
      range[1] = range[0] + 2.0 * half;
    }
    const Handle(StepGeom_TrimmedCurve) trimmed = new StepGeom_TrimmedCurve();
    trimmed->Init(new TCollection_HAsciiString(""), conic.Entity->SweptCurve(), MakeTrim(range[0] / angle),
      MakeTrim(range[1] / angle), true, StepGeom_tpParameter);
    conic.Entity->SetSweptCurve(trimmed);
  }
}
void FlattenTrims(const ModelEntities& entities)
{
  constexpr int most = 16;
  entities.ForEach<StepGeom_TrimmedCurve>(
    [](const Handle(StepGeom_TrimmedCurve) & curve)
    {
      for (int i = 0; i < most; ++i)
      {
        const auto inner = Handle(StepGeom_TrimmedCurve)::DownCast(curve->BasisCurve());
        double first = 0.0;
        double ends[2] = { 0.0, 0.0 };
        if (inner.IsNull() || !FindParameter(inner->Trim1(), first) ||
          !FindParameter(curve->Trim1(), ends[0]) || !FindParameter(curve->Trim2(), ends[1]))
        {
          return;
        }
        const double sign = inner->SenseAgreement() ? 1.0 : -1.0;
        curve->Init(curve->Name(), inner->BasisCurve(), MakeTrim(first + sign * ends[0]),
          MakeTrim(first + sign * ends[1]), curve->SenseAgreement() == inner->SenseAgreement(),
          StepGeom_tpParameter);
      }
    });
}
}
