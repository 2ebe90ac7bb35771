// TestMassPropertiesImage FILE.step -T FOLDER -V BASELINE.png: the translucent part with its centre of mass
// and principal axes.
#include "smTestPipeline.h"
#include "smVTKCompatibility.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTesting.h>

#include <cstdio>

int TestMassPropertiesImage(int argc, char* argv[])
{
  smtest::RequireUsage(argc >= 6, "TestMassPropertiesImage FILE.step -T FOLDER -V BASELINE.png");
  smtest::Pipeline pipeline(argv[1], smtest::DisplayMesh::Fine);
  pipeline.Mass->SetGlyphScale(0.05);
  vtkNew<vtkRenderWindow> window;
  pipeline.Mass->SetRenderWindow(window);

  vtkNew<sm::CompositeMapper> partMapper;
  partMapper->SetInputConnection(pipeline.Reader->GetOutputPort());
  partMapper->ScalarVisibilityOff();
  vtkNew<vtkActor> part;
  part->SetMapper(partMapper);
  part->GetProperty()->SetOpacity(0.45);
  part->GetProperty()->SetColor(0.45, 0.6, 0.8);
  vtkNew<vtkPolyDataMapper> glyphMapper;
  glyphMapper->SetInputConnection(pipeline.Mass->GetOutputPort());
  vtkNew<vtkActor> glyph;
  glyph->SetMapper(glyphMapper);
  glyph->GetProperty()->SetLineWidth(2);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(glyph);
  renderer->AddActor(part);
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->SetMultiSamples(0);
  window->SetSize(400, 400);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-1.0, -1.7, 1.1);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.2);
  window->Render();
  smtest::CheckEqual("status", sm::names::StatusOk, pipeline.Mass->GetStatus());

  // vtkImageDifference forgives shifts by a pixel and 16 of 255 in colour, and sums the rest: the same driver
  // gives 0, a picture without the sphere 29, one without the axes 910.
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, const_cast<const char**>(argv));
  testing->SetRenderWindow(window);
  smtest::CheckEqual("picture", vtkTesting::PASSED, testing->RegressionTest(5.0));
  return smtest::Finish();
}
