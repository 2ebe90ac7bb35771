/**
 * @file smHullBound.h
 * @brief Largest magnitude of the integrals over a panel or a ribbon, whatever its weights are
 *
 * Where weights differ by orders of magnitude no ellipse is small enough for a bound of the integrands. But
 * with positive weights the surface lies in the box of its control points, and its area is bounded by Cauchy
 * and Crofton's formula: the area is 1/pi times the measure of the lines that it meets, each counted as often
 * as it meets it. A line is the section of two planes, which are polynomials of degrees (p, q) on the patch
 * and vanish together at no more than 2 p q points (Bezout), except for lines of measure 0. Lines that meet a
 * convex body have the measure pi/2 times the area of its surface. So the patch has at most p q times the
 * surface of its box, however it is parametrised.
 */
#ifndef smHullBound_h
#define smHullBound_h

#include "smFacePanels.h"
#include "smPatchMajorants.h"

#include <array>
#include <cstdint>

namespace sm
{
struct HullBound
{
  /// Bounds of the area, every part counted as often as it is covered, and of the distance from the point
  /// that moments are about. Infinite where the trim curve leads to where the weight may vanish, and where
  /// weights differ by less than this bound is made for.
  double Area;
  double Reach;

  /// Bound of the magnitude of an integral.
  double GetMagnitude(const BoundClass& integrand) const;
};

/// Returns the bound of a whole patch, which is covered once. `shift`: see PlanRequest.
HullBound BoundPatchByHull(const FacePanels& panels, std::uint32_t patch, const std::array<double, 3>& shift);
HullBound BoundPanelByHull(const FacePanels& panels, const Panel& panel, const std::array<double, 3>& shift);
HullBound BoundRibbonByHull(
  const FacePanels& panels, const Ribbon& ribbon, const std::array<double, 3>& shift);
}

#endif
