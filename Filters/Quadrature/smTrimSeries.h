/**
 * @file smTrimSeries.h
 * @brief A piece of a trim curve as Chebyshev series, and its range for complex parameters
 */
#ifndef smTrimSeries_h
#define smTrimSeries_h

#include "smFacePanels.h"
#include "smFiltersQuadratureModule.h"
#include "smPatchMajorants.h"

#include <array>
#include <vector>

namespace sm
{
/// (s(t), r(t)) in the parameters of a patch for t on [start, end] of the piece, mapped to [-1,1].
class SMFILTERSQUADRATURE_EXPORT TrimSeries
{
public:
  /// `coefficients`: degree + 1 pairs (u,v) in Bernstein form.
  void Expand(const double* coefficients, int degree, const Patch& patch, double start, double end);

  int GetDegree() const { return static_cast<int>(this->Series[0].size()) - 1; }
  /// Returns true when s does not change along the piece.
  bool IsConstantInS() const;
  /// Coefficients of s (0) or r (1).
  const std::vector<double>& GetSeries(int direction) const { return this->Series[direction]; }
  /// Ends of an interval that contains s (0) or r (1) along the piece, with little room to spare.
  double GetLow(int direction) const { return this->Low[direction]; }
  double GetHigh(int direction) const { return this->High[direction]; }

  /// Returns true for a piece that stays on its patch or leaves it by little. A piece that leaves its patch
  /// by d, relative to it, has the patch's bounds of positions and derivatives times OnPatchGrowth, as long
  /// as n r d <= 1e-3, n = p + q, r: ratio of neighbours' weights. For the Bernstein polynomials' negative
  /// terms sum to at most (1 + r d)^n - 1 times the positive ones.
  bool IsOnPatch(const Patch& patch) const;
  static constexpr double OnPatchGrowth = 1.01;

  /// The box of {(xi s(t), r(t))} for xi in [xiStart, xiEnd], not thinner than 1e-6.
  ParameterBox GetBox(double xiStart, double xiEnd) const;

  /// An ellipse around the box's interval, scaled to [-1,1], that holds xi s(t) (direction 0) or r(t)
  /// (direction 1) for all t in the ellipse and real xi in [xiStart, xiEnd]. See Bounds.md.
  Ellipse Map(const Ellipse& t, int direction, const ParameterBox& box, double xiStart, double xiEnd) const;

  /// Upper bounds of |s|, and of |ds/dt| (direction 0) or |dr/dt| (1) with t mapped to [0,1], in the ellipse.
  double GetMaxS(const Ellipse& t) const;
  double GetMaxSlope(const Ellipse& t, int direction = 1) const;

private:
  std::vector<double> Series[2];
  std::vector<double> Derivative[2];
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
  void UpdateMajorants(const Ellipse& t, std::size_t count) const;
  mutable std::vector<double> Majorants;
  mutable double MajorantsAxis = 0.0;
};
}

#endif
