#include "smOCCTParameterCurves.h"

#include "smFormat.h"
#include "smOCCTCompatibility.h"
#include "smOCCTContradictions.h"
#include "smOCCTFailure.h"

#include <vtkMath.h>

#include <Bnd_Box.hxx>
#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Ellipse.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomConvert_Units.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <StepGeom_Axis2Placement.hxx>
#include <StepGeom_Axis2Placement2d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_Ellipse.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_PcurveOrSurface.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace sm
{
namespace
{
/// Fractions of an edge at which it is compared. Its ends are left out: they may lie at a pole.
constexpr std::array<double, 4> Fractions = { 0.13, 0.37, 0.61, 0.86 };

/// Parameter curves may lie this far from their edges, relative to the size of all: the default of
/// vtkSurfaceIntegralBase::SetGapLimit().
constexpr double GapLimit = 1e-3;

/// Up to this distance, relative to the size of all, a parameter curve may be a rough approximation; of 23
/// real files with parameter curves one has such that are 2e-3 off, and none has larger ones.
constexpr double ApproximationLimit = 1e-2;

/// Calls `visit` once with each edge of a face that is in a shell.
void VisitEdges(
  const ModelEntities& entities, const std::function<void(const Handle(StepShape_EdgeCurve) &)>& visit)
{
  std::unordered_set<const Standard_Transient*> seen;
  const auto visitShell = [&](const Handle(StepShape_ConnectedFaceSet) & shell)
  {
    for (int k = 1; HasFaceList(shell) && k <= shell->NbCfsFaces(); ++k)
    {
      const Handle(StepShape_Face) face = shell->CfsFacesValue(k);
      for (int b = 1; !face.IsNull() && b <= face->NbBounds(); ++b)
      {
        const Handle(StepShape_FaceBound) bound = face->BoundsValue(b);
        const auto loop = Handle(StepShape_EdgeLoop)::DownCast(bound.IsNull() ? nullptr : bound->Bound());
        for (int e = 1; !loop.IsNull() && e <= loop->NbEdgeList(); ++e)
        {
          const Handle(StepShape_OrientedEdge) use = loop->EdgeListValue(e);
          const auto edge =
            Handle(StepShape_EdgeCurve)::DownCast(use.IsNull() ? nullptr : use->EdgeElement());
          if (!edge.IsNull() && seen.insert(edge.get()).second)
          {
            visit(edge);
          }
        }
      }
    }
  };
  entities.ForEach<StepShape_ConnectedFaceSet>(visitShell);
}

/// Finds the parameters between which an edge uses its curve, the first one below the last one. Returns false
/// if they are not clear.
bool FindRange(const Handle(StepShape_EdgeCurve) & edge, const Handle(Geom_Curve) & curve, double range[2])
{
  gp_Pnt ends[2];
  if (!GetPoint(edge->EdgeStart(), ends[0]) || !GetPoint(edge->EdgeEnd(), ends[1]))
  {
    return false;
  }
  if (!edge->SameSense())
  {
    std::swap(ends[0], ends[1]);
  }
  const double first = curve->FirstParameter();
  const double last = curve->LastParameter();
  const double width = last - first;
  for (int k = 0; k < 2; ++k)
  {
    // Most curves end at their vertices, which is known without searching.
    const double own = k == 0 ? first : last;
    if (!Precision::IsInfinite(own) && curve->Value(own).Distance(ends[k]) <= Precision::Confusion())
    {
      range[k] = own;
      continue;
    }
    const GeomAPI_ProjectPointOnCurve foot(ends[k], curve);
    if (foot.NbPoints() == 0)
    {
      return false;
    }
    range[k] = foot.LowerDistanceParameter();
  }
  if (range[1] <= range[0] + Precision::PConfusion() * width && curve->IsClosed())
  {
    // The end is the start, or lies behind the point at which the curve closes.
    range[1] = curve->IsPeriodic() ? range[1] + curve->Period() : last;
  }
  return range[0] < range[1];
}

/// A parameter curve on its surface.
class CurveOnSurface
{
public:
  CurveOnSurface(const Handle(Geom_Surface) & surface, const Handle(Geom2d_Curve) & curve)
    : Surface(surface)
    , Curve(curve)
  {
    double low[2];
    double high[2];
    surface->Bounds(low[0], high[0], low[1], high[1]);
    this->Period[0] = surface->IsUPeriodic() ? surface->UPeriod()
      : surface->IsUClosed()                 ? high[0] - low[0]
                                             : 0.0;
    this->Period[1] = surface->IsVPeriodic() ? surface->VPeriod()
      : surface->IsVClosed()                 ? high[1] - low[1]
                                             : 0.0;
    // Beyond a pole the formula continues on the other side.
    this->IsSphere = !Handle(Geom_SphericalSurface)::DownCast(surface).IsNull();
    this->Period[1] = this->IsSphere ? 2.0 * vtkMath::Pi() : this->Period[1];
  }

  gp_Pnt Evaluate(double s) const
  {
    const gp_Pnt2d p = this->Curve->Value(s);
    return this->Surface->Value(p.X(), p.Y());
  }

  /// Returns the distance of a point at the parameter `t` of the edge: from the point at the same parameter
  /// or, if that is above `limit`, from the whole curve, of the point's foot on the surface. A point that is
  /// farther than that from the surface has a gap there, which is reported elsewhere, and no distance.
  double GetDistance(const gp_Pnt& point, double t, double limit)
  {
    const bool isInside = t >= this->Curve->FirstParameter() && t <= this->Curve->LastParameter();
    double least = isInside ? this->Evaluate(t).Distance(point) : std::numeric_limits<double>::infinity();
    if (least <= limit)
    {
      return least;
    }
    if (this->Feet.IsNull())
    {
      this->Feet = new ShapeAnalysis_Surface(this->Surface);
    }
    const gp_Pnt2d uv = this->Feet->ValueOfUV(point, Precision::Confusion());
    const gp_Pnt foot = this->Surface->Value(uv.X(), uv.Y());
    if (foot.Distance(point) > limit)
    {
      return 0.0;
    }
    const int turns[2] = { this->Period[0] > 0.0 ? MostTurns : 0, this->Period[1] > 0.0 ? MostTurns : 0 };
    for (int i = -turns[0]; i <= turns[0]; ++i)
    {
      for (int k = -turns[1]; k <= turns[1]; ++k)
      {
        this->Approach({ uv.X() + i * this->Period[0], uv.Y() + k * this->Period[1] }, foot, least);
        if (this->IsSphere)
        {
          this->Approach(
            { uv.X() + (i + 0.5) * this->Period[0], (k + 0.5) * this->Period[1] - uv.Y() }, foot, least);
        }
      }
    }
    return least;
  }

private:
  /// Parameter curves may be moved by whole periods.
  static constexpr int MostTurns = 2;

  /// Lowers `minimum` to the distance of `foot` from the point of the curve that is nearest to `uv` in the
  /// parameters.
  void Approach(const gp_Pnt2d& uv, const gp_Pnt& foot, double& least) const
  {
    const Geom2dAPI_ProjectPointOnCurve nearest(uv, this->Curve);
    for (int i = 1; i <= nearest.NbPoints(); ++i)
    {
      least = std::min(least, this->Improve(nearest.Parameter(i), foot));
    }
    for (const double end : { this->Curve->FirstParameter(), this->Curve->LastParameter() })
    {
      least = Precision::IsInfinite(end) ? least : std::min(least, this->Evaluate(end).Distance(foot));
    }
  }

  /// Returns the smallest distance near `s`, which is nearest in the parameters, where a unit of u may be
  /// longer than one of v. The interval is divided by the golden ratio.
  double Improve(double s, const gp_Pnt& foot) const
  {
    constexpr double ratio = 0.6180339887498949;
    constexpr int steps = 40;
    const double first = this->Curve->FirstParameter();
    const double last = this->Curve->LastParameter();
    const double reach = Precision::IsInfinite(last - first) ? 0.125 * std::fabs(s) : 0.125 * (last - first);
    double low = std::max(first, s - reach);
    double high = std::min(last, s + reach);
    double least = this->Evaluate(s).Distance(foot);
    for (int i = 0; i < steps; ++i)
    {
      const double inner[2] = { high - ratio * (high - low), low + ratio * (high - low) };
      const double distance[2] = { this->Evaluate(inner[0]).Distance(foot),
        this->Evaluate(inner[1]).Distance(foot) };
      least = std::min({ least, distance[0], distance[1] });
      (distance[0] < distance[1] ? high : low) = distance[0] < distance[1] ? inner[1] : inner[0];
    }
    return least;
  }

  Handle(Geom_Surface) Surface;
  Handle(Geom2d_Curve) Curve;
  /// Made when it is needed.
  Handle(ShapeAnalysis_Surface) Feet;
  double Period[2];
  bool IsSphere = false;
};

/// Returns true for surfaces whose parameters are certain: not for those that depend on a curve's, or on the
/// length of a vector.
bool IsExamined(const Handle(Geom_Surface) & surface)
{
  return !surface.IsNull() &&
    (surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface)) ||
      surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)));
}

