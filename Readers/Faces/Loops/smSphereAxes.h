/**
 * @file smSphereAxes.h
 * @brief Chooses the poles of a sphere so that the loops of its face avoid them
 */
#ifndef smSphereAxes_h
#define smSphereAxes_h

#include "smDraftFace.h"

#include <vector>

namespace sm
{
/// Returns the same sphere with another axis.
SurfacePointer TurnSphere(const ElementarySurface& sphere, const Vector3& axis);

/// Returns true if the largest loop runs clockwise or encloses nothing, as a seam does that ends at no pole:
/// the loops do not bound the face from outside.
bool HasOnlyHoles(const DraftFace& face);

/// Returns axes to try for a sphere: through the ends of its seam, those of its loops, which make a circle a
/// line of constant parameter, then fixed ones.
std::vector<Vector3> ListSphereAxes(const DraftFace& face, const ElementarySurface& sphere);
}

#endif
