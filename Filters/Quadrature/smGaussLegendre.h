/**
 * @file smGaussLegendre.h
 * @brief Gauss-Legendre rules on [0,1]
 */
#ifndef smGaussLegendre_h
#define smGaussLegendre_h

#include "smFiltersQuadratureModule.h"
#include <vector>

namespace sm
{
constexpr int MaximumRuleSize = 32;

/// Nodes (increasing, in (0,1)) and weights (positive, sum 1) of the n-point rule, exact to degree 2n-1, by
/// Newton's method on the Legendre polynomial in extended precision. n is 1 to MaximumRuleSize.
SMFILTERSQUADRATURE_EXPORT void ComputeGaussLegendre(
  int n, std::vector<double>& nodes, std::vector<double>& weights);

/// All rules as (node, weight) pairs back to back: that of n points starts at double n (n-1). Computed once.
/// Thread safe.
SMFILTERSQUADRATURE_EXPORT const std::vector<double>& GetRuleTable();
}

#endif
