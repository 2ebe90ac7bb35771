// TestMassPropertiesSchemes FOLDER opengl|none: the paper's schemes through the filter: values, what is NaN,
// what the status says, options, instances, edits, budgets; with `none` (the caller limits OpenGL) the CPU
// computes, or nothing.
#include "smBoxBodies.h"
#include "smDecimalCommas.h"
#include "smSchemeNames.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"
#include "smWrongSamples.h"

#include <vtkCellData.h>
#include <vtkComputeContext.h>
#include <vtkImageData.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSchemeMassPropertiesGPU.h>
#include <vtkTable.h>

#include <algorithm>
#include <cstdio>
#include <regex>

namespace
{
using namespace smtest;
namespace names = sm::names;

struct SchemePipeline
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkSchemeMassPropertiesGPU> Mass;

  explicit SchemePipeline(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    this->Mass->SetInputConnection(this->Reader->GetOutputPort());
  }
};

/// Every value that exists, for a comparison bit for bit.
std::vector<double> ListValues(vtkMassPropertiesBase* mass)
{
  std::vector<double> all;
  for (const char* name : { names::Volume, names::SurfaceArea, names::CenterOfMass, names::FirstMoments,
         names::SecondMoments, names::VolumeInertia, names::PrincipalMoments, names::Evaluations,
         names::PaperErrorEstimate, names::PaperErrorEstimateWithBoundary, names::SubPatches })
  {
    const std::vector<double> values = GetArray(mass, name);
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

/// Arrays that every result of a scheme has, and those that it must not have.
void CheckForm(vtkSchemeMassPropertiesGPU* mass, const std::string& scheme)
{
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  CheckEqual("status", names::StatusToleranceNotMet, mass->GetStatus());
  const std::string said = GetMessages(mass);
  const std::string why = scheme + " has no error bound";
  const std::size_t place = said.find(why);
  CheckTrue("it says why, once", place != std::string::npos && said.find(why, place + 1) == std::string::npos,
    said.substr(0, 500));
  const std::string summary =
    vtkTable::SafeDownCast(mass->GetOutputDataObject(2))->GetValueByName(0, names::Text).ToString();
  char options[80];
  std::snprintf(options, sizeof(options), "\nk = %d, 4 x 4 texels a sub-patch, chords of planes to 1e-08",
    mass->GetSubPatchFactor());
  CheckTrue("the text says with what", summary.find(options) != std::string::npos, summary);
  CheckTrue("nothing is suspected",
    said.find("suspect") == std::string::npos && said.find("outside") == std::string::npos, said);
  for (const char* name :
    { names::Volume, names::SurfaceArea, names::CenterOfMass, names::FirstMoments, names::SecondMoments,
      names::VolumeInertia, names::VolumeInertiaAtOrigin, names::PrincipalMoments, names::RadiiOfGyration })
  {
    const std::vector<double> values = GetArray(mass, name);
    CheckTrue(std::string(name) + " is there",
      !values.empty() &&
        std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }));
    CheckTrue(std::string(name) + " has no bound", std::isnan(GetFieldBound(fields, name)));
  }
  for (const char* name :
    { names::ClosureCorrection, names::MaxGap, names::GapArea, names::GapSquared, names::ClosureResidual })
  {
    const std::vector<double> values = GetArray(mass, name);
    CheckTrue(std::string(name) + " is not known", values.size() == 1 && std::isnan(values[0]));
  }
  CheckEqual("Scheme", scheme, GetFieldText(fields, names::Scheme));
  CheckTrue("estimates",
    mass->GetPaperErrorEstimate() >= 0.0 &&
      mass->GetPaperErrorEstimateWithBoundary() >= mass->GetPaperErrorEstimate());
  Check("estimate in the field data", mass->GetPaperErrorEstimate(),
    GetField(fields, names::PaperErrorEstimate), 0.0);
  Check("the other one", mass->GetPaperErrorEstimateWithBoundary(),
    GetField(fields, names::PaperErrorEstimateWithBoundary), 0.0);
  Check("sub-patches", static_cast<double>(mass->GetSubPatches()), GetField(fields, names::SubPatches), 0.0);
  auto* solids = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
  for (const char* name :
    { names::Scheme, names::PaperErrorEstimate, names::PaperErrorEstimateWithBoundary, names::SubPatches })
  {
    CheckTrue(std::string("column ") + name,
      solids->GetColumnByName(name) &&
        solids->GetColumnByName(name)->GetNumberOfTuples() == solids->GetNumberOfRows());
  }
  auto* faces = vtkTable::SafeDownCast(mass->GetOutputDataObject(3));
  CheckTrue("faces have no bound",
    faces->GetNumberOfRows() > 0 && std::isnan(faces->GetValueByName(0, "VolumeBound").ToDouble()) &&
      std::isfinite(faces->GetValueByName(0, "Volume").ToDouble()));
  mass->Update(5);
  auto* bodies = vtkPartitionedDataSetCollection::SafeDownCast(mass->GetOutputDataObject(5));
  vtkCellData* cells = vtkPolyData::SafeDownCast(bodies->GetPartition(0, 0))->GetCellData();
  const auto getFirst = [cells](const char* name)
  { return cells->HasArray(name) ? cells->GetArray(name)->GetComponent(0, 0) : 0.0; };
  CheckTrue("bounds and gaps of the mesh are not known",
    std::isnan(getFirst(names::FaceBound)) && std::isnan(getFirst(names::FaceGap)));
  CheckTrue("its shares are", cells->HasArray(names::FaceShare) && std::isfinite(getFirst(names::FaceShare)));
}

