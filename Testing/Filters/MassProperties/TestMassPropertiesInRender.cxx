// TestMassPropertiesInRender own|shared FOLDER: the filter, and one that evaluates display points, run for
// the first time inside a window's Render(), in contexts of their own or in the window's, and the picture
// does not change.
#include "smTestManifest.h"
#include "smTestPipeline.h"
#include "smVTKCompatibility.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNURBSDeform.h>
#include <vtkNURBSPointEvaluatorGPU.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace
{
using namespace smtest;

struct Scene
{
  Pipeline Source;
  vtkNew<vtkNURBSDeform> Deform;
  vtkNew<vtkNURBSPointEvaluatorGPU> Points;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<sm::CompositeMapper> PartMapper;
  vtkNew<vtkPolyDataMapper> GlyphMapper;
  vtkNew<vtkActor> Part;
  vtkNew<vtkActor> Glyph;

  Scene(const Expected& part, bool shared)
    : Source(part.Path, DisplayMesh::Fine)
  {
    if (shared)
    {
      this->Source.Mass->SetRenderWindow(this->Window);
      this->Points->SetRenderWindow(this->Window);
    }
    // All control points move by the same vector: the volume stays, and every display point is evaluated.
    this->Deform->SetInputConnection(this->Source.Reader->GetOutputPort());
    this->Deform->SetDisplacement(0.02 * part.Size, 0.0, 0.0);
    this->Deform->SetPointEvaluator(this->Points);
    this->Source.Mass->SetInputConnection(this->Deform->GetOutputPort());
    this->Source.Mass->SetGlyphScale(0.1);
    this->PartMapper->SetInputConnection(this->Deform->GetOutputPort());
    this->GlyphMapper->SetInputConnection(this->Source.Mass->GetOutputPort());
    this->Part->SetMapper(this->PartMapper);
    this->Part->GetProperty()->SetOpacity(0.5);
    this->Glyph->SetMapper(this->GlyphMapper);
    this->Renderer->AddActor(this->Glyph);
    this->Renderer->AddActor(this->Part);
    this->Renderer->SetBackground(0.2, 0.3, 0.4);
    // A camera from the closed form: ResetCamera would run the filter before the rendering does.
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(part.Center.data());
    camera->SetPosition(
      part.Center[0] + part.Size, part.Center[1] + 1.5 * part.Size, part.Center[2] + part.Size);
    camera->SetViewUp(0, 0, 1);
    camera->SetClippingRange(0.1 * part.Size, 10 * part.Size);
    this->Window->SetSize(300, 300);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
  }

  std::vector<unsigned char> Render()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, 299, 299, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }
};

long long CountDifferences(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  long long count = a.size() == b.size() ? 0 : -1;
  for (std::size_t i = 0; count >= 0 && i < a.size(); ++i)
  {
    count += a[i] != b[i] ? 1 : 0;
  }
  return count;
}

/// Pixels of the green glyph, so that an empty picture cannot pass.
long long CountGreen(const std::vector<unsigned char>& pixels)
{
  long long count = 0;
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
  {
    count += pixels[i + 1] > pixels[i] + 40 && pixels[i + 1] > pixels[i + 2] + 40 ? 1 : 0;
  }
  return count;
}
}

int TestMassPropertiesInRender(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestMassPropertiesInRender own|shared FOLDER");
  const bool shared = std::string(argv[1]) == "shared";
  const Expected part = Manifest(argv[2]).GetSolid("slanted_hole", "moved")[0];

  Scene inside(part, shared);
  inside.Source.Mass->CacheFaceResultsOff();
  CheckTrue("the filter has not run", std::isnan(inside.Source.Mass->GetVolume()));
  const auto first = inside.Render();
  Check("volume", part.Volume, inside.Source.Mass->GetVolume(), 1e-9 * part.Volume);
  CheckTrue("the glyph is in the picture", CountGreen(first) > 50,
    std::to_string(CountGreen(first)) + " green pixels");
  CheckEqual("display points by", "opengl", inside.Points->GetBackendName());
  CheckRange("all of them", 100.0, static_cast<double>(inside.Points->GetNumberOfEvaluations()), 1e6);
  CheckEqual("changed values in the next picture", 0, CountDifferences(first, inside.Render()));

  inside.Deform->Modified();
  inside.Source.Mass->Modified();
  CheckEqual("changed values after another run inside Render()", 0, CountDifferences(first, inside.Render()));

  inside.Deform->Modified();
  inside.Source.Mass->Modified();
  inside.Source.Mass->Update();
  CheckEqual("changed values after a run between two pictures", 0, CountDifferences(first, inside.Render()));

  Scene before(part, false);
  before.Source.Mass->Update();
  CheckEqual("changed values against a filter that ran before", 0, CountDifferences(first, before.Render()));
  CheckEqual("changed values after a second window was drawn", 0, CountDifferences(first, inside.Render()));
  return Finish();
}
