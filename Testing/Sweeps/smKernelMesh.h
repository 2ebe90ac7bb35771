/**
 * @file smKernelMesh.h
 * @brief The triangles of OpenCASCADE's mesher on converted faces, to compare with
 */
#ifndef smKernelMesh_h
#define smKernelMesh_h

#include "smFaceMesher.h"
#include "smOCCTBody.h"

#include <vector>

namespace smtest
{
/// Triangulates the shape, in mm, on one thread; deflection and angle as MeshLimits. False where the mesher
/// threw.
bool MeshByKernel(const TopoDS_Shape& shape, double deflection, double angle);

/// The triangles of the faces, without normals, relative to `origin`; Deviation is `deflection`. Faces it
/// gave up on are empty.
std::vector<sm::FaceMesh> GetKernelMeshes(
  const sm::ConvertedBody& body, const double origin[3], double deflection);
}

#endif
