/**
 * @file smMeshFile.h
 * @brief Writes the display mesh of a part as a file of triangles
 */
#ifndef smMeshFile_h
#define smMeshFile_h

#include <string>

class vtkPartitionedDataSetCollection;

namespace sm
{
/// Returns true for a name with the extension of one of the formats: .stl (binary), .obj, .ply, .vtp, .glb.
bool IsMeshName(const std::string& fileName);

/**
 * Writes the triangles of all solids as one mesh in which points with equal coordinates are merged, so that
 * it is closed where the solids are; in a .glb file the bodies are separate, see MakeGLB(). The unit is in a
 * header or a field array, if the format has one. Returns an error message; empty if the file was written.
 */
std::string WriteMesh(
  vtkPartitionedDataSetCollection* bodies, const std::string& unit, const std::string& fileName);
}

#endif
