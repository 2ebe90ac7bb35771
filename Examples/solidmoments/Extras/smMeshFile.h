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
