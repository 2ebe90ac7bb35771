/**
 * @file smPatchTraits.h
 * @brief Properties of a whole rational Bézier patch: poles, equal weights, polynomial lengths
 */
#ifndef smPatchTraits_h
#define smPatchTraits_h

#include "smFiltersQuadratureModule.h"

#include <array>
#include <vector>

namespace sm
{
/// Properties of a whole patch, found before any box of it is examined.
struct PatchTraits
{
  /// All weights are equal: numerators are the integrands up to a constant.
  bool Polynomial = true;
  /// Edges that are one point (poles): s = 0, s = 1, r = 0, r = 1. There m has the factor s, 1-s, r, 1-r.
  std::array<bool, 4> Collapsed{};
  /// |m| over those factors is itself a polynomial, as on every elementary surface (an arc's speed is
  /// rational).
  bool PolynomialLength = false;
  /// m has a constant direction, as in a plane: |m| is a polynomial as long as m does not vanish.
  bool ConstantDirection = false;
  /// Bound of the deviation, due to rounding, of m~.m~ from the square of that form on the patch.
  double SquareDeviation = 0.0;
};

/// Finds Polynomial and Collapsed; PatchMajorants::ExpandPatch() finds the others. Points are those of the
/// patch: (p+1) x (q+1), s fastest, homogeneous relative to its centre.
SMFILTERSQUADRATURE_EXPORT PatchTraits FindPatchTraits(const std::array<double, 4>* points, int p, int q);

/// Moves the control points of every edge that are within `size` times the patch's of one another to one
/// point: a pole whose coordinates were rounded.
void CollapseEdges(std::vector<std::array<double, 4>>& points, int p, int q, double size);
}

#endif
