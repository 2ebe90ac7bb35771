/**
 * @file smOCCTCurve.h
 * @brief OpenCASCADE's edge curves as polynomial pieces in their own parameter
 */
#ifndef smOCCTCurve_h
#define smOCCTCurve_h

#include "smOCCTParameterMap.h"
#include "smPolynomialCurve.h"
#include "smReadersSTEPModule.h"

#include <Geom_Curve.hxx>

#include <functional>
#include <vector>

namespace sm
{
/// Exact for lines and polynomial splines, else FitEdge.
SMREADERSSTEP_EXPORT EdgeCurve ConvertEdge(
  const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map);

/// Polynomial pieces to 1e-14 of the curve's size.
EdgeCurve FitEdge(const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map);

/// The same for any smooth function of the parameter between the breaks; its values carry roundings of
/// coordinates as large as `magnitude`.
EdgeCurve FitEdge(
  const std::function<Vector3(double)>& position, const std::vector<double>& breaks, double magnitude);

/// Breaks of a 3D curve: first, last and the knots between.
std::vector<double> GetCurveBreaks(const Handle(Geom_Curve) & curve, double first, double last);
}

#endif
