/**
 * @file smSubmergedFace.h
 * @brief The part of a face below a plane, as panels, ribbons and caps
 *
 * Let h be the height above the plane and f a flux that vanishes where h does. The integral of f over the part of a face below
 * the plane is again a sum over panels. A patch is halved into boxes until each box is below the plane, is above it, or has a
 * height that is monotone in s or in r (by the Bernstein coefficients of the derivative). Where the height is monotone in s, the
 * waterline is a graph s = g(r). Of the region left of a trim piece, the submerged part is left of the piece or left of the
 * graph, whichever is further left. Therefore the trim pieces are cut where they cross the plane, and graphs replace the pieces
 * above it. Where the height is monotone in r, s and r are exchanged. Graphs are approximated by polynomials of degree 9 at most.
 *
 * None of these steps needs to be exact: near the waterline |f| <= |h| |n|, so that a displacement d of a graph changes the
 * integral by the order of d^2. This error is added to the bound by means of bounds of h along the graph. The bound also covers
 * the boxes around points where the height is 0 and stationary (tangent planes, saddles, tips), whose contribution falls with the
 * fourth power of their size, and the strips between a face and an edge on opposite sides of the plane.
 */
#ifndef smSubmergedFace_h
#define smSubmergedFace_h

#include "smFacePanelsCache.h"
#include "smFiltersBuoyancyModule.h"
#include "smHeightNet.h"

#include <cstddef>

namespace sm
{
/// The submerged part of a face.
struct SubmergedFace
{
  /// The submerged part: `face` itself in Parts[0] if all of it is below the plane, else new faces with ids of their own, where
  /// Parts[1] has s and r exchanged. A null pointer is an empty part.
  CutFacePointer Parts[2];
  /// Upper bound of the integral of |h| |n| over all regions that may have been included or omitted wrongly.
  double CutError = 0.0;
  /// Upper bound of the area of all ribbons and caps of the face, of which those of the submerged part are parts; 0 without such a
  /// part.
  double StripArea = 0.0;
  /// Number of boxes examined.
  std::size_t Boxes = 0;
};

/// Cuts a face at the plane. `tolerance` is the limit for CutError; if a limit of work is reached first, CutError exceeds it. A
/// face with an error is returned unchanged. Thread safe.
SMFILTERSBUOYANCY_EXPORT SubmergedFace CutBelow(
  const CutFacePointer& face, const HeightPlane& plane, double tolerance);
}

#endif
