/**
 * @file smMeshOrigin.h
 * @brief Names of files of triangles, and the point that their points are relative to
 */
#ifndef smMeshOrigin_h
#define smMeshOrigin_h

#include <array>
#include <string>
#include <vector>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace sm
{
/// Returns the extension of the file's name in lower case, with the dot.
std::string GetMeshExtension(const std::string& fileName);

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

/// Returns the bodies with triangles.
std::vector<vtkPolyData*> ListMeshes(vtkPartitionedDataSetCollection* collection);

/// Returns "100000 0 -5", which reads back to the same doubles.
std::string FormatMeshOrigin(const std::array<double, 3>& origin, const char* separator);
}

#endif
