#include "smEditScene.h"

#include "smBodyScene.h"
#include "smQuantities.h"
#include "smText.h"

#include <smFormat.h>
#include <smMassPropertyNames.h>
#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellPicker.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTimerLog.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>

namespace sm
{
namespace
{
const int Margin = 20;
const int FontSize = 17;
// Layers of depth peeling. Parts like the shipped one have at most this many surfaces behind each other; each
// layer is another pass.
const int Peels = 8;
const int FewPeels = 4;
const double DarkColor[3] = { 0.12, 0.15, 0.20 };
const double AmberColor[3] = { 0.75, 0.42, 0.0 };
const double RedColor[3] = { 0.85, 0.05, 0.05 };
const int SamplesOfEdge = 32;

const char* const ShortHint = "h: help";
const char* const HelpText = "click a face: show its control net\n"
                             "drag a control point: move it in the plane of the screen\n"
                             "Shift + drag: move it along the face's normal\n"
                             "Ctrl + wheel: change the weight of the orange control point\n"
                             "Esc: cancel a drag\n"
                             "Ctrl+Z, Ctrl+Y: undo, redo\n"
                             "o: move one face alone, or all faces at an edge\n"
                             "r: reset the part to the file\n"
                             "v: hold the volume, or do not\n"
                             "s: save a picture\n"
                             "f: show the whole part\n"
                             "drag elsewhere: rotate, middle button: pan\n"
                             "wheel, right button: zoom\n"
                             "h: hide this help, q: quit";

void SetInput(vtkActor* actor, vtkPolyData* data)
{
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(data);
}

std::string FormatMilliseconds(double seconds, int digits = 1)
{
  return FormatFixed(1e3 * seconds, digits);
}
}

EditScene::EditScene(vtkRenderWindow* window, EditedPart& part, const std::string& title)
  : Window(window)
  , Part(part)
  , Net(Body)
{
  for (int i = 0; i < part.GetNumberOfBodies(); ++i)
  {
    DrawnBody drawn;
    drawn.Mesh = vtkSmartPointer<vtkPolyData>::New();
    drawn.Mesh->ShallowCopy(part.GetBody(i));
    drawn.Lines = MakeOutlines(drawn.Mesh);
    drawn.Actor = AddBody(this->Body, drawn.Mesh);
    // Opaque lines need no depth peeling, which would double the time of a picture.
    drawn.Outlines = AddOutlines(this->Body, drawn.Lines);
    drawn.Outlines->GetProperty()->SetOpacity(1.0);
    drawn.Outlines->PickableOff();
    this->Bodies.push_back(drawn);
  }
  this->Mass->SetInputData(part.GetBodies());
  this->Mass->SetRenderWindow(window);
  this->Mass->ShowPrincipalAxesOn();
  AddMark(this->Body, this->Front, this->Mass->GetOutput());
  vtkSmartPointer<vtkActor> opened = AddActor(this->Front, this->Opened, RedColor, 1.0);
  opened->GetProperty()->SetLineWidth(3.0f);
  opened->GetProperty()->LightingOff();

  const int height = window->GetSize()[1];
  this->Title = AddText(this->Front, title, FontSize, true, Margin, height - Margin, true);
  this->State = AddText(this->Front, " ", FontSize, false, Margin, height - Margin - 28, true);
  this->Numbers = AddText(this->Front, " ", FontSize, false, Margin, Margin, false);
  this->Hint = AddText(
    this->Front, ShortHint, FontSize - 3, false, window->GetSize()[0] - Margin, height - Margin, true);
  this->Hint->GetTextProperty()->SetJustificationToRight();
  this->Hint->GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
  SetUpLayers(window, this->Body, this->Front, Peels);
  this->Update();
  SetView(this->Body, this->GetBounds().data(), 1.15, -0.12); // room for the numbers below
  this->Draw();
}

EditScene::~EditScene()
{
  this->Mass->SetRenderWindow(nullptr);
  this->Window->RemoveRenderer(this->Front);
  this->Window->RemoveRenderer(this->Body);
}

std::array<double, 6> EditScene::GetBounds() const
{
  vtkBoundingBox box;
  for (const DrawnBody& drawn : this->Bodies)
  {
    box.AddBounds(drawn.Mesh->GetBounds());
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

void EditScene::ShowAll()
{
  this->Body->ResetCamera(this->GetBounds().data());
  this->Draw();
}

void EditScene::ShowBodies()
{
  for (std::size_t i = 0; i < this->Bodies.size(); ++i)
  {
    DrawnBody& drawn = this->Bodies[i];
    vtkNURBSDataSet* body = this->Part.GetBody(static_cast<int>(i));
    if (drawn.Mesh->GetPoints() != body->GetPoints())
    {
      // A new vtkPolyData, because an old one keeps its computed bounds when it gets points that are older,
      // as after an undo.
      drawn.Mesh = vtkSmartPointer<vtkPolyData>::New();
      drawn.Mesh->ShallowCopy(body);
      SetInput(drawn.Actor, drawn.Mesh);
      vtkCellArray* lines = drawn.Lines->GetLines();
      vtkNew<vtkPolyData> outlines;
      outlines->SetPoints(body->GetPoints());
      outlines->SetLines(lines);
      drawn.Lines = outlines;
      SetInput(drawn.Outlines, outlines);
    }
  }
}

void EditScene::ShowOpened()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < this->Part.GetNumberOfBodies(); ++i)
  {
    for (const OpenedEdge& opened : this->Part.GetOpened(i))
    {
      const EdgeCurve& curve = opened.Source->Curve;
      lines->InsertNextCell(SamplesOfEdge + 1);
      for (int k = 0; k <= SamplesOfEdge; ++k)
      {
        const double s = static_cast<double>(k) / SamplesOfEdge;
        const EdgeCurve::Point p = curve.Evaluate((1.0 - s) * curve.GetStart() + s * curve.GetEnd());
        lines->InsertCellPoint(
          points->InsertNextPoint(ToWorld(this->Part.GetBody(i), { p[0], p[1], p[2], 1.0 }).data()));
      }
    }
  }
  this->Opened->SetPoints(points);
  this->Opened->SetLines(lines);
}

std::string EditScene::DescribeOpened() const
{
  std::size_t count = 0;
  double widest = 0.0;
  for (int i = 0; i < this->Part.GetNumberOfBodies(); ++i)
  {
    for (const OpenedEdge& opened : this->Part.GetOpened(i))
    {
      ++count;
      widest = std::max(widest, opened.Gap);
    }
  }
  if (count == 0)
  {
    return {};
  }
  const std::string unit = GetText(this->Mass->GetOutput()->GetFieldData(), 0, names::LengthUnit);
  return std::to_string(count) + (count == 1 ? " edge" : " edges") + " opened, largest gap " +
    FormatDigits(widest, 3) + " " + unit + "\n";
}

std::string EditScene::DescribeHold() const
{
  if (!this->Hold.IsOn())
  {
    return {};
  }
  if (!this->Hold.GetVolume())
  {
    return "the volume is held from the next drag on\n";
  }
  const std::string unit = GetText(this->Mass->GetOutput()->GetFieldData(), 0, names::LengthUnit);
  const bool isHeld = this->Hold.GetDeviation() <= VolumeHold::Tolerance;
  return std::string(isHeld ? "volume held at " : "volume NOT held at ") +
    FormatDigits(*this->Hold.GetVolume(), 12) + " " + unit + "^3, off by " +
    FormatDigits(this->Hold.GetDeviation(), 2) + " of it\n";
}

void EditScene::ShowNumbers()
{
  const std::string opened = this->DescribeOpened();
  const std::string status = this->Mass->GetStatus();
  std::string text =
    GetText(vtkTable::SafeDownCast(this->Mass->GetOutputDataObject(2))->GetRowData(), 0, names::Text);
  if (this->ShowTimes && !this->Times.empty())
  {
    const UpdateTimes& t = this->Times.back();
    text += "Update: " + FormatMilliseconds(t.GetComputing()) + " ms (edit " + FormatMilliseconds(t.Edit) +
      ", display points " + FormatMilliseconds(t.Display) + ", moments " + FormatMilliseconds(t.Moments) +
      "), picture " + FormatMilliseconds(t.Draw, 0) + " ms";
  }
  SetText(this->Numbers, RaiseDigits(TrimEnd(text)));
  const double* color = status == names::StatusOk ? DarkColor
    : status == names::StatusToleranceNotMet      ? AmberColor
                                                  : RedColor;
  this->Numbers->GetTextProperty()->SetColor(color[0], color[1], color[2]);

  std::string state = opened;
  state += this->Rule == EditRule::OneFace ? "moving one face alone\n" : "";
  state += RaiseDigits(this->DescribeHold());
  state += this->Notice;
  SetText(this->State, state.empty() ? " " : state);
  const double* stateColor = opened.empty() ? DarkColor : RedColor;
  this->State->GetTextProperty()->SetColor(stateColor[0], stateColor[1], stateColor[2]);
}

void EditScene::Update()
{
  UpdateTimes times;
  times.Hold = this->Hold.IsOn() ? this->Hold.GetSolveSeconds() : 0.0;
  times.Edit = this->Part.GetEditSeconds();
  times.Display = this->Part.GetDisplaySeconds();
  const double start = vtkTimerLog::GetUniversalTime();
  this->Mass->Update();
  const double computed = vtkTimerLog::GetUniversalTime();
  times.Moments = computed - start;
  this->Hold.Record(this->Mass->GetVolume());
  this->ShowBodies();
  this->ShowOpened();
  this->Net.Follow(this->Part);
  // The picture shows the drawing time of the previous one.
  times.Draw = this->Times.empty() ? 0.0 : this->Times.back().Draw;
  this->Times.push_back(times);
  this->Draw();
  this->Times.back().Draw = vtkTimerLog::GetUniversalTime() - computed;
  if (times.Edit == 0.0 && this->Times.size() > 1)
  {
    this->Times.pop_back(); // an undo is not an edit
  }
}

void EditScene::Draw()
{
  this->ShowNumbers();
  // Reset at every drawing, so that a picture does not depend on earlier ones.
  this->Body->ResetCameraClippingRange();
  this->Window->Render();
}

bool EditScene::PickFace(int x, int y, int& body, int& face)
{
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0);
  if (!picker->Pick(x, y, 0.0, this->Body))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Bodies.size(); ++i)
  {
    vtkDataArray* faces =
      this->Bodies[i].Mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
    if (this->Bodies[i].Actor == picker->GetActor() && faces && picker->GetCellId() >= 0)
    {
      body = static_cast<int>(i);
      face = static_cast<int>(faces->GetComponent(picker->GetCellId(), 0));
      return face >= 0 && face < this->Part.GetBody(body)->GetModel()->GetNumberOfFaces();
    }
  }
  return false;
}

void EditScene::SetHelp(bool shown)
{
  this->Help = shown;
  SetText(this->Hint, shown ? HelpText : ShortHint);
  this->Hint->GetTextProperty()->SetBackgroundOpacity(shown ? 0.8 : 0.0);
}

void EditScene::SetShowTimes(bool shown)
{
  this->ShowTimes = shown;
}

void EditScene::SetHurried(bool hurried)
{
  this->Body->SetMaximumNumberOfPeels(hurried ? FewPeels : Peels);
  this->Body->SetUseFXAA(!hurried);
  this->Mass->SetCheckEditedSolids(!hurried);
  if (!hurried)
  {
    this->Mass->Update();
    this->ShowNumbers();
  }
}

void EditScene::SetNotice(const std::string& notice)
{
  this->Notice = notice;
}

void EditScene::SetRule(EditRule rule)
{
  this->Rule = rule;
}
}
