/**
 * @file smExportTopology.h
 * @brief Edges and vertices of a body that is saved: their identification, and the distances of the faces
 * from them
 */
#ifndef smExportTopology_h
#define smExportTopology_h

#include "smFace.h"

#include <array>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/// Finds the vertices that edges share, and measures gaps. Lengths are those of the model, before a
/// conversion of units. Does not use OpenCASCADE.
class ExportTopology
{
public:
  struct EdgeRecord
  {
    std::shared_ptr<const Edge> Source;
    /// Vertices at its start and end.
    int Nodes[2] = { 0, 0 };
    /// Largest distance of the faces from the curve at equal parameters.
    double Gap = 0.0;
  };
  struct VertexRecord
  {
    std::array<double, 3> Position{};
    /// Largest distance of the ends of edges and trim curves from the vertex.
    double Reach = 0.0;
    /// False for a vertex that was joined to another one.
    bool IsUsed = false;
  };

  explicit ExportTopology(vtkTrimmedNURBSModel* model);

  const std::vector<EdgeRecord>& GetEdges() const { return this->Edges; }
  const std::vector<VertexRecord>& GetVertices() const { return this->Vertices; }
  std::size_t GetEdge(const Coedge& coedge) const { return this->Index.at(coedge.Use.get()); }
  /// Returns the vertex at the end (`last`) or at the start of a coedge.
  int GetNode(const Coedge& coedge, bool last) const
  {
    return this->Edges[this->GetEdge(coedge)].Nodes[last != coedge.Reversed ? 1 : 0];
  }
  /// Returns the end (`last`) or the start of a coedge in (u,v).
  static TrimCurve::Point GetEnd(const Coedge& coedge, bool last)
  {
    return last != coedge.Reversed ? coedge.Curve.GetEndPoint() : coedge.Curve.GetStartPoint();
  }
  /// Returns true if a degenerate edge has to close the loop between this coedge and the next.
  bool IsJump(const Loop& loop, std::size_t coedge) const { return this->Jumps.count({ &loop, coedge }) > 0; }
  /// Diagonal of the body's box, or of the box of its edges if the body has none.
  double GetSize() const { return this->Size; }
  /// Returns the number of corners of loops at which the edges end at different vertices.
  int GetOpenCorners() const { return this->OpenCorners; }

private:
  void CollectEdges();
  void MeasureSize();
  int Find(int node);
  void Join(int first, int second);
  void JoinVertices();
  void Reach(int node, const std::array<double, 3>& point);
  void MeasureGaps();
  void MeasureGap(const Face& face, const Coedge& coedge);
  void FindJumps(const Face& face, const Loop& loop);

  vtkTrimmedNURBSModel* Model;
  double Size = 0.0;
  std::vector<EdgeRecord> Edges;
  std::unordered_map<const Edge*, std::size_t> Index;
  std::vector<VertexRecord> Vertices;
  /// Union-find forest of the vertices that were joined.
  std::vector<int> Parent;
  std::set<std::pair<const Loop*, std::size_t>> Jumps;
  int OpenCorners = 0;
};
}

#endif
