/**
 * @file smMeshPicture.h
 * @brief Pictures of the triangles of faces, to be looked at
 */
#ifndef smMeshPicture_h
#define smMeshPicture_h

#include "smFaceMesher.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace smtest
{
/// A sheet of square tiles, two faces in a row, with one tile for each mesh of a face.
class MeshSheet
{
public:
  /// `tile`: pixels along a side.
  explicit MeshSheet(int tile)
    : Tile(tile)
  {
  }

  /**
   * All meshes of a face are seen against the mean normal of the last one, or askew where the face closes in
   * itself. Triangles that are inverted are red. Every face has as many meshes.
   */
  void Add(const sm::Face& face, const std::vector<const sm::FaceMesh*>& meshes);

  /// Writes a PNG file. False where it cannot be written.
  bool Write(const std::string& fileName) const;

private:
  int Tile;
  std::vector<vtkSmartPointer<vtkImageData>> Faces;
};
}

#endif
