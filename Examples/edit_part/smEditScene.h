/**
 * @file smEditScene.h
 * @brief The picture of an edited part: translucent body, control net, centre of mass, principal axes, opened
 * edges and results
 *
 * The mass filter works in the window's own OpenGL context. The results are those of the bodies as they are
 * drawn.
 */
#ifndef smEditScene_h
#define smEditScene_h

#include "smControlNet.h"
#include "smEditedPart.h"
#include "smVolumeHold.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

class vtkActor;
class vtkMassPropertiesGPU;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace sm
{
/// Seconds of one update.
struct UpdateTimes
{
  double Hold = 0.0;    ///< the correction that keeps the volume
  double Edit = 0.0;    ///< new faces, opened edges
  double Display = 0.0; ///< display points of the new faces
  double Moments = 0.0; ///< all integrals and their bounds
  double Draw = 0.0;    ///< the picture

  /// Returns the time from the mouse event to the results, without the picture.
  double GetComputing() const { return this->Hold + this->Edit + this->Display + this->Moments; }
};

class EditScene
{
public:
  /// Adds its renderers to the window and draws the part once. `part` and `window` must outlive it.
  EditScene(vtkRenderWindow* window, EditedPart& part, const std::string& title);
  ~EditScene();
  EditScene(const EditScene&) = delete;
  EditScene& operator=(const EditScene&) = delete;

  /// Computes the moments and draws, after a change of the part.
  void Update();
  /// Draws, after a change of the view, the net or the texts alone.
  void Draw();
  /// Moves the camera so that all bodies are in the picture.
  void ShowAll();

  /// Finds the face under a pixel; false where there is none.
  bool PickFace(int x, int y, int& body, int& face);

  EditedPart& GetPart() { return this->Part; }
  VolumeHold& GetHold() { return this->Hold; }
  ControlNet& GetNet() { return this->Net; }
  vtkRenderer* GetRenderer() { return this->Body; }
  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkMassPropertiesGPU* GetMass() { return this->Mass; }

  void SetHelp(bool shown);
  bool IsHelpShown() const { return this->Help; }
  /// Shows the times of the last update, which differ from run to run. Default: shown.
  void SetShowTimes(bool shown);
  /// Draws fewer translucent layers, does not smooth edges and leaves out the check for a boundary that
  /// crosses itself, for pictures during a drag; the numbers are the same. Default: off.
  void SetHurried(bool hurried);
  /// Shows a line about the last event; empty: none.
  void SetNotice(const std::string& notice);
  /// Sets the rule of edits that the picture names when it is "one face".
  void SetRule(EditRule rule);

  /// Times of the updates: first that of the whole part, then one for each edit. Undo, redo and reset have
  /// none.
  const std::vector<UpdateTimes>& GetTimes() const { return this->Times; }

private:
  struct DrawnBody
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkActor> Outlines;
    vtkSmartPointer<vtkPolyData> Mesh;
    vtkSmartPointer<vtkPolyData> Lines;
  };

  std::array<double, 6> GetBounds() const;
  void ShowBodies();
  void ShowOpened();
  void ShowNumbers();
  std::string DescribeOpened() const;
  std::string DescribeHold() const;

  vtkRenderWindow* Window;
  EditedPart& Part;
  vtkNew<vtkRenderer> Body;
  vtkNew<vtkRenderer> Front;
  vtkNew<vtkMassPropertiesGPU> Mass;
  ControlNet Net;
  VolumeHold Hold;
  std::vector<DrawnBody> Bodies;
  vtkNew<vtkPolyData> Opened;
  vtkSmartPointer<vtkTextActor> Title;
  vtkSmartPointer<vtkTextActor> Numbers;
  vtkSmartPointer<vtkTextActor> State;
  vtkSmartPointer<vtkTextActor> Hint;
  std::string Notice;
  EditRule Rule = EditRule::MoveSharedBoundary;
  bool Help = false;
  bool ShowTimes = true;
  std::vector<UpdateTimes> Times;
};
}

#endif
