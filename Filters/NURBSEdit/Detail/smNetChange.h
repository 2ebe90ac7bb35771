/**
 * @file smNetChange.h
 * @brief Control points of faces that change, and the neighbours' rows, edges and vertices that follow them
 */
#ifndef smNetChange_h
#define smNetChange_h

#include "smBoundaryRows.h"
#include "smMapSlopes.h"
#include "smModelEdit.h"
#include "smVector.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace sm
{
/// Returns the diagonal of the model's LocalBounds, or of the box of its control points if LocalBounds are
/// not set.
double GetBodySize(vtkTrimmedNURBSModel* model);

/// Collects new control points of faces, and then moves the neighbours' boundary rows, the edges and the
/// vertices that belong to them.
class NetChange
{
public:
  NetChange(vtkTrimmedNURBSModel* model, EditRule rule);

  /// Sets everything of a face except its control points; must be called before these are set.
  void SetTemplate(int face, const FacePointer& face_);
  /// Length of difference quotients, see MapSlopes.
  double GetStep() const { return this->Step; }
  /// Scales Residual and Rounding of a face by the derivatives of the map. They are never reduced, because
  /// edges follow their rows.
  void RaiseErrors(int face, const MapSlopes& slopes);
  /// Sets the faces whose common edges follow regardless of the rule, and the map that moves edges without
  /// rows.
  void SetMap(const std::vector<bool>& faces, const PointMap& map);
  void SetPoint(int face, std::size_t entry, const std::array<double, 4>& point);

  /// Returns, for each control point of each face, the number of its group: points of one group follow each
  /// other, whichever of them is set.
  std::vector<std::vector<int>> FindGroups();

  /// Moves the dependent rows, edges and vertices, and stores the changed faces in a copy of the model. It
  /// changes nothing if the map gives a value for an edge that is not finite.
  void Finish(ModelEdit& edit);

private:
  using Homogeneous = std::array<double, 4>;

  /// One use of an edge by a face.
  struct Use
  {
    int Face;
    int Loop;
    int Coedge;
    bool IsRow = false;
    BoundaryRow Row;
  };
  struct EdgeUses
  {
    std::shared_ptr<const Edge> Source;
    std::vector<Use> Uses;
    /// Result of FindRows(): all uses are along rows, and the rows coincide.
    bool HasRows = false;
    bool Coincident = false;
    /// True if the map moves the edge.
    bool Mapped = false;
  };

  const Face& GetFace(int face) const { return *this->Faces[face]; }
  const TrimCurve& GetTrim(const Use& use) const
  {
    return this->GetFace(use.Face).Loops[use.Loop].Coedges[use.Coedge].Curve;
  }
  const std::vector<Homogeneous>& GetNet(int face) const;
  void CollectEdges();
  /// Searches the rows of an edge's uses, when they are first needed, so that the cost of an edit depends on
  /// the edges that it changes.
  bool FindRows(EdgeUses& edge);
  /// Returns true if control points of a face at the edge were set.
  bool IsTouched(const EdgeUses& edge) const;
  void Propagate();
  void Follow(const EdgeUses& edge, const Use& use, std::size_t entry);
  /// Adds the errors of face `from` to those of face `to`, whose row follows that of `from`.
  void FollowErrors(int from, int to);
  static std::shared_ptr<const EdgeOrigin> GetOrigin(const EdgeUses& edge, const RowCurve& row);
  void JoinEnds();
  std::size_t FindVertex(std::size_t end) const;
  void MoveEdges();
  void CarryEdge(std::size_t index);
  void MapEdge(std::size_t index);
  void MoveVertex(std::size_t end, const Point3& to);
  void MoveVertices();
  std::shared_ptr<Edge> GetNewEdge(const std::shared_ptr<const Edge>& edge);

  vtkTrimmedNURBSModel* Model;
  EditRule Rule;
  std::vector<FacePointer> Faces;
  std::map<int, std::vector<Homogeneous>> Nets;
  std::set<std::pair<int, std::size_t>> Moved;
  std::deque<std::pair<int, std::size_t>> Queue;
  std::vector<bool> Chosen;
  PointMap Map;
  double Tolerance = 0.0;
  double Step = 0.0;
  std::vector<EdgeUses> Edges;
  /// For each coedge of each face: index of the edge, and of the use in it.
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> EdgesOfFace;
  std::map<const Edge*, std::shared_ptr<const Edge>> NewEdges;
  /// True if all results of the map for edges are finite.
  bool Finite = true;
  /// Union-find over ends of edges, numbered 2 index + (0: start, 1: end): entry i is another end at the same
  /// vertex, or i itself. Two ends are the same vertex if they follow one another in a loop and have bitwise
  /// equal coordinates. Equal coordinates elsewhere may be a coincidence of one edit.
  std::vector<std::size_t> SameVertex;
  /// Present position of each vertex, by its representative end.
  std::map<std::size_t, Point3> Vertices;
};
}

#endif
