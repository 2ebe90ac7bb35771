/**
 * @file smPatchGradient.h
 * @brief Integrals of moments times the Bernstein polynomials of one patch, and their rounding bounds
 *
 * For each control point (i,j) of the patch, with R = B_i(s) B_j(r) / w, n = Ss x Sr outwards and x from the
 * point that moments are about, integrals over the patch's panels of
 *
 *     g R n   and   g R (x.n)   for g = 1, x, y, z, xx, yy, zz, xy, yz, xz,
 *     R_s (Sr x e) + R_r (e x Ss)   and   R_s x.(Sr x e) + R_r x.(e x Ss) + 2 R |n|,   e = n / |n|.
 *
 * Sums are factored: at each point of a line of constant r the values meet the p + 1 polynomials in s, and at
 * the end of the line the sums meet the q + 1 polynomials in r.
 */
#ifndef smPatchGradient_h
#define smPatchGradient_h

#include "smPatchLines.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sm
{
/// Number of moments, in the order 1, x, y, z, xx, yy, zz, xy, yz, xz, and the degree of each.
constexpr int NumberOfMoments = 10;
constexpr std::array<int, NumberOfMoments> MomentDegrees{ 0, 1, 1, 1, 2, 2, 2, 2, 2, 2 };

/// Places of the integrals of a control point, in fours.
namespace channel
{
/// Component c of the integral with moment g is at 4 g + c; that of x.n at 4 g + 3.
constexpr int Flux = 3;
/// Three components of the vector of the area, and its scalar.
constexpr int Area = 4 * NumberOfMoments;
/// Bounds of roundings relative to u: that of g R n with a g of degree k is at Noise + k, that of g R x.n at
/// Noise + k + 1.
constexpr int Noise = Area + 4;
constexpr int Count = Noise + 4;
}

/// The integrals of a patch.
struct PatchSums
{
  int Degree[2] = { 1, 1 };
  /// channel::Count numbers for each control point, s fastest.
  std::vector<double> Sums;
  /// Bounds, relative to u, of the roundings of the area's vector (0) and scalar (1), of all control points
  /// together and so of each.
  double AreaNoise[2] = { 0.0, 0.0 };
  /// The largest BoundBasis() of the panels.
  double Growth = 1.0;
  std::int64_t Evaluations = 0;

  const double* Get(int i, int j) const
  {
    return this->Sums.data() + channel::Count * (i + (this->Degree[0] + 1) * static_cast<std::size_t>(j));
  }
};

/// Returns sums of 0 for the lines of a patch.
PatchSums MakePatchSums(const PatchTask& task, const std::vector<PatchLine>& lines);

/// Computes the integrals on the processor. Thread safe.
PatchSums ComputePatchSums(const PatchTask& task);
}

#endif
