/**
 * @file smFaceMesher.h
 * @brief Triangles of one face between boundary points that it shares with its neighbours
 */
#ifndef smFaceMesher_h
#define smFaceMesher_h

#include "Detail/smBoundaryLoop.h"
#include "Detail/smEdgeSamples.h"
#include "Detail/smSurfaceBlocks.h"
#include "smFace.h"
#include "smFiltersTessellationModule.h"
#include "smWholeSphere.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
struct FaceMesh
{
  /// In the coordinates of the model; unit normals point out of the body.
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<double, 3>> Normals;
  std::vector<std::array<double, 2>> Parameters;
  /// Counter-clockwise seen from outside.
  std::vector<std::array<int, 3>> Triangles;
  /// Bound of the distance of the triangles from the surface, across it, see smSurfaceBlocks.h.
  double Deviation = 0.0;
  /// Refinement ended with a Deviation above the deflection: it would take too many points.
  bool IsUnproved = false;
  /// Bound of the angle, in radians, by which the surface's normal turns within a triangle, see
  /// TriangleJudge::GetNormalTurn().
  double NormalTurn = 0.0;
  /// Triangles whose normals are against the surface's, which nothing mends; Reason says why.
  int InvertedTriangles = 0;
  /// A sentence where the face has no triangles, or not those that its boundary asks for.
  std::string Reason;
  /// The sphere that the face covers, of which the triangles are a coarse picture; see MeshForScales().
  WholeSphere Sphere;
};

/**
 * Triangulates what lies to the left of the loops. Segments of the loops stay as they are, and nothing is put
 * on them. With `halve` it lists chords (edge, number) that have to be halved first, because they cross
 * others or enclose nothing, and has no triangles then.
 */
SMFILTERSTESSELLATION_EXPORT FaceMesh MeshFace(const Face& face, const SurfaceBlocks& blocks,
  const std::vector<BoundaryLoop>& loops, const MeshLimits& limits, std::vector<std::pair<int, int>>* halve);
}

#endif