/// Returns the whole ellipse of a curve, or of a part of one, whose first axis is the shorter one:
/// OpenCASCADE makes another ellipse of it. Null for other curves.
Handle(Geom2d_Curve) MakeTallEllipse(Handle(StepGeom_Curve) entity)
{
  const auto part = Handle(StepGeom_TrimmedCurve)::DownCast(entity);
  const auto ellipse = Handle(StepGeom_Ellipse)::DownCast(part.IsNull() ? entity : part->BasisCurve());
  const Handle(StepGeom_Axis2Placement2d) place =
    ellipse.IsNull() ? nullptr : ellipse->Position().Axis2Placement2d();
  if (place.IsNull() || place->Location().IsNull() || !(ellipse->SemiAxis1() < ellipse->SemiAxis2()))
  {
    return nullptr;
  }
  const Handle(StepGeom_CartesianPoint) center = place->Location();
  const Handle(StepGeom_Direction) axis = place->HasRefDirection() ? place->RefDirection() : nullptr;
  if (center->NbCoordinates() != 2 || (!axis.IsNull() && axis->NbDirectionRatios() != 2))
  {
    return nullptr;
  }
  const gp_Dir2d first = axis.IsNull()
    ? gp_Dir2d(1.0, 0.0)
    : gp_Dir2d(axis->DirectionRatiosValue(1), axis->DirectionRatiosValue(2));
  const gp_Ax2d longer(
    gp_Pnt2d(center->CoordinatesValue(1), center->CoordinatesValue(2)), gp_Dir2d(-first.Y(), first.X()));
  return new Geom2d_Ellipse(longer, ellipse->SemiAxis2(), ellipse->SemiAxis1());
}

