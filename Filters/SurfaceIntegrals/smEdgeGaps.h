/**
 * @file smEdgeGaps.h
 * @brief Gaps between faces and their common edges, for each edge
 */
#ifndef smEdgeGaps_h
#define smEdgeGaps_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smSurfaceIntegrator.h"

#include "vtkTrimmedNURBSModel.h"

#include <limits>
#include <string>
#include <vector>

namespace sm
{
/// The gaps of all coedges of one edge of a body.
struct EdgeGap
{
  const Edge* Source = nullptr;
  /// Number of the edge in its model, from 0, in the order in which the faces use it.
  int Index = 0;
  /// Number of coedges that use the edge, and the sum of their signs, which is 0 if their directions cancel.
  int Uses = 0;
  int SignedUses = 0;
  /// Sums over the coedges, and their widest gap; NaN if not every coedge was measured.
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  /// Largest change of the volume by closing the gap in another way (smClosingSpread.h); NaN if it was not
  /// measured, or if the signed uses do not cancel.
  double Spread = std::numeric_limits<double>::quiet_NaN();

  bool IsOpen() const { return this->SignedUses != 0; }
};

/// Gaps above this fraction of the size of a body are significant.
constexpr double LargeGap = 1e-5;

/// Order of the table: the widest gap first, unknown gaps last.
SMFILTERSSURFACEINTEGRALS_EXPORT bool IsWider(const EdgeGap& a, const EdgeGap& b);

/**
 * Adds up the gaps of the coedges of each edge. The result is sorted by the widest gap, then in the order of
 * the faces; edges with unknown gaps are last. `faces` has the results of the model's faces in their order;
 * if it is null, all gaps are unknown. Edges that are one point are omitted.
 */
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<EdgeGap> CollectEdgeGaps(
  const vtkTrimmedNURBSModel& model, const std::vector<FaceIntegrals>* faces);

/// Returns a sentence about the widest gap if it exceeds the tolerance of its edge in the file, or 1e-5 of
/// `size`; else an empty string. Gaps below 1e-12 of the size are attributed to rounding.
SMFILTERSSURFACEINTEGRALS_EXPORT std::string DescribeWorstEdge(
  const std::vector<EdgeGap>& edges, double size, const std::string& unit);
}

#endif
