#include "smSTEPEdgeShapes.h"

#include "smSTEPTopologyAttributes.h"
#include "smTextEncoding.h"

#include <algorithm>

namespace sm
{
namespace
{
/// The tolerance of a vertex is so many times the distance of the ends of its edges.
constexpr double VertexMargin = 1.000001;

/// The tolerance of an edge that stands for others is so many times the bound of their distance.
constexpr double DistanceMargin = 1.5;

void WidenVertices(EdgeShape& edge)
{
  for (const bool isStart : { true, false })
  {
    VertexShape& vertex = *(isStart ? edge.Start : edge.End);
    const Vector3 end = edge.Curve->Evaluate(isStart ? edge.First : edge.Last);
    vertex.Tolerance = std::max(vertex.Tolerance, VertexMargin * Norm(Subtract(end, vertex.Point)));
  }
}
}

void DescribeShape(std::uint64_t id, std::string_view name, ShapeData& data)
{
  data.FileId = static_cast<std::int64_t>(id);
  data.Name = DecodePart21Text(name);
  data.Name = data.Name == "NONE" ? std::string() : data.Name;
}

STEPEdgeShapes::Index STEPEdgeShapes::GetVertexEntity(Index edge, bool isStart) const
{
  return this->Entities.Follow(this->Entities.Get(edge, isStart ? StartOfEdge : EndOfEdge));
}

STEPEdgeShapes::Index STEPEdgeShapes::GetVertexEntity(const STEPEdgeEnd& end) const
{
  return this->GetVertexEntity(end.Edge, end.IsFirst == this->Source.GetEdge(end.Edge)->IsForward);
}

STEPEdgeShapes::Index STEPEdgeShapes::FindVertex(Index vertex)
{
  auto found = this->Joined.find(vertex);
  while (found != this->Joined.end() && found->second != vertex)
  {
    vertex = found->second;
    found = this->Joined.find(vertex);
  }
  return vertex;
}

void STEPEdgeShapes::JoinVertices(Index a, Index b)
{
  a = this->FindVertex(a);
  b = this->FindVertex(b);
  if (a != b)
  {
    this->Joined[std::max(a, b)] = std::min(a, b);
  }
}

const STEPJoinedEdges& STEPEdgeShapes::JoinEdges(const std::vector<Index>& edges, double precision)
{
  this->Joints = sm::JoinEdges(edges, this->Source, precision);
  this->CommonEdges.assign(this->Joints.Common.size(), nullptr);
  for (const auto& [a, b] : this->Joints.Vertices)
  {
    this->JoinVertices(this->GetVertexEntity(a), this->GetVertexEntity(b));
  }
  return this->Joints;
}

const VertexPointer& STEPEdgeShapes::GetVertex(Index entity, const Vector3& position)
{
  VertexPointer& vertex = this->Vertices[this->FindVertex(entity)];
  if (!vertex)
  {
    vertex = std::make_shared<VertexShape>();
    vertex->Point = position;
  }
  return vertex;
}

const VertexPointer& STEPEdgeShapes::GetVertex(const STEPEdgeEnd& end)
{
  const STEPEdge& edge = *this->Source.GetEdge(end.Edge);
  return this->GetVertex(this->GetVertexEntity(end), end.IsFirst ? edge.Start : edge.End);
}

const EdgePointer& STEPEdgeShapes::GetEdge(Index entity)
{
  EdgePointer& result = this->Edges[entity];
  const STEPEdge* edge = this->Source.GetEdge(entity);
  if (result || !edge)
  {
    return result;
  }
  result = std::make_shared<EdgeShape>();
  result->Curve = edge->Curve;
  result->First = edge->First;
  result->Last = edge->Last;
  result->Start = this->GetVertex({ entity, true });
  result->End = this->GetVertex({ entity, false });
  WidenVertices(*result);
  DescribeShape(edge->Id, edge->Name, result->Data);
  return result;
}

const std::vector<STEPJoinedEdges::Use>* STEPEdgeShapes::FindCommon(Index entity) const
{
  const auto found = this->Joints.Edges.find(entity);
  return found == this->Joints.Edges.end() ? nullptr : &found->second;
}

EdgePointer STEPEdgeShapes::MakePart(const STEPCommonEdge& common)
{
  const STEPEdge& edge = *this->Source.GetEdge(common.Edge);
  const auto result = std::make_shared<EdgeShape>();
  result->Curve = edge.Curve;
  result->First = common.First;
  result->Last = common.Last;
  result->Start = this->GetVertex(common.Ends[0]);
  result->End = this->GetVertex(common.Ends[1]);
  WidenVertices(*result);
  DescribeShape(edge.Id, edge.Name, result->Data);
  return result;
}

const EdgePointer& STEPEdgeShapes::GetCommonEdge(std::size_t number)
{
  const STEPCommonEdge& common = this->Joints.Common[number];
  EdgePointer& result = this->CommonEdges[number];
  if (!result)
  {
    result = common.IsWhole ? this->GetEdge(common.Edge) : this->MakePart(common);
    result->Tolerance = std::max(result->Tolerance, DistanceMargin * common.Distance);
  }
  return result;
}
}
