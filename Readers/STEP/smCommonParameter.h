/**
 * @file smCommonParameter.h
 * @brief Restores the common parameter of a trim curve and its edge where the two are parametrised differently
 */
#ifndef smCommonParameter_h
#define smCommonParameter_h

#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"
#include "smReadersSTEPModule.h"

#include <array>

namespace sm
{
/// Distances between S(c(t)) and C(t) at equal parameter, along the edge and across it. Largest of three samples of
/// every piece of the trim curve.
struct Step
{
  double Lag = 0.0;
  double Gap = 0.0;
};
SMREADERSSTEP_EXPORT Step MeasureStep(
  const NURBSSurface& surface, const TrimCurve& trim, const EdgeCurve& edge);

enum class StepResult
{
  InStep,
  Restored,
  /// The trim curve is as it was.
  Failed
};

/**
 * A trim curve lags when it is more than 1e-7 of `size` and more than three times its gap behind or ahead of the edge. It is
 * then replaced by c(tau(t)), with (S(c(tau)) - C(t)) . C'(t) = 0: the same points of the face at the parameters of
 * the edge. Its ends stay where they are, bit for bit; what tau would move them by is taken off linearly along the curve.
 * The result is fitted by polynomial pieces, cut where c, C and the surface have their knots, to `tolerance` in u
 * and v, or to the floor that rounding sets; what is left is added to the residual. A coordinate that is constant stays so.
 * It fails where tau does not exist or does not increase, or when the lag does not fall to half.
 */
SMREADERSSTEP_EXPORT StepResult RestoreCommonParameter(const NURBSSurface& surface, const EdgeCurve& edge,
  double size, const std::array<double, 2>& tolerance, TrimCurve& trim);
}

#endif
