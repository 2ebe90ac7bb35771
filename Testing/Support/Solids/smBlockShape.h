/**
 * @file smBlockShape.h
 * @brief The OCCT solid of a rational block: six Bézier patches that share twelve Bézier edges
 */
#ifndef smBlockShape_h
#define smBlockShape_h

#include "smRationalBlock.h"

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Shape.hxx>

#include <array>

namespace smtest
{
/// Patch of the face where parameter `axis` is `side` (0 or 1); its parameters are the block's next two,
/// cyclically.
Handle(Geom_BSplineSurface) MakeBlockPatch(const RationalBlock& block, int axis, int side);

/// The solid. Trim curves are straight and edges, trims and patches have the same parameters, so nothing has
/// a gap except for rounding. A surface in `replaced` (index 2 axis + side) stands for the patch; it must
/// have the same points at the same parameters.
TopoDS_Shape MakeBlockShape(
  const RationalBlock& block, const std::array<Handle(Geom_Surface), 6>& replaced = {});
}

#endif
