/**
 * @file smEdgeSpread.h
 * @brief Measures how far closings of the gaps at one edge move integrals; the proof is in Bounds.md
 */
#ifndef smEdgeSpread_h
#define smEdgeSpread_h

#include "smClosingSpread.h"

#include <memory>
#include <vector>

namespace sm
{
/// One use of an edge by a face.
struct EdgeUse
{
  const Face* Source = nullptr;
  const Coedge* Boundary = nullptr;

  /// Returns the contribution of the use to the edge's signed uses.
  double GetSign() const;
};

/// Measures an edge whose signed uses cancel, with a stated tolerance. Volumes up to `negligible` are
/// measured coarsely.
std::shared_ptr<const EdgeSpread> MeasureEdge(
  const Edge& edge, const std::vector<EdgeUse>& uses, double tolerance, double negligible);
}

#endif
