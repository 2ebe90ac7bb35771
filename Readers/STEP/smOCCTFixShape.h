/**
 * @file smOCCTFixShape.h
 * @brief OpenCASCADE's repair of shapes, as its own reader of STEP files applies it
 */
#ifndef smOCCTFixShape_h
#define smOCCTFixShape_h

#include <TopoDS_Shape.hxx>

#include <functional>
#include <vector>

namespace sm
{
/// Repairs some faces of a shape as OpenCASCADE's repair of the whole shape would, and returns the shape with
/// them; `repaired` gets what became of these faces. The shape given is not changed, apart from what
/// OpenCASCADE adds to edges and vertices of these faces.
using FaceRepair = std::function<TopoDS_Shape(
  const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& faces, std::vector<TopoDS_Shape>& repaired)>;

/// Decides whether a shape needs a repair: returns true for a shape that does not, which it may exchange or
/// repair in part.
using RepairFilter = std::function<bool(TopoDS_Shape&, const FaceRepair&)>;

/// Gets a solid, shell, face or edge, and what a repair replaced it by.
using ShapeVisitor = std::function<void(const TopoDS_Shape& from, const TopoDS_Shape& to)>;

/// Repairs a shape unless `isSound` returns true for it; a shape of which the repair fails is returned as it
/// is. `precision` and the largest tolerance that edges and vertices may get are in millimetres. Hold a
/// KernelSession.
TopoDS_Shape RepairOnDemand(const TopoDS_Shape& shape, double precision, double maximum,
  const RepairFilter& isSound, const ShapeVisitor& visitChanges);
}

#endif
