/**
 * @file smTriangleJudge.h
 * @brief How far triangles between the vertices of a face are from its surface, and whether they are turned over
 */
#ifndef smTriangleJudge_h
#define smTriangleJudge_h

#include "smMeshRepair.h"
#include "smNURBSSurface.h"
#include "smSurfaceBlocks.h"

#include <vector>

namespace sm
{
class TriangleJudge
{
public:
  using Corners = MeshRepair::Corners;

  /// The arguments must outlive the judge; vertices may be added.
  TriangleJudge(
    const SurfaceBlocks& blocks, const std::vector<MeshVertex>& vertices, NURBSSurface::Walker& walker);

  /// True where two corners are one point of the body.
  bool IsCollapsed(const Corners& t) const;
  /// Bound of the distance between the corners, see SurfaceBlocks; of that at the corners; the sum of both.
  double GetError(const Corners& t) const;
  double GetGap(const Corners& t) const;
  double GetDeviation(const Corners& t) const { return this->GetError(t) + this->GetGap(t); }
  /// The height of the triangle in space above its longest side.
  double GetHeight(const Corners& t) const;
  /// True for a triangle, no line, whose normal is against the mean of the normals of its corners.
  bool IsInverted(const Corners& t) const;
  /// True for a triangle, no line, whose normal is against the surface's at its middle.
  bool IsTurned(const Corners& t) const;
  /// The same of the triangle whose corners are moved to the surface, where edges lie off it.
  bool IsFolded(const Corners& t) const;
  /// |S_u| and |S_v| at its middle.
  std::array<double, 2> GetSpeeds(const Corners& t) const;

private:
  /// The surface's derivatives at the middle of a triangle.
  void EvaluateMiddle(const Corners& t, Vector3& du, Vector3& dv) const;
  bool IsAgainst(const std::array<Vector3, 3>& corners, const Corners& t) const;

  const SurfaceBlocks& Blocks;
  const std::vector<MeshVertex>& Vertices;
  NURBSSurface::Walker& Walker;
};
}

#endif
