// TestMassPropertiesBackends FOLDER solids|device|options: the CPU and OpenGL compute the same.
//   solids    all exact solids: within the sum of both bounds, and to 1e-13
//   device    the same by what is for a GPU: a line for each node of a ribbon, programs for its degrees,
//   mapped memory options   the same bits for any number of threads; expressions, budget, abort and a change
//   of backend
#include "smBackendComparison.h"
#include "smTestManifest.h"
#include "smWrongSamples.h"

#include <vtkSMPTools.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

#include <cstdio>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Moments and bounds, for a comparison bit for bit.
std::vector<double> GetAll(vtkMassPropertiesGPU* mass)
{
  std::vector<double> all;
  for (const char* name : { names::Volume, names::SurfaceArea, names::CenterOfMass, names::VolumeInertia,
         names::GapSquared, names::MaxGap, names::GapArea, names::ClosureCorrection, names::Evaluations })
  {
    for (const std::string& full : { std::string(name), std::string(name) + names::BoundSuffix })
    {
      const std::vector<double> values = GetArray(mass, full);
      all.insert(all.end(), values.begin(), values.end());
    }
  }
  return all;
}

void CheckSolids(const std::string& folder, bool asDevice)
{
  const Manifest manifest(folder);
  vtkNew<vtkSTEPReader> reader;
  UseCoarseMesh(reader);
  for (const char* solid : { "box", "cylinder", "cone", "sphere", "torus", "slanted_hole", "bicylinder",
         "hollow_sphere", "ellipsoid", "airfoil", "gear", "spline_ring", "wavy_plate" })
  {
    for (const Expected& expected : manifest.GetSolid(solid))
    {
      // Two sums of a million roundings: 1e-13. Far from the origin of the file nothing is worse, for moments
      // are local.
      reader->SetFileName(expected.Path.c_str());
      CompareBackends(reader, 1e-13, asDevice);
    }
  }
}

void CheckThreads(const std::string& path)
{
  std::printf("--- threads\n");
  std::vector<double> first;
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    Pipeline pipeline(path);
    pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
    pipeline.Mass->Update();
    const std::string renderer = pipeline.Mass->GetRenderer();
    const int actual = vtkSMPTools::GetEstimatedNumberOfThreads();
    CheckTrue("renderer",
      renderer == "CPU, " + std::to_string(actual) + (actual == 1 ? " thread" : " threads"), renderer);
    CheckTrue("volume", pipeline.Mass->GetVolume() > 0.0);
    const std::vector<double> all = GetAll(pipeline.Mass);
    first = first.empty() ? all : first;
    CheckTrue("same bits for any number of threads", all == first && all.size() > 20);
  }
}

void CheckExpression(const Expected& box)
{
  std::printf("--- an expression on the CPU\n");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(box.Path.c_str());
  vtkNew<vtkSurfaceIntegralGPU> integral;
  MessageTrap trap(integral);
  integral->SetInputConnection(reader->GetOutputPort());
  integral->SetBackend(vtkSurfaceIntegralGPU::CPU);
  integral->AddAreaMoment("A", 0, 0, 0);
  integral->AddIntegrand("mine", "length(normal)");
  integral->AddVolumeMoment("Vxyz", 1, 1, 1);
  integral->Update();
  CheckEqual("status", names::StatusNotComputed, integral->GetStatus());
  CheckTrue("the expression is NaN",
    std::isnan(integral->GetIntegral("mine")) && std::isnan(integral->GetIntegralBound("mine")));
  const std::string messages = GetMessages(integral);
  CheckTrue("it is named, with the remedy",
    messages.find("mine was not computed") != std::string::npos &&
      messages.find("needs OpenGL 4.3 with doubles") != std::string::npos,
    messages);
  Check("the area is computed", box.Area, integral->GetIntegral("A"), 1e-9 * box.Area);
  // A box 30 x 20 x 10 in a corner.
  const double exact = 30.0 * 30 * 20 * 20 * 10 * 10 / 8;
  Check("and the placed moment", exact, integral->GetIntegral("Vxyz"), 1e-12 * exact);
  auto* faces = vtkTable::SafeDownCast(integral->GetOutputDataObject(3));
  CheckTrue("NaN face by face",
    faces && faces->GetNumberOfRows() == 6 && std::isnan(faces->GetValueByName(0, "mine").ToDouble()));

  integral->SetBackend(vtkSurfaceIntegralGPU::OPENGL);
  integral->Update();
  CheckEqual("with OpenGL", names::StatusOk, integral->GetStatus());
  Check("the expression", box.Area, integral->GetIntegral("mine"), 1e-9 * box.Area);
  Check("the placed moment", exact, integral->GetIntegral("Vxyz"), 1e-12 * exact);

  integral->SetBackend(vtkSurfaceIntegralGPU::CPU);
  integral->RemoveAllIntegrands();
  integral->AddIntegrand("mine", "length(normal)");
  integral->Update();
  CheckTrue("alone it is NaN, too",
    std::isnan(integral->GetIntegral("mine")) && integral->GetStatus() == names::StatusNotComputed);
}

