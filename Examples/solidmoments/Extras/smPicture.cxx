#include "smPicture.h"

#include "smBodyScene.h"
#include "smFormat.h"
#include "smMassPropertyNames.h"
#include "smResults.h"
#include "smStabilityAnalysis.h"
#include "smTableText.h"
#include "smText.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

namespace
{
const int Width = 900;
const int Height = 700;
const int Margin = 20;
const double SignalColor[3] = { 0.90, 0.05, 0.12 };
/// How far a scene moves to the left of a colour bar, relative to half of the width: the scene is as wide as
/// the picture is high, and 5 % more, and the bar begins at 87 % of the width.
const double RoomForBar = 0.12;
const int MaxNumbers = 5;   // of flagged places
const size_t MaxLine = 100; // characters across the picture

/// Returns the caption: the values that exist, and the status if it is not ok.
std::string Caption(const sm::FileResult& file)
{
  std::string text;
  const auto add = [&](const std::string& label, const std::string& value, double bound, int power)
  {
    if (value != "-")
    {
      text += (text.empty() ? "" : "\n") + label + "  " + value + " " + file.FormatUnit(power) +
        (std::isnan(bound) ? " (no bound)" : "");
    }
  };
  const auto addScalar = [&add](const std::string& label, const sm::ScalarQuantity& quantity, int power)
  { add(label, sm::FormatValue(quantity.Get(), quantity.Bound), quantity.Bound, power); };
  const sm::TotalResult& total = file.Total;
  addScalar("volume", total.Volume, 3);
  addScalar("area", total.Area, 2);
  add("centre of mass", sm::FormatVector(total.Center.Value, total.Center.Bound), total.Center.Bound, 1);
  if (const auto* stability = total.Analyses.Find<sm::StabilityResult>())
  {
    text += "\nstability  " + stability->Verdict;
    addScalar("stability margin", stability->Margin, 1);
  }
  if (file.Status != "ok")
  {
    text += "\nstatus  " + file.Status;
  }
  return sm::RaiseDigits(text);
}

void AddNumber(vtkRenderer* front, vtkCell* cell, int number)
{
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput(std::to_string(number).c_str());
  vtkPoints* points = cell->GetPoints();
  double middle[3];
  points->GetPoint(points->GetNumberOfPoints() / 2, middle);
  text->SetPosition(middle);
  text->SetDisplayOffset(6, 6);
  vtkTextProperty* style = text->GetTextProperty();
  style->SetFontSize(20);
  style->SetBold(true);
  style->SetColor(SignalColor[0], SignalColor[1], SignalColor[2]);
  style->SetBackgroundColor(1.0, 1.0, 1.0);
  style->SetBackgroundOpacity(0.8);
  front->AddViewProp(text);
}

/// Draws the flagged faces and edges in both layers, and names the worst below the title.
void AddFlagged(vtkRenderer* body, vtkRenderer* front, vtkPolyData* flagged)
{
  vtkDataArray* numbers = flagged->GetCellData()->GetArray(sm::names::Flag);
  auto* texts = vtkStringArray::SafeDownCast(flagged->GetCellData()->GetAbstractArray(sm::names::Text));
  if (!numbers || !texts || flagged->GetNumberOfCells() == 0)
  {
    return;
  }
  for (vtkRenderer* layer : { body, front })
  {
    vtkActor* actor = sm::AddActor(layer, flagged, SignalColor, layer == body ? 1.0 : 0.55);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(4.0f);
  }
  std::map<int, vtkIdType> firstCells;
  for (vtkIdType cell = 0; cell < flagged->GetNumberOfCells(); ++cell)
  {
    firstCells.emplace(static_cast<int>(numbers->GetComponent(cell, 0)), cell);
  }
  std::string lines;
  for (const auto& [number, cell] : firstCells)
  {
    if (number <= MaxNumbers)
    {
      AddNumber(front, flagged->GetCell(cell), number);
      lines += sm::WrapText(std::to_string(number) + " " + texts->GetValue(cell), MaxLine);
    }
  }
  const auto more = static_cast<int>(std::lround(numbers->GetRange()[1])) - MaxNumbers;
  lines += more > 0 ? "and " + std::to_string(more) + " more" : "";
  sm::AddText(front, sm::RaiseDigits(lines), 15, false, Margin, Height - 2 * Margin - 10, true)
    ->GetTextProperty()
    ->SetColor(SignalColor[0], SignalColor[1], SignalColor[2]);
}

/// Colours of values, from the smallest to the largest: pale yellow, green, blue, almost black.
constexpr double RampColors[][3] = { { 0.98, 0.96, 0.72 }, { 0.55, 0.82, 0.50 }, { 0.13, 0.55, 0.55 },
  { 0.17, 0.25, 0.50 }, { 0.15, 0.02, 0.20 } };

/// Returns a table of RampColors from 0 to `largest`; NaN is grey.
vtkSmartPointer<vtkLookupTable> MakeRamp(double largest)
{
  constexpr int count = 256;
  constexpr int parts = static_cast<int>(std::size(RampColors)) - 1;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  for (int i = 0; i < count; ++i)
  {
    const double at = static_cast<double>(i) * parts / (count - 1);
    const int part = std::min(static_cast<int>(at), parts - 1);
    double color[3];
    for (int k = 0; k < 3; ++k)
    {
      color[k] = RampColors[part][k] + (at - part) * (RampColors[part + 1][k] - RampColors[part][k]);
    }
    table->SetTableValue(i, color[0], color[1], color[2], 1.0);
  }
  table->SetNanColor(0.6, 0.6, 0.6, 1.0);
  table->SetTableRange(0.0, largest);
  return table;
}

/// Adds the body with its faces in the colours of their values, and the colour bar. Returns false, and adds
/// nothing, if no face has a value.
bool AddColoredBody(const sm::Picture& picture, vtkPolyData* mesh, vtkRenderer* body, vtkRenderer* front)
{
  vtkDataArray* values =
    picture.FaceArray.empty() ? nullptr : mesh->GetCellData()->GetArray(picture.FaceArray.c_str());
  double range[2] = { 0.0, 0.0 };
  if (values)
  {
    values->GetFiniteRange(range);
  }
  if (!(range[1] > 0.0))
  {
    return false;
  }
  const vtkSmartPointer<vtkLookupTable> ramp = MakeRamp(range[1]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(picture.FaceArray.c_str());
  mapper->SetLookupTable(ramp);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.65);
  body->AddActor(actor);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(ramp);
  bar->SetNumberOfLabels(5);
  bar->SetUnconstrainedFontSize(true);
  bar->SetTitle(" ");
  bar->SetLabelFormat("%.4g");
  bar->GetLabelTextProperty()->SetColor(0.1, 0.1, 0.1);
  bar->GetLabelTextProperty()->SetFontSize(16);
  bar->GetLabelTextProperty()->SetItalic(false);
  bar->GetLabelTextProperty()->SetBold(false);
  bar->GetLabelTextProperty()->SetShadow(false);
  bar->SetPosition(0.87, 0.25);
  bar->SetWidth(0.1);
  bar->SetHeight(0.5);
  front->AddViewProp(bar);
  vtkSmartPointer<vtkTextActor> title = sm::AddText(
    front, sm::RaiseDigits(picture.FaceTitle), 16, false, Width - Margin, Height * 3 / 4 + Margin, true);
  title->GetTextProperty()->SetJustificationToRight();
  return true;
}

void SetUpScene(const sm::Picture& picture, vtkRenderer* body, vtkRenderer* front)
{
  const vtkSmartPointer<vtkPolyData> mesh = sm::JoinParts(picture.Body);
  const bool hasBar = AddColoredBody(picture, mesh, body, front);
  if (!hasBar)
  {
    sm::AddBody(body, mesh);
  }
  sm::AddOutlines(body, sm::MakeOutlines(mesh));
  sm::AddMark(body, front, picture.Mark);
  vtkBoundingBox box(mesh->GetBounds());
  if (picture.Stability)
  {
    sm::AddDrawing(body, front, picture.Stability);
    box.AddBounds(picture.Stability->GetBounds());
  }
  if (picture.Flagged)
  {
    AddFlagged(body, front, picture.Flagged);
  }
  double bounds[6];
  box.GetBounds(bounds);
  sm::SetUpLayers(picture.Window, body, front, 12);
  // Room for the caption below, and for the names of flagged places above.
  const bool isFlagged = picture.Flagged && picture.Flagged->GetNumberOfCells() > 0;
  sm::SetView(body, bounds, isFlagged ? 0.72 : 1.05, isFlagged ? 0.0 : -0.06);
  if (hasBar)
  {
    double center[2];
    body->GetActiveCamera()->GetWindowCenter(center);
    body->GetActiveCamera()->SetWindowCenter(RoomForBar, center[1]);
  }

  const std::string& path = picture.Result->File;
  sm::AddText(front, sm::GetFileName(path), 18, true, Margin, Height - Margin, true);
  sm::AddText(front, Caption(*picture.Result), 18, false, Margin, Margin, false);
}
}

namespace sm
{
std::string WritePicture(const Picture& picture, const std::string& fileName)
{
  vtkNew<vtkRenderer> body;
  vtkNew<vtkRenderer> front;
  vtkOpenGLRenderWindow* window = picture.Window;
  window->SetOffScreenRendering(1);
  window->SetSize(Width, Height);
  SetUpScene(picture, body, front);
  window->Render();
  std::string error = WriteImage(GrabImage(window), fileName);
  window->RemoveRenderer(front);
  window->RemoveRenderer(body);
  return error;
}
}
