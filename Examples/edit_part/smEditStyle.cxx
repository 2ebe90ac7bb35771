#include "smEditStyle.h"

#include "smBodyScene.h"

#include <smFormat.h>
#include <vtkImageData.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

vtkStandardNewMacro(smEditStyle);

namespace
{
const double GrabRadius = 11.0; // pixels
const int ClickRadius = 3;      // pixels that the mouse may move in a click
const double WeightFactor = 1.25;
}

void smEditStyle::SetScene(sm::EditScene* scene)
{
  this->Scene = scene;
  this->SetDefaultRenderer(scene ? scene->GetRenderer() : nullptr);
}

std::array<double, 3> smEditStyle::ToDisplay(const std::array<double, 3>& world)
{
  vtkRenderer* renderer = this->Scene->GetRenderer();
  renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
  renderer->WorldToDisplay();
  std::array<double, 3> display;
  renderer->GetDisplayPoint(display.data());
  return display;
}

std::array<double, 3> smEditStyle::ToWorld(double x, double y, double depth)
{
  vtkRenderer* renderer = this->Scene->GetRenderer();
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  double world[4];
  renderer->GetWorldPoint(world);
  return { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
}

void smEditStyle::BeginDrag(int point)
{
  this->Dragged = this->Scene->GetNet().GetGrip(point);
  if (!this->Scene->GetPart().GetPosition(this->Dragged, this->Start))
  {
    return;
  }
  sm::VolumeHold& hold = this->Scene->GetHold();
  if (hold.IsOn() &&
    !hold.Begin(this->Scene->GetPart(), this->Dragged, this->Rule, this->Scene->GetMass()->GetVolume()))
  {
    this->Scene->SetNotice(hold.GetMessage());
    this->Scene->Draw();
    return;
  }
  this->IsDragging = true;
  this->Normal = this->Scene->GetPart().GetNormal(this->Dragged);
  this->Scene->GetNet().SetSelection(point);
  this->Scene->SetNotice("");
  this->Scene->SetHurried(true);
  this->Scene->Draw();
}

std::array<double, 3> smEditStyle::GetDisplacement()
{
  const int* position = this->Interactor->GetEventPosition();
  const double moved[2] = { static_cast<double>(position[0] - this->Pressed[0]),
    static_cast<double>(position[1] - this->Pressed[1]) };
  // The motion starts at the point itself, which may be some pixels from the mouse. Its depth is computed
  // again, because the clipping range changes with the body's size.
  const std::array<double, 3> start = this->ToDisplay(this->Start);
  const std::array<double, 3> from = this->ToWorld(start[0], start[1], start[2]);
  const std::array<double, 3> to = this->ToWorld(start[0] + moved[0], start[1] + moved[1], start[2]);
  std::array<double, 3> displacement{ to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  const double normalLength = std::hypot(this->Normal[0], this->Normal[1], this->Normal[2]);
  if (!this->Interactor->GetShiftKey() || !(normalLength > 0.0))
  {
    return displacement;
  }
  // Computes the motion on the screen, in pixels, for a move along the normal by the length of a pixel. If
  // the normal points at the viewer, a drag upwards moves the point outwards.
  const std::array<double, 3> right = this->ToWorld(start[0] + 1.0, start[1], start[2]);
  const double pixel = std::hypot(right[0] - from[0], right[1] - from[1], right[2] - from[2]);
  const std::array<double, 3> tip = this->ToDisplay({ this->Start[0] + pixel * this->Normal[0],
    this->Start[1] + pixel * this->Normal[1], this->Start[2] + pixel * this->Normal[2] });
  const double along[2] = { tip[0] - start[0], tip[1] - start[1] };
  const double squared = along[0] * along[0] + along[1] * along[1];
  const double pixels = squared > 0.04 ? (moved[0] * along[0] + moved[1] * along[1]) / squared : moved[1];
  for (int c = 0; c < 3; ++c)
  {
    displacement[c] = pixels * pixel * this->Normal[c];
  }
  return displacement;
}

void smEditStyle::Drag()
{
  sm::VolumeHold& hold = this->Scene->GetHold();
  const std::array<double, 3> displacement = this->GetDisplacement();
  const vtkSmartPointer<vtkTrimmedNURBSModel> held = hold.IsOn() ? hold.Solve(displacement) : nullptr;
  if (hold.IsOn() && !held)
  {
    this->Scene->SetNotice(hold.GetMessage());
    this->Scene->Draw();
    return;
  }
  sm::EditedPart& part = this->Scene->GetPart();
  const bool moved =
    held ? part.Replace(this->Dragged.Body, held) : part.Move(this->Dragged, displacement, this->Rule);
  this->Scene->SetNotice(moved ? std::string() : part.GetMessage());
  this->Scene->Update();
}

void smEditStyle::EndDrag(bool keep)
{
  this->IsDragging = false;
  if (keep)
  {
    this->Scene->SetHurried(false);
    this->Scene->GetPart().Commit();
    this->Scene->Draw();
    return;
  }
  this->Scene->GetPart().Cancel();
  this->Scene->SetHurried(false);
  this->Scene->SetNotice("drag cancelled");
  this->Scene->Update();
}

void smEditStyle::OnLeftButtonDown()
{
  const int* position = this->Interactor->GetEventPosition();
  this->Pressed[0] = position[0];
  this->Pressed[1] = position[1];
  const int point = this->Scene->GetNet().FindNear(position[0], position[1], GrabRadius);
  if (point >= 0)
  {
    this->BeginDrag(point);
    return;
  }
  this->MayBeClick = true;
  this->Superclass::OnLeftButtonDown();
}

void smEditStyle::OnMouseMove()
{
  if (this->IsDragging)
  {
    this->Drag();
    return;
  }
  const int* position = this->Interactor->GetEventPosition();
  if (std::abs(position[0] - this->Pressed[0]) > ClickRadius ||
    std::abs(position[1] - this->Pressed[1]) > ClickRadius)
  {
    this->MayBeClick = false;
  }
  if (this->State == VTKIS_NONE &&
    this->Scene->GetNet().SetHighlight(this->Scene->GetNet().FindNear(position[0], position[1], GrabRadius)))
  {
    this->Scene->Draw();
  }
  this->Superclass::OnMouseMove();
}

void smEditStyle::OnLeftButtonUp()
{
  if (this->IsDragging)
  {
    this->EndDrag(true);
    return;
  }
  this->Superclass::OnLeftButtonUp();
  if (!this->MayBeClick)
  {
    return;
  }
  this->MayBeClick = false;
  int body = -1;
  int face = -1;
  if (!this->Scene->PickFace(this->Pressed[0], this->Pressed[1], body, face))
  {
    body = -1;
  }
  this->Scene->GetNet().Show(this->Scene->GetPart(), body, face);
  this->Scene->SetNotice("");
  this->Scene->Draw();
}

void smEditStyle::ScaleWeight(double factor)
{
  const int point = this->Scene->GetNet().GetSelection();
  double weight = 1.0;
  if (this->IsDragging)
  {
    return;
  }
  if (this->Scene->GetHold().IsOn())
  {
    this->Scene->SetNotice("a weight would change the volume, which is held; press v first");
    this->Scene->Draw();
    return;
  }
  if (point < 0 || !this->Scene->GetPart().GetWeight(this->Scene->GetNet().GetGrip(point), weight))
  {
    this->Scene->SetNotice("drag a control point first: its weight is changed");
    this->Scene->Draw();
    return;
  }
  weight *= factor;
  const bool done =
    this->Scene->GetPart().SetWeight(this->Scene->GetNet().GetGrip(point), weight, this->Rule);
  this->Scene->GetPart().Commit();
  this->Scene->SetNotice(
    done ? "weight " + sm::FormatDigits(weight, 7) : this->Scene->GetPart().GetMessage());
  this->Scene->Update();
}

void smEditStyle::OnMouseWheelForward()
{
  if (this->Interactor->GetControlKey())
  {
    this->ScaleWeight(WeightFactor);
    return;
  }
  this->Superclass::OnMouseWheelForward();
}

void smEditStyle::OnMouseWheelBackward()
{
  if (this->Interactor->GetControlKey())
  {
    this->ScaleWeight(1.0 / WeightFactor);
    return;
  }
  this->Superclass::OnMouseWheelBackward();
}

void smEditStyle::FinishStep(bool done, const char* notice, const char* nothing)
{
  this->Scene->SetNotice(done ? notice : nothing);
  if (done)
  {
    this->Scene->GetHold().Forget();
    this->Scene->Update();
  }
  else
  {
    this->Scene->Draw();
  }
}

void smEditStyle::SavePicture()
{
  int number = 0;
  std::string name;
  do
  {
    name = this->PictureStem + "_" + std::to_string(++number) + ".png";
  } while (std::ifstream(name).good());
  const std::string error = sm::WriteImage(sm::GrabImage(this->Scene->GetWindow()), name);
  this->Scene->SetNotice(error.empty() ? "saved " + name : error);
  this->Scene->Draw();
}

void smEditStyle::ToggleRule()
{
  this->Rule = this->Rule == sm::EditRule::OneFace ? sm::EditRule::MoveSharedBoundary : sm::EditRule::OneFace;
  this->Scene->SetRule(this->Rule);
  this->Scene->SetNotice("");
  this->Scene->Draw();
}

void smEditStyle::ToggleHold()
{
  sm::VolumeHold& hold = this->Scene->GetHold();
  hold.SetOn(!hold.IsOn());
  this->Scene->SetNotice("");
  this->Scene->Draw();
}

void smEditStyle::OnEditKey(const std::string& key)
{
  sm::EditedPart& part = this->Scene->GetPart();
  const bool control = this->Interactor->GetControlKey() != 0;
  if (control && key == "z")
  {
    this->FinishStep(part.Undo(), "undone", "nothing to undo");
  }
  else if (control && (key == "y" || key == "Z"))
  {
    this->FinishStep(part.Redo(), "redone", "nothing to redo");
  }
  else if (!control && key == "r")
  {
    this->FinishStep(part.Reset(), "reset to the file", "nothing was changed");
  }
  else if (!control && key == "o")
  {
    this->ToggleRule();
  }
  else if (!control && key == "v")
  {
    this->ToggleHold();
  }
}

void smEditStyle::OnKeyPress()
{
  const char* symbol = this->Interactor->GetKeySym();
  const std::string key = symbol ? symbol : "";
  if (this->IsDragging)
  {
    if (key == "Escape")
    {
      this->EndDrag(false);
    }
    return; // other keys must not change the part during a drag
  }
  const bool control = this->Interactor->GetControlKey() != 0;
  if (!control && key == "h")
  {
    this->Scene->SetHelp(!this->Scene->IsHelpShown());
    this->Scene->Draw();
  }
  else if (!control && key == "s")
  {
    this->SavePicture();
  }
  else if (!control && key == "f")
  {
    this->Scene->ShowAll();
  }
  else
  {
    this->OnEditKey(key);
  }
}

void smEditStyle::OnChar()
{
  // The base class's other keys would change how the part is drawn.
  const char key = this->Interactor->GetKeyCode();
  if (!this->IsDragging && (key == 'q' || key == 'e'))
  {
    this->Interactor->ExitCallback();
  }
}
