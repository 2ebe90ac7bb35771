/**
 * @file smOCCTFixShape.h
 * @brief OpenCASCADE's repair of shapes, with the settings of its own reader of STEP files
 */
#ifndef smOCCTFixShape_h
#define smOCCTFixShape_h

#include <TopoDS_Shape.hxx>

#include <functional>
#include <vector>

namespace sm
{
/// Gets a solid, shell, face or edge, and what a repair replaced it by.
using ShapeVisitor = std::function<void(const TopoDS_Shape& from, const TopoDS_Shape& to)>;

/// Repairs a shape; a shape of which the repair fails is returned as it is. `precision` and the largest
/// tolerance that edges and vertices may get are in millimetres.
TopoDS_Shape FixShape(
  const TopoDS_Shape& shape, double precision, double maximum, const ShapeVisitor& visitChanges);

/// Repairs some faces of a shape as the repair of the whole shape would, and returns the shape with them;
/// `repaired` gets what became of these faces. The shape given is not changed, apart from what OpenCASCADE
/// adds to edges and vertices of these faces.
TopoDS_Shape FixFaces(const TopoDS_Shape& whole, const std::vector<TopoDS_Shape>& faces, double precision,
  double maximum, const ShapeVisitor& visitChanges, std::vector<TopoDS_Shape>& repaired);
}

#endif
