/**
 * @file smFaceMeshWriter.h
 * @brief The triangles of a face as a FaceMesh: its own points, normals, and the bound of its deviation
 */
#ifndef smFaceMeshWriter_h
#define smFaceMeshWriter_h

#include "smFaceMesher.h"
#include "smMeshRepair.h"
#include "smTriangleJudge.h"
#include "smVector.h"

#include <functional>
#include <vector>

namespace sm
{
/// The input of WriteFaceMesh().
struct MeshedFace
{
  const Face& Source;
  const SurfaceBlocks& Blocks;
  /// The box of the parameters of the face.
  const ParameterBox& Box;
  const std::vector<MeshVertex>& Vertices;
  const TriangleJudge& Judge;
  /// The normal of the surface near parameters where Su x Sv vanishes; 0: there is none.
  std::function<Vector3(const std::array<double, 2>&)> FindNormal;
};

/// Adds the triangles to `result`, with the points that they use, in the order of their use, and sets the
/// deviation.
void WriteFaceMesh(
  const std::vector<MeshRepair::Corners>& triangles, const MeshedFace& face, FaceMesh& result);
}

#endif
