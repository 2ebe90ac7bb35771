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
  /// The direction that the row runs in: 0 for u.
  int Direction = 0;
  /// The fixed parameter is the end of its domain, not the start.
  bool AtEnd = false;
  /// The row's parameter falls where the edge's grows.
  bool Falling = false;

  int GetSize(const NURBSSurface& surface) const { return surface.NumberOfControlPoints[this->Direction]; }
  /// Index of the control point that is number `k` from the edge's start.
  std::size_t GetEntry(const NURBSSurface& surface, int k) const;
};

/// False unless the trim curve lies on one side of the domain (to 1e-12 of it) and leads from corner to corner without turning
/// back, and the knots are clamped, so that the row alone makes that side.
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
  /// Bit for bit.
  bool operator==(const RowCurve& other) const;
  std::array<long double, 3> Evaluate(long double x) const;
};

/// The same degree and knots, points within `tolerance`, a length, and weights that differ by one factor.
bool Coincide(const RowCurve& a, const RowCurve& b, double tolerance);

/// An edge and the row that it followed before the first edit of the row, and the row that it follows now. One that
/// moved since has left the edge behind, which then begins anew.
struct EdgeOrigin
{
  std::shared_ptr<const Edge> Source;
  RowCurve Row;
  RowCurve Now;
};

/**
 * The curve of `origin` displaced as its row was: C(t) + now(x(t)) - origin.Row(x(t)), where x(t) is the row's
 * parameter along `trim`. Exact but for rounding where both rows are polynomial; else fitted, and the fit's residual is added to
 * the curve's.
 */
EdgeCurve Displace(const EdgeOrigin& origin, const RowCurve& now, const NURBSSurface& surface,
  const BoundaryRow& row, const TrimCurve& trim);
}

#endif