/// Values near the exact ones, by far more than what texels leave; the GPU's and the CPU's are the same to
/// rounding.
void CheckSolid(const Expected& expected, double near)
{
  const char* const schemes[] = { "", "MIDPOINT", "GAUSS2", "GAUSS3" };
  for (int scheme = 1; scheme <= 3; ++scheme)
  {
    std::printf("--- %s, %s\n", expected.Path.c_str(), schemes[scheme]);
    SchemePipeline pipeline(expected.Path);
    vtkNew<vtkSchemeMassPropertiesGPU> cpu;
    cpu->SetInputConnection(pipeline.Reader->GetOutputPort());
    cpu->SetBackend(vtkSchemeMassPropertiesGPU::CPU);
    pipeline.Mass->SetBackend(vtkSchemeMassPropertiesGPU::OPENGL);
    MessageTrap trap(pipeline.Mass);
    MessageTrap cpuTrap(cpu);
    for (vtkSchemeMassPropertiesGPU* mass : { pipeline.Mass.Get(), cpu.Get() })
    {
      mass->SetScheme(scheme);
      mass->SetSubPatchFactor(16);
      mass->Update();
      CheckForm(mass, schemes[scheme]);
      const double coarse = scheme == 1 ? 20.0 * near : near;
      Check("volume", expected.Volume, mass->GetVolume(), coarse * expected.Volume);
      double center[3];
      mass->GetCenterOfMass(center);
      for (int i = 0; i < 3; ++i)
      {
        Check("centre", expected.Center[i], center[i], coarse * expected.Size);
      }
      double inertia[9];
      mass->GetVolumeInertia(inertia);
      Check("inertia", expected.GetInertiaTrace(), inertia[0] + inertia[4] + inertia[8],
        10.0 * coarse * expected.GetInertiaTrace());
    }
    const std::vector<double> a = ListValues(pipeline.Mass);
    const std::vector<double> b = ListValues(cpu);
    CheckTrue("both have everything", a.size() == b.size() && a.size() == 30);
    Check("volume of GPU and CPU", a[0], b[0], 1e-13 * a[0]);
    Check("area of GPU and CPU", a[1], b[1], 1e-13 * a[1]);
    for (int i = 2; i < 5; ++i)
    {
      Check("centre of GPU and CPU", a[i], b[i], 1e-13 * (expected.GetDistance() + expected.Size));
    }
    CheckEqual("evaluations of GPU and CPU", pipeline.Mass->GetEvaluations(), cpu->GetEvaluations());
    CheckEqual("backends", std::string(names::BackendOpenGL) + names::BackendCPU,
      pipeline.Mass->GetBackendName() + cpu->GetBackendName());
    CheckTrue("dispatches", pipeline.Mass->GetDispatches() > 0 && cpu->GetDispatches() == 0);
    pipeline.Mass->Modified();
    pipeline.Mass->Update();
    CheckTrue("the next run has the same bits", ListValues(pipeline.Mass) == a);
  }
}

