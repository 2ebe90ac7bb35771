/**
 * @file smDisplayMesh.h
 * @brief Meshes of bodies as polydata: the one that scales are taken from, and the one that is shown
 */
#ifndef smDisplayMesh_h
#define smDisplayMesh_h

#include "smFaceMesher.h"
#include "smReadersSTEPModule.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace sm
{
/// The deflection for a body of that diagonal: at least 1e-5 of it, and 1e-3 when the one that was asked for
/// is not a number above 0.
SMREADERSSTEP_EXPORT double LimitDeflection(double deflection, double diagonal);

/// Limits of the mesh that a body's scales are taken from, whatever is shown: a part of its box's diagonal,
/// and radians. At the reader's default settings it is shown, too, because OpenCASCADE's box is seldom a
/// tenth larger than the body.
MeshLimits GetScaleLimits(double diagonal);

/// Returns the deflection that meshes of MeshForScales() have reached: above `deflection` where a whole
/// sphere has only a few triangles.
double GetReachedDeflection(const std::vector<FaceMesh>& meshes, double deflection);

/// Joins the meshes of all faces to one of the body in part coordinates, faces moved by `origin`, with
/// normals and the arrays of vtkNURBSDataSet. Every face has its own points; triangles are wound outward. It
/// remembers the deflection it was made for. Reports in a sentence each what faces have no triangles, and
/// what meshes may be open.
vtkSmartPointer<vtkPolyData> JoinMeshes(const std::vector<FacePointer>& faces, std::vector<FaceMesh> meshes,
  const double origin[3], double deflection, std::vector<std::string>& messages);

/// Returns true if a scale mesh, from JoinMeshes(), is within these limits without being much finer than
/// needed.
bool DoesSuit(vtkPolyData* scaleMesh, const MeshLimits& limits);
}

#endif
