#include "smOCCTImport.h"

#include "smOCCTFailure.h"
#include "smOCCTGeometry.h"

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace sm
{
namespace
{
bool IsOriented(const TopoDS_Shape& shape)
{
  return shape.Orientation() == TopAbs_FORWARD || shape.Orientation() == TopAbs_REVERSED;
}

bool IsReversed(const TopoDS_Shape& shape)
{
  return shape.Orientation() == TopAbs_REVERSED;
}

Vector3 ToVector(const gp_Pnt& p)
{
  return { p.X(), p.Y(), p.Z() };
}

/// Finds the pcurve that the edge stores for this surface. BRep_Tool is not used, because it makes a pcurve
/// on a plane if there is none.
Handle(Geom2d_Curve) FindStoredTrim(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface,
  const TopLoc_Location& faceLocation, double& first, double& last)
{
  const TopLoc_Location location = faceLocation.Predivided(edge.Location());
  const Handle(BRep_TEdge) shape = Handle(BRep_TEdge)::DownCast(edge.TShape());
  for (const Handle(BRep_CurveRepresentation) & curve : shape->ChangeCurves())
  {
    if (curve->IsCurveOnSurface(surface, location))
    {
      Handle(BRep_GCurve)::DownCast(curve)->Range(first, last);
      const bool isSecond = curve->IsCurveOnClosedSurface() && IsReversed(edge);
      return isSecond ? curve->PCurve2() : curve->PCurve();
    }
  }
  return {};
}

/// Computes a pcurve for an edge that has none on a curved surface.
Handle(Geom2d_Curve)
  AddMissingTrim(const TopoDS_Edge& edge, const TopoDS_Face& face, double& first, double& last)
{
  Handle(Geom2d_Curve) curve;
  CatchKernelFailure(
    [&]
    {
      ShapeFix_Edge().FixAddPCurve(edge, face, BRep_Tool::IsClosed(edge, face));
      curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    });
  return curve;
}
}

Placement ToPlacement(const gp_Trsf& trsf)
{
  Placement result;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result.Linear[i][j] = trsf.Value(i + 1, j + 1);
    }
    result.Translation[i] = trsf.Value(i + 1, 4);
  }
  return result;
}

void ShapeImport::KeepFacesExcept(const std::vector<TopoDS_Shape>& faces)
{
  this->IsKept = true;
  for (const TopoDS_Shape& face : faces)
  {
    this->Changed.insert(face.TShape().get());
  }
}

void ShapeImport::AddReplacement(const TopoDS_Shape& from, const TopoDS_Shape& to)
{
  const void* key = from.TShape().get();
  const auto add = [&](auto& origins, const auto& made)
  {
    const auto known = made.find(key);
    for (TopExp_Explorer it(to, from.ShapeType()); known != made.end() && it.More(); it.Next())
    {
      origins.emplace(it.Current().TShape().get(), known->second);
    }
  };
  if (from.ShapeType() == TopAbs_FACE)
  {
    add(this->FaceOrigins, this->Origin->Faces);
  }
  else if (from.ShapeType() == TopAbs_EDGE)
  {
    add(this->EdgeOrigins, this->Origin->Edges);
  }
  else if (from.ShapeType() == TopAbs_SHELL)
  {
    add(this->ShellOrigins, this->Origin->Shells);
  }
}

