/**
 * @file smCommonParameter.h
 * @brief Restores the common parameter of a trim curve and its edge where the two are parametrised
 * differently
 */
#ifndef smCommonParameter_h
#define smCommonParameter_h

#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"
#include "smReadersFacesModule.h"

#include <array>

namespace sm
{
/// Distances between S(c(t)) and C(t) at equal parameter, along the edge and across it. Largest of three
/// samples of every piece of the trim curve.
struct Step
{
  double Lag = 0.0;
  double Gap = 0.0;
};
SMREADERSFACES_EXPORT Step MeasureStep(
  const NURBSSurface& surface, const TrimCurve& trim, const EdgeCurve& edge);

enum class StepResult
{
  InStep,
  Restored,
  /// The trim curve was not changed.
  Failed
};

/**
 * Replaces a trim curve that is parametrised differently from its edge: one whose points at equal parameter
 * are displaced along the edge by more than 1e-7 of `size` and more than three times the gap. It is replaced
 * by c(tau(t)), with (S(c(tau)) - C(t)) . C'(t) = 0: the same points of the face at the parameters of the
 * edge. Its ends are kept bit for bit; the displacement that tau would give them is subtracted linearly along
 * the curve. The result is fitted by polynomial pieces, cut where c, C and the surface have their knots, to
 * `tolerance` in u and v, or to the level of rounding; the error of the fit is added to the residual. A
 * constant coordinate remains constant. Fails if tau does not exist or does not increase, or if the
 * displacement does not decrease to half.
 */
SMREADERSFACES_EXPORT StepResult RestoreCommonParameter(const NURBSSurface& surface, const EdgeCurve& edge,
  double size, const std::array<double, 2>& tolerance, TrimCurve& trim);
}

#endif