class ParameterCurveCheck
{
public:
  ParameterCurveCheck(const Handle(StepData_StepModel) & model, double angle)
    : Model(model)
    , Angle(angle)
    , Geometry(angle)
  {
  }

  /// Adds the edges that have parameter curves.
  void Add(const Handle(StepShape_EdgeCurve) & edge)
  {
    const auto onSurface = Handle(StepGeom_SurfaceCurve)::DownCast(edge->EdgeGeometry());
    if (onSurface.IsNull() || onSurface->Curve3d().IsNull() || onSurface->AssociatedGeometry().IsNull())
    {
      return;
    }
    // What OpenCASCADE makes no curve of is reported elsewhere.
    CatchFailure([&]() { this->AddSamples(edge, onSurface); });
  }

  void Run(double unit, std::vector<std::string>& messages, std::vector<std::string>& defects)
  {
    if (this->Size.IsVoid())
    {
      return;
    }
    const double size = std::sqrt(this->Size.SquareExtent());
    for (const Sampled& edge : this->Edges)
    {
      CatchFailure([&]() { this->Compare(edge, size, unit); });
    }
    this->Contradictory.Report(defects);
    this->Rough.Report(messages);
  }

private:
  struct Sampled
  {
    Handle(StepShape_EdgeCurve) Edge;
    Handle(StepGeom_SurfaceCurve) Curve;
    std::array<double, Fractions.size()> Parameters;
    std::array<gp_Pnt, Fractions.size()> Points;
  };

  void AddSamples(const Handle(StepShape_EdgeCurve) & edge, const Handle(StepGeom_SurfaceCurve) & onSurface)
  {
    const Handle(Geom_Curve) curve = this->Geometry.MakeCurve(onSurface->Curve3d());
    double range[2];
    if (curve.IsNull() || !FindRange(edge, curve, range))
    {
      return;
    }
    Sampled sampled{ edge, onSurface, {}, {} };
    for (std::size_t i = 0; i < Fractions.size(); ++i)
    {
      sampled.Parameters[i] = range[0] + Fractions[i] * (range[1] - range[0]);
      sampled.Points[i] = curve->Value(sampled.Parameters[i]);
      this->Size.Add(sampled.Points[i]);
    }
    this->Edges.push_back(sampled);
  }

