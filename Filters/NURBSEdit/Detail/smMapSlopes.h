/**
 * @file smMapSlopes.h
 * @brief Derivatives of a map of space, by difference quotients
 */
#ifndef smMapSlopes_h
#define smMapSlopes_h

#include "smModelEdit.h"

#include <array>

namespace sm
{
/// Derivatives of a map, by differences over a length `step`: the largest absolute value of every entry of
/// the Jacobian over the points, and the largest factor by which the map lengthens a vector. A map that only
/// translates has exactly 1 and 0.
struct MapSlopes
{
  std::array<std::array<double, 3>, 3> Entries{};
  double Lengthening = 0.0;

  void Add(const PointMap& map, const std::array<double, 3>& point, double step);
  /// Returns bounds of the components of the mapped vector, from bounds of the components of a vector.
  std::array<double, 3> Apply(const std::array<double, 3>& bounds) const;
};
}

#endif
