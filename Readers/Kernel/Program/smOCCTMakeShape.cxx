#include "smOCCTMakeShape.h"

#include "smOCCTMakeGeometry.h"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace sm
{
namespace
{
/// Part of a segment of a curve below which it has no length.
constexpr double EndRounding = 1e-12;

/// Parts of a curve meet if their ends are closer than this, in millimetres.
constexpr double JoinTolerance = 1e-6;

/// Makes a part of a closed spline over its seam on the periodic spline; null for other curves.
Handle(Geom_Curve) MakePeriodicPart(const CompositeCurve<3>& parts, double range[2])
{
  const bool isOne = parts.Segments.size() == 2 && parts.Segments[0].Curve == parts.Segments[1].Curve;
  const auto spline = isOne ? Handle(Geom_BSplineCurve)::DownCast(MakeKernelCurve(*parts.Segments[0].Curve))
                            : Handle(Geom_BSplineCurve)();
  if (spline.IsNull() || !spline->IsClosed())
  {
    return {};
  }
  spline->SetPeriodic();
  range[0] = parts.Segments[0].First;
  range[1] = parts.Segments[0].Last + parts.Segments[1].Last - parts.Segments[1].First;
  return Handle(Geom_Curve)(spline);
}

/// Joins the parts of a curve between two of its parameters to one spline with the same points.
Handle(Geom_Curve) Join(const CompositeCurve<3>& parts, double range[2])
{
  GeomConvert_CompCurveToBSplineCurve joined;
  double start = 0.0;
  bool hasParts = false;
  for (const CurveSegment<3>& segment : parts.Segments)
  {
    // A segment runs from First to Last while the parameter of the whole curve grows by its length.
    const double from = std::clamp((range[0] - start) / segment.Length, 0.0, 1.0);
    const double to = std::clamp((range[1] - start) / segment.Length, 0.0, 1.0);
    start += segment.Length;
    if (to - from <= EndRounding)
    {
      continue;
    }
    const double first = segment.First + from * (segment.Last - segment.First);
    const double last = segment.First + to * (segment.Last - segment.First);
    const Handle(Geom_TrimmedCurve) part = new Geom_TrimmedCurve(
      MakeKernelCurve(*segment.Curve), std::min(first, last), std::max(first, last), true, false);
    if (first > last)
    {
      part->Reverse();
    }
    hasParts = true;
    if (!joined.Add(GeomConvert::CurveToBSplineCurve(part), JoinTolerance, true))
    {
      throw std::runtime_error("the parts of a curve do not meet");
    }
  }
  if (!hasParts)
  {
    throw std::runtime_error("a curve has no part between its vertices");
  }
  const Handle(Geom_BSplineCurve) spline = joined.BSplineCurve();
  range[0] = spline->FirstParameter();
  range[1] = spline->LastParameter();
  return Handle(Geom_Curve)(spline);
}

class ShapeMaker
{
public:
  ShapeMaker(MadeShapes& made, std::unordered_map<const FaceShape*, TopoDS_Shape>& faces)
    : Made(made)
    , Faces(faces)
  {
  }

  TopoDS_Shape Make(const BodyShape& body)
  {
    TopoDS_Solid solid;
    this->Builder.MakeSolid(solid);
    TopoDS_Shape last;
    for (const ShellUse& use : body.Shells)
    {
      last = this->MakeShell(use.Shell);
      last.Orientation(use.Reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
      this->Builder.Add(solid, last);
    }
    return body.IsSolid ? TopoDS_Shape(solid) : last;
  }

private:
  template <class Table, class Value>
  void Remember(Table& table, const TopoDS_Shape& shape, const Value& value)
  {
    table[shape.TShape().get()] = value;
    this->Made.KeptShapes.push_back(shape);
  }

  TopoDS_Shape MakeShell(const ShellPointer& source)
  {
    TopoDS_Shell shell;
    this->Builder.MakeShell(shell);
    for (const FaceUse& use : source->Faces)
    {
      this->Builder.Add(
        shell, this->MakeFace(use.Face).Oriented(use.Reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
    }
    shell.Closed(source->Closed);
    this->Remember(this->Made.Shells, shell, source);
    return shell;
  }

  const Handle(Geom_Surface) & MakeSurface(const FaceShape& face)
  {
    // Faces may have different parts of one surface.
    const ParameterRange u = face.GetDomain(0);
    const ParameterRange v = face.GetDomain(1);
    Handle(Geom_Surface)& surface = this->Surfaces[{ face.Surface.get(), u.Low, u.High, v.Low, v.High }];
    if (surface.IsNull())
    {
      surface = MakeKernelSurface(*face.Surface);
      if (face.IsTrimmed(0) || face.IsTrimmed(1))
      {
        const auto end = [](double x)
        { return std::clamp(x, -Precision::Infinite(), Precision::Infinite()); };
        surface =
          new Geom_RectangularTrimmedSurface(surface, end(u.Low), end(u.High), end(v.Low), end(v.High));
      }
      this->Made.Surfaces[surface.get()] = face.Surface;
      this->Made.KeptGeometry.push_back(surface);
    }
    return surface;
  }

  TopoDS_Shape MakeFace(const FaceShapePointer& source)
  {
    TopoDS_Shape& known = this->Faces[source.get()];
    if (!known.IsNull())
    {
      return known;
    }
    const Handle(Geom_Surface) surface = this->MakeSurface(*source);
    TopoDS_Face face;
    this->Builder.MakeFace(face, surface, Precision::Confusion());
    for (const WireShape& wire : source->Wires)
    {
      TopoDS_Wire made;
      this->Builder.MakeWire(made);
      for (const CoedgeShape& use : wire.Coedges)
      {
        const TopoDS_Edge edge = this->MakeEdge(use.Edge);
        this->Builder.Add(
          made, edge.Oriented(use.Reversed != wire.Reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
      }
      made.Closed(BRep_Tool::IsClosed(made));
      made.Orientation(wire.Reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
      this->Builder.Add(face, made);
    }
    this->AddTrims(*source, face);
    known = face;
    this->Remember(this->Made.Faces, face, source);
    const auto [single, isNew] = this->Made.SurfaceFaces.emplace(surface.get(), source);
    single->second = isNew ? source : nullptr;
    return face;
  }

  /// Adds the curves in the parameters of a face; an edge that the face uses twice has two.
  void AddTrims(const FaceShape& source, const TopoDS_Face& face)
  {
    std::unordered_map<const EdgeShape*, const CoedgeShape*> uses[2];
    for (const WireShape& wire : source.Wires)
    {
      for (const CoedgeShape& use : wire.Coedges)
      {
        if (use.Trim)
        {
          uses[use.Reversed ? 1 : 0].emplace(use.Edge.get(), &use);
        }
      }
    }
    for (const int side : { 0, 1 })
    {
      for (const auto& [edge, use] : uses[side])
      {
        const auto other = uses[1 - side].find(edge);
        const TopoDS_Edge made = this->Edges[edge];
        if (other == uses[1 - side].end())
        {
          this->Builder.UpdateEdge(made, MakeKernelCurve(*use->Trim), face, edge->Tolerance);
          this->Builder.Range(made, face, use->First, use->Last);
        }
        else if (side == 0)
        {
          this->Builder.UpdateEdge(
            made, MakeKernelCurve(*use->Trim), MakeKernelCurve(*other->second->Trim), face, edge->Tolerance);
          this->Builder.Range(made, face, use->First, use->Last);
        }
        if (!edge->Degenerate && BRep_Tool::Degenerated(made) == false && !this->HasCurve(made))
        {
          BRepLib::BuildCurve3d(made);
        }
      }
    }
  }

  static bool HasCurve(const TopoDS_Edge& edge)
  {
    double first = 0.0;
    double last = 0.0;
    return !BRep_Tool::Curve(edge, first, last).IsNull();
  }

  TopoDS_Edge MakeEdge(const EdgePointer& source)
  {
    TopoDS_Edge& edge = this->Edges[source.get()];
    if (!edge.IsNull())
    {
      return edge;
    }
    double range[2] = { source->First, source->Last };
    const bool hasCurve = source->HasCurve() && !source->Curve->GetIf<CurveOnSurface>();
    if (hasCurve)
    {
      this->Builder.MakeEdge(edge, this->MakeCurve(*source, range), source->Tolerance);
    }
    else
    {
      this->Builder.MakeEdge(edge);
      this->Builder.Degenerated(edge, source->Degenerate);
    }
    if (source->Start)
    {
      this->Builder.Add(edge, this->MakeVertex(source->Start).Oriented(TopAbs_FORWARD));
    }
    if (source->End)
    {
      this->Builder.Add(edge, this->MakeVertex(source->End).Oriented(TopAbs_REVERSED));
    }
    if (hasCurve)
    {
      this->Builder.Range(edge, range[0], range[1]);
    }
    this->Remember(this->Made.Edges, edge, source);
    return edge;
  }

  Handle(Geom_Curve) MakeCurve(const EdgeShape& edge, double range[2])
  {
    if (const auto* parts = edge.Curve->GetIf<CompositeCurve<3>>())
    {
      const Handle(Geom_Curve) curve = MakePeriodicPart(*parts, range);
      return curve.IsNull() ? Join(*parts, range) : curve;
    }
    Handle(Geom_Curve)& curve = this->Curves[edge.Curve.get()];
    if (curve.IsNull())
    {
      curve = MakeKernelCurve(*edge.Curve);
      this->Made.Curves[curve.get()] = edge.Curve;
      this->Made.KeptGeometry.push_back(curve);
    }
    return curve;
  }

  TopoDS_Vertex MakeVertex(const VertexPointer& source)
  {
    TopoDS_Vertex& vertex = this->Vertices[source.get()];
    if (vertex.IsNull())
    {
      const Vector3& p = source->Point;
      this->Builder.MakeVertex(vertex, gp_Pnt(p[0], p[1], p[2]), source->Tolerance);
      this->Remember(this->Made.Vertices, vertex, source);
    }
    return vertex;
  }

  MadeShapes& Made;
  std::unordered_map<const FaceShape*, TopoDS_Shape>& Faces;
  BRep_Builder Builder;
  std::unordered_map<const EdgeShape*, TopoDS_Edge> Edges;
  std::unordered_map<const VertexShape*, TopoDS_Vertex> Vertices;
  std::unordered_map<const void*, Handle(Geom_Curve)> Curves;
  std::map<std::tuple<const void*, double, double, double, double>, Handle(Geom_Surface)> Surfaces;
};
}

TopoDS_Shape MakeKernelShape(
  const BodyShape& body, MadeShapes& made, std::unordered_map<const FaceShape*, TopoDS_Shape>& faces)
{
  return ShapeMaker(made, faces).Make(body);
}
}
