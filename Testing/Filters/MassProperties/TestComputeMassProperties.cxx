// TestComputeMassProperties FOLDER: the library call has the bits of vtkMassPropertiesGPU on the CPU backend,
// for solids, an assembly with densities, an open shell and inputs without a solid; and its failures are
// statuses.
#include "smBoxBodies.h"
#include "smComputeMassProperties.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Returns true if both have the same bits, or both are NaN.
bool AreSame(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

template <std::size_t N>
void CheckArray(vtkFieldData* data, vtkIdType row, const char* name,
  const sm::Bounded<std::array<double, N>>& actual, int& compared)
{
  vtkDataArray* values = data->GetArray(name);
  vtkDataArray* bounds = data->GetArray((std::string(name) + names::BoundSuffix).c_str());
  if (!CheckTrue(std::string("there is an array ") + name, values && bounds))
  {
    return;
  }
  CheckEqual("components", static_cast<int>(N), values->GetNumberOfComponents());
  bool same = AreSame(bounds->GetComponent(row, 0), actual.Bound);
  for (std::size_t i = 0; i < N; ++i)
  {
    same = same && AreSame(values->GetComponent(row, static_cast<int>(i)), actual.Value[i]);
  }
  CheckTrue(std::string("same bits: ") + name, same);
  ++compared;
}

void CheckBody(vtkFieldData* data, vtkIdType row, const sm::BodyMassProperties& body, bool hasMass)
{
  const auto wrap = [](const sm::Bounded<double>& quantity) {
    return sm::Bounded<std::array<double, 1>>{ { quantity.Value }, quantity.Bound };
  };
  int compared = 0;
  CheckArray(data, row, names::Volume, wrap(body.Volume), compared);
  CheckArray(data, row, names::SurfaceArea, wrap(body.Area), compared);
  CheckArray(data, row, names::CenterOfMass, body.Center, compared);
  CheckArray(data, row, names::VolumeInertia, body.Inertia, compared);
  CheckArray(data, row, names::VolumeInertiaAtOrigin, body.InertiaAtOrigin, compared);
  CheckArray(data, row, names::PrincipalMoments, body.PrincipalMoments, compared);
  CheckArray(data, row, names::PrincipalAxes, body.PrincipalAxes, compared);
  CheckArray(data, row, names::RadiiOfGyration, body.RadiiOfGyration, compared);
  if (hasMass)
  {
    CheckArray(data, row, names::Mass, wrap(body.Mass), compared);
    CheckArray(data, row, names::MassCenter, body.MassCenter, compared);
    CheckArray(data, row, names::MassInertia, body.MassInertia, compared);
    CheckTrue("density", AreSame(data->GetArray(names::Density)->GetComponent(row, 0), body.Density));
  }
  CheckEqual("quantities", hasMass ? 11 : 8, compared);
  const std::pair<const char*, double> defects[] = { { names::ClosureCorrection, body.ClosureCorrection },
    { names::ClosureResidual, body.ClosureResidual }, { names::GapSquared, body.GapSquared },
    { names::GapArea, body.GapArea }, { names::MaxGap, body.MaxGap }, { names::OpenEdges, body.OpenEdges } };
  for (const auto& [name, value] : defects)
  {
    vtkDataArray* array = data->GetArray(name);
    CheckTrue(std::string("same: ") + name, array && AreSame(array->GetComponent(row, 0), value));
  }
  const std::pair<const char*, double> spreads[] = { { names::Volume, body.Volume.Spread },
    { names::SurfaceArea, body.Area.Spread }, { names::CenterOfMass, body.Center.Spread },
    { names::VolumeInertia, body.Inertia.Spread },
    { names::PrincipalMoments, body.PrincipalMoments.Spread } };
  for (const auto& [name, value] : spreads)
  {
    vtkDataArray* array = data->GetArray((std::string(name) + names::SpreadSuffix).c_str());
    CheckTrue(std::string("same spread: ") + name, array && AreSame(array->GetComponent(row, 0), value));
  }
  // NaN where there are no axes.
  CheckEqual("degenerate", data->GetArray(names::PrincipalAxesDegenerate)->GetComponent(row, 0) == 1.0,
    body.PrincipalAxesDegenerate);
}

/// Sets the filter's options as the call's, and compares all rows.
void Compare(vtkMassPropertiesGPU* filter, const sm::MassPropertiesOptions& options, bool hasMass)
{
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetRelativeTolerance(options.RelativeTolerance);
  filter->SetDensity(options.Density);
  for (const sm::MaterialRule& rule : options.Materials)
  {
    filter->AddMaterial(rule.Pattern.c_str(), rule.Material.Name.c_str(), rule.Material.Density);
  }
  MessageTrap trap(filter);
  filter->Update();
  const sm::MassPropertiesResult result =
    sm::ComputeMassProperties(filter->GetInputDataObject(0, 0), options);
  CheckBody(filter->GetOutput()->GetFieldData(), 0, result.Total, hasMass);
  CheckEqual("status", filter->GetStatus(), result.Total.Status);
  CheckEqual("solids", filter->GetNumberOfSolids(), static_cast<int>(result.Solids.size()));
  CheckEqual("faces", filter->GetNumberOfFaces(), result.Faces);
  CheckEqual("evaluations", static_cast<long long>(filter->GetEvaluations()), result.Evaluations);
  CheckEqual(
    "length unit", GetFieldText(filter->GetOutput()->GetFieldData(), names::LengthUnit), result.LengthUnit);
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  std::size_t messages = result.Total.Messages.size();
  for (std::size_t i = 0; i < result.Solids.size(); ++i)
  {
    const sm::BodyMassProperties& body = result.Solids[i];
    const auto row = static_cast<vtkIdType>(i);
    CheckBody(table->GetRowData(), row, body, hasMass);
    CheckEqual("name", std::string(table->GetValueByName(row, names::Name).ToString()), body.Name);
    CheckEqual("id", std::string(table->GetValueByName(row, names::Id).ToString()), body.Id);
    CheckEqual("status", std::string(table->GetValueByName(row, names::Status).ToString()), body.Status);
    messages += body.Messages.size();
  }
  CheckEqual("messages", filter->GetNumberOfMessages(), static_cast<int>(messages));
}

vtkSmartPointer<vtkPartitionedDataSetCollection> MakeAssembly()
{
  auto assembly = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  BoxBody box;
  box.Add({ { 0, 0, 0 }, { 10, 20, 30 } });
  const auto steel = box.Make();
  steel->GetModel()->SetDensity(7850.0);
  auto second = vtkSmartPointer<vtkNURBSDataSet>::New();
  second->ShallowCopy(steel);
  vtkNew<vtkMatrix4x4> placement;
  const double rows[16] = { 0, -1, 0, 100, 1, 0, 0, -20, 0, 0, 1, 30, 0, 0, 0, 1 };
  placement->DeepCopy(rows);
  second->SetPlacement(placement);
  second->SetModel(steel->GetModel());
  BoxBody other;
  other.Add({ { -5, -6, -7 }, { 1, 2, 3 } });
  const char* const parts[] = { "steel", "steel again", "plate" };
  const vtkSmartPointer<vtkNURBSDataSet> leaves[] = { steel, second, other.Make() };
  for (unsigned int i = 0; i < 3; ++i)
  {
    assembly->SetPartition(i, 0, leaves[i]);
    assembly->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), parts[i]);
  }
  return assembly;
}

