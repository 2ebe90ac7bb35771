/**
 * @file smControlNet.h
 * @brief The control net of one face: its control points as spheres of constant size on the screen, joined by
 * lines
 */
#ifndef smControlNet_h
#define smControlNet_h

#include "smEditedPart.h"

#include <vtkNew.h>

class vtkActor;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace sm
{
class ControlNet
{
public:
  /// Draws in `renderer`, which must outlive the net.
  explicit ControlNet(vtkRenderer* renderer);
  ~ControlNet();
  ControlNet(const ControlNet&) = delete;
  ControlNet& operator=(const ControlNet&) = delete;

  /// Shows the net of a face, without highlight and selection; hides it for body -1.
  void Show(const EditedPart& part, int body, int face);
  /// Updates the points of the same face after an edit.
  void Follow(const EditedPart& part);

  bool IsShown() const { return this->Body >= 0; }
  int GetBody() const { return this->Body; }
  int GetFace() const { return this->Face; }

  /// Returns the control point nearest to a pixel, at most `radius` pixels away; if points cover each other,
  /// the one in front. -1: none.
  int FindNear(double x, double y, double radius) const;
  Grip GetGrip(int point) const;

  ///@{
  /// Sets the point under the mouse, which is drawn light, and the selected point, which was dragged last and
  /// is drawn orange. -1: none. True when it changed.
  bool SetHighlight(int point);
  bool SetSelection(int point);
  int GetSelection() const { return this->Selection; }
  ///@}

private:
  void Rebuild(const EditedPart& part);
  void Paint();

  vtkRenderer* Renderer;
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkUnsignedCharArray> Colors;
  vtkSmartPointer<vtkActor> PointActor;
  vtkSmartPointer<vtkActor> LineActor;
  int Body = -1;
  int Face = -1;
  int Columns = 0;
  int Rows = 0;
  int Highlight = -1;
  int Selection = -1;
};
}

#endif