void CheckOptions(const Manifest& manifest)
{
  std::printf("--- options\n");
  const Expected hole = manifest.GetSolid("slanted_hole", "plain")[0];
  SchemePipeline pipeline(hole.Path);
  vtkSchemeMassPropertiesGPU* mass = pipeline.Mass;
  MessageTrap trap(mass);
  CheckTrue("defaults",
    mass->GetScheme() == vtkSchemeMassPropertiesGPU::GAUSS2 && mass->GetSubPatchFactor() == 2 &&
      mass->GetTrimTextureFactor() == 4 && mass->GetChordTolerance() == 1e-8 &&
      mass->GetDeviation() == vtkSchemeMassPropertiesGPU::BOUNDED && !mass->GetKeepTrimTextures());
  CheckTrue("nothing before the first run",
    std::isnan(mass->GetPaperErrorEstimate()) && std::isnan(mass->GetPaperErrorEstimateWithBoundary()) &&
      mass->GetSubPatches() == 0);
  // The filter with bounds, compared with this one on the same bodies. Its evaluations count what is
  // evaluated again.
  vtkNew<vtkMassPropertiesGPU> adaptive;
  adaptive->SetInputConnection(pipeline.Reader->GetOutputPort());
  adaptive->CacheFaceResultsOff();
  adaptive->Update();
  const std::vector<double> before = ListValues(adaptive);
  vtkFieldData* fields = adaptive->GetOutput()->GetFieldData();
  CheckTrue("the filter with bounds has none of it",
    !fields->HasArray(names::Scheme) && !fields->HasArray(names::PaperErrorEstimate) &&
      !fields->HasArray(names::PaperErrorEstimateWithBoundary) && !fields->HasArray(names::SubPatches));

  mass->SetScheme(-1);
  CheckEqual("clamped from below", vtkSchemeMassPropertiesGPU::MIDPOINT, mass->GetScheme());
  mass->SetScheme(99);
  mass->SetSubPatchFactor(0);
  mass->SetTrimTextureFactor(99);
  mass->SetDeviation(-3);
  CheckTrue("clamped",
    mass->GetScheme() == vtkSchemeMassPropertiesGPU::GAUSS3 && mass->GetSubPatchFactor() == 1 &&
      mass->GetTrimTextureFactor() == 16 && mass->GetDeviation() == vtkSchemeMassPropertiesGPU::BOUNDED);
  for (const double wrong : { 0.0, 1.0, -1e-3, std::nan("") })
  {
    mass->SetChordTolerance(wrong);
  }
  CheckTrue("refused", trap.NumberOfErrors == 4 && mass->GetChordTolerance() == 1e-8);

  // Only the cylinder counts: 4 knot intervals.
  mass->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS2);
  mass->SetSubPatchFactor(12);
  mass->SetTrimTextureFactor(4);
  mass->Update();
  CheckEqual("sub-patches", 4 * 12 * 12, mass->GetSubPatches());
  CheckTrue("no textures unless asked for", mass->GetNumberOfTrimTextures() == 0 && !mass->GetTrimTexture(0));
  const double bounded = mass->GetPaperErrorEstimate();
  const double volume = mass->GetVolume();
  mass->SetDeviation(vtkSchemeMassPropertiesGPU::SAMPLED);
  mass->SetKeepTrimTextures(true);
  mass->Update();
  CheckRange("sampled is less than bounded", 0.5 * bounded, mass->GetPaperErrorEstimate(), bounded);
  Check("the volume is the same", volume, mass->GetVolume(), 0.0);
  CheckEqual("one texture: the cylinder", 1, mass->GetNumberOfTrimTextures());
  vtkImageData* image = mass->GetTrimTexture(0);
  CheckTrue(
    "its name", mass->GetTrimTextureName(0).find(" #") != std::string::npos, mass->GetTrimTextureName(0));
  CheckTrue("none beyond", !mass->GetTrimTexture(1) && mass->GetTrimTextureName(-1).empty());
  const int* size = image->GetDimensions();
  CheckEqual("texels", 4LL * 12 * 12 * 16, static_cast<long long>(size[0]) * size[1] * size[2]);
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  const auto inside = std::count(pixels, pixels + image->GetNumberOfPoints(), 255);
  const auto outside = std::count(pixels, pixels + image->GetNumberOfPoints(), 0);
  CheckTrue("black and white", inside > 0 && outside > 0 && inside + outside == image->GetNumberOfPoints());

  // Finer: nearer, and at least of first order, for every texel is right but those on the border. The chords
  // of the two ellipses in the planes are the rest.
  mass->SetChordTolerance(1e-8);
  mass->SetSubPatchFactor(1);
  mass->Update();
  const double coarse = std::fabs(mass->GetVolume() - hole.Volume);
  mass->SetSubPatchFactor(128);
  mass->Update();
  CheckRange("the error falls", 0.0, std::fabs(mass->GetVolume() - hole.Volume), coarse / 128.0);

  adaptive->Modified();
  adaptive->Update();
  CheckTrue("the filter with bounds has its bits again",
    ListValues(adaptive) == before && adaptive->GetStatus() == names::StatusOk);
  mass->SetKeepTrimTextures(false);
  mass->Update();
  CheckTrue("no textures any more", mass->GetNumberOfTrimTextures() == 0);

  // The sphere is shaders' alone.
  SchemePipeline sphere(manifest.GetSolid("sphere", "plain")[0].Path);
  MessageTrap sphereTrap(sphere.Mass);
  sphere.Mass->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS3);
  sphere.Mass->Update();
  const double exact = sphere.Mass->GetVolume();
  const WrongSamples wrong(sphere.Mass, 1.0 + 1.0 / 1024);
  sphere.Mass->Update();
  Check("perturbed", exact * (1.0 + 1.0 / 1024), sphere.Mass->GetVolume(), 1e-13 * exact);
}

