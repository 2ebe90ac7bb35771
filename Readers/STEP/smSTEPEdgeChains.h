/**
 * @file smSTEPEdgeChains.h
 * @brief Edges of a shell that lie on several edges of adjacent faces
 */
#ifndef smSTEPEdgeChains_h
#define smSTEPEdgeChains_h

#include "smSTEPEdgeDistance.h"
#include "smSTEPEdgeTwins.h"

namespace sm
{
/// Largest distance of edges that are joined, relative to their length.
constexpr double MaxEdgeDistance = 1e-4;

/// An edge of the file.
struct STEPSingleEdge
{
  Part21File::Index Entity = Part21File::None;
  /// Its place in the shell.
  std::size_t Order = 0;
  const STEPEdge* Edge = nullptr;
};

/// Adds those of `edges` that chains of others of them cover; see JoinEdges(). None if the work is spent.
void AddEdgeChains(
  const std::vector<STEPSingleEdge>& edges, double precision, STEPEdgeWork& work, STEPJoinedEdges& joined);
}

#endif