void CheckAssembly()
{
  std::printf("--- assembly with densities\n");
  const auto assembly = MakeAssembly();
  for (const bool isWhole : { true, false })
  {
    sm::MassPropertiesOptions options;
    if (isWhole)
    {
      options.Materials = { { "pl*", { "wood", 700.0 } } };
    }
    vtkNew<vtkMassPropertiesGPU> filter;
    filter->SetInputData(assembly);
    Compare(filter, options, true);
    const sm::MassPropertiesResult result = sm::ComputeMassProperties(assembly, options);
    const double steel = 2 * 6000.0 * 7850e-9;
    const double wood = isWhole ? 480.0 * 700e-9 : 0.0;
    Check("known mass", steel + wood, result.KnownMass.Value, result.KnownMass.Bound);
    CheckEqual("a total mass", isWhole, std::isfinite(result.Total.Mass.Value));
    CheckEqual("solids with a mass", isWhole ? 3 : 2, result.SolidsWithMass);
    CheckEqual("solids with a volume", 3, result.SolidsWithVolume);
    CheckEqual("material", isWhole ? "wood" : "", result.Solids[2].Material);
  }
}

void CheckFailure(
  const char* what, const char* status, const char* said, const sm::MassPropertiesResult& result)
{
  CheckEqual(what, status, result.Total.Status);
  CheckTrue(std::string("reason: ") + result.Reason, result.Reason.find(said) != std::string::npos);
  CheckTrue("no volume", std::isnan(result.Total.Volume.Value) && std::isnan(result.Total.Volume.Bound));
  CheckTrue("no area", std::isnan(result.Total.Area.Value));
}

