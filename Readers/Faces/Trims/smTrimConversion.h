/**
 * @file smTrimConversion.h
 * @brief Converts pcurves to polynomial pieces in the parameters of the converted surface
 */
#ifndef smTrimConversion_h
#define smTrimConversion_h

#include "smNativeTrim.h"
#include "smPolynomialCurve.h"

#include <array>

namespace sm
{
/// Returns the tolerance of the fit of a trim curve in each of our parameters.
SMREADERSFACES_EXPORT std::array<double, 2> GetTrimTolerance(
  const ParameterMap maps[2], const double width[2]);

/**
 * Converts a pcurve to a trim curve over the edge's range, in the parameters of the converted surface:
 * exactly for polynomial pcurves if both maps are the identity, else cut at arc borders and fitted to 1e-13
 * of an arc or of `width`, or to the level of rounding of the angles.
 */
SMREADERSFACES_EXPORT TrimCurve ConvertTrim(const NativeTrim& trim, double edgeFirst, double edgeLast,
  const ParameterMap maps[2], const double width[2]);
}

#endif
