/**
 * @file smGaussRule.h
 * @brief Gauss-Legendre rules in extended precision
 */
#ifndef smGaussRule_h
#define smGaussRule_h

#include "smExactMoments.h"

#include <vector>

namespace smtest
{
/// On [0,1].
struct GaussRule
{
  std::vector<Real> Nodes;
  std::vector<Real> Weights;
};

/// Nodes by Newton's method on the Legendre polynomial.
GaussRule MakeGaussRule(int count);
}

#endif
