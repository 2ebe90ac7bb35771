/**
 * @file smOCCTCurve.h
 * @brief Converts OpenCASCADE's edge curves to polynomial pieces, with the same parameter
 */
#ifndef smOCCTCurve_h
#define smOCCTCurve_h

#include "Geometry/smCurveFit.h"
#include "Geometry/smParameterMap.h"
#include "smPolynomialCurve.h"
#include "smReadersSTEPModule.h"

#include <Geom_Curve.hxx>

#include <vector>

namespace sm
{
/// Converts a curve: exactly for lines and polynomial splines, else by FitEdge().
SMREADERSSTEP_EXPORT EdgeCurve ConvertEdge(
  const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map);

/// Fits polynomial pieces to 1e-14 of the curve's size.
EdgeCurve FitEdge(const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map);

/// Returns the breaks of a 3D curve: first, last and the knots between.
std::vector<double> GetCurveBreaks(const Handle(Geom_Curve) & curve, double first, double last);
}

#endif