ShapeGroup ShapeImport::MakeGroup(const TopoDS_Shape& shape)
{
  ShapeGroup group;
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
  {
    group.Solids.push_back({ this->MakeSolid(it.Current()), IsReversed(it.Current()),
      ToPlacement(it.Current().Location().Transformation()) });
  }
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
  {
    group.Shells.push_back({ this->MakeShell(it.Current().Located(TopLoc_Location())),
      IsReversed(it.Current()), ToPlacement(it.Current().Location().Transformation()) });
  }
  for (TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
  {
    if (IsOriented(it.Current()))
    {
      group.Faces.push_back({ this->MakeFace(TopoDS::Face(it.Current())), IsReversed(it.Current()) });
    }
  }
  return group;
}

FaceShapePointer ShapeImport::Find(const TopoDS_Shape& face) const
{
  const FaceShapePointer* found = this->Faces.Seek(face);
  return found ? *found : nullptr;
}

SolidPointer ShapeImport::MakeSolid(const TopoDS_Shape& solid)
{
  const TopoDS_Shape own = solid.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  if (const SolidPointer* known = this->Solids.Seek(own))
  {
    return *known;
  }
  const auto result = std::make_shared<SolidShape>();
  for (TopExp_Explorer it(own, TopAbs_SHELL); it.More(); it.Next())
  {
    result->Shells.push_back({ this->MakeShell(it.Current()), IsReversed(it.Current()), {} });
  }
  this->Solids.Bind(own, result);
  return result;
}

ShellPointer ShapeImport::MakeShell(const TopoDS_Shape& shell)
{
  const TopoDS_Shape own = shell.Oriented(TopAbs_FORWARD);
  if (const ShellPointer* known = this->Shells.Seek(own))
  {
    return *known;
  }
  const auto result = std::make_shared<ShellShape>();
  result->Closed = BRep_Tool::IsClosed(own);
  for (TopExp_Explorer it(own, TopAbs_FACE); it.More(); it.Next())
  {
    if (IsOriented(it.Current()))
    {
      result->Faces.push_back({ this->MakeFace(TopoDS::Face(it.Current())), IsReversed(it.Current()) });
    }
  }
  const void* key = own.TShape().get();
  const auto replaced = this->ShellOrigins.find(key);
  ShellPointer origin = replaced == this->ShellOrigins.end() ? nullptr : replaced->second;
  if (!origin && this->Origin)
  {
    const auto same = this->Origin->Shells.find(key);
    origin = same == this->Origin->Shells.end() ? nullptr : same->second;
  }
  if (origin)
  {
    result->Data = origin->Data;
    result->LostFaces = origin->LostFaces;
  }
  this->Shells.Bind(own, result);
  return result;
}

FaceShapePointer ShapeImport::MakeFace(const TopoDS_Face& source)
{
  const TopoDS_Face face = TopoDS::Face(source.Oriented(TopAbs_FORWARD));
  if (const FaceShapePointer* known = this->Faces.Seek(face))
  {
    return *known;
  }
  const void* key = face.TShape().get();
  if (this->IsKept && this->Changed.count(key) == 0)
  {
    const auto same = this->Origin->Faces.find(key);
    if (same != this->Origin->Faces.end())
    {
      this->Faces.Bind(face, same->second);
      return same->second;
    }
  }
  const auto result = std::make_shared<FaceShape>();
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  result->Location = ToPlacement(location.Transformation());
  if (!surface.IsNull())
  {
    result->Surface = this->MakeSurface(surface);
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    {
      double bounds[4];
      trimmed->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
      for (int d = 0; d < 2; ++d)
      {
        if (!Precision::IsInfinite(bounds[2 * d]) && !Precision::IsInfinite(bounds[2 * d + 1]))
        {
          result->Range[d] = { bounds[2 * d], bounds[2 * d + 1] };
        }
      }
    }
  }
  for (TopoDS_Iterator it(face); it.More(); it.Next())
  {
    if (it.Value().ShapeType() == TopAbs_WIRE && IsOriented(it.Value()))
    {
      this->AddWire(it.Value(), face, *result);
    }
  }
  if (const FaceShapePointer origin = this->FindOrigin(key, surface))
  {
    result->Source = origin;
    result->Data = origin->Data;
    result->Bounded = origin->Bounded;
    result->Own = origin->Own;
  }
  this->Faces.Bind(face, result);
  return result;
}

/// Returns the face that a face comes from: the one that it replaces, itself, or the only one on its surface.
FaceShapePointer ShapeImport::FindOrigin(const void* face, const Handle(Geom_Surface) & surface) const
{
  const auto find = [](const auto& table, const void* key)
  {
    const auto found = table.find(key);
    return found == table.end() ? FaceShapePointer() : found->second;
  };
  FaceShapePointer origin = find(this->FaceOrigins, face);
  origin = origin || !this->Origin ? origin : find(this->Origin->Faces, face);
  return origin || !this->Origin ? origin : find(this->Origin->SurfaceFaces, surface.get());
}

void ShapeImport::AddWire(const TopoDS_Shape& source, const TopoDS_Face& face, FaceShape& result)
{
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  const bool isPlane = !surface.IsNull() && surface->IsKind(STANDARD_TYPE(Geom_Plane));
  WireShape wire;
  wire.Reversed = IsReversed(source);
  for (TopoDS_Iterator it(source); it.More(); it.Next())
  {
    const TopoDS_Edge edge = TopoDS::Edge(it.Value());
    if (!IsOriented(edge))
    {
      continue;
    }
    CoedgeShape use;
    use.Edge = this->MakeEdge(edge);
    use.Reversed = IsReversed(edge);
    Handle(Geom2d_Curve) trim = FindStoredTrim(edge, surface, location, use.First, use.Last);
    if (trim.IsNull() && !isPlane && !surface.IsNull())
    {
      trim = AddMissingTrim(edge, face, use.First, use.Last);
    }
    if (!trim.IsNull())
    {
      use.Trim = MakeGeometry(trim);
    }
    wire.Coedges.push_back(std::move(use));
  }
  result.Wires.push_back(std::move(wire));
}

EdgePointer ShapeImport::MakeEdge(const TopoDS_Edge& source)
{
  const TopoDS_Edge edge = TopoDS::Edge(source.Oriented(TopAbs_FORWARD));
  if (const EdgePointer* known = this->Edges.Seek(edge))
  {
    return *known;
  }
  const void* key = edge.TShape().get();
  EdgePointer origin;
  if (this->Origin)
  {
    const auto same = this->Origin->Edges.find(key);
    origin = same == this->Origin->Edges.end() ? nullptr : same->second;
  }
  if (this->IsKept && origin)
  {
    this->Edges.Bind(edge, origin);
    return origin;
  }
  const auto replaced = this->EdgeOrigins.find(key);
  origin = replaced == this->EdgeOrigins.end() ? origin : replaced->second;
  const auto result = std::make_shared<EdgeShape>();
  TopLoc_Location location;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, result->First, result->Last);
  result->Curve = curve.IsNull() ? nullptr : this->MakeCurve(curve);
  result->Location = ToPlacement(location.Transformation());
  result->Tolerance = BRep_Tool::Tolerance(edge);
  result->Degenerate = BRep_Tool::Degenerated(edge);
  result->Start = this->MakeVertex(TopExp::FirstVertex(edge));
  result->End = this->MakeVertex(TopExp::LastVertex(edge));
  if (origin)
  {
    result->Data = origin->Data;
  }
  this->Edges.Bind(edge, result);
  return result;
}

