/**
 * @file smOCCTMakeShape.h
 * @brief Bodies of a file as shapes of OpenCASCADE
 */
#ifndef smOCCTMakeShape_h
#define smOCCTMakeShape_h

#include "Shapes/smShape.h"

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>

#include <unordered_map>
#include <vector>

namespace sm
{
/// What shapes, curves and surfaces of OpenCASCADE were made of, by the address of their data.
struct MadeShapes
{
  std::unordered_map<const void*, ShellPointer> Shells;
  std::unordered_map<const void*, FaceShapePointer> Faces;
  std::unordered_map<const void*, EdgePointer> Edges;
  std::unordered_map<const void*, VertexPointer> Vertices;
  std::unordered_map<const void*, CurvePointer<3>> Curves;
  std::unordered_map<const void*, SurfacePointer> Surfaces;
  /// The only face on a surface; null if there are several.
  std::unordered_map<const void*, FaceShapePointer> SurfaceFaces;
  /// Keep what addresses refer to.
  std::vector<TopoDS_Shape> KeptShapes;
  std::vector<Handle(Standard_Transient)> KeptGeometry;
};

/// Makes the shape of a solid, or of the shell that a body has. `faces` gets those of its faces. Throws what
/// OpenCASCADE throws, and std::runtime_error.
TopoDS_Shape MakeKernelShape(
  const BodyShape& body, MadeShapes& made, std::unordered_map<const FaceShape*, TopoDS_Shape>& faces);
}

#endif
