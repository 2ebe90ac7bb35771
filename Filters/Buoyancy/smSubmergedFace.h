/**
 * @file smSubmergedFace.h
 * @brief The part of a face below a plane, as panels, ribbons and caps
 *
 * Let h be the height above the plane and f a flux that vanishes where h does. The integral of f over the
 * part of a face below the plane is again a sum over panels. A patch is halved into boxes until each box is
 * below the plane, is above it, or has a height that is monotone in s or in r (by the Bernstein coefficients
 * of the derivative). Where the height is monotone in s, the waterline is a graph s = g(r). In the region
 * left of a trim piece, the submerged part is left of the piece or left of the graph, whichever is further
 * left. Therefore the trim pieces are cut where they cross the plane, and graphs replace the pieces above it.
 * Where the height is monotone in r, s and r are exchanged. Graphs are approximated by polynomials of degree
 * 9 at most.
 *
 * None of these steps needs to be exact: near the waterline |f| <= |h| |n|, so that a displacement d of a
 * graph changes the integral by the order of d^2. This error is added to the bound by means of bounds of h
 * along the graph. The bound also covers the boxes around points where the height is 0 and stationary
 * (tangent planes, saddles, tips), whose contribution falls with the fourth power of their size, and the
 * strips between a face and an edge on opposite sides of the plane.
 *
 * **Sections.** The area of the section is the flux of -up through the submerged part, its moments those of
 * -up g(x, y), x and y coordinates of the plane. The 2-form w = g dx dy is closed, but does not vanish on the
 * plane. Let X be the chain as computed and X' the true one over the same parameters, |X' - X| <= d with the
 * plane's own error in d, and R the part that is kept as submerged. The chain of the body must be closed:
 * every edge is shared, so that only the graphs bound R.
 * 1. w over X'(R) less w over X(R) is, by Stokes' theorem, w over what the border of R sweeps from X to X':
 * at most max|g| d times the length of that border, which is the graphs alone, since patches, ribbons and
 * caps share all others.
 * 2. Points of R above the true plane, and points outside R below it, contribute at most max|g| times their
 * area: a point left of a graph p(r) has N <= e = max |N(p(r), r)|, and if it is above the true plane N >=
 * -n, n the noise of N by d and by rounding; as N is monotone the sliver is at most (e + n) / |dN/ds| wide.
 * The same holds with the other sign, and where a trim piece is cut.
 * 3. Boxes, strips and caps whose heights have no certain sign beyond n count with their whole area, and d
 * times their border. AreaError is the sum, for g = 1. It is of first order in e and d, so graphs are fitted
 * to rounding; at a plane that runs along a face or touches it along a curve it is as wide as the area that d
 * leaves open.
 */
#ifndef smSubmergedFace_h
#define smSubmergedFace_h

#include "smFacePanelsCache.h"
#include "smFiltersBuoyancyModule.h"
#include "smHeightNet.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace sm
{
/// Limits of the errors of a cut.
struct CutLimits
{
  /// Limit of SubmergedFace::CutError.
  double Volume = 0.0;
  /// Limit of SubmergedFace::AreaError; infinite if all fluxes vanish on the plane, and AreaError is not
  /// wanted.
  double Area = std::numeric_limits<double>::infinity();
  /// Bound d of the displacement of the chain's points relative to the plane by reading, placement and
  /// rounding; for AreaError.
  double Displacement = 0.0;

  bool HasArea() const { return std::isfinite(this->Area); }
  bool operator==(const CutLimits& other) const
  {
    return this->Volume == other.Volume && this->Area == other.Area &&
      this->Displacement == other.Displacement;
  }
};

/// Bounds of the integrals of |h| |n| and of |n| over regions that may be on the wrong side.
struct CutErrors
{
  double Volume = 0.0;
  double Area = 0.0;
};

/// The submerged part of a face.
struct SubmergedFace
{
  /// The submerged part: `face` itself in Parts[0] if all of it is below the plane, else new faces with ids
  /// of their own, where Parts[1] has s and r exchanged. A null pointer is an empty part.
  CutFacePointer Parts[2];
  /// Upper bound of the integral of |h| |n| over all regions that may have been included or omitted wrongly.
  double CutError = 0.0;
  /// Upper bound of the error of the section's area, see above; 0 if it is not wanted.
  double AreaError = 0.0;
  /// Upper bound of the area of all ribbons and caps of the face, of which those of the submerged part are
  /// parts; 0 without such a part.
  double StripArea = 0.0;
  /// Number of boxes examined.
  std::size_t Boxes = 0;
};

/// Cuts a face at the plane. If a limit of work is reached first, the errors exceed their limits. A face with
/// an error is returned unchanged. Thread safe.
SMFILTERSBUOYANCY_EXPORT SubmergedFace CutBelow(
  const CutFacePointer& face, const HeightPlane& plane, const CutLimits& limits);
}

#endif
