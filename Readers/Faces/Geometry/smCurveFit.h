/**
 * @file smCurveFit.h
 * @brief Polynomial pieces for curves in space, to rounding level
 */
#ifndef smCurveFit_h
#define smCurveFit_h

#include "smPolynomialCurve.h"
#include "smReadersFacesModule.h"
#include "smVector.h"

#include <functional>
#include <vector>

namespace sm
{
/// Fits any function that is smooth between the breaks to 1e-14 of its size. The rounding of its values is
/// that of coordinates as large as `magnitude`. Throws std::runtime_error if it needs too many pieces.
SMREADERSFACES_EXPORT EdgeCurve FitEdge(
  const std::function<Vector3(double)>& position, const std::vector<double>& breaks, double magnitude);
}

#endif
