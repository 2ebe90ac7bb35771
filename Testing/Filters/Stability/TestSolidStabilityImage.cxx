// TestSolidStabilityImage FOLDER -T FOLDER -V BASELINE.png: three leaning prisms, stable, too close and
// unstable, with what the filter draws: the support polygon, the projected centre of mass and the line to it,
// green, amber and red.
#include "smStandingSolids.h"

#include "smSceneTesting.h"
#include "smStabilityNames.h"
#include "smTestPipeline.h"
#include "smVTKCompatibility.h"

#include "smStepFile.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSolidStability.h>

namespace
{
/// A prism that leans by a share of its base, at its place along x, and the drawing of how it stands.
void AddPrism(vtkRenderer* renderer, const std::string& folder, double lean, double x, const char* verdict)
{
  const double axis[3] = { 0, 0, 1 };
  const double shift[3] = { x, 0, 0 };
  const TopoDS_Shape prism =
    smtest::Rotated(smtest::MakeLeaningPrism(10, 10, 14, 10 * lean), axis, 0.0, shift);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(smtest::WriteStanding(folder, "image", prism).c_str());
  vtkNew<vtkSolidStability> stability;
  stability->SetInputConnection(reader->GetOutputPort());
  stability->Update();
  smtest::CheckEqual("verdict", verdict, stability->GetStability());

  vtkNew<sm::CompositeMapper> partMapper;
  partMapper->SetInputConnection(reader->GetOutputPort());
  partMapper->ScalarVisibilityOff();
  vtkNew<vtkActor> part;
  part->SetMapper(partMapper);
  part->GetProperty()->SetOpacity(0.3);
  part->GetProperty()->SetColor(0.45, 0.6, 0.8);
  vtkNew<vtkPolyDataMapper> drawingMapper;
  drawingMapper->SetInputConnection(stability->GetOutputPort());
  vtkNew<vtkActor> drawing;
  drawing->SetMapper(drawingMapper);
  drawing->GetProperty()->LightingOff();
  drawing->GetProperty()->SetLineWidth(3);
  renderer->AddActor(drawing);
  renderer->AddActor(part);
}
}

int TestSolidStabilityImage(int argc, char* argv[])
{
  smtest::RequireUsage(argc >= 6, "TestSolidStabilityImage FOLDER -T FOLDER -V BASELINE.png");
  smtest::QuietOcct();
  vtkNew<vtkRenderer> renderer;
  AddPrism(renderer, argv[1], 0.4, 0.0, "stable");
  AddPrism(renderer, argv[1], 1.0, 21.0, "too-close");
  AddPrism(renderer, argv[1], 1.6, 48.0, "unstable");

  // The same driver gives 0, red and green exchanged 33.
  smtest::CheckScene(argc, argv, renderer, { -0.15, -1.5, 0.65 }, { 700, 300 });
  return smtest::Finish();
}
