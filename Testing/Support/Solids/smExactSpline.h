/**
 * @file smExactSpline.h
 * @brief Closed planar cubic splines and the exact moments of bodies made from them
 *
 * The integrands of moments are polynomials on every span, so Gauss rules of sufficient order in extended
 * precision give them exactly; lengths are integrated to extended-precision convergence.
 */
#ifndef smExactSpline_h
#define smExactSpline_h

#include "smExactMoments.h"

#include <array>
#include <vector>

namespace smtest
{
/// A closed cubic B-spline in the plane, clamped, counter-clockwise. The poles have 12 significant digits, so
/// a STEP file carries them without error.
struct ClosedSpline
{
  static constexpr int Degree = 3;
  /// Full knot vector, poles + 4 values; integers.
  std::vector<double> Knots;
  std::vector<std::array<double, 2>> Poles;

  /// Integral of p^a q^b over the enclosed region, a, b >= 0, a + b <= 6.
  Real GetRegionMoment(int a, int b) const;
  /// Integral of p^a along the curve, a <= 1.
  Real GetLengthMoment(int a) const;
};

/// Interpolates closed data with C2 continuity at uniform parameters.
ClosedSpline InterpolateClosed(const std::vector<std::array<double, 2>>& points);

/// A Joukowski airfoil with rounded trailing edge, chord about 100, through `count` points.
ClosedSpline Airfoil(int count);
/// A gear of `teeth` rounded teeth between radii about 46 and 54, 12 points a tooth.
ClosedSpline Gear(int teeth);
/// A closed, not convex section in the (radius, z) half plane, to be revolved about z.
ClosedSpline RingSection();

/// The region extruded from z = 0 to z = height: (p, q) = (x, y).
ExactMoments Extruded(const ClosedSpline& section, Real height);
/// The region revolved about z: (p, q) = (radius, z).
ExactMoments Revolved(const ClosedSpline& section);
}

#endif
