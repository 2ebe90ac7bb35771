/**
 * @file smBoundaryRows.h
 * @brief Rows of control points that run along an edge, and edge curves that follow them
 */
#ifndef smBoundaryRows_h
#define smBoundaryRows_h

#include "smFace.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace sm
{
/// The outermost row of a surface's control points that a coedge runs along from end to end.
struct BoundaryRow
{
  /// Direction of the row: 0 for u, 1 for v.
  int Direction = 0;
  /// True if the other parameter is fixed at the end of its domain, false if at the start.
  bool AtEnd = false;
  /// True if the row's parameter decreases where the edge's increases.
  bool Falling = false;

  int GetSize(const NURBSSurface& surface) const { return surface.NumberOfControlPoints[this->Direction]; }
  /// Returns the index, among the control points of the surface, of the row's point `k`, counted from the
  /// edge's start.
  std::size_t GetEntry(const NURBSSurface& surface, int k) const;
};

/// Finds the row that a trim curve runs along. Returns false unless the curve lies on one side of the domain
/// (to 1e-12 of its width) and runs monotonically from corner to corner, and the knots are clamped, so that
/// the row alone determines that side of the surface.
bool FindBoundaryRow(const NURBSSurface& surface, const TrimCurve& trim, BoundaryRow& row);

/// A rational B-spline curve over [0,1], in the edge's direction.
struct RowCurve
{
  int Degree = 1;
  std::vector<double> Knots;
  std::vector<std::array<double, 4>> Points;

  RowCurve() = default;
  RowCurve(const NURBSSurface& surface, const BoundaryRow& row);
  bool IsPolynomial() const;
  /// Returns true if all numbers are bitwise equal.
  bool operator==(const RowCurve& other) const;
  std::array<long double, 3> Evaluate(long double x) const;
};

/// Returns true if two rows have the same degree and knots, points within `tolerance` (a length), and
/// proportional weights.
bool Coincide(const RowCurve& a, const RowCurve& b, double tolerance);

/// An edge with the row along it before the first edit, and the row as it was when the edge last followed it.
/// If the row has moved since without the edge, the edge at its present position becomes a new origin.
struct EdgeOrigin
{
  std::shared_ptr<const Edge> Source;
  RowCurve Row;
  RowCurve Now;
};

/**
 * Returns the curve of `origin`, displaced as its row was: C(t) + now(x(t)) - origin.Row(x(t)), where x(t) is
 * the row's parameter along `trim`. Exact except for rounding where both rows are polynomial; else fitted,
 * and the fit's residual is added to the curve's.
 */
EdgeCurve Displace(const EdgeOrigin& origin, const RowCurve& now, const NURBSSurface& surface,
  const BoundaryRow& row, const TrimCurve& trim);
}

#endif
