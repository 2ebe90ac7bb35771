/**
 * @file smGroundTrim.h
 * @brief Trim curves on their patches, as rational Bézier curves in the ground's frame
 *
 * The curve's polynomials are put into de Casteljau's scheme of the patch; coefficients are multiplied by their binomials, so that
 * products are convolutions of positive terms and nothing cancels.
 */
#ifndef smGroundTrim_h
#define smGroundTrim_h

#include "smGroundNet.h"

namespace sm
{
/// The part of a trim piece between `start` and `end` in a patch: the curve's image under the patch, exactly (a rational curve of
/// degree up to (p + q) d). `uv` are the pairs of coefficients of a piece of this degree in the patch's own (u, v).
GroundCurve ComposeTrim(
  const GroundPatch& root, const Patch& patch, const double* uv, int degree, double start, double end);

/// The part of the piece stays in the patch's own square, where the net vouches for heights.
bool StaysInSquare(const Patch& patch, const double* uv, int degree, double start, double end);

/// (s, r) of the same piece at the curve's parameter.
std::array<double, 2> GetTrimPoint(
  const Patch& patch, const double* uv, int degree, double start, double end, double t);
}

#endif
