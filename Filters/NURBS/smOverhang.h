/**
 * @file smOverhang.h
 * @brief Bounds of how far a trim curve leads beyond the domain of its surface
 *
 * Beyond its domain a surface is continued by the polynomials of its nearest Bézier patch, so that panels and
 * ribbons are as exact there as elsewhere. But the file's surface ends at its domain: the strip between is a
 * gap of the model, up to the given distance wide.
 *
 * With the parameters of the patch in [-a,1+a] x [-b,1+b], a Bernstein polynomial of degrees p, q is at most
 * its largest coefficient times (1+2a)^p (1+2b)^q, and so are its derivatives with theirs. That bounds |P|,
 * |P_s|, |P_r| of the numerator P and |w_s|, |w_r| from above, w from below, and the surface's derivatives by
 * |S_s| <= (|P_s| + |P| |w_s| / w) / w. Where weights differ much that is far too large; but within the
 * domain |S_s| is at most the patch's Stretch, and beyond it grows by no more than the second derivatives,
 * which are bounded likewise, times a + b. A point's distance from the domain's border is at most the
 * overhangs in s and r times these.
 */
#ifndef smOverhang_h
#define smOverhang_h

#include "smFiltersNURBSModule.h"

#include "smBezierPatch.h"
#include "smFace.h"
#include "smPolynomialCurve.h"

#include <array>

namespace sm
{
struct SMFILTERSNURBS_EXPORT Overhang
{
  /// Bounds of the largest distance from the border, and of its integral and the integral of its square along
  /// the trim curve.
  double Distance = 0.0;
  double Area = 0.0;
  double Squared = 0.0;

  void Add(const Overhang& other);
};

/// Bounds for the part of the curve (u,v) with parameters in [start,end], in the patch that continues the
/// surface to it; `low` and `high` are the corners of the surface's domain. Infinite where the continued
/// weights may vanish.
SMFILTERSNURBS_EXPORT Overhang BoundOverhang(const Patch& patch, const std::array<double, 4>* points,
  const BernsteinPiece<2>& curve, double start, double end, const std::array<double, 2>& low,
  const std::array<double, 2>& high);

/// Returns the face with trim curves that stay in the surface's domain: their coefficients outside are moved
/// to its border.
Face MoveTrimsInside(const Face& face);
}

#endif
