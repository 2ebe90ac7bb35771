/**
 * @file smSubmergedFace.h
 * @brief The part of a cut face below a plane, as panels, ribbons and caps of its own
 *
 * With h the height above the plane and f a flux that vanishes where h does, the integral of f over the part below is a sum of
 * panels again. A patch is halved into boxes until in each of them it is below, or above, or its height is monotone in s or in
 * r (by the Bernstein coefficients of the derivative). Where it is monotone in s, the waterline is a graph s = g(r): of the
 * region left of a trim piece, what is below is left of the piece or of the graph, whichever is nearer; so the
 * pieces are cut where they cross the plane, and graphs take the place of those above. Where it is monotone in r, s and r are
 * exchanged. Graphs are refitted by polynomials of degree 9 at most.
 *
 * Nothing of this is exact, and nothing has to be: |f| <= |h| |n| there, so that a graph off by d moves the integral by d^2, which is added to
 * the bound by bounds of h along it; so are boxes around points where the height is stationary and 0 (tangent planes, saddles, tips),
 * whose share falls with the fourth power of their size, and strips between a face and an edge on either side of the plane.
 */
#ifndef smSubmergedFace_h
#define smSubmergedFace_h

#include "smFacePanelsCache.h"
#include "smFiltersBuoyancyModule.h"
#include "smHeightNet.h"

#include <cstddef>

namespace sm
{
struct SubmergedFace
{
  /// What lies below: the face itself where all of it does; else new faces with ids of their own, of which the second has s and r
  /// exchanged. Null: nothing.
  CutFacePointer Parts[2];
  /// Bound of the integral of |h| |n| over what may have been added or left out wrongly.
  double CutError = 0.0;
  /// Boxes that were looked at.
  std::size_t Boxes = 0;
};

/// `tolerance`: what CutError is to stay below; where a limit of work ends it first, CutError says so. A face that could not be
/// cut is returned as it is. Thread safe.
SMFILTERSBUOYANCY_EXPORT SubmergedFace CutBelow(
  const CutFacePointer& face, const HeightPlane& plane, double tolerance);
}

#endif
