/**
 * @file smSTEPEdges.h
 * @brief Edges of a STEP file on their curves, from their entities alone
 */
#ifndef smSTEPEdges_h
#define smSTEPEdges_h

#include "smSTEPGeometry.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

namespace sm
{
/// An edge as a part of a curve. Its direction is that of the curve's natural parameter, its vertices are in
/// this order.
struct STEPEdge
{
  std::uint64_t Id = 0;
  std::string Name;
  CurvePointer<3> Curve;
  /// Natural parameters, First < Last.
  double First = 0.0;
  double Last = 0.0;
  /// Vertices at First and at Last, in millimetres.
  Vector3 Start{};
  Vector3 End{};
  /// True if the edge of the file runs from Start to End, false if it runs against the curve.
  bool IsForward = true;
  /// True if its sense contradicts its vertices on a line or an open spline, where the points are the same.
  bool IsTurned = false;
  /// Larger one of the distances of the vertices from the ends.
  double Gap = 0.0;
};

/**
 * Converts EDGE_CURVE, each once, when it is asked for. The part of its curve is what its vertices, their
 * order and its sense state (ISO 10303-42, edge_curve):
 *
 * | curve | parameters of the vertices | both vertices are the same |
 * |---|---|---|
 * | line | feet | refused, except a part that is shorter than SameVertex |
 * | ellipse, circle | angles, the second one less than a turn behind | the whole turn |
 * | parabola, hyperbola | closed form | refused |
 * | open spline, and others | feet; ends of the curve within SameVertex | likewise |
 * | closed spline, and others | likewise; a part over the seam is a composite curve | the whole curve |
 *
 * Not thread safe. Throws only std::bad_alloc.
 */
class SMREADERSSTEP_EXPORT STEPEdges
{
public:
  using Index = Part21File::Index;

  /// Vertices closer than this are the same, in millimetres: the accuracy that CAD systems give their
  /// vertices.
  static constexpr double SameVertex = 1e-7;

  /// Keeps references to all.
  STEPEdges(
    const STEPAttributes& entities, const STEPUnitSizes& units, STEPGeometry& geometry, STEPLedger& ledger);

  /// Returns an edge; null if it has a row in the ledger.
  const STEPEdge* GetEdge(Index entity);
  /// Takes over the edges that the other one has made and this one has not.
  void Take(STEPEdges& other) { this->Edges.merge(other.Edges); }

private:
  STEPEdge Make(Index entity);
  Vector3 ReadVertex(Index vertex) const;

  const STEPAttributes& Entities;
  STEPUnitSizes Units;
  STEPGeometry& Geometry;
  STEPLedger& Ledger;
  std::unordered_map<Index, std::unique_ptr<STEPEdge>> Edges;
};
}

#endif
