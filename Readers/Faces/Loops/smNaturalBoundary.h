/**
 * @file smNaturalBoundary.h
 * @brief Bounds a face on a closed surface that lies outside all of its loops
 */
#ifndef smNaturalBoundary_h
#define smNaturalBoundary_h

#include "smDraftFace.h"

namespace sm
{
/// Returns true if the surface is closed, such as a sphere or torus: in both directions it is periodic or has
/// two poles.
SMREADERSFACES_EXPORT bool IsOnClosedSurface(const DraftFace& face);

/// Returns true if the face uses an edge twice. Its loop runs along a seam then, and is not a hole even if it
/// runs clockwise.
bool HasSeam(const DraftFace& face);

/**
 * Adds the natural boundary of the surface as the outer loop: two poles, or a pair of seams, in either
 * direction. A loop on a sphere or torus that encloses no pole bounds two parts of it; the face is the part
 * on its left, which for a loop that runs clockwise in (u,v) is the rest of the surface. `face` has completed
 * loops, all of them holes. Returns false, and leaves the face as it is, if the surface is not closed in both
 * directions or if no straight seam passes clear of all holes.
 */
bool AddNaturalBoundary(DraftFace& face);
}

#endif
