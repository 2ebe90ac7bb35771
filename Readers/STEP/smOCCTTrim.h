/**
 * @file smOCCTTrim.h
 * @brief Converts OpenCASCADE's pcurves to polynomial pieces in the parameters of the converted surface
 */
#ifndef smOCCTTrim_h
#define smOCCTTrim_h

#include "smOCCTNativeTrim.h"
#include "smPolynomialCurve.h"
#include "smReadersSTEPModule.h"

#include <array>

namespace sm
{
/// Returns the tolerance of the fit of a trim curve in each of our parameters.
std::array<double, 2> GetTrimTolerance(const ParameterMap maps[2], const double width[2]);

/**
 * Converts a pcurve to a trim curve over the edge's range, in the parameters of the converted surface:
 * exactly for polynomial pcurves if both maps are the identity, else cut at arc borders and fitted to 1e-13
 * of an arc or of `width`, or to the level of rounding of the angles.
 */
SMREADERSSTEP_EXPORT TrimCurve ConvertTrim(const NativeTrim& trim, double edgeFirst, double edgeLast,
  const ParameterMap maps[2], const double width[2]);
}

#endif
