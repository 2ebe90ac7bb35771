// TestMassPropertiesPictures MODE SOLIDS PARTS MODELS OUTPUT BASELINES: what vtkMassPropertiesGPU puts out,
// drawn, against BASELINES/TestMassPropertiesPictures_MODE.png. SOLIDS: what smMakeSolids wrote, PARTS: what
// make_paper_parts wrote, MODELS: Examples/Models.
//   parts     translucent bodies with marker and axes
//   assembly  the same of assemblies, with a marker in every solid
//   axes      with axes, without, and of bodies whose moments coincide: none
//   flagged   markers of open and of inaccurate results are red
//   colors    faces by their share (upper row) and solids by their volume, cell data of port 5
// Each is drawn once more with something wrong, which has to be noticed.
#include "smPictureTesting.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"
#include "smVTKCompatibility.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLookupTable.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <functional>
#include <list>

namespace
{
constexpr int TileSize = 300;

struct Folders
{
  std::string Solids;
  std::string Parts;
  std::string Models;
};

/// A square with the bodies, the marker and the axes of a file.
class Tile
{
public:
  explicit Tile(const std::string& path)
    : Shown(path, smtest::DisplayMesh::Fine)
  {
    this->Shown.Mass->SetGlyphScale(0.05);
    this->BodyMapper->SetInputConnection(this->Shown.Mass->GetOutputPort(5));
    this->BodyMapper->ScalarVisibilityOff();
    vtkNew<vtkActor> body;
    body->SetMapper(this->BodyMapper);
    body->SetProperty(this->BodyProperty);
    this->BodyProperty->SetOpacity(0.4);
    this->BodyProperty->SetColor(0.45, 0.6, 0.8);
    vtkNew<vtkPolyDataMapper> glyphMapper;
    glyphMapper->SetInputConnection(this->Shown.Mass->GetOutputPort());
    vtkNew<vtkActor> glyph;
    glyph->SetMapper(glyphMapper);
    glyph->GetProperty()->SetLineWidth(2);
    this->Renderer->AddActor(glyph);
    this->Renderer->AddActor(body);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Renderer->SetUseDepthPeeling(1);
    this->Renderer->SetMaximumNumberOfPeels(12);
    this->Renderer->SetOcclusionRatio(0.0);
  }

  vtkMassPropertiesGPU* GetMass() { return this->Shown.Mass; }
  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// Opaque, coloured by an array of port 5 from blue to red, over a range that may be logarithmic.
  void ColorBy(const char* array, double low, double high, bool isLog)
  {
    vtkNew<vtkLookupTable> colors;
    colors->SetHueRange(0.667, 0.0);
    isLog ? colors->SetScaleToLog10() : colors->SetScaleToLinear();
    this->BodyProperty->SetOpacity(1.0);
    this->BodyMapper->SetScalarVisibility(true);
    this->BodyMapper->SetScalarModeToUseCellFieldData();
    this->BodyMapper->SelectColorArray(array);
    this->BodyMapper->SetLookupTable(colors);
    this->BodyMapper->SetUseLookupTableScalarRange(false);
    this->BodyMapper->SetScalarRange(low, high);
  }

  void LookAt(double zoom = 1.2)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(-1.0, -1.7, 1.1);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 0, 1);
    this->Renderer->ResetCamera();
    camera->Zoom(zoom);
  }

private:
  smtest::Pipeline Shown;
  vtkNew<sm::CompositeMapper> BodyMapper;
  vtkNew<vtkProperty> BodyProperty;
  vtkNew<vtkRenderer> Renderer;
};

/// Tiles in rows of two from the top, in one window.
class Scene
{
public:
  Tile& Add(const std::string& path)
  {
    this->Tiles.emplace_back(path);
    Tile& tile = this->Tiles.back();
    tile.GetMass()->SetRenderWindow(this->Window);
    this->Window->AddRenderer(tile.GetRenderer());
    return tile;
  }

  std::list<Tile>& GetTiles() { return this->Tiles; }

  vtkSmartPointer<vtkImageData> Draw()
  {
    const int rows = (static_cast<int>(this->Tiles.size()) + 1) / 2;
    this->Window->SetMultiSamples(0);
    this->Window->SetAlphaBitPlanes(1);
    this->Window->SetSize(2 * TileSize, rows * TileSize);
    int i = 0;
    for (Tile& tile : this->Tiles)
    {
      const double top = 1.0 - static_cast<double>(i / 2) / rows;
      tile.GetRenderer()->SetViewport(0.5 * (i % 2), top - 1.0 / rows, 0.5 * (i % 2 + 1), top);
      tile.LookAt();
      ++i;
    }
    this->Window->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(this->Window);
    grab->SetInputBufferTypeToRGB();
    grab->ReadFrontBufferOff();
    grab->Update();
    return grab->GetOutput();
  }

private:
  vtkNew<vtkRenderWindow> Window;
  std::list<Tile> Tiles;
};

using SceneChange = std::function<void(Scene&)>;