void CheckBudgetAndAbort(const std::string& ring)
{
  std::printf("--- budget, abort, perturbation on the CPU\n");
  Pipeline exact(ring);
  exact.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  exact.Mass->Update();
  CheckEqual("status", names::StatusOk, exact.Mass->GetStatus());

  Pipeline pipeline(ring);
  MessageTrap trap(pipeline.Mass);
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  pipeline.Mass->SetMaximumEvaluations(1);
  pipeline.Mass->Update();
  CheckEqual("a spent budget", names::StatusToleranceNotMet, pipeline.Mass->GetStatus());
  CheckTrue("spends less", pipeline.Mass->GetEvaluations() < exact.Mass->GetEvaluations());
  CheckRange("its error over its bound", 0.0,
    std::fabs(pipeline.Mass->GetVolume() - exact.Mass->GetVolume()) / pipeline.Mass->GetVolumeBound(), 1.0);

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* mass = static_cast<vtkMassPropertiesGPU*>(filter);
      // Past cutting: while items run.
      mass->SetAbortExecute(mass->GetProgress() >= 0.5 ? 1 : 0);
    });
  pipeline.Mass->SetMaximumEvaluations(1000000000);
  const unsigned long tag = pipeline.Mass->AddObserver(vtkCommand::ProgressEvent, stop);
  pipeline.Mass->Update();
  CheckTrue(
    "an aborted run does not reach all of the volume", pipeline.Mass->GetVolume() < exact.Mass->GetVolume());
  CheckRange("but bounds it", 0.0,
    std::fabs(pipeline.Mass->GetVolume() - exact.Mass->GetVolume()) / pipeline.Mass->GetVolumeBound(), 1.0);
  CheckEqual("flagged", names::StatusToleranceNotMet, pipeline.Mass->GetStatus());
  CheckTrue("and says so",
    pipeline.Mass->GetNumberOfMessages() > 0 &&
      pipeline.Mass->GetMessage(0) == "the run was aborted before all faces were integrated");
  pipeline.Mass->RemoveObserver(tag);
  pipeline.Mass->Modified();
  pipeline.Mass->Update();
  CheckTrue("the next run has the same bits", GetAll(pipeline.Mass) == GetAll(exact.Mass));

  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::OPENGL);
  pipeline.Mass->Update();
  CheckEqual("a change of backend", names::BackendOpenGL, pipeline.Mass->GetBackendName());
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  pipeline.Mass->Update();
  CheckTrue("and back: the same bits", GetAll(pipeline.Mass) == GetAll(exact.Mass));

  const WrongSamples wrong(pipeline.Mass, 1.0 + 1.0 / 1024);
  pipeline.Mass->Update();
  Check("perturbed samples", exact.Mass->GetVolume() * (1.0 + 1.0 / 1024), pipeline.Mass->GetVolume(),
    1e-12 * exact.Mass->GetVolume());
  pipeline.Mass->SetBackend(17);
  CheckEqual("a backend out of range is clamped", vtkMassPropertiesGPU::CPU, pipeline.Mass->GetBackend());
}
}

int TestMassPropertiesBackends(int argc, char* argv[])
{
  RequireUsage(argc >= 3, "TestMassPropertiesBackends FOLDER solids|device|options");
  vtkSMPTools::SetBackend("STDThread");
  const std::string folder = argv[1];
  const std::string mode = argv[2];
  if (mode == "solids" || mode == "device")
  {
    CheckSolids(folder, mode == "device");
  }
  else if (mode == "options")
  {
    CheckThreads(folder + "/gear-plain.step");
    CheckThreads(folder + "/slanted_hole-moved.step");
    vtkSMPTools::Initialize(0);
    CheckExpression(Manifest(folder).GetSolid("box", "plain")[0]);
    CheckBudgetAndAbort(folder + "/spline_ring-plain.step");
  }
  return Finish();
}
