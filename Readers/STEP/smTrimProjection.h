/**
 * @file smTrimProjection.h
 * @brief Projects an edge on the surface of a face, to rounding
 */
#ifndef smTrimProjection_h
#define smTrimProjection_h

#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"
#include "smReadersSTEPModule.h"

#include <array>

namespace sm
{
/**
 * Replaces a trim curve that is only near its edge by one of the points of the surface nearest to C(t), (S(c(t)) - C(t)) . Su = 0 and
 * . Sv = 0, fitted by polynomial pieces to `tolerance` in u and v; what is left is its residual. A curve of constant u or v stays, and
 * so does each end that is right to rounding. Returns false, with the curve as it was, where the edge is farther off the surface than
 * off the curve and so contradicts it, or where the points do not exist, are far from the curve, or are not smooth enough to be fitted.
 */
SMREADERSSTEP_EXPORT bool ProjectEdge(const NURBSSurface& surface, const EdgeCurve& edge,
  const std::array<double, 2>& tolerance, TrimCurve& trim);
}

#endif