void CheckAssembly(const Manifest& manifest)
{
  std::printf("--- instances\n");
  const Expected expected = manifest.GetSpecial("assembly");
  SchemePipeline pipeline(expected.Path);
  MessageTrap trap(pipeline.Mass);
  pipeline.Mass->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS2);
  pipeline.Mass->SetKeepTrimTextures(true);
  pipeline.Mass->Update();
  CheckForm(pipeline.Mass, "GAUSS2");
  auto* solids = vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(1));
  CheckEqual("solids", 500, solids->GetNumberOfRows());
  const double one = solids->GetValueByName(0, "Volume").ToDouble();
  Check("500 times the volume", 500.0 * one, pipeline.Mass->GetVolume(), 1e-12 * 500.0 * one);
  const long long subPatches = solids->GetValueByName(7, names::SubPatches).ToLongLong();
  CheckEqual("500 times the sub-patches", 500 * subPatches, pipeline.Mass->GetSubPatches());
  CheckTrue("evaluated once",
    pipeline.Mass->GetEvaluations() <= 4 * subPatches &&
      (subPatches == 0 || pipeline.Mass->GetEvaluations() > 0));
  CheckRange("textures of one part", 0, pipeline.Mass->GetNumberOfTrimTextures(), 50);
}

/// Shells: the inner one is recognized as a void though nothing has a bound. With boxes alone: planes are
/// exact.
void CheckShells()
{
  std::printf("--- shells of boxes\n");
  BoxBody body;
  body.Add({ { -10, -10, -10 }, { 10, 10, 10 } });
  body.Add({ { -2, -3, -4 }, { 2, 3, 4 } });
  vtkNew<vtkSchemeMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputData(body.Make());
  mass->SetScheme(vtkSchemeMassPropertiesGPU::MIDPOINT);
  mass->Update();
  Check("the void counts as one", 8000.0 - 192.0, mass->GetVolume(), 1e-9);
  CheckForm(mass, "MIDPOINT");
  CheckTrue("it was reversed", GetMessages(mass).find("1 of 2 shells was inside out") != std::string::npos);
  CheckTrue("planes have no sub-patches and no estimate",
    mass->GetSubPatches() == 0 && mass->GetPaperErrorEstimate() == 0.0);

  BoxBody open;
  open.Add({ { 0, 0, 0 }, { 1, 2, 3 }, true, 5 });
  mass->SetInputData(open.Make());
  mass->Update();
  CheckEqual("an open solid is open", names::StatusOpen, mass->GetStatus());
  mass->SetInputData(open.Make(false));
  mass->Update();
  CheckTrue(
    "a surface has no volume", std::isnan(mass->GetVolume()) && mass->GetStatus() == names::StatusOpen);
  Check("but an area", 22.0 - 2.0, mass->GetSurfaceArea(), 1e-12);
  CheckTrue("and nothing is said of its bound", GetMessages(mass).find("error bound") == std::string::npos,
    GetMessages(mass));
}

