/**
 * @class   smEditStyle
 * @brief   edits a part by mouse and keys; HelpText in smEditScene.cxx lists them
 *
 * Rotating, panning and zooming are those of the base class. The displacement of a drag is computed from its
 * start, so that the path of the mouse makes no difference.
 */
#ifndef smEditStyle_h
#define smEditStyle_h

#include "smEditScene.h"

#include <vtkInteractorStyleTrackballCamera.h>

#include <array>
#include <string>

class smEditStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static smEditStyle* New();
  vtkTypeMacro(smEditStyle, vtkInteractorStyleTrackballCamera);

  /// Sets the scene, which is not owned and must outlive the style's events.
  void SetScene(sm::EditScene* scene);
  /// Sets the stem of the pictures that the key s saves: "lever" gives lever_1.png, lever_2.png, ...;
  /// existing files are kept.
  void SetPictureStem(const std::string& stem) { this->PictureStem = stem; }

  void OnLeftButtonDown() override;
  void OnMouseMove() override;
  void OnLeftButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override;

protected:
  smEditStyle() = default;
  ~smEditStyle() override = default;

private:
  smEditStyle(const smEditStyle&) = delete;
  void operator=(const smEditStyle&) = delete;

  void BeginDrag(int point);
  void Drag();
  void EndDrag(bool keep);
  std::array<double, 3> GetDisplacement();
  /// World to display: pixels, and a depth in [0, 1].
  std::array<double, 3> ToDisplay(const std::array<double, 3>& world);
  std::array<double, 3> ToWorld(double x, double y, double depth);
  void ScaleWeight(double factor);
  void SavePicture();
  void OnEditKey(const std::string& key);
  void ToggleRule();
  void ToggleHold();
  void FinishStep(bool done, const char* notice, const char* nothing);

  sm::EditScene* Scene = nullptr;
  std::string PictureStem = "part";
  sm::EditRule Rule = sm::EditRule::MoveSharedBoundary;
  bool IsDragging = false;
  bool MayBeClick = false;
  int Pressed[2] = { 0, 0 };
  /// The position of the dragged point before the drag, and the face's normal there.
  std::array<double, 3> Start{};
  std::array<double, 3> Normal{};
  sm::Grip Dragged;
};

#endif
