/**
 * @file smRationalBlock.h
 * @brief Solids that are the image of the unit cube under a polynomial or rational map, and their moments
 *
 * Every face is one Bézier patch and every edge one Bézier curve. The integrands of the moments are
 * polynomials where the map is one, so Gauss rules of sufficient order in extended precision give them
 * exactly; where it is rational they are integrated to extended-precision convergence, which is checked.
 */
#ifndef smRationalBlock_h
#define smRationalBlock_h

#include "smExactMoments.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace smtest
{
/// x = sum B_i(u) B_j(v) B_k(w) W_ijk P_ijk / sum B_i B_j B_k W_ijk.
struct RationalBlock
{
  std::array<int, 3> Degree{ 1, 1, 1 };
  /// Index i + (Degree[0] + 1) * (j + (Degree[1] + 1) * k).
  std::vector<std::array<double, 3>> Poles;
  /// One for each pole, or empty: all 1.
  std::vector<double> Weights;

  std::size_t GetIndex(int i, int j, int k) const;
  bool IsRational() const { return !this->Weights.empty(); }
};

/// Poles from a function of the lattice point (i/p, j/q, k/r).
using LatticeFunction = std::function<std::array<double, 3>(double u, double v, double w)>;
RationalBlock MakeBlock(const std::array<int, 3>& degree, const LatticeFunction& position);

/// The same solid, its parameters replaced by Möbius functions: the weights become those of
/// factor[0]^i factor[1]^j factor[2]^k, the poles stay.
RationalBlock Reparametrized(const RationalBlock& block, const std::array<double, 3>& factor);

/// Moments and area. Throws std::runtime_error where the map's Jacobian changes its sign at a sample (the
/// block folds) or the integrals do not converge. The Jacobian may be negative throughout.
ExactMoments IntegrateBlock(const RationalBlock& block);

/// Sign of the Jacobian in the middle.
int GetHandedness(const RationalBlock& block);
}

#endif
