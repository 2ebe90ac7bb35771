// TestSolidSectionImage FOLDER -T FOLDER -V BASELINE.png: a hollow ball, a block with a slanted hole and a
// torus below planes, closed by their sections.
#include "smSceneTesting.h"
#include "smSectionTesting.h"

#include <vtkActor.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <memory>

int TestSolidSectionImage(int argc, char* argv[])
{
  using namespace smtest;
  RequireUsage(argc >= 6, "TestSolidSectionImage FOLDER -T FOLDER -V BASELINE.png");
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
    scene.Filter->Update(7);
    auto* clipped = vtkPartitionedDataSetCollection::SafeDownCast(scene.Filter->GetOutputDataObject(7));
    mapper->SetInputDataObject(clipped->GetPartitionAsDataObject(0, 0));
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectColorArray("Color");
    mapper->SetColorModeToDirectScalars();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(place, 0, 0);
    renderer->AddActor(actor);
  }
  // The same driver gives 0, sections in grey some 50.
  CheckScene(argc, argv, renderer, { -0.2, -1.2, 1.1 }, { 700, 320 });
  return Finish();
}