void CheckEdit(const Manifest& manifest)
{
  std::printf("--- an edit\n");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(manifest.GetSolid("spline_ring", "plain")[0].Path.c_str());
  reader->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  auto* read = vtkNURBSDataSet::SafeDownCast(output->GetPartition(0, 0));
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(read->GetModel());
  vtkNew<vtkNURBSDataSet> leaf;
  leaf->ShallowCopy(read);
  leaf->SetModel(model);
  vtkNew<vtkSchemeMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputData(leaf);
  mass->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS3);
  mass->Update();
  const std::vector<double> before = ListValues(mass);
  const sm::FacePointer old = model->GetFaces()[0];
  auto moved = std::make_shared<sm::Face>(*old);
  moved->Id = sm::NewId();
  for (auto& p : moved->Surface.ControlPoints)
  {
    p[2] += 1e-3 * p[3];
  }
  model->SetFace(0, moved);
  leaf->Modified();
  mass->Modified();
  mass->Update();
  CheckTrue("an edit is seen", ListValues(mass) != before);
  vtkNew<vtkSchemeMassPropertiesGPU> fresh;
  MessageTrap freshTrap(fresh);
  fresh->SetInputData(leaf);
  fresh->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS3);
  fresh->Update();
  CheckTrue("as by a new filter, to the bit", ListValues(mass) == ListValues(fresh));
  model->SetFace(0, old);
  mass->Modified();
  mass->Update();
  CheckTrue("undone: the same bits", ListValues(mass) == before);
}

