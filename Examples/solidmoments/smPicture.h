/**
 * @file smPicture.h
 * @brief A picture of a part, translucent, with its centre of mass marked and its results in a corner
 *
 * The faces and edges that make its result suspect or open are red, and the worst of them numbered and named.
 */
#ifndef smPicture_h
#define smPicture_h

#include <string>

class vtkOpenGLRenderWindow;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace sm
{
struct FileResult;

struct Picture
{
  vtkOpenGLRenderWindow* Window = nullptr;         ///< the window to draw in, off screen
  vtkPartitionedDataSetCollection* Body = nullptr; ///< the bodies to draw
  vtkPolyData* Mark = nullptr;                     ///< port 0 of vtkMassPropertiesGPU
  vtkPolyData* Stability = nullptr;   ///< port 0 of vtkSolidStability, in its own colours; null: none
  vtkPolyData* Flagged = nullptr;     ///< port 6: faces and edges to mark; may be empty
  const FileResult* Result = nullptr; ///< for the caption
  /// A cell array of Body by which its faces are coloured, from 0 to its maximum, with a colour bar, and the
  /// title of that; empty: the faces have their own colours.
  std::string FaceArray, FaceTitle;
};

/// Writes a PNG file. Returns an error message, empty when it is written.
std::string WritePicture(const Picture& picture, const std::string& fileName);
}

#endif
