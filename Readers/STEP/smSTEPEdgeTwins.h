/**
 * @file smSTEPEdgeTwins.h
 * @brief Edges of a shell that lie on each other without being one
 */
#ifndef smSTEPEdgeTwins_h
#define smSTEPEdgeTwins_h

#include "smSTEPEdges.h"

#include <unordered_map>
#include <vector>

namespace sm
{
/// The edge that stands for another one.
struct STEPEdgeTwin
{
  Part21File::Index Edge = Part21File::None;
  /// True if the parameters of the two curves run in opposite directions.
  bool IsOpposite = false;
};

/**
 * Finds pairs of edges that lie on each other. `edges` has the edge of every use in a closed shell, also
 * twice; pairs are sought among those that are there once. Two faces meet at one edge that both use (ISO
 * 10303-42, closed_shell), but some programs write an edge of its own for each face; SolveSpace does so. Two
 * edges are a pair if five points that divide their parameters evenly are closer than `precision`
 * (millimetres) and than 1e-4 of the length, in the same or the opposite order, and no third edge lies there.
 * Returns the first edge of each pair, in the order of `edges`, by the second one. Edges that have a row in
 * the ledger are left out.
 */
std::unordered_map<Part21File::Index, STEPEdgeTwin> FindEdgeTwins(
  const std::vector<Part21File::Index>& edges, STEPEdges& table, double precision);
}

#endif
