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

#include "smFacePanels.h"
#include "smPatchPlans.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sm
{
/// Number of moments, in the order 1, x, y, z, xx, yy, zz, xy, yz, xz, and the degree of each.
constexpr int NumberOfMoments = 10;
constexpr std::array<int, NumberOfMoments> MomentDegrees{ 0, 1, 1, 1, 2, 2, 2, 2, 2, 2 };

/// Places of the integrals of a control point.
namespace channel
{
/// Component c of the integral with moment g is at 3 g + c; that of x.n at Flux + g.
constexpr int Normal = 0;
constexpr int Flux = 3 * NumberOfMoments;
/// Three components of the vector of the area, and its scalar.
constexpr int Area = Flux + NumberOfMoments;
/// Bounds of roundings relative to u: that of g R n with a g of degree k is at Noise + k, that of g R x.n at
/// Noise + k + 1.
constexpr int Noise = Area + 4;
constexpr int Count = Noise + 4;
}

/// Returns a bound of the sums of the absolute values of the patch's Bernstein polynomials on a panel: 1
/// unless the trim curve leaves the patch.
double BoundBasis(const FacePanels& panels, const Panel& panel);

/// Not thread safe.
class PatchGradient
{
public:
  /// `shift` is that of PlanRequest; `moved` bounds by how far, in x, y and z, the control points may be off.
  void Compute(const FacePanels& panels, std::uint32_t patch, const PatchPlan& plan,
    const std::array<double, 3>& shift, const std::array<double, 3>& moved);

  /// channel::Count numbers for control point i + (p + 1) j.
  const double* Get(int i, int j) const
  {
    return this->Sums.data() + channel::Count * (i + (this->Degree[0] + 1) * static_cast<std::size_t>(j));
  }
  /// Returns the bound, relative to u, of the roundings of the area's vector (0) and scalar (1), of all
  /// control points together and so of each.
  double GetAreaNoise(int which) const { return this->AreaNoise[which]; }
  std::int64_t GetEvaluations() const { return this->Evaluations; }
  /// The largest BoundBasis() of the panels.
  double GetGrowth() const { return this->Growth; }

private:
  struct Line;
  void AddItem(const PlannedItem& item);
  void AddPoint(const Line& line, double s, double weight);

  const FacePanels* Panels = nullptr;
  const Patch* Source = nullptr;
  const std::array<double, 4>* Points = nullptr;
  int Degree[2] = { 1, 1 };
  std::array<double, 3> Origin{};
  /// Bound of the distance by which a point is off, and of the same of Ss and Sr.
  double Moved = 0.0;
  double Slope[2] = { 0.0, 0.0 };
  /// Number of roundings of a sample, and of additions to a sum.
  double Roundings = 0.0;
  double Additions = 0.0;
  double Growth = 1.0;
  double AreaNoise[2] = { 0.0, 0.0 };
  std::int64_t Evaluations = 0;
  std::vector<double> Sums;

  // Of the current line: the net reduced to a curve in s and its derivatives, the polynomials in r, and sums
  // for each polynomial in s.
  std::vector<std::array<double, 4>> Row, RowS, RowR;
  std::vector<double> LineSums;
  /// Those that meet the derivatives of the polynomials in r: four numbers each.
  std::vector<double> LineSlopes;
};
}

#endif
