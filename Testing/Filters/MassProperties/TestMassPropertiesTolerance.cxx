// TestMassPropertiesTolerance FOLDER: tolerances of single quantities, budgets, and the same bits from run to
// run and after an edit.
#include "smBoxBodies.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <smFace.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTrimmedNURBSModel.h>

#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace
{
using namespace smtest;
namespace names = sm::names;

const char* const Quantities[] = { names::Volume, names::SurfaceArea, names::CenterOfMass,
  names::VolumeInertia };

void CheckSingleTolerances(const Expected& solid)
{
  std::printf("--- tolerances of single quantities\n");
  Pipeline pipeline(solid.Path);
  vtkMassPropertiesGPU* mass = pipeline.Mass;
  MessageTrap trap(mass);
  const double scales[] = { solid.Volume, solid.Area, std::cbrt(solid.Volume), solid.GetInertiaTrace() };
  for (const double wrong : { 2.0, 0.0, -1e-9, std::numeric_limits<double>::quiet_NaN() })
  {
    mass->SetRelativeTolerance(wrong);
    Check("a tolerance that is refused", 1e-9, mass->GetRelativeTolerance(), 0.0);
  }
  CheckEqual("errors", 4, trap.NumberOfErrors);
  trap.NumberOfErrors = 0;
  mass->SetRelativeTolerance(1e-20);
  Check("the smallest", 1e-15, mass->GetRelativeTolerance(), 0.0);
  mass->SetRelativeTolerance(1e-9);
  mass->Update();
  const vtkTypeInt64 all = mass->GetEvaluations();

  mass->SetSurfaceAreaTolerance(1e-2, 0.0);
  mass->Update();
  CheckEqual("a loose area is ok", names::StatusOk, mass->GetStatus());
  CheckTrue("and costs less", mass->GetEvaluations() < all);
  for (int i = 0; i < 4; ++i)
  {
    const double bound = GetFieldBound(mass->GetOutput()->GetFieldData(), Quantities[i]) / scales[i];
    CheckRange(std::string(Quantities[i]) + " bound", 1e-16, bound, i == 1 ? 1e-2 : 1e-9);
  }

  // No relative tolerance can be met; the absolute ones are.
  mass->SetSurfaceAreaTolerance(0.0, 0.0);
  mass->SetRelativeTolerance(1e-15);
  mass->Update();
  CheckEqual("1e-15 is below rounding", names::StatusToleranceNotMet, mass->GetStatus());
  mass->SetVolumeTolerance(0.0, 1e-6 * scales[0]);
  mass->SetSurfaceAreaTolerance(0.0, 1e-6 * scales[1]);
  mass->SetCenterOfMassTolerance(0.0, 1e-6 * scales[2]);
  mass->Update();
  CheckEqual("the inertia's is still missing", names::StatusToleranceNotMet, mass->GetStatus());
  mass->SetInertiaTolerance(0.0, 1e-6 * scales[3]);
  mass->Update();
  CheckEqual("absolute tolerances count", names::StatusOk, mass->GetStatus());
  CheckTrue("and cost less", mass->GetEvaluations() < all);
  for (int i = 0; i < 4; ++i)
  {
    const double bound = GetFieldBound(mass->GetOutput()->GetFieldData(), Quantities[i]) / scales[i];
    CheckRange(std::string(Quantities[i]) + " bound, absolute", 1e-16, bound, 1e-6);
  }

  mass->SetVolumeTolerance(2.0, 0.0);
  mass->SetVolumeTolerance(0.0, -1.0);
  mass->SetInertiaTolerance(std::numeric_limits<double>::quiet_NaN(), 0.0);
  CheckEqual("nonsense is refused", 3, trap.NumberOfErrors);
  CheckTrue("and changes nothing",
    mass->GetVolumeTolerance()[0] == 0.0 && mass->GetVolumeTolerance()[1] == 1e-6 * scales[0]);
}

/// The centre of a bar, 1000 by 10 by 10, is judged by half its diagonal, 500, and not by the cube root of
/// its volume, 46.
void CheckSlender()
{
  std::printf("--- a slender part\n");
  BoxBody bar;
  bar.Add({ { -500, -5, -5 }, { 500, 5, 5 } });
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  const auto leaf = bar.Make();
  leaf->GetModel()->SetVolumeScale(1e5);
  leaf->GetModel()->SetAreaScale(4e4);
  mass->SetInputData(leaf);
  mass->Update();
  const double bound = mass->GetCenterOfMassBound();
  CheckRange("bound of the centre", 1e-16, bound, 1e-9);
  for (const double share : { 100.0, 1000.0 })
  {
    mass->SetCenterOfMassTolerance(bound / share, 0.0);
    mass->Update();
    Check("the bound is that of rounding", bound, mass->GetCenterOfMassBound(), 1e-3 * bound);
    CheckEqual("status at the bound over " + std::to_string(share),
      share < 500.0 ? names::StatusOk : names::StatusToleranceNotMet, mass->GetStatus());
  }
}

/// Residuals of trim curves are measured: what they add to a bound is a part of BoundsMeasured.
void CheckMeasured(const Expected& solid)
{
  std::printf("--- residuals are measured\n");
  Pipeline pipeline(solid.Path);
  pipeline.Reader->Update();
  auto* leaf = vtkNURBSDataSet::SafeDownCast(
    pipeline.Reader->GetOutput()->GetPartitionedDataSet(0)->GetPartitionAsDataObject(0));
  double bounds[2][4];
  double measured[2][4];
  for (int run = 0; run < 2; ++run)
  {
    vtkNew<vtkNURBSDataSet> input;
    input->ShallowCopy(leaf);
    vtkNew<vtkTrimmedNURBSModel> model;
    model->ShallowCopy(leaf->GetModel());
    for (int f = 0; f < model->GetNumberOfFaces() && run > 0; ++f)
    {
      auto face = std::make_shared<sm::Face>(*model->GetFaces()[f]);
      face->Id = sm::NewId();
      for (sm::Loop& loop : face->Loops)
      {
        for (sm::Coedge& coedge : loop.Coedges)
        {
          coedge.Curve.AddResidual(0, 1e-7);
          coedge.Curve.AddResidual(1, 1e-7);
        }
      }
      model->SetFace(f, face);
    }
    input->SetModel(model);
    vtkNew<vtkMassPropertiesGPU> mass;
    mass->SetBackend(vtkMassPropertiesGPU::CPU);
    mass->SetInputData(input);
    mass->Update();
    vtkFieldData* fields = mass->GetOutput()->GetFieldData();
    for (int i = 0; i < 4; ++i)
    {
      bounds[run][i] = GetFieldBound(fields, Quantities[i]);
      measured[run][i] = GetField(fields, names::BoundsMeasured, i);
    }
  }
  // The volume changes by the square of the residuals alone; the closing of the chain takes the rest.
  for (int i = 0; i < 2; ++i)
  {
    const double more = bounds[1][i] - bounds[0][i];
    CheckTrue(std::string(Quantities[i]) + ": the bound grows", more > 0.0, std::to_string(more));
    Check("  and so does its measured part", more, measured[1][i] - measured[0][i], 1e-6 * more);
  }
}

void CheckSeconds(const Expected& solid)
{
  std::printf("--- seconds\n");
  Pipeline pipeline(solid.Path);
  vtkMassPropertiesGPU* mass = pipeline.Mass;
  MessageTrap trap(mass);
  mass->SetMaximumSeconds(1e-9);
  mass->Update();
  CheckEqual("no time", names::StatusNotComputed, mass->GetStatus());
  CheckTrue(
    "and it says so", mass->GetMessage(0).find("maximum seconds") != std::string::npos, mass->GetMessage(0));
  mass->SetMaximumSeconds(0.0);
  mass->Update();
  CheckEqual("all the time", names::StatusOk, mass->GetStatus());
}

bool SameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && !a.empty() &&
    std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Values and bounds of everything in the field data.
std::vector<double> Collect(vtkMassPropertiesGPU* mass)
{
  std::vector<double> values;
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  for (const char* name : { names::Volume, names::SurfaceArea, names::CenterOfMass, names::FirstMoments,
         names::SecondMoments, names::VolumeInertia, names::PrincipalMoments, names::RadiiOfGyration,
         names::GapSquared, names::ClosureResidual })
  {
    vtkDataArray* array = fields->GetArray(name);
    for (int i = 0; array && i < array->GetNumberOfComponents(); ++i)
    {
      values.push_back(array->GetComponent(0, i));
    }
    values.push_back(GetFieldBound(fields, name));
  }
  return values;
}

void CheckBits(const Expected& solid, int backend)
{
  std::printf("--- the same bits, backend %d\n", backend);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(solid.Path.c_str());
  reader->Update();
  auto* leaf = vtkNURBSDataSet::SafeDownCast(
    vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0))
      ->GetPartitionAsDataObject(0, 0));
  if (!CheckTrue("a leaf", leaf != nullptr))
  {
    return;
  }
  const auto weigh = [backend](vtkMassPropertiesGPU* mass, vtkNURBSDataSet* input)
  {
    mass->SetBackend(backend);
    mass->SetInputData(input);
    mass->Modified();
    mass->Update();
    return Collect(mass);
  };
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  const std::vector<double> first = weigh(mass, leaf);
  const vtkTypeInt64 all = mass->GetEvaluations();
  CheckTrue("again", SameBits(first, weigh(mass, leaf)));
  CheckEqual("known faces cost nothing", 0, mass->GetEvaluations());
  mass->CacheFaceResultsOff();
  CheckTrue("all over again", SameBits(first, weigh(mass, leaf)));
  CheckEqual("for all of it", all, mass->GetEvaluations());
  mass->CacheFaceResultsOn();

  // One control point of one face moves: the filter that knows the other faces, and one that knows none.
  vtkNew<vtkNURBSDataSet> edited;
  edited->ShallowCopy(leaf);
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(leaf->GetModel());
  auto face = std::make_shared<sm::Face>(*model->GetFaces()[0]);
  face->Id = sm::NewId();
  std::array<double, 4>& point = face->Surface.ControlPoints[face->Surface.ControlPoints.size() / 2];
  point[2] += 1e-3 * solid.Size * point[3];
  model->SetFace(0, face);
  edited->SetModel(model);
  const std::vector<double> incremental = weigh(mass, edited);
  vtkNew<vtkMassPropertiesGPU> fresh;
  MessageTrap freshTrap(fresh);
  const std::vector<double> full = weigh(fresh, edited);
  CheckTrue("an edit changes something", !SameBits(first, incremental));
  CheckTrue("an edit gives the bits of a full run", SameBits(full, incremental));
  CheckTrue("undone, those of the first", SameBits(first, weigh(mass, leaf)));
}
}

int TestMassPropertiesTolerance(int argc, char* argv[])
{
  if (argc != 2)
  {
    return 2;
  }
  const Manifest manifest(argv[1]);
  const Expected ring = manifest.GetSolid("spline_ring", "plain").front();
  CheckSingleTolerances(ring);
  CheckSeconds(ring);
  CheckSlender();
  CheckMeasured(ring);
  CheckBits(ring, vtkMassPropertiesGPU::OPENGL);
  CheckBits(ring, vtkMassPropertiesGPU::CPU);
  CheckBits(manifest.GetSolid("gear", "plain").front(), vtkMassPropertiesGPU::OPENGL);
  return Finish();
}
