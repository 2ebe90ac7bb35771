#include "smModelPictures.h"

#include "smBodyScene.h"
#include "smFigureTable.h"

#include <smFormat.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSTEPReader.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace smfigure
{
namespace
{
constexpr int Columns = 3;
constexpr int Width = 330;
constexpr int Height = 270;
/// Pictures are drawn larger by this factor and averaged.
constexpr int Oversampling = 2;

struct Model
{
  std::string Name;
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkMassPropertiesGPU> Mass;
};

/// Reads and integrates a model. Returns an error message, empty when it has a volume and status ok.
std::string Integrate(const std::string& file, vtkRenderWindow* window, Model& model)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  model.Name = name.substr(0, name.find_last_of('.'));
  model.Reader->SetFileName(file.c_str());
  model.Reader->Update();
  if (model.Reader->GetStatus() != vtkSTEPReader::OK)
  {
    return file + " could not be read";
  }
  model.Mass->SetInputConnection(model.Reader->GetOutputPort());
  model.Mass->SetRenderWindow(window); // integrate in the context that draws
  model.Mass->ShowPrincipalAxesOff();
  model.Mass->SetGlyphScale(0.025);
  model.Mass->Update();
  return model.Mass->GetStatus() == "ok" ? std::string()
                                         : file + " has no volume to show: " + model.Mass->GetStatus();
}

/// Returns the caption: the volume with eight significant digits.
std::string MakeCaption(Model& model)
{
  const double volume = model.Mass->GetVolume();
  const int before = static_cast<int>(std::floor(std::log10(std::abs(volume)))) + 1;
  return sm::RaiseDigits(sm::FormatFixed(volume, std::max(8 - before, 0)) + " mm^3");
}

vtkSmartPointer<vtkImageData> Draw(Model& model, vtkRenderWindow* window)
{
  vtkNew<vtkRenderer> body;
  vtkNew<vtkRenderer> front;
  window->SetOffScreenRendering(1);
  window->SetSize(Oversampling * Width, Oversampling * Height);
  const vtkSmartPointer<vtkPolyData> mesh =
    sm::JoinParts(vtkPartitionedDataSetCollection::SafeDownCast(model.Reader->GetOutputDataObject(0)));
  sm::AddBody(body, mesh);
  sm::AddOutlines(body, sm::MakeOutlines(mesh));
  sm::AddMark(body, front, model.Mass->GetOutput());
  sm::SetUpLayers(window, body, front, 24);
  body->SetGradientBackground(false);
  body->SetBackground(1.0, 1.0, 1.0);
  sm::SetView(body, mesh->GetBounds(), 1.2, -0.06); // room for the caption below
  std::string name = model.Name;
  std::replace(name.begin(), name.end(), '_', ' ');
  const int size = 14 * Oversampling;
  const int middle = Oversampling * Width / 2;
  for (const auto& [text, bold, line] :
    { std::tuple(name, true, 1.5), std::tuple(MakeCaption(model), false, 0.3) })
  {
    const vtkSmartPointer<vtkTextActor> caption =
      sm::AddText(front, text, size, bold, middle, static_cast<int>(line * size), false);
    caption->GetTextProperty()->SetJustificationToCentered();
  }
  window->Render();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputData(sm::GrabImage(window));
  average->SetShrinkFactors(Oversampling, Oversampling, 1);
  average->AveragingOn();
  average->Update();
  window->RemoveRenderer(front);
  window->RemoveRenderer(body);
  return average->GetOutput();
}

/// Arranges pictures in rows from the top, on white.
vtkSmartPointer<vtkImageData> Arrange(const std::vector<vtkSmartPointer<vtkImageData>>& pictures)
{
  const int count = static_cast<int>(pictures.size());
  const int rows = (count + Columns - 1) / Columns;
  auto page = vtkSmartPointer<vtkImageData>::New();
  page->SetDimensions(std::min(count, Columns) * Width, rows * Height, 1);
  page->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(page->GetScalarPointer());
  std::fill_n(pixels, 3 * page->GetNumberOfPoints(), static_cast<unsigned char>(255));
  for (int i = 0; i < count; ++i)
  {
    for (int y = 0; y < Height; ++y)
    {
      const auto* line = static_cast<unsigned char*>(pictures[i]->GetScalarPointer(0, y, 0));
      std::copy_n(line, 3 * Width,
        static_cast<unsigned char*>(
          page->GetScalarPointer(i % Columns * Width, (rows - 1 - i / Columns) * Height + y, 0)));
    }
  }
  return page;
}

std::vector<std::string> MakeRow(Model& model)
{
  double center[3];
  model.Mass->GetCenterOfMass(center);
  std::vector<std::string> row = { model.Name, std::to_string(model.Mass->GetNumberOfFaces()) };
  for (const double value : { model.Mass->GetVolume(), model.Mass->GetVolumeBound(), center[0], center[1],
         center[2], model.Mass->GetCenterOfMassBound() })
  {
    row.push_back(FormatNumber(value));
  }
  row.push_back(model.Mass->GetStatus());
  return row;
}
}

std::string WriteFigure1(
  const std::vector<std::string>& files, const std::string& folder, vtkRenderWindow* window)
{
  FigureTable table;
  table.Name = "fig1";
  table.Columns = { "model", "faces", "volume", "volume_bound", "center_x", "center_y", "center_z",
    "center_bound", "status" };
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const std::string& file : files)
  {
    Model model;
    const std::string error = Integrate(file, window, model);
    if (!error.empty())
    {
      return error;
    }
    table.Rows.push_back(MakeRow(model));
    pictures.push_back(Draw(model, window));
  }
  const std::string error = sm::WriteImage(Arrange(pictures), folder + "/fig1.png");
  return error.empty() ? WriteTable(table, folder) : error;
}
}
