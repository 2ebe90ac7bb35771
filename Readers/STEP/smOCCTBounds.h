/**
 * @file smOCCTBounds.h
 * @brief The bounding box of a shape of OpenCASCADE
 */
#ifndef smOCCTBounds_h
#define smOCCTBounds_h

#include "smReadersSTEPModule.h"

#include <TopoDS_Shape.hxx>

namespace sm
{
/// xmin xmax ymin … of the shape in kernel coordinates, wider than the shape where its surfaces are splines. Faces that have no
/// finite box are left out and counted in `unbounded`; false when none has one.
SMREADERSSTEP_EXPORT bool GetShapeBounds(
  const TopoDS_Shape& shape, double bounds[6], int* unbounded = nullptr);

/// The same of the shape's edges alone; false when it has none. For faces whose edges have no curves in their parameters, whose boxes
/// OpenCASCADE cannot tell.
SMREADERSSTEP_EXPORT bool GetEdgeBounds(const TopoDS_Shape& shape, double bounds[6]);
}

#endif
