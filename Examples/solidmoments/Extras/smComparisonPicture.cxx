#include "smComparisonPicture.h"

#include "smBodyScene.h"
#include "smComparison.h"
#include "smFilterSetUp.h"
#include "smProductBodies.h"
#include "smResults.h"
#include "smText.h"

#include "vtkBoundingBox.h"
#include "vtkCADReader.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <map>
#include <string>

namespace sm
{
namespace
{
const int Width = 900;
const int Height = 700;
const int Margin = 20;
const int LineHeight = 26;

struct Style
{
  const char* State;
  double Color[3];
  double Opacity;
  bool IsOld;
};

const Style Styles[] = { { states::Unchanged, { 0.62, 0.64, 0.67 }, 0.3, false },
  { states::Moved, { 0.20, 0.45, 0.85 }, 0.9, false }, { states::Changed, { 0.95, 0.62, 0.05 }, 0.9, false },
  { states::Mirrored, { 0.55, 0.25, 0.70 }, 0.9, false }, { states::Added, { 0.13, 0.62, 0.25 }, 0.9, false },
  { states::Removed, { 0.85, 0.12, 0.10 }, 0.35, true } };

/// Returns the states of solids by their ids in the old or the new file.
std::map<std::string, std::string> ListStates(
  const ProductDifference& comparison, std::string ComparedBody::*id)
{
  std::map<std::string, std::string> states;
  for (const ComparedPart& part : comparison.Parts)
  {
    for (const ComparedBody& body : part.Bodies)
    {
      states[body.*id] = part.State;
    }
  }
  return states;
}

/// Returns one mesh of all solids of a file with this state.
vtkSmartPointer<vtkPolyData> JoinState(
  vtkCADReader* reader, const std::map<std::string, std::string>& states, const std::string& state)
{
  vtkNew<vtkPartitionedDataSetCollection> chosen;
  unsigned int count = 0;
  for (const ProductBody& body : ListBodies(reader->GetOutputDataObject(0)))
  {
    const auto found = states.find(body.Id);
    if (found != states.end() && found->second == state)
    {
      chosen->SetPartition(count++, 0, body.Leaf);
    }
  }
  return JoinParts(chosen);
}

void SetUpComparison(vtkCADReader* before, vtkCADReader* after, const JobOptions& options,
  vtkOpenGLRenderWindow* window, vtkRenderer* body, vtkRenderer* front)
{
  const auto oldStates = ListStates(*options.Comparison, &ComparedBody::OldId);
  const auto newStates = ListStates(*options.Comparison, &ComparedBody::NewId);
  vtkBoundingBox box;
  int line = Margin;
  for (const Style& style : Styles)
  {
    const auto count = std::find_if(options.Comparison->Counts.begin(), options.Comparison->Counts.end(),
      [&style](const auto& entry) { return entry.first == std::string(style.State); });
    if (count == options.Comparison->Counts.end() || count->second == 0)
    {
      continue;
    }
    const vtkSmartPointer<vtkPolyData> mesh =
      style.IsOld ? JoinState(before, oldStates, style.State) : JoinState(after, newStates, style.State);
    AddActor(body, mesh, style.Color, style.Opacity);
    AddOutlines(body, MakeOutlines(mesh));
    box.AddBounds(mesh->GetBounds());
    vtkTextActor* text =
      AddText(front, std::to_string(count->second) + " " + style.State, 18, true, Margin, line, false);
    text->GetTextProperty()->SetColor(style.Color[0], style.Color[1], style.Color[2]);
    line += LineHeight;
  }
  double bounds[6];
  box.GetBounds(bounds);
  SetUpLayers(window, body, front, 12);
  SetView(body, bounds, 1.05, -0.06); // room for the caption below
  AddText(front, GetFileName(options.ComparedName) + " -> " + GetFileName(options.FileName), 18, true, Margin,
    Height - Margin, true);
}
}

std::string WriteComparison(vtkCADReader* before, vtkCADReader* after, const JobOptions& options)
{
  vtkNew<vtkMassPropertiesGPU> filter;
  SetUpFilter(filter, options);
  std::string error;
  vtkOpenGLRenderWindow* window = StartWindow(filter, error);
  if (!window)
  {
    return error;
  }
  vtkNew<vtkRenderer> body;
  vtkNew<vtkRenderer> front;
  window->SetOffScreenRendering(1);
  window->SetSize(Width, Height);
  SetUpComparison(before, after, options, window, body, front);
  window->Render();
  error = WriteImage(GrabImage(window), options.PictureName);
  window->RemoveRenderer(front);
  window->RemoveRenderer(body);
  return error;
}
}
