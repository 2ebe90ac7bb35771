/**
 * @file smOCCTMesh.h
 * @brief The display mesh of a body: triangles of OpenCASCADE with (face, u, v) at every point
 */
#ifndef smOCCTMesh_h
#define smOCCTMesh_h

#include "smOCCTBody.h"

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

/// xmin xmax ymin … of the shape in kernel coordinates, from its triangles where it has them.
bool GetShapeBounds(const TopoDS_Shape& shape, double bounds[6]);

/// Triangulates the shape; deflection in mm, angle in radians. What goes wrong is a sentence, else empty.
std::string TriangulateShape(const TopoDS_Shape& shape, double deflection, double angle);

/// The triangles of the faces that were converted; `trsf`, `unit` and `origin` as in ConvertBody.
DisplayMesh BuildMesh(ConvertedBody& body, const gp_Trsf& trsf, double unit, const double origin[3]);
}

#endif