VertexPointer ShapeImport::MakeVertex(const TopoDS_Vertex& vertex)
{
  if (vertex.IsNull())
  {
    return nullptr;
  }
  if (const VertexPointer* known = this->Vertices.Seek(vertex))
  {
    return *known;
  }
  VertexPointer result;
  if (this->IsKept)
  {
    // A kept edge has this vertex.
    const auto same = this->Origin->Vertices.find(vertex.TShape().get());
    result = same == this->Origin->Vertices.end() ? nullptr : same->second;
  }
  if (!result)
  {
    result = std::make_shared<VertexShape>();
    result->Point = ToVector(BRep_Tool::Pnt(vertex));
    result->Tolerance = BRep_Tool::Tolerance(vertex);
  }
  this->Vertices.Bind(vertex, result);
  return result;
}

CurvePointer<3> ShapeImport::MakeCurve(const Handle(Geom_Curve) & curve)
{
  const auto [found, isNew] = this->Curves.try_emplace(curve.get());
  if (isNew && this->Origin)
  {
    const auto same = this->Origin->Curves.find(curve.get());
    found->second = same == this->Origin->Curves.end() ? nullptr : same->second;
  }
  if (!found->second)
  {
    found->second = MakeGeometry(curve);
  }
  return found->second;
}

SurfacePointer ShapeImport::MakeSurface(const Handle(Geom_Surface) & surface)
{
  const auto [found, isNew] = this->Surfaces.try_emplace(surface.get());
  if (isNew && this->Origin)
  {
    const auto same = this->Origin->Surfaces.find(surface.get());
    found->second = same == this->Origin->Surfaces.end() ? nullptr : same->second;
  }
  if (!found->second)
  {
    found->second = MakeGeometry(surface);
  }
  return found->second;
}
}
