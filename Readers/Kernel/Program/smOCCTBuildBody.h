/**
 * @file smOCCTBuildBody.h
 * @brief A trimmed NURBS model as a shape of OpenCASCADE: shared edges and vertices, trim curves, measured
 * tolerances
 */
#ifndef smOCCTBuildBody_h
#define smOCCTBuildBody_h

#include "Geometry/smParameterMap.h"
#include "smFace.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
struct BuiltBody
{
  /// A solid, a shell, or a compound of shells; null when no face is left.
  TopoDS_Shape Shape;
  /// Shapes of the model's faces, as the shell uses them; null for a face that is left out.
  std::vector<TopoDS_Face> Faces;
  std::vector<std::pair<TopoDS_Edge, std::shared_ptr<const Edge>>> Edges;
  /// Largest tolerance of an edge, and the length of the shortest one, kernel units.
  double Tolerance = 0.0;
  double ShortestEdge = 0.0;
  /// Warnings about differences from the model, and about properties of the file; one sentence each.
  std::vector<std::string> Warnings;
};

/**
 * Builds the shape of all faces. `map` transforms stored coordinates to those of OpenCASCADE; a reflection
 * reverses the faces.
 *
 * A face that is a plane, cylinder, cone, sphere or torus, as the reader made it a B-spline or moved or
 * scaled since, becomes one; so do edges that are lines and circles. All others become B-splines.
 *
 * The edge of a face becomes one edge with the curve C_e(t), and each coedge a curve of the same parameter in
 * the face's (u,v); two coedges of one face that run against each other are a seam. Coedges that follow each
 * other in a loop share a vertex when their ends are no farther apart than 1e-5 of the body's size. The
 * tolerance of an edge is the largest distance of S(c(t)) from C_e(t) at equal parameters, measured; that of
 * a vertex is the largest distance of the ends that meet there. Neither is below 1e-7 kernel units. A face
 * without loops is bounded by the borders of its domain.
 *
 * Where a loop jumps in (u,v) and not in space, at a pole, the straight piece that closes it becomes a
 * degenerate edge.
 *
 * A face that OpenCASCADE refuses is left out and named in a warning. Throws only std::bad_alloc.
 */
BuiltBody BuildBody(vtkTrimmedNURBSModel* model, const AffineMap& map);
}

#endif
