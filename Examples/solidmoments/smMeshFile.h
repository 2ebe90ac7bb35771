/**
 * @file smMeshFile.h
 * @brief Writes the display mesh of a part as a file of triangles
 */
#ifndef smMeshFile_h
#define smMeshFile_h

#include <array>
#include <string>
#include <vector>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace sm
{
/// Returns true for a name with the extension of one of the formats: .stl (binary), .obj, .ply, .vtp, .glb.
bool IsMeshName(const std::string& fileName);

/**
 * The point that is subtracted from the points of a mesh. Points in .stl and .ply are single precision: far
 * from 0, rounding them would damage triangles that are within their deflection of the surface.
 */
struct MeshOrigin
{
  std::array<double, 3> Origin{};
  /// What the user must know of it; empty if rounding is at most a hundredth of the deflection without it.
  std::string Message;
};

/// Share of the deflection that the rounding of single precision may take.
constexpr double SinglePrecisionShare = 0.01;

/// Returns true for a format with points of single precision that are not relative to their body.
bool HasSinglePoints(const std::string& fileName);

/// Finds the origin of the mesh of all solids. `deflection`: in `unit`; 0: a thousandth of the diagonal of
/// the smallest solid.
MeshOrigin FindMeshOrigin(vtkPartitionedDataSetCollection* bodies, const std::string& unit, double deflection,
  const std::string& fileName);

/**
 * Writes the triangles of all solids as one mesh in which points with equal coordinates are merged, so that
 * it is closed where the solids are; in a .glb file the bodies are separate, see MakeGLB(). The unit is in a
 * header or a field array, if the format has one, and so is an origin that is not 0. Returns an error
 * message; empty if the file was written.
 */
std::string WriteMesh(vtkPartitionedDataSetCollection* bodies, const std::string& unit,
  const std::array<double, 3>& origin, const std::string& fileName);

/**
 * Writes triangles as .obj in metres and in the frame `pose`, rows of a matrix with metres: (R | t) with
 * points R^T (metres * p - t); or the convex hull of these points. Returns an error message; empty if the
 * file was written.
 */
std::string WriteLinkMesh(const std::vector<vtkPolyData*>& bodies, double metres,
  const std::array<double, 12>& pose, bool isHull, const std::string& fileName);
}

#endif