  void Compare(const Sampled& edge, double size, double unit)
  {
    const bool isPreferred = edge.Curve->MasterRepresentation() != StepGeom_pscrCurve3d;
    for (int k = 1; k <= edge.Curve->NbAssociatedGeometry(); ++k)
    {
      const Handle(StepGeom_Pcurve) stated = edge.Curve->AssociatedGeometryValue(k).Pcurve();
      const double distance = stated.IsNull() ? 0.0 : this->GetDistance(edge, stated, GapLimit * size);
      if (distance <= GapLimit * size)
      {
        continue;
      }
      FirstOfSeveral& findings =
        isPreferred && distance > ApproximationLimit * size ? this->Contradictory : this->Rough;
      findings.Add(
        [&]()
        {
          return "Edge #" + std::to_string(this->Model->IdentLabel(edge.Edge)) +
            " of the file: its parameter curve #" + std::to_string(this->Model->IdentLabel(stated)) +
            " lies " + FormatDistance(distance * unit) + " mm from its curve #" +
            std::to_string(this->Model->IdentLabel(edge.Curve->Curve3d())) +
            (isPreferred ? ", which is taken, although the file prefers the parameter curve."
                         : ", which is taken.");
        });
    }
  }

  /// Returns the largest distance of the samples from the parameter curve, 0 if that is not examined.
  double GetDistance(const Sampled& edge, const Handle(StepGeom_Pcurve) & stated, double limit)
  {
    const Handle(Geom_Surface) surface = this->FindSurface(stated->BasisSurface());
    const Handle(StepRepr_DefinitionalRepresentation) representation = stated->ReferenceToCurve();
    if (!IsExamined(surface) || representation.IsNull() || representation->NbItems() < 1)
    {
      return 0.0;
    }
    const auto entity = Handle(StepGeom_Curve)::DownCast(representation->ItemsValue(1));
    Handle(Geom2d_Curve) plane = MakeTallEllipse(entity);
    plane = plane.IsNull() && !entity.IsNull() ? this->Geometry.MakePlaneCurve(entity) : plane;
    if (plane.IsNull())
    {
      return 0.0;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const double angle : { this->Angle, 1.0 })
    {
      CurveOnSurface curve(surface, GeomConvert_Units::DegreeToRadian(plane, surface, 1.0, angle));
      double distance = 0.0;
      for (std::size_t i = 0; i < Fractions.size() && distance < least; ++i)
      {
        distance = std::max(distance, curve.GetDistance(edge.Points[i], edge.Parameters[i], limit));
      }
      least = std::min(least, distance);
      if (least <= limit || this->Angle == 1.0)
      {
        break;
      }
    }
    return least;
  }

  /// Makes the surface of an entity, once.
  const Handle(Geom_Surface) & FindSurface(const Handle(StepGeom_Surface) & entity)
  {
    const auto [found, isNew] = this->Surfaces.try_emplace(entity.get());
    if (isNew && !entity.IsNull())
    {
      found->second = this->Geometry.MakeSurface(entity);
    }
    return found->second;
  }

  Handle(StepData_StepModel) Model;
  double Angle;
  EntityGeometry Geometry;
  std::vector<Sampled> Edges;
  Bnd_Box Size;
  FirstOfSeveral Contradictory;
  FirstOfSeveral Rough;
  std::unordered_map<const Standard_Transient*, Handle(Geom_Surface)> Surfaces;
};
}

void CheckParameterCurves(const ModelEntities& entities, double unit, double angle,
  const EntityFilter& matters, std::vector<std::string>& messages, std::vector<std::string>& defects)
{
  if (entities.Find({ STANDARD_TYPE(StepGeom_Pcurve) }).empty())
  {
    return;
  }
  const Handle(StepData_StepModel)& model = entities.GetModel();
  ParameterCurveCheck check(model, angle);
  VisitEdges(entities,
    [&](const Handle(StepShape_EdgeCurve) & edge)
    {
      if (matters(model->IdentLabel(edge)))
      {
        check.Add(edge);
      }
    });
  check.Run(unit, messages, defects);
}
}
