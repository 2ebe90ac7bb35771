/**
 * @file smTrimCutting.h
 * @brief Cuts trim curves where they cross the knot lines of a surface
 */
#ifndef smTrimCutting_h
#define smTrimCutting_h

#include "smFiltersNURBSModule.h"

#include "smPolynomialCurve.h"

#include <array>
#include <vector>

namespace sm
{
/// The cells of a surface: the grid of its distinct knots. Column c is [U[c], U[c+1]], row j is [V[j],
/// V[j+1]].
struct SMFILTERSNURBS_EXPORT CellGrid
{
  std::vector<double> U;
  std::vector<double> V;

  int GetNumberOfColumns() const { return static_cast<int>(this->U.size()) - 1; }
  int GetNumberOfRows() const { return static_cast<int>(this->V.size()) - 1; }
  /// Cell index of a coordinate; the nearest cell outside the domain.
  static int Find(const std::vector<double>& breaks, double x);
  /// Returns true if points are no farther apart than the rounding of a panel in their cells, which may be
  /// narrow compared with the parameters.
  bool AreSame(const std::array<double, 2>& a, const std::array<double, 2>& b) const;
};

/// A part of one polynomial trim piece that lies in one cell.
struct TrimSegment
{
  /// Range of the piece's local parameter.
  double Start = 0.0;
  double End = 1.0;
  /// (u,v) at both ends. Neighbours hold the same doubles, and a cut holds the knot itself.
  std::array<double, 2> StartPoint{};
  std::array<double, 2> EndPoint{};
  int Column = 0;
  int Row = 0;
};

/**
 * Appends to `roots` the parameters in the open interval (0,1) where the polynomial with these Bernstein
 * coefficients changes sign, increasing. By Descartes' rule in Bernstein form: no variation of sign, no
 * root; one variation, one root; else subdivision. A touching (double) root is not a crossing and is left
 * out.
 */
SMFILTERSNURBS_EXPORT void FindSignChanges(
  const double* coefficients, int degree, std::vector<double>& roots);

/// Cuts a piece at the interior knots of the grid and appends its segments in the order of the parameter.
SMFILTERSNURBS_EXPORT void CutAtKnotLines(
  const BernsteinPiece<2>& piece, const CellGrid& grid, std::vector<TrimSegment>& segments);
}

#endif