/// Fills the scene, and returns what makes it wrong.
SceneChange MakeParts(const Folders& folders, Scene& scene)
{
  scene.Add(folders.Models + "/free_form_part.step");
  scene.Add(folders.Parts + "/propeller.step");
  scene.Add(folders.Parts + "/crank.step");
  scene.Add(smtest::Manifest(folders.Solids).GetSolid("slanted_hole", "moved")[0].Path);
  return [](Scene& wrong)
  {
    for (Tile& tile : wrong.GetTiles())
    {
      tile.GetMass()->SetGlyphScale(0.0);
    }
  };
}

SceneChange MakeAssemblies(const Folders& folders, Scene& scene)
{
  scene.Add(folders.Parts + "/gear_train.step").GetMass()->GlyphPerSolidOn();
  scene.Add(smtest::Manifest(folders.Solids).GetSpecial("two_solids").Path).GetMass()->GlyphPerSolidOn();
  return [](Scene& wrong) { wrong.GetTiles().front().GetMass()->GlyphPerSolidOff(); };
}

SceneChange MakeAxes(const Folders& folders, Scene& scene)
{
  const smtest::Manifest manifest(folders.Solids);
  const std::string part = manifest.GetSolid("slanted_hole", "moved")[0].Path;
  scene.Add(part);
  scene.Add(part).GetMass()->ShowPrincipalAxesOff();
  scene.Add(manifest.GetSolid("sphere", "plain")[0].Path);
  scene.Add(manifest.GetSolid("cylinder", "moved")[0].Path);
  return [](Scene& wrong) { wrong.GetTiles().front().GetMass()->ShowPrincipalAxesOff(); };
}

SceneChange MakeFlagged(const Folders& folders, Scene& scene)
{
  const smtest::Manifest manifest(folders.Solids);
  scene.Add(manifest.GetSpecial("open_solid").Path);
  scene.Add(manifest.GetSolid("slanted_hole", "moved")[0].Path).GetMass()->SetRelativeTolerance(1e-15);
  return [](Scene& wrong) { wrong.GetTiles().back().GetMass()->SetRelativeTolerance(1e-9); };
}

SceneChange MakeColors(const Folders& folders, Scene& scene)
{
  scene.Add(folders.Models + "/free_form_part.step").ColorBy(sm::names::FaceShare, 0.0, 0.08, false);
  scene.Add(folders.Parts + "/propeller.step").ColorBy(sm::names::FaceShare, -0.1, 0.4, false);
  scene.Add(folders.Parts + "/gear_train.step").ColorBy(sm::names::VolumeOfWholeSolid, 20.0, 2e5, true);
  scene.Add(smtest::Manifest(folders.Solids).GetSpecial("two_solids").Path)
    .ColorBy(sm::names::VolumeOfWholeSolid, 0.0, 8000.0, false);
  return [](Scene& wrong) { wrong.GetTiles().front().ColorBy(sm::names::FaceShare, 0.0, 0.1, false); };
}

SceneChange Fill(const std::string& mode, const Folders& folders, Scene& scene)
{
  return mode == "parts" ? MakeParts(folders, scene)
    : mode == "assembly" ? MakeAssemblies(folders, scene)
    : mode == "axes"     ? MakeAxes(folders, scene)
    : mode == "flagged"  ? MakeFlagged(folders, scene)
    : mode == "colors"   ? MakeColors(folders, scene)
                         : SceneChange();
}
}

int TestMassPropertiesPictures(int argc, char* argv[])
{
  Scene scene;
  const SceneChange spoil = argc == 7 ? Fill(argv[1], { argv[2], argv[3], argv[4] }, scene) : SceneChange();
  smtest::RequireUsage(spoil != nullptr,
    "TestMassPropertiesPictures parts|assembly|axes|flagged|colors SOLIDS PARTS MODELS OUTPUT BASELINES");
  const std::string mode = argv[1];
  const std::string name = "/TestMassPropertiesPictures_" + mode;
  const vtkSmartPointer<vtkImageData> baseline = smtest::ReadPicture(argv[6] + name + ".png");
  const vtkSmartPointer<vtkImageData> picture = scene.Draw();
  for (Tile& tile : scene.GetTiles())
  {
    const bool isOk = tile.GetMass()->GetStatus() == sm::names::StatusOk;
    smtest::CheckTrue("status", isOk == (mode != "flagged"), tile.GetMass()->GetStatus());
  }
  smtest::WritePicture(picture, argv[5] + name + ".png");
  smtest::CheckRange("pixels unlike the baseline's", 0.0, smtest::ShareOfOtherPixels(picture, baseline),
    smtest::PictureLimit, "share of all");
  spoil(scene);
  const vtkSmartPointer<vtkImageData> wrong = scene.Draw();
  smtest::WritePicture(wrong, argv[5] + name + "_wrong.png");
  smtest::CheckRange("pixels of a wrong one", 2.0 * smtest::PictureLimit,
    smtest::ShareOfOtherPixels(wrong, baseline), 0.9, "it is noticed, and is a picture of that size");
  return smtest::Finish();
}
