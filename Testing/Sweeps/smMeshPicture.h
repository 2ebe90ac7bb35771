/**
 * @file smMeshPicture.h
 * @brief Pictures of the triangles of one face, to be looked at
 */
#ifndef smMeshPicture_h
#define smMeshPicture_h

#include "smFaceMesher.h"

#include <string>
#include <vector>

namespace smtest
{
/**
 * Writes a PNG file with one tile for each mesh of the face, all seen against the mean normal of the last one, or askew where the face
 * closes in itself. Triangles that are turned over are red. False where the file cannot be written.
 */
bool WriteMeshPicture(
  const sm::Face& face, const std::vector<const sm::FaceMesh*>& meshes, const std::string& fileName);
}

#endif
