// TestSolidSectionImage FOLDER -T FOLDER -V BASELINE.png: a hollow ball, a block with a slanted hole and a torus below planes, closed by
// their sections.
#include "smSectionTesting.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTesting.h>

#include <cstdio>
#include <memory>

int TestSolidSectionImage(int argc, char* argv[])
{
  using namespace smtest;
  if (argc < 6)
  {
    std::fprintf(stderr, "usage: TestSolidSectionImage FOLDER -T FOLDER -V BASELINE.png\n");
    return 1;
  }
  const Manifest manifest(argv[1]);
  vtkNew<vtkRenderer> renderer;
  // Through the middle of the void, along the axis of the hole, and along Villarceau's circles.
  const std::tuple<const char*, Vector, Vector, double> parts[] = { { "hollow_sphere", { 1, 2, -1.5L },
                                                                      { -0.3L, -1, 0.6L }, 0.0 },
    { "slanted_hole", { 20, 11, 8 }, { 0, -1, 0.2L }, 14.0 },
    { "torus", { 0, 0, 0 }, { -0.3L, 0, 0.953939201416946L }, 84.0 } };
  std::vector<std::unique_ptr<SectionScene>> scenes;
  for (const auto& [name, point, normal, place] : parts)
  {
    scenes.push_back(std::make_unique<SectionScene>(manifest.GetSolid(name, "plain")[0].Path, false));
    SectionScene& scene = *scenes.back();
    scene.Set(point, normal);
    scene.Filter->Update();
    CheckEqual(std::string(name) + ", status", "ok", scene.Filter->GetStatus());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(scene.Filter->GetOutputPort(7));
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectColorArray("Color");
    mapper->SetColorModeToDirectScalars();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(place, 0, 0);
    renderer->AddActor(actor);
  }
  vtkNew<vtkRenderWindow> window;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->SetMultiSamples(0);
  window->SetSize(700, 320);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-0.2, -1.2, 1.1);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(2.2);
  window->Render();

  // vtkImageDifference forgives shifts by a pixel and 16 of 255 in colour: the same driver gives 0, sections in grey some 50.
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, const_cast<const char**>(argv));
  testing->SetRenderWindow(window);
  CheckEqual("picture", vtkTesting::PASSED, testing->RegressionTest(10.0));
  return Finish();
}
