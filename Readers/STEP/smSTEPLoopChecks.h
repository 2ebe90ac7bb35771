/**
 * @file smSTEPLoopChecks.h
 * @brief Finds edges that run against their loop or their curve, and curves off the vertices of their edge
 */
#ifndef smSTEPLoopChecks_h
#define smSTEPLoopChecks_h

#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"
#include "smSTEPEdges.h"
#include "smSTEPFaceLoops.h"

#include <unordered_set>
#include <utility>
#include <vector>

namespace sm
{
/**
 * Checks the loops of faces while their shapes are made, and adds problems to the census:
 *
 * - ReversedEdge, ReversedLine: edges of a loop that run against the others. The first edge is kept or
 * reversed, whichever reverses fewer edges in total; if both reverse equally many, either is possible. Edges
 * in another order form one loop, or a gap that the integrals detect.
 * - ReversedLine: an edge whose vertices are on its curve in the reverse order, which leaves one reading.
 * - CurveOffVertex: a line, a circle or an ellipse that is farther from the vertices of its edge than 2e-3 of
 * the extent of the body's edges and twice the stated uncertainty.
 *
 * Each loop and each edge is checked once. Keeps references to both.
 */
class STEPLoopChecks
{
public:
  STEPLoopChecks(const STEPAttributes& entities, STEPCensus& census)
    : Entities(entities)
    , Census(census)
  {
  }

  /// Checks the order of the edges of a loop, all of which have been made.
  void AddLoop(const STEPFaceLoop& loop, STEPEdges& edges);
  /// Checks the edges of the loops since the last call, those of one body; `uncertainty` in mm.
  void FinishBody(double uncertainty);

private:
  using Index = Part21File::Index;

  void CheckEdge(Index entity, const STEPEdge& edge, double limit);
  void Add(CensusDefect defect, Index entity, std::uint64_t other, const char* place);

  const STEPAttributes& Entities;
  STEPCensus& Census;
  std::unordered_set<Index> Known;
  std::vector<std::pair<Index, const STEPEdge*>> Edges;
};
}

#endif
