/**
 * @file smSTEPRevolvedConics.h
 * @brief Which turn of a circle or ellipse is meant that is revolved about an axis through its centre
 */
#ifndef smSTEPRevolvedConics_h
#define smSTEPRevolvedConics_h

#include "smSTEPGeometry.h"

namespace sm
{
/**
 * Such a surface has two parameters at every point, with opposite normals. Finds the range of the conic's
 * parameter that stands for it: a whole turn, centred about the parameter curves that the file has on the
 * surface; it begins at 0 if there are none that state it. For a face without edges: the half turn whose
 * normals lead outwards, or inwards if the face is against them. Returns false for any other surface.
 */
bool FindRevolvedRange(const STEPAttributes& entities, STEPGeometry& geometry, Part21File::Index entity,
  const STEPSurface& surface, ParameterRange& range);
}

#endif