void CheckBudgets(const Manifest& manifest)
{
  std::printf("--- budgets and abort\n");
  SchemePipeline pipeline(manifest.GetSolid("torus", "plain")[0].Path);
  vtkSchemeMassPropertiesGPU* mass = pipeline.Mass;
  MessageTrap trap(mass);
  mass->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS2);
  mass->SetSubPatchFactor(1024);
  mass->SetMaximumEvaluations(1000);
  {
    const DecimalCommas commas;
    mass->Update();
    mass->SetChordTolerance(1.5);
  }
  CheckTrue("decimal points", trap.Errors.find("The chord tolerance 1.5 ") != std::string::npos, trap.Errors);
  const auto isNothing = [mass]()
  {
    return std::isnan(mass->GetVolume()) && std::isnan(mass->GetPaperErrorEstimate()) &&
      mass->GetStatus() == names::StatusNotComputed;
  };
  CheckTrue("too costly: nothing", isNothing() && mass->GetEvaluations() == 0);
  CheckTrue("it says so, with decimal points",
    std::regex_search(
      GetMessages(mass), std::regex("takes [0-9][.][0-9]+e[+]0[0-9] .*divide into fewer sub-patches")),
    GetMessages(mass));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* self = static_cast<vtkSchemeMassPropertiesGPU*>(filter);
      self->SetAbortExecute(self->GetProgress() > 0.31 ? 1 : 0);
    });
  mass->SetMaximumEvaluations(2000000000);
  mass->SetSubPatchFactor(200);
  const unsigned long tag = mass->AddObserver(vtkCommand::ProgressEvent, stop);
  mass->Update();
  CheckTrue("aborted: nothing", isNothing() && mass->GetEvaluations() > 0);
  CheckTrue(
    "and it says so", GetMessages(mass).find("the run was aborted") != std::string::npos, GetMessages(mass));
  mass->RemoveObserver(tag);
  mass->SetMaximumSeconds(1e-6);
  mass->Update();
  CheckTrue("out of time: nothing", isNothing());
  CheckTrue(
    "and it says so", GetMessages(mass).find("maximum seconds") != std::string::npos, GetMessages(mass));
  mass->SetMaximumSeconds(0.0);
  mass->Update();
  CheckTrue("then everything", std::isfinite(mass->GetVolume()));
}

void CheckWithoutOpenGL(const Manifest& manifest)
{
  const Expected sphere = manifest.GetSolid("sphere", "plain")[0];
  SchemePipeline pipeline(sphere.Path);
  MessageTrap trap(pipeline.Mass);
  pipeline.Mass->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS3);
  pipeline.Mass->SetSubPatchFactor(8);
  pipeline.Mass->GetComputeContext()->SetSource(vtkComputeContext::EGL);
  pipeline.Mass->Update();
  CheckEqual("backend", names::BackendCPU, pipeline.Mass->GetBackendName());
  CheckForm(pipeline.Mass, "GAUSS3");
  CheckTrue("it says why", GetMessages(pipeline.Mass).find("without OpenGL") != std::string::npos);
  Check("volume", sphere.Volume, pipeline.Mass->GetVolume(), 1e-6 * sphere.Volume);
  pipeline.Mass->SetBackend(vtkSchemeMassPropertiesGPU::OPENGL);
  pipeline.Mass->Update();
  CheckTrue("OpenGL insisted on: nothing",
    std::isnan(pipeline.Mass->GetVolume()) && std::isnan(pipeline.Mass->GetPaperErrorEstimate()));
  CheckEqual("status", names::StatusNotComputed, pipeline.Mass->GetStatus());
}
}

int TestMassPropertiesSchemes(int argc, char* argv[])
{
  RequireUsage(argc >= 3, "TestMassPropertiesSchemes FOLDER opengl|none");
  vtkSMPTools::SetBackend("STDThread");
  const Manifest manifest(argv[1]);
  if (std::string(argv[2]) == "none")
  {
    CheckWithoutOpenGL(manifest);
    return Finish();
  }
  for (const char* solid :
    { "sphere", "torus", "ellipsoid", "spline_ring", "hollow_sphere", "cylinder", "airfoil" })
  {
    // Not trimmed, or trimmed along lines of the parameters: the quadrature and the chords are all that is
    // left.
    CheckSolid(manifest.GetSolid(solid, "plain")[0], 1e-4);
  }
  for (const char* variant : { "moved", "mirrored", "reversed", "far" })
  {
    CheckSolid(manifest.GetSolid("slanted_hole", variant)[0], 1e-3);
  }
  CheckSolid(manifest.GetSolid("bicylinder", "turned")[0], 2e-2);
  CheckOptions(manifest);
  CheckAssembly(manifest);
  CheckShells();
  CheckEdit(manifest);
  CheckBudgets(manifest);
  return Finish();
}
