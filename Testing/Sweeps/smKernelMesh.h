/**
 * @file smKernelMesh.h
 * @brief The triangles of OpenCASCADE's mesher on converted faces, to compare with
 */
#ifndef smKernelMesh_h
#define smKernelMesh_h

#include "smBodyConversion.h"
#include "smFaceMesher.h"

#include <TopoDS_Shape.hxx>

#include <unordered_map>
#include <vector>

namespace smtest
{
/// OpenCASCADE's shape of a body, and its face of each face.
struct KernelBody
{
  TopoDS_Shape Shape;
  std::unordered_map<const sm::FaceShape*, TopoDS_Shape> Faces;
};

/// Makes OpenCASCADE's shape of a body; without faces where it cannot, and prints why.
KernelBody MakeKernelBody(const sm::BodyShape& body);

/// Triangulates the shape, in mm, on one thread; deflection and angle as MeshLimits. False where the mesher
/// threw.
bool MeshByKernel(const TopoDS_Shape& shape, double deflection, double angle);

/// The triangles of the faces, without normals, relative to `origin`; Deviation is `deflection`. Faces it
/// gave up on are empty.
std::vector<sm::FaceMesh> GetKernelMeshes(
  const sm::ConvertedBody& body, const KernelBody& kernel, const double origin[3], double deflection);
}

#endif
