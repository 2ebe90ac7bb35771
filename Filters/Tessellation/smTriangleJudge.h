/**
 * @file smTriangleJudge.h
 * @brief How far triangles between the vertices of a face are from its surface, and whether they are inverted
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

  /// Returns true where two corners are one point of the body.
  bool IsCollapsed(const Corners& t) const;
  /// Bound of the distance between the corners, see SurfaceBlocks; of that at the corners; the sum of both.
  double GetError(const Corners& t) const;
  double GetGap(const Corners& t) const;
  double GetDeviation(const Corners& t) const { return this->GetError(t) + this->GetGap(t); }
  /// The height of the triangle in space above its longest side.
  double GetHeight(const Corners& t) const;
  /// Returns true for a triangle, no line, whose normal is against the mean of the normals of its corners.
  bool IsAgainstCorners(const Corners& t) const;
  /// Returns true for a triangle, no line, whose normal is against the surface's at its middle.
  bool IsInverted(const Corners& t) const;
  /// The same of the triangle whose corners are moved to the surface, where edges lie off it.
  bool IsFolded(const Corners& t) const;
  /**
   * Bound, in radians, of the angle between the surface's normal anywhere on the box of the triangle's
   * parameters and the normal at one of its corners: the first bound that is at most `enough`, else the
   * smallest, of those from the corners and twice the one from the middle of the box. Pi if there is none, as
   * at poles.
   *
   * Let n be the normal there, p0 and q0 the derivatives, S_u = p + a n and S_v = q + b n with p and q across
   * n. Then S_u x S_v = p x q + b p x n + a n x q: along n at least |p0 x q0| - f |q0| - g |p0| - f g, across
   * n at most |b| |p| + |a| |q|, with |p - p0| <= f, |q - q0| <= g, |a| and |b| from
   * SurfaceBlocks::GetDerivativeChanges().
   */
  double GetNormalTurn(const Corners& t, double enough) const;
  /// |S_u| and |S_v| at its middle.
  std::array<double, 2> GetSpeeds(const Corners& t) const;

private:
  ParameterBox GetBox(const Corners& t) const;
  /// The bound of GetNormalTurn() from the derivatives at a point from which the box reaches `share` of its
  /// widths.
  double BoundTurn(const ParameterBox& box, double share, const Vector3& du, const Vector3& dv) const;
  /// The surface's derivatives at the middle of a triangle.
  void EvaluateMiddle(const Corners& t, Vector3& du, Vector3& dv) const;
  bool IsAgainst(const std::array<Vector3, 3>& corners, const Corners& t) const;

  const SurfaceBlocks& Blocks;
  const std::vector<MeshVertex>& Vertices;
  NURBSSurface::Walker& Walker;
};
}

#endif
