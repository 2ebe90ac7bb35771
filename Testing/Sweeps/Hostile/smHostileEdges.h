/**
 * @file smHostileEdges.h
 * @brief The edges and vertices that the faces of a hostile solid share, good and bad ones
 */
#ifndef smHostileEdges_h
#define smHostileEdges_h

#include "smHostileCuts.h"
#include "smHostileShape.h"

#include "smFace.h"

#include <memory>
#include <string>
#include <vector>

namespace smhostile
{
using EdgePointer = std::shared_ptr<const sm::Edge>;

/// A rail cut into edges where curves end on it.
struct RailEdges
{
  /// Interior parameters, then also 0 and 1, increasing.
  std::vector<double> Breaks;
  std::vector<Point3> Vertices;
  std::vector<EdgePointer> Edges;
  /// Bernstein coefficients of the rail's parameter over each edge's range: every face runs along the edge
  /// like this.
  std::vector<std::vector<std::array<double, 1>>> Progress;
};

/// Plan all breaks first, then BuildRails(), then the faces.
class SharedEdges
{
public:
  /// Chooses how far edges and vertices are off.
  SharedEdges(const Shape& shape, Random& random);

  /// A vertex on a rail, strictly between its ends; others are ignored.
  void AddBreak(int rail, double t);
  void BuildRails();

  const RailEdges& GetRail(int rail) const { return this->Rails[rail]; }
  /// The vertex at a break or an end of a rail.
  Point3 GetVertex(int rail, double t) const;
  /// A new vertex near this point.
  Point3 DisplaceVertex(const Point3& point);
  /// An edge near a curve in a sheet, which is given in the sheet's own parameters.
  EdgePointer MakeCutEdge(
    const Sheet& sheet, const sm::TrimCurve& curve, const Point3& start, const Point3& end);

  int NewFileId() { return this->NextFileId++; }
  std::string Describe() const;

private:
  EdgeQuality ChooseQuality();
  std::vector<std::array<double, 1>> ChooseProgress(double start, double end);
  void BuildRail(int rail);

  const Shape& Source;
  Random& Dice;
  std::vector<Point3> Corners;
  std::vector<RailEdges> Rails;
  double VertexOffset = 0.0;
  double EdgeOffset = 0.0;
  bool PoorEdges = false;
  int NextFileId = 1;
};

/// A curve in a sheet's own parameters as a curve in its surface's (u,v).
sm::TrimCurve ToDomain(const Sheet& sheet, sm::TrimCurve curve);
}

#endif
