/**
 * @class   smEditStyle
 * @brief   what mouse and keys do to an edited part: see HelpText in smEditScene.cxx
 *
 * Whatever is not an edit (turning, shifting, zooming) is the trackball's. A drag is computed from where it began: where the
 * mouse went in between makes no difference.
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

  /// Held, not owned; must outlive the style's events.
  void SetScene(sm::EditScene* scene);
  /// Of the pictures that the key s saves: "lever" gives lever_1.png, lever_2.png …, never one that exists.
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
  /// Pixels, and a depth in [0, 1].
  std::array<double, 3> ToDisplay(const std::array<double, 3>& world);
  std::array<double, 3> ToWorld(double x, double y, double depth);
  void ScaleWeight(double factor);
  void SavePicture();
  void FinishStep(bool done, const char* notice, const char* nothing);

  sm::EditScene* Scene = nullptr;
  std::string PictureStem = "part";
  sm::EditRule Rule = sm::EditRule::MoveSharedBoundary;
  bool IsDragging = false;
  bool MayBeClick = false;
  int Pressed[2] = { 0, 0 };
  /// The dragged point where it was, and the face's normal there.
  std::array<double, 3> Start{};
  std::array<double, 3> Normal{};
  sm::Grip Dragged;
};

#endif
