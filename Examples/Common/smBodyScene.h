/**
 * @file smBodyScene.h
 * @brief Draws a body for the example programs: translucent, its edges as lines, its centre of mass marked
 * green
 *
 * A window has two layers: that of the body, and one in front of it for captions and for markers inside the
 * body.
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
/// The colour of centres of mass.
extern const double GreenColor[3];

/// Makes the faces' colours the active cell scalars of `part`; steel blue where the file has none.
void AddColors(vtkPolyData* part);
/// Returns one mesh of all parts, coloured by AddColors(). Faces share no points, so the shading is not
/// smooth across their edges.
vtkSmartPointer<vtkPolyData> JoinParts(vtkPartitionedDataSetCollection* parts);

/// Returns the borders of all faces as lines; they are open borders of the mesh, since faces share no points.
/// The points are those of `mesh`.
vtkSmartPointer<vtkPolyData> MakeOutlines(vtkPolyData* mesh);

/// Adds an actor of one colour; with a null `color` the cells have their own, see AddColors().
vtkSmartPointer<vtkActor> AddActor(
  vtkRenderer* renderer, vtkPolyData* data, const double* color, double opacity);
vtkSmartPointer<vtkActor> AddBody(vtkRenderer* renderer, vtkPolyData* mesh);
vtkSmartPointer<vtkActor> AddOutlines(vtkRenderer* renderer, vtkPolyData* lines);
/// Adds the marker of a centre of mass to both layers; the front one is faint and shows it through thick
/// walls.
void AddMark(vtkRenderer* body, vtkRenderer* front, vtkPolyData* mark);
/// Adds lines and polygons to both layers, in the colours of their cells and without lighting.
void AddDrawing(vtkRenderer* body, vtkRenderer* front, vtkPolyData* drawing);

/// Adds text whose lower left corner, or upper left corner when `hanging`, is at the pixel (x, y).
vtkSmartPointer<vtkTextActor> AddText(
  vtkRenderer* renderer, const std::string& text, int size, bool bold, int x, int y, bool hanging);
/// Bytes that are not UTF-8 are replaced.
void SetText(vtkTextActor* actor, const std::string& text);
/// Replaces ^2 and ^3 by superscript digits, which a picture's fonts have and a terminal may not.
std::string RaiseDigits(std::string text);

/// Sets up the background, depth peeling with `peels` layers, the window's two layers and the camera that
/// they share.
void SetUpLayers(vtkRenderWindow* window, vtkRenderer* body, vtkRenderer* front, int peels);
/// Sets the camera in front of `bounds`, above and a little to the left. With `zoom` 1 all of it is in the
/// picture, whose centre is shifted by `shift` of its height.
void SetView(vtkRenderer* body, const double bounds[6], double zoom, double shift);

/// Renders the window and returns its picture, three bytes a pixel.
vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window);
/// Writes a PNG file. Returns an error message, empty when it is written.
std::string WriteImage(vtkImageData* image, const std::string& fileName);
}

#endif