void CheckFailures()
{
  std::printf("--- failures\n");
  const auto assembly = MakeAssembly();
  const auto compute = [&assembly](const auto& change)
  {
    sm::MassPropertiesOptions options;
    change(options);
    return sm::ComputeMassProperties(assembly, options);
  };
  using Options = sm::MassPropertiesOptions;
  CheckFailure("null", names::StatusEmpty, "no solid", sm::ComputeMassProperties(nullptr));
  CheckFailure("nothing in it", names::StatusEmpty, "no solid",
    sm::ComputeMassProperties(vtkSmartPointer<vtkPartitionedDataSetCollection>::New()));
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  mesh->SetPoints(points);
  CheckFailure("a mesh", names::StatusEmpty, "without exact geometry", sm::ComputeMassProperties(mesh));
  const char* const notComputed = names::StatusNotComputed;
  CheckFailure("density", notComputed, "Density is 1e+250; give kg/m^3 from 1e-200 to 1e200",
    compute([](Options& options) { options.Density = 1e250; }));
  CheckFailure("tolerance", notComputed, "RelativeTolerance is",
    compute([](Options& options) { options.RelativeTolerance = std::numeric_limits<double>::quiet_NaN(); }));
  CheckFailure("density tolerance", notComputed, "DensityTolerance is 2",
    compute([](Options& options) { options.DensityTolerance = 2.0; }));
  CheckFailure(
    "gap limit", notComputed, "GapLimit is 3", compute([](Options& options) { options.GapLimit = 3.0; }));
  CheckFailure("evaluations", notComputed, "MaximumEvaluations is 0",
    compute([](Options& options) { options.MaximumEvaluations = 0; }));
  CheckFailure("seconds", notComputed, "MaximumSeconds is -1",
    compute([](Options& options) { options.MaximumSeconds = -1.0; }));
  CheckFailure("material", notComputed, "Materials, x: 0 is not a density; give kg/m^3 from 1e-200",
    compute(
      [](Options& options) {
        options.Materials = { { "x", { "steel" } } };
      }));
  CheckFailure("stopped", notComputed, "aborted",
    compute([](Options& options) { options.Progress = [](double) { return false; }; }));
  CheckFailure("an exception of the callback", notComputed, "enough",
    compute([](Options& options)
      { options.Progress = [](double) -> bool { throw std::runtime_error("enough"); }; }));
  const sm::MassPropertiesResult sound = compute([](Options&) {});
  CheckEqual("and nothing is left of them", names::StatusOk, sound.Total.Status);
  CheckEqual("no reason", "", sound.Reason);
  const sm::MassPropertiesResult stated = compute(
    [](Options& options) {
      options.Materials = { { "*", { "pump", 0.0, -1.0, 2.0 } } };
    });
  const double all = 2.0 * static_cast<double>(stated.Solids.size());
  Check("a stated mass of each solid", all, stated.Total.Mass.Value, 0.0);
  Check("  is overridden", all, stated.Total.OverriddenMass, 0.0);
  const sm::MassPropertiesResult none = compute(
    [](Options& options) {
      options.Materials = { { "*", { sm::LeftOutMaterial }, true } };
    });
  CheckEqual("all is left out", names::StatusEmpty, none.Total.Status);
  CheckEqual("  no solids", 0, static_cast<long long>(none.Solids.size()));
}
}

int TestComputeMassProperties(int argc, char* argv[])
{
  if (argc < 2)
  {
    return 1;
  }
  const Manifest manifest(argv[1]);
  for (const char* solid : { "slanted_hole", "torus", "spline_ring", "wavy_plate" })
  {
    std::printf("--- %s\n", solid);
    Pipeline pipeline(manifest.GetSolid(solid)[0].Path);
    sm::MassPropertiesOptions options;
    options.RelativeTolerance = 1e-7;
    options.Density = 2700.0;
    Compare(pipeline.Mass, options, true);
  }
  for (const char* special : { "assembly", "two_solids", "open_solid", "open_shell" })
  {
    std::printf("--- %s\n", special);
    Pipeline pipeline(manifest.GetSpecial(special).Path);
    Compare(pipeline.Mass, {}, false);
  }
  {
    std::printf("--- a file without solids\n");
    Pipeline pipeline(manifest.GetSpecial("no_geometry").Path);
    Compare(pipeline.Mass, {}, false);
  }
  CheckAssembly();
  CheckFailures();
  return Finish();
}
