/**
 * @file smFacePieces.h
 * @brief Counts the outer loops of a face, and finds faces on both parts of a torus that crosses itself
 */
#ifndef smFacePieces_h
#define smFacePieces_h

#include "smFaceCheck.h"

namespace sm
{
/**
 * Returns the number of loops that run counter-clockwise in (u,v). A connected face has one, which the
 * others, holes, lie within.
 *
 * This is Gauss and Bonnet's sum, integral of K dA + integral of kappa_g ds + turning angles = 2 pi chi. With
 * angles from the direction of Su it is, by Stokes' theorem and for any metric, the number of turns of the
 * tangents of the loops in (u,v), cut open at seams and poles; a loop that does not cross itself has one turn
 * with the sign of its area. A connected face with L loops has 2 - L turns, and with two outer loops it has
 * two more. The signs of areas are taken because tangents turn at random where a loop is narrower than the
 * rounding of its curves: by these, 73 of 25,207 faces of 98 real files would differ, by the signs none does.
 * The integral over the curvature is therefore not computed: it would give the same whole number, and where
 * it is 0, as on planes and cylinders, it knows nothing of the region. Which region it is, the vector area
 * and the moments decide (smFaceCheck.h). Loops that cross themselves, and holes that run the wrong way, are
 * found by the multiplicities of the integrals (smCoverage.h).
 *
 * A loop whose area is less than a thousandth of that of its box is not counted.
 */
SMREADERSFACES_EXPORT int CountOuterLoops(const Face& face);

/// Returns true if a face on a torus that crosses itself has points of both its outer and its inner part.
SMREADERSFACES_EXPORT bool IsOnBothParts(
  const Face& face, const SpindleTorus& torus, const StatementPlace& place);
}

#endif
