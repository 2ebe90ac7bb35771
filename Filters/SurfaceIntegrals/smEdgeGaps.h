/**
 * @file smEdgeGaps.h
 * @brief The gaps between faces and their common edges, edge by edge
 */
#ifndef smEdgeGaps_h
#define smEdgeGaps_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smSurfaceIntegrator.h"

#include "vtkTrimmedNURBSModel.h"

#include <string>
#include <vector>

namespace sm
{
/// One edge of a body with the gaps of all its uses.
struct EdgeGap
{
  const Edge* Source = nullptr;
  /// Coedges that use the edge, and whether their directions cancel.
  int Uses = 0;
  int SignedUses = 0;
  /// Sums over the uses, and the widest gap of any; NaN when not every use was measured.
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;

  bool IsOpen() const { return this->SignedUses != 0; }
};

/// Order of the table: the widest gap first, gaps that are not known last.
SMFILTERSSURFACEINTEGRALS_EXPORT bool IsWider(const EdgeGap& a, const EdgeGap& b);

/**
 * Adds the coedges' gaps up by edge, the widest first, then in the order of the faces; edges that are not known come
 * last. `faces` holds the results of the model's faces in their order, or is null: nothing is known. Edges that are one
 * point are left out.
 */
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<EdgeGap> CollectEdgeGaps(
  const vtkTrimmedNURBSModel& model, const std::vector<FaceIntegrals>* faces);

/// A sentence about the widest gap when it exceeds the tolerance that the file gives its edge, or 1e-5 of `size`; else
/// empty. What rounding leaves, below 1e-12 of the size, is no gap.
SMFILTERSSURFACEINTEGRALS_EXPORT std::string DescribeWorstEdge(
  const std::vector<EdgeGap>& edges, double size);
}

#endif
