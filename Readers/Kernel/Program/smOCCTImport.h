/**
 * @file smOCCTImport.h
 * @brief Shapes of OpenCASCADE as shapes of a file
 */
#ifndef smOCCTImport_h
#define smOCCTImport_h

#include "Shapes/smShape.h"
#include "smOCCTMakeShape.h"

#include <Geom2d_Curve.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace sm
{
Placement ToPlacement(const gp_Trsf& trsf);

/**
 * Makes shapes of a file of those of OpenCASCADE; shapes that OpenCASCADE shares are one object. On a surface
 * that is not a plane an edge without a curve in its parameters gets OpenCASCADE's approximation.
 */
class ShapeImport
{
public:
  /// `origin` has shapes that OpenCASCADE's were made of: surfaces and curves that are still the same keep
  /// their values, and shapes their data; null: none.
  explicit ShapeImport(const MadeShapes* origin = nullptr)
    : Origin(origin)
  {
  }

  /// Keeps faces, except those given, and their edges, as the objects that they were made of, if they are
  /// still the same: a repair may change the edges of a face and leave it the same object.
  void KeepFacesExcept(const std::vector<TopoDS_Shape>& faces);
  /// States that `to` is what became of a shape that was made of a file's.
  void AddReplacement(const TopoDS_Shape& from, const TopoDS_Shape& to);

  /// Returns the solids, the shells outside of solids and the faces outside of shells of a shape.
  ShapeGroup MakeGroup(const TopoDS_Shape& shape);
  /// Returns the object that a face became; null if it was not made.
  FaceShapePointer Find(const TopoDS_Shape& face) const;

private:
  template <class Value>
  using ShapeMap = NCollection_DataMap<TopoDS_Shape, Value, TopTools_ShapeMapHasher>;

  SolidPointer MakeSolid(const TopoDS_Shape& solid);
  ShellPointer MakeShell(const TopoDS_Shape& shell);
  FaceShapePointer MakeFace(const TopoDS_Face& face);
  EdgePointer MakeEdge(const TopoDS_Edge& edge);
  VertexPointer MakeVertex(const TopoDS_Vertex& vertex);
  FaceShapePointer FindOrigin(const void* face, const Handle(Geom_Surface) & surface) const;
  void AddWire(const TopoDS_Shape& wire, const TopoDS_Face& source, FaceShape& face);
  CurvePointer<3> MakeCurve(const Handle(Geom_Curve) & curve);
  SurfacePointer MakeSurface(const Handle(Geom_Surface) & surface);

  const MadeShapes* Origin;
  bool IsKept = false;
  std::unordered_set<const void*> Changed;
  /// Shapes of the file that OpenCASCADE's come from.
  std::unordered_map<const void*, FaceShapePointer> FaceOrigins;
  std::unordered_map<const void*, EdgePointer> EdgeOrigins;
  std::unordered_map<const void*, ShellPointer> ShellOrigins;
  ShapeMap<SolidPointer> Solids;
  ShapeMap<ShellPointer> Shells;
  ShapeMap<FaceShapePointer> Faces;
  ShapeMap<EdgePointer> Edges;
  ShapeMap<VertexPointer> Vertices;
  std::unordered_map<const void*, CurvePointer<3>> Curves;
  std::unordered_map<const void*, SurfacePointer> Surfaces;
};
}

#endif
