/**
 * @file smSTEPEdgeTwins.h
 * @brief Edges of a shell that lie on each other without being one
 */
#ifndef smSTEPEdgeTwins_h
#define smSTEPEdgeTwins_h

#include "smSTEPEdges.h"

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sm
{
/// The vertex of an edge at its first or its last parameter.
struct STEPEdgeEnd
{
  Part21File::Index Edge = Part21File::None;
  bool IsFirst = true;
};

/// An edge, or a part of one, that two faces share.
struct STEPCommonEdge
{
  Part21File::Index Edge = Part21File::None;
  /// False for a part between two parameters; its ends are vertices of any edge.
  bool IsWhole = true;
  double First = 0.0;
  double Last = 0.0;
  std::array<STEPEdgeEnd, 2> Ends;
  /// Bound of the distance of the edge that it stands for, in millimetres.
  double Distance = 0.0;
};

/// The edges that stand for others.
struct STEPJoinedEdges
{
  struct Use
  {
    /// Index in Common.
    std::size_t Common = 0;
    /// True if the parameters of the two curves run in opposite directions.
    bool IsOpposite = false;
  };

  std::vector<STEPCommonEdge> Common;
  /// What stands for an edge, in the direction of its parameter. Edges that stand for themselves are not
  /// here.
  std::unordered_map<Part21File::Index, std::vector<Use>> Edges;
  /// Vertices that are the same.
  std::vector<std::pair<STEPEdgeEnd, STEPEdgeEnd>> Vertices;
  /// Number of edges that were divided.
  std::size_t NumberOfDivided = 0;
};

/**
 * Finds edges that lie on each other. `edges` has the edge of every use in a closed shell, also twice; those
 * that are there once are considered. Two faces meet at one edge that both use (ISO 10303-42, closed_shell),
 * but some programs write an edge of its own for each face; SolveSpace does so.
 *
 * - Two edges are a pair if five points that divide their parameters evenly are closer than `precision`
 *   (millimetres) and than 1e-4 of the length, in the same or the opposite order, so is the bound of their
 *   distance (BoundEdgeDistance()), and no third edge lies there.
 * - Other edges are divided where vertices of others of them lie on their curves, as close as that. Two parts
 *   are a pair if their ends are the same, and the bound of their distance is as small. An edge is
 *   joined if each of its parts is in one pair, whose other edge is joined, too: chains that stop short,
 *   overlap, or cover an edge twice are left as they are.
 *
 * No edge is joined any more after an amount of work that grows with the number of edges (STEPEdgeWork).
 * Edges that have a row in the ledger are left out. The senses of the uses are not compared: edges that are
 * used twice in one direction are open.
 */
STEPJoinedEdges JoinEdges(const std::vector<Part21File::Index>& edges, STEPEdges& table, double precision);

/// Returns a message on the edges of a body that were joined.
std::string DescribeJoinedEdges(std::uint64_t body, const STEPJoinedEdges& joined);
}

#endif
