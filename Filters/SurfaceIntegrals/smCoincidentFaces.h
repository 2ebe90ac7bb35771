/**
 * @file smCoincidentFaces.h
 * @brief Faces of a closed boundary that lie on each other; not installed
 */
#ifndef smCoincidentFaces_h
#define smCoincidentFaces_h

#include "smFiltersSurfaceIntegralsModule.h"

#include "smBodyIntegrals.h"

namespace sm
{
/**
 * Marks a body as suspect if two of its faces have the same edges and enclose no volume between them: they
 * lie on each other with opposite sides, a membrane that adds to the area and to nothing else. `volume` and
 * `area` are the indices of their integrands. An edge that more than two faces use is not a contradiction by
 * itself, since parts of a solid may touch along it. Faces that lie on each other with different edges are
 * not found.
 */
SMFILTERSSURFACEINTEGRALS_EXPORT void FlagCoincidentFaces(BodyIntegrals& body, int volume, int area);
}

#endif
