/**
 * @file smGroundTrim.h
 * @brief Trim curves on their patches, as rational Bézier curves in the ground's frame
 *
 * The curve's polynomials are substituted for the parameters in de Casteljau's scheme of the patch;
 * coefficients are multiplied by their binomials, so that products are convolutions of positive terms and
 * nothing cancels.
 */
#ifndef smGroundTrim_h
#define smGroundTrim_h

#include "smGroundNet.h"

namespace sm
{
/// Returns the image of a trim piece between `start` and `end` under its patch, exactly: a rational curve of
/// degree up to (p + q) d. `uv` are the pairs of coefficients of a piece of this degree in the patch's own
/// (u, v).
GroundCurve ComposeTrim(
  const GroundPatch& root, const Patch& patch, const double* uv, int degree, double start, double end);

/// Returns true if the part of the piece stays in the patch's parameter square, where the control net bounds
/// heights.
bool StaysInSquare(const Patch& patch, const double* uv, int degree, double start, double end);

/// Returns (s, r) of the same piece at the parameter t of the composed curve.
std::array<double, 2> GetTrimPoint(
  const Patch& patch, const double* uv, int degree, double start, double end, double t);
}

#endif
