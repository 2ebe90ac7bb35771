/**
 * @file smOCCTMesh.h
 * @brief The display mesh of a body: triangles of OpenCASCADE with (face, u, v) at every point
 */
#ifndef smOCCTMesh_h
#define smOCCTMesh_h

#include "smOCCTBody.h"
#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"

#include <string>
#include <vector>

namespace sm
{
/// In part coordinates and model units. Every face has its own points; triangles are wound outward.
struct DisplayMesh
{
  std::vector<Vector3> Points;
  std::vector<Vector3> Normals;
  /// Parameters on the converted surface.
  std::vector<std::array<double, 2>> Parameters;
  std::vector<int> PointFace;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<int> TriangleFace;
  /// About the volume and the area of the body.
  double Volume = 0.0;
  double Area = 0.0;
};

/// xmin xmax ymin … of the shape in kernel coordinates, from its triangles where it has them. Faces that have no
/// finite box are left out and counted in `unbounded`; false when none has one.
SMREADERSSTEP_EXPORT bool GetShapeBounds(
  const TopoDS_Shape& shape, double bounds[6], int* unbounded = nullptr);

/// The same for the shape's edges alone.
SMREADERSSTEP_EXPORT bool GetEdgeBounds(const TopoDS_Shape& shape, double bounds[6]);

/// The deflection the mesher can take, in mm: at least 1e-5 of the diagonal and ten times its own precision, 1e-3 of
/// the diagonal when the one that was asked for is no number above 0.
SMREADERSSTEP_EXPORT double LimitDeflection(double deflection, double diagonal);

/**
 * Triangulates the shape; deflection in mm, angle in radians. What goes wrong is a sentence, else empty. `progress`,
 * where there is one, gets a fraction in [0,1] and answers false to stop. After `seconds` (0: never) it stops too and
 * gives the faces that were not reached as much again, one by one; some may have no triangles then.
 */
SMREADERSSTEP_EXPORT std::string TriangulateShape(const TopoDS_Shape& shape, double deflection, double angle,
  const ProgressCallback& progress = {}, double seconds = 0.0);

/// The triangles of the faces that were converted; `trsf`, `unit` and `origin` as in ConvertBody.
SMREADERSSTEP_EXPORT DisplayMesh BuildMesh(
  ConvertedBody& body, const gp_Trsf& trsf, double unit, const double origin[3]);
}

#endif
