/**
 * @file smMeshFile.h
 * @brief The display mesh of a part as a file of triangles
 */
#ifndef smMeshFile_h
#define smMeshFile_h

#include <string>

class vtkPartitionedDataSetCollection;

namespace sm
{
/// True for a name that ends as one of the formats does: .stl (binary), .obj, .ply, .vtp, .glb.
bool IsMeshName(const std::string& fileName);

/**
 * Writes the triangles of all solids as one mesh, in which points with the same coordinates are one: it is closed where the solids are; a
 * .glb file has them apart, see MakeGLB(). A header or a field array says the unit where the format has a place for it. Returns an error message, empty when it is written.
 */
std::string WriteMesh(
  vtkPartitionedDataSetCollection* bodies, const std::string& unit, const std::string& fileName);
}

#endif
