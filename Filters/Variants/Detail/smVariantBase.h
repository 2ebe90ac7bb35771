/**
 * @file smVariantBase.h
 * @brief What makes a model unfit as the base of variants
 */
#ifndef smVariantBase_h
#define smVariantBase_h

#include "smNURBSSurface.h"

#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <string>
#include <vector>

namespace sm
{
/// Returns why the moments of a model are not those of a solid, and what to do; empty if they are. It has to
/// be closed (CheckTopology()). Of several shells one encloses the largest volume, and all others, its voids,
/// have the opposite sign: what the mass properties would reverse is refused here.
std::string FindBaseProblem(vtkTrimmedNURBSModel& model);

/**
 * Returns true if a face without loops opens by a move, whose displacements are w dx, w dy, w dz of the
 * control points: no edge closes it, so no ribbon does. Control points that coincide, because the surface
 * closes on itself or has a pole, have to move alike. A border that is neither closed so nor a pole belongs
 * to other faces, and may not move at all.
 */
bool OpensFace(const NURBSSurface& surface, const std::vector<std::array<double, 3>>& displacements);
}

#endif
