/**
 * @file smDisplayMesh.h
 * @brief The display mesh of a body: the triangles of its faces with (face, u, v) at every point
 */
#ifndef smDisplayMesh_h
#define smDisplayMesh_h

#include "smFaceMesher.h"
#include "smReadersSTEPModule.h"
#include "smVector.h"

#include <string>
#include <vector>

namespace sm
{
/// In part coordinates and model units. Every face has its own points; triangles are wound outward.
struct DisplayMesh
{
  std::vector<Vector3> Points;
  std::vector<Vector3> Normals;
  std::vector<std::array<double, 2>> Parameters;
  std::vector<int> PointFace;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<int> TriangleFace;
  /// FaceMesh::Deviation of each face.
  std::vector<double> Deviations;
};

/// The deflection for a body of that diagonal: at least 1e-5 of it, and 1e-3 when the one that was asked for is no number above 0.
SMREADERSSTEP_EXPORT double LimitDeflection(double deflection, double diagonal);

/// Joins the meshes of all faces, moved by `origin`. Says in a sentence each what faces have no triangles, and what meshes may be open.
DisplayMesh JoinMeshes(const std::vector<FacePointer>& faces, std::vector<FaceMesh> meshes,
  const double origin[3], std::vector<std::string>& messages);
}

#endif
