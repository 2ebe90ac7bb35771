/**
 * @file smBodyScene.h
 * @brief How the example programs draw a body: translucent, its edges as lines, its centre of mass marked green
 *
 * Two layers of one window: the body's, and one in front of it for captions and for what a thick wall would hide.
 */
#ifndef smBodyScene_h
#define smBodyScene_h

#include "vtkSmartPointer.h"

#include <string>

class vtkActor;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace sm
{
extern const double InkColor[3];
/// Of centres of mass.
extern const double GreenColor[3];

/// Gives the cells of `part` the colours of their faces, steel where the file has none.
void AddColors(vtkPolyData* part);
/// All parts in one mesh with these colours. Faces share no points, so shading breaks where they meet.
vtkSmartPointer<vtkPolyData> JoinParts(vtkPartitionedDataSetCollection* parts);

/// The borders of all faces, which are open borders of the mesh since faces share no points. Its points are those of `mesh`.
vtkSmartPointer<vtkPolyData> MakeOutlines(vtkPolyData* mesh);

/// Without a color the cells have their own, see AddColors().
vtkSmartPointer<vtkActor> AddActor(
  vtkRenderer* renderer, vtkPolyData* data, const double* color, double opacity);
vtkSmartPointer<vtkActor> AddBody(vtkRenderer* renderer, vtkPolyData* mesh);
vtkSmartPointer<vtkActor> AddOutlines(vtkRenderer* renderer, vtkPolyData* lines);
/// Once in its place, and once faintly over everything, for thick walls hide what is inside.
void AddMark(vtkRenderer* body, vtkRenderer* front, vtkPolyData* mark);
/// Likewise, in the colours of its cells and without lights: lines and polygons.
void AddDrawing(vtkRenderer* body, vtkRenderer* front, vtkPolyData* drawing);

/// UTF-8; what is not is replaced. Its lower left corner in pixels, or its upper left when it hangs from there.
vtkSmartPointer<vtkTextActor> AddText(
  vtkRenderer* renderer, const std::string& text, int size, bool bold, int x, int y, bool hanging);
void SetText(vtkTextActor* actor, const std::string& text);
/// The fonts of a picture have what a plain terminal may not: raised digits, "mm^3" with a 3 that stands high.
std::string RaiseDigits(std::string text);

/// Background, depth peeling (as many layers as `peels`), layers of the window, and one camera for both.
void SetUpLayers(vtkRenderWindow* window, vtkRenderer* body, vtkRenderer* front, int peels);
/// Looks at what is in `bounds` from in front, above and a little to the left. `zoom` 1: all of it is in the picture; the center
/// of the picture is shifted by `shift` of its height.
void SetView(vtkRenderer* body, const double bounds[6], double zoom, double shift);

/// Draws the window, three bytes a pixel.
vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window);
/// Writes PNG. Returns why it could not; an empty string when it is written.
std::string WriteImage(vtkImageData* image, const std::string& fileName);
}

#endif
