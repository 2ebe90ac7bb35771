/**
 * @file smEditSession.h
 * @brief Examples/edit_part without its program: a part, its scene, and events played from text
 */
#ifndef smEditSession_h
#define smEditSession_h

#include "smEditScene.h"
#include "smEditStyle.h"
#include "smEventPlayer.h"
#include "smTesting.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <unistd.h>

namespace smtest
{
using Point3 = std::array<double, 3>;

class EditSession
{
public:
  static constexpr int Width = 720;
  static constexpr int Height = 560;
  enum Modifiers
  {
    Shift = 1,
    Control = 2
  };

  /// Events are played from a file in `folder`, as those of a user. Its name has the number of the process:
  /// with one name for all, tests that ran together played each other's keys.
  EditSession(vtkPartitionedDataSetCollection* bodies, const std::string& name, const std::string& folder)
    : Part(bodies)
    , Folder(folder)
    , Scene((this->Window->SetSize(Width, Height), this->Window.Get()), this->Part, name)
  {
    this->Interactor->SetRenderWindow(this->Window);
    this->Style->SetScene(&this->Scene);
    this->Interactor->SetInteractorStyle(this->Style);
    this->Interactor->Initialize();
    this->Scene.SetShowTimes(false);
    this->Scene.Draw();
  }
  ~EditSession() { this->Interactor->SetInteractorStyle(nullptr); }

  void Add(const char* event, int x, int y, int modifiers = 0, const char* key = "0")
  {
    char line[128];
    std::snprintf(line, sizeof(line), "%s %d %d %d %d 0 %s\n", event, x, y, modifiers,
      key[0] != '0' && key[1] == '\0' ? key[0] : 0, key);
    this->Events += line;
  }
  void AddClick(int x, int y)
  {
    this->Add("MouseMoveEvent", x, y);
    this->Add("LeftButtonPressEvent", x, y);
    this->Add("LeftButtonReleaseEvent", x, y);
  }
  /// Presses and moves; does not release.
  void AddDrag(int x, int y, int dx, int dy, int modifiers = 0)
  {
    this->Add("MouseMoveEvent", x, y);
    this->Add("LeftButtonPressEvent", x, y, modifiers);
    this->Add("MouseMoveEvent", x + dx / 2 + 7, y + dy / 2, modifiers);
    this->Add("MouseMoveEvent", x + dx, y + dy, modifiers);
  }
  void AddKey(const char* key, int modifiers = 0) { this->Add("KeyPressEvent", 5, 5, modifiers, key); }

  /// Plays what was added; false when the player refuses it.
  bool Play()
  {
    const std::string fileName = this->Folder + "/edit_session_" + std::to_string(getpid()) + ".events";
    std::ofstream(fileName) << "# StreamVersion 1.2\n" << this->Events;
    this->Events.clear();
    const bool played = CheckEqual("events played", "", sm::PlayEvents(this->Interactor, fileName));
    std::remove(fileName.c_str());
    return played;
  }

  /// Shows the net of a face, as a click on it would.
  void ShowNet(int body, int face) { this->Scene.GetNet().Show(this->Part, body, face); }

  /// The pixel of a world point.
  std::array<int, 2> ToPixel(const Point3& world)
  {
    vtkRenderer* renderer = this->Scene.GetRenderer();
    renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    return { static_cast<int>(std::lround(display[0])), static_cast<int>(std::lround(display[1])) };
  }

  /// The displacement in the world that a motion by so many pixels gives, in the plane of the screen at the
  /// depth of a point: by the formula of the perspective, one pixel there is 2 depth tan(angle / 2) / height.
  Point3 ToDisplacement(const Point3& at, double dx, double dy)
  {
    const Frame frame = this->GetFrame(at);
    Point3 d;
    for (int c = 0; c < 3; ++c)
    {
      d[c] = frame.Length * (dx * frame.Right[c] + dy * frame.Up[c]);
    }
    return d;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  sm::EditedPart Part;
  std::string Folder;
  sm::EditScene Scene;
  vtkNew<smEditStyle> Style;

private:
  struct Frame
  {
    Point3 Right;
    Point3 Up;
    double Length; ///< of a pixel
  };

  vtkCamera* GetCamera() { return this->Scene.GetRenderer()->GetActiveCamera(); }

  Frame GetFrame(const Point3& at)
  {
    vtkCamera* camera = this->GetCamera();
    Point3 forward;
    Point3 away;
    vtkMath::Subtract(camera->GetFocalPoint(), camera->GetPosition(), forward);
    vtkMath::Normalize(forward.data());
    vtkMath::Subtract(at.data(), camera->GetPosition(), away.data());
    Frame frame;
    vtkMath::Cross(forward.data(), camera->GetViewUp(), frame.Right.data());
    vtkMath::Normalize(frame.Right.data());
    vtkMath::Cross(frame.Right.data(), forward.data(), frame.Up.data());
    const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
    frame.Length = 2.0 * vtkMath::Dot(away.data(), forward.data()) * std::tan(angle / 2.0) / Height;
    return frame;
  }

  std::string Events;
};
}

#endif
