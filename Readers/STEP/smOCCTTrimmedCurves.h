/**
 * @file smOCCTTrimmedCurves.h
 * @brief Trimmed and revolved curves whose parameters OpenCASCADE reads in another way
 */
#ifndef smOCCTTrimmedCurves_h
#define smOCCTTrimmedCurves_h

#include "smOCCTEntities.h"

namespace sm
{
/**
 * Trims circles and ellipses that are revolved about an axis through their centre to a whole turn.
 * OpenCASCADE would trim them to half a turn and turn their parameter, but not the parameter curves of edges
 * on the surface.
 *
 * Such a surface has two parameters at every point, with opposite normals. The turn is centred about the
 * parameter curves that the file has on the surface; it begins at 0 if there are none that decide. A face
 * without edges gets the half turn whose normals lead outwards. `angle` is the file's unit of angles in
 * radians.
 */
void KeepRevolvedConics(const ModelEntities& entities, double angle);

/**
 * Trims the basis of a trimmed curve instead of that curve itself. The parameter of a trimmed curve is that
 * of its basis, counted from its start in its sense (ISO 10303-42); OpenCASCADE takes that of the basis, and
 * does not convert its unit.
 */
void FlattenTrims(const ModelEntities& entities);
}

#endif
