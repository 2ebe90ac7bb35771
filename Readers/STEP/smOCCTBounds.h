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
/// Gets xmin xmax ymin … of the shape in kernel coordinates; the box may be larger than the shape if surfaces
/// are splines. Faces without a finite box are left out and counted in `unbounded`. Returns false if no face
/// has a finite box.
SMREADERSSTEP_EXPORT bool GetShapeBounds(
  const TopoDS_Shape& shape, double bounds[6], int* unbounded = nullptr);

/// Gets the box of the shape's edges only; returns false if there are none. It is needed for faces without
/// trim curves, whose boxes OpenCASCADE cannot compute.
SMREADERSSTEP_EXPORT bool GetEdgeBounds(const TopoDS_Shape& shape, double bounds[6]);
}

#endif
