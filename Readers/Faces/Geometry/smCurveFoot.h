/**
 * @file smCurveFoot.h
 * @brief The parameter of the point of a curve that is closest to a given point
 */
#ifndef smCurveFoot_h
#define smCurveFoot_h

#include "smGeometricCurve.h"

namespace sm
{
/**
 * Returns the natural parameter at which a curve is closest to a point: in closed form for a line, and for a
 * point on a conic; else by Newton's method from the closest one of some points of each span. The range of a
 * spline is its domain. NaN if the domain of another curve is infinite.
 */
template <int Dimension>
double FindCurveParameter(const GeometricCurve<Dimension>& curve, const std::array<double, Dimension>& point);

/// Improves a parameter by Newton's method within [low, high], as long as the distance decreases.
template <int Dimension>
double ImproveCurveParameter(const GeometricCurve<Dimension>& curve,
  const std::array<double, Dimension>& point, double t, double low, double high);

extern template SMREADERSFACES_EXPORT double FindCurveParameter<2>(
  const GeometricCurve<2>&, const std::array<double, 2>&);
extern template SMREADERSFACES_EXPORT double FindCurveParameter<3>(
  const GeometricCurve<3>&, const std::array<double, 3>&);
extern template SMREADERSFACES_EXPORT double ImproveCurveParameter<3>(
  const GeometricCurve<3>&, const std::array<double, 3>&, double, double, double);
}

#endif
