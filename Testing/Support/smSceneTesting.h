/**
 * @file smSceneTesting.h
 * @brief A scene drawn as the image tests of the filters do, against its baseline
 */
#ifndef smSceneTesting_h
#define smSceneTesting_h

#include "smTesting.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTesting.h>

#include <array>

namespace smtest
{
/// Draws the renderer's actors on white, seen from the direction `from` with z upwards, in a window of `size`
/// pixels, and checks the picture by vtkTesting with the options -T and -V of the arguments.
/// vtkImageDifference forgives shifts by a pixel and 16 of 255 in colour, and sums the rest; the sum must not
/// exceed 10.
inline void CheckScene(int argc, char* argv[], vtkRenderer* renderer, const std::array<double, 3>& from,
  const std::array<int, 2>& size)
{
  vtkNew<vtkRenderWindow> window;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(2.2);
  window->Render();
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, const_cast<const char**>(argv));
  testing->SetRenderWindow(window);
  CheckEqual("picture", vtkTesting::PASSED, testing->RegressionTest(10.0));
}
}

#endif
