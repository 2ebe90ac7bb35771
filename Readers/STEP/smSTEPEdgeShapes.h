/**
 * @file smSTEPEdgeShapes.h
 * @brief The vertices and edges of a body, each once
 */
#ifndef smSTEPEdgeShapes_h
#define smSTEPEdgeShapes_h

#include "Shapes/smShape.h"
#include "smSTEPEdgeTwins.h"

#include <string_view>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Sets number and name of a shape; the name NONE is none.
void DescribeShape(std::uint64_t id, std::string_view name, ShapeData& data);

/// Makes the vertices and edges of a body.
class STEPEdgeShapes
{
public:
  using Index = Part21File::Index;

  /// Keeps references to both.
  STEPEdgeShapes(const STEPAttributes& entities, STEPEdges& edges)
    : Entities(entities)
    , Source(edges)
  {
  }

  /// Returns the first or the last vertex of an edge in the direction of the edge.
  Index GetVertexEntity(Index edge, bool isStart) const;
  /// Makes one vertex of two.
  void JoinVertices(Index a, Index b);
  /// Joins the edges of a closed shell that lie on each other; `edges` has that of every use. Replaces the
  /// result of the last shell, which it returns.
  const STEPJoinedEdges& JoinEdges(const std::vector<Index>& edges, double precision);

  const VertexPointer& GetVertex(Index entity, const Vector3& position);
  /// Returns the edge of an entity; null if it has a row.
  const EdgePointer& GetEdge(Index entity);
  /// Returns what stands for an edge of this shell, in the direction of its parameter; null: the edge itself.
  const std::vector<STEPJoinedEdges::Use>* FindCommon(Index entity) const;
  /// Returns an edge that stands for others.
  const EdgePointer& GetCommonEdge(std::size_t number);

private:
  Index FindVertex(Index vertex);
  Index GetVertexEntity(const STEPEdgeEnd& end) const;
  const VertexPointer& GetVertex(const STEPEdgeEnd& end);
  EdgePointer MakePart(const STEPCommonEdge& common);

  const STEPAttributes& Entities;
  STEPEdges& Source;
  std::unordered_map<Index, Index> Joined;
  std::unordered_map<Index, VertexPointer> Vertices;
  std::unordered_map<Index, EdgePointer> Edges;
  STEPJoinedEdges Joints;
  std::vector<EdgePointer> CommonEdges;
};
}

#endif
