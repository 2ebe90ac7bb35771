/**
 * @file smBodyMesh.h
 * @brief A display mesh of faces that share edges: closed where the faces are, within a deflection that is
 * proved
 */
#ifndef smBodyMesh_h
#define smBodyMesh_h

#include "smFaceMesher.h"
#include "smFiltersTessellationModule.h"
#include "smProgressCallback.h"

#include <vector>

namespace sm
{
/**
 * One mesh for each face. Every edge is sampled once: points of different faces on one edge have the same
 * bits, and so have the ends of edges that meet in a loop. So the triangles of a closed body have no open
 * sides.
 *
 * Each face is within its FaceMesh::Deviation of its surface, and that is at most the deflection unless the
 * gap between face and edges, or the limits on the number of points, forbid it. Edges are within the
 * deflection of their chords. The angle is aimed at; FaceMesh::NormalTurn is a proved bound of what was
 * reached.
 *
 * Runs on the threads of vtkSMPTools, with the same result for any number of them. `progress`, where there is
 * one, is called on the calling thread; when it answers false, faces that were not reached have no triangles.
 */
SMFILTERSTESSELLATION_EXPORT std::vector<FaceMesh> MeshFaces(
  const std::vector<FacePointer>& faces, const MeshLimits& limits, const ProgressCallback& progress = {});

/**
 * The same for the meshes that a body is measured and its shells are compared by. Whole spheres (FaceMesh::
 * Sphere) are measured and compared as spheres, so that a grid of 48 triangles is enough; its
 * Deviation, which is proved, may exceed the deflection.
 */
SMFILTERSTESSELLATION_EXPORT std::vector<FaceMesh> MeshForScales(
  const std::vector<FacePointer>& faces, const MeshLimits& limits, const ProgressCallback& progress = {});
}

#endif
