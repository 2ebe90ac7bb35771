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
/// Derivatives of a map, by differences over a length `step`: the largest of their sizes at the points, entry by entry, and the largest
/// factor by which it lengthens a vector. A map that only translates has exactly 1 and 0.
struct MapSlopes
{
  std::array<std::array<double, 3>, 3> Entries{};
  double Lengthening = 0.0;

  void Add(const PointMap& map, const std::array<double, 3>& point, double step);
  /// Bound of what becomes of a vector whose components have these bounds.
  std::array<double, 3> Apply(const std::array<double, 3>& bounds) const;
};
}

#endif
