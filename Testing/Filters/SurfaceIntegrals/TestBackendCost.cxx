// TestBackendCost FOLDER PART: the estimate of what a run takes, and the backend that AUTOMATIC takes by it.
#include "smLatticeBody.h"
#include "smRatedFilter.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkComputeContext.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkSurfaceIntegralGPU.h>

namespace
{
using namespace smtest;
namespace names = sm::names;
using RatedMass = RatedFilter<vtkMassPropertiesGPU>;

double GetCPUSeconds(const sm::RunSize& size, std::size_t integrands, int threads, int lanes)
{
  return sm::EstimateBackends(size, integrands, { threads, lanes }, {}).CPUSeconds;
}

double GetGPUSeconds(const sm::RunSize& size, std::size_t integrands)
{
  return sm::EstimateBackends(size, integrands, { 2, 8 }, {}).OpenGLSeconds;
}

void CheckModel()
{
  std::printf("--- the model\n");
  const sm::RunSize small{ 1e5, 1e5 };
  const sm::RunSize huge{ 1e9, 1e8 };
  for (const int threads : { 1, 2 })
  {
    for (const int lanes : { 1, 2, 4, 8 })
    {
      CheckTrue(
        "a small run is the CPU's", !sm::EstimateBackends(small, 14, { threads, lanes }, {}).PrefersOpenGL());
      CheckTrue(
        "a huge one is a GPU's", sm::EstimateBackends(huge, 14, { threads, lanes }, {}).PrefersOpenGL());
    }
  }
  const sm::BackendRates rates;
  CheckTrue("a GPU is started first", GetGPUSeconds({}, 14) >= rates.ContextSeconds + rates.ProgramSeconds);
  CheckTrue("the CPU is not", GetCPUSeconds({}, 14, 1, 1) < 0.01);
  for (const double evaluations : { 1e4, 1e5, 1e6, 1e7, 1e8 })
  {
    const sm::RunSize size{ evaluations, 1e6 };
    const sm::RunSize more{ 2.0 * evaluations, 1e6 };
    CheckTrue("more evaluations, more seconds",
      GetCPUSeconds(more, 14, 2, 8) > GetCPUSeconds(size, 14, 2, 8) &&
        GetGPUSeconds(more, 14) > GetGPUSeconds(size, 14));
    CheckTrue("more integrands, more seconds",
      GetCPUSeconds(size, 84, 2, 8) > GetCPUSeconds(size, 14, 2, 8) &&
        GetGPUSeconds(size, 84) > GetGPUSeconds(size, 14));
    CheckTrue("more bytes, more seconds", GetGPUSeconds({ evaluations, 1e9 }, 14) > GetGPUSeconds(size, 14));
    CheckTrue("more threads, fewer seconds", GetCPUSeconds(size, 14, 4, 8) < GetCPUSeconds(size, 14, 2, 8));
    CheckTrue("more lanes, fewer seconds",
      GetCPUSeconds(size, 14, 2, 8) < GetCPUSeconds(size, 14, 2, 4) &&
        GetCPUSeconds(size, 14, 2, 4) < GetCPUSeconds(size, 14, 2, 2) &&
        GetCPUSeconds(size, 14, 2, 2) < GetCPUSeconds(size, 14, 2, 1));
  }
}

void CheckEvaluations(const std::string& path, double factor)
{
  Pipeline pipeline(path);
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  pipeline.Mass->Update();
  const auto actual = static_cast<double>(pipeline.Mass->GetEvaluations());
  const double estimated = pipeline.Mass->GetEstimatedEvaluations();
  std::printf("%s\n", path.c_str());
  CheckRange("evaluations that were estimated", actual / factor, estimated, factor * actual);
  CheckEqual("the backend was chosen", "", pipeline.Mass->GetBackendReason());
}

/// What AUTOMATIC takes where it seeks a GPU.
struct Sought
{
  std::string Backend = names::BackendCPU;
  std::string Reason = "no GPU; estimated ";

  Sought()
  {
    vtkNew<vtkComputeContext> context;
    if (context->StartOnGPU())
    {
      this->Backend = names::BackendOpenGL;
      this->Reason = "estimated ";
    }
  }
};

void CheckChoice(
  const std::string& what, RatedMass* mass, const std::string& backend, const std::string& reason)
{
  mass->Update();
  CheckEqual(what + ": backend", backend, mass->GetBackendName());
  CheckEqual(what + ": why", reason, mass->GetBackendReason().substr(0, reason.size()));
  CheckEqual(what + ": why, in the field data", mass->GetBackendReason(),
    GetFieldText(mass->GetOutput()->GetFieldData(), names::BackendReason));
  CheckEqual(what + ": status", names::StatusOk, mass->GetStatus());
}

void CheckFilter(const std::string& path)
{
  std::printf("--- the backend of a filter\n");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  UseCoarseMesh(reader);
  vtkNew<RatedMass> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  vtkComputeContext* context = mass->GetComputeContext();
  CheckChoice("a small part", mass, names::BackendCPU, "estimated ");
  CheckEqual("no context is made", vtkComputeContext::NOT_STARTED, context->GetStatus());
  CheckTrue("no message is made", !Says(mass, "without OpenGL"));
  CheckTrue("the seconds of both are reported",
    mass->GetBackendReason().find("; OpenGL ") != std::string::npos, mass->GetBackendReason());

  // A context that somebody has started changes nothing.
  CheckEqual("a context", vtkComputeContext::READY, context->Start());
  mass->SetRelativeTolerance(2e-9);
  CheckChoice("with a context that is ready", mass, names::BackendCPU, "estimated ");
  context->Stop();

  const Sought sought;
  mass->SetRates(MakeGPURates(1e-9));
  mass->Modified();
  CheckChoice("a slow processor", mass, sought.Backend, sought.Reason);
  CheckTrue("a context was sought", context->GetStatus() != vtkComputeContext::NOT_STARTED);
  CheckTrue("that there is no GPU is not a message", !Says(mass, "without OpenGL"));

  mass->SetRates({});
  vtkNew<vtkComputeContext> other;
  CheckEqual("a window", vtkComputeContext::READY, other->Start());
  mass->SetRenderWindow(other->GetRenderWindow());
  CheckChoice("a render window", mass, names::BackendOpenGL, "in the render window");
  mass->SetRenderWindow(nullptr);
  CheckChoice("none", mass, names::BackendCPU, "estimated ");
  context->SetSource(vtkComputeContext::EGL);
  mass->Modified();
  CheckChoice("a source", mass, names::BackendOpenGL, "a source was chosen");

  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetInputConnection(reader->GetOutputPort());
  integral->AddIntegrand("mine", "length(normal)");
  integral->Update();
  CheckEqual("an expression: backend", names::BackendOpenGL, integral->GetBackendName());
  CheckEqual("an expression: why", "expressions need OpenGL", integral->GetBackendReason());
}

/// The same choice for a full run, an edit of one face, and its undo, though the run of one face alone would
/// be the other backend's.
void CheckEdits()
{
  std::printf("--- edits\n");
  const auto leaf = LatticeBody().Make();
  vtkNew<RatedMass> mass;
  mass->SetInputData(leaf);
  mass->SetRates(MakeGPURates(0.0));
  mass->Update();
  // Half of the seconds of the slow processor for the whole body.
  const Sought sought;
  mass->SetRates(MakeGPURates(0.5 * mass->GetEstimatedSeconds(vtkMassPropertiesGPU::CPU)));
  mass->Modified();
  CheckChoice("full run", mass, sought.Backend, sought.Reason);
  const std::string reason = mass->GetBackendReason();
  const std::vector<double> first = GetFieldNumbers(mass);

  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(leaf->GetModel());
  auto face = std::make_shared<sm::Face>(*model->GetFaces()[5]);
  face->Id = sm::NewId();
  std::array<double, 4>& point = face->Surface.ControlPoints[face->Surface.ControlPoints.size() / 2];
  point[2] += 0.1 * point[3];
  model->SetFace(5, face);
  vtkNew<vtkNURBSDataSet> edited;
  edited->ShallowCopy(leaf);
  edited->SetModel(model);
  mass->SetInputData(edited);
  CheckChoice("edit", mass, sought.Backend, reason);
  vtkNew<vtkMassPropertiesGPU> fresh;
  fresh->SetBackend(
    sought.Backend == names::BackendCPU ? vtkMassPropertiesGPU::CPU : vtkMassPropertiesGPU::OPENGL);
  fresh->SetInputData(edited);
  fresh->Update();
  CheckTrue("only a part is evaluated",
    mass->GetEvaluations() > 0 && mass->GetEvaluations() < fresh->GetEvaluations(),
    std::to_string(mass->GetEvaluations()) + " of " + std::to_string(fresh->GetEvaluations()));
  CheckTrue("the bits of a full run", HaveSameBits(GetFieldNumbers(fresh), GetFieldNumbers(mass)));
  CheckTrue("other numbers", !HaveSameBits(first, GetFieldNumbers(mass)));

  mass->SetInputData(leaf);
  CheckChoice("undo", mass, sought.Backend, reason);
  CheckEqual("nothing is evaluated", 0, mass->GetEvaluations());
  CheckTrue("the bits of the full run", HaveSameBits(first, GetFieldNumbers(mass)));
}
}

int TestBackendCost(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestBackendCost FOLDER PART");
  const Manifest manifest(argv[1]);
  CheckModel();
  CheckEvaluations(argv[2], 4.0);
  for (const char* solid :
    { "cylinder", "cone", "sphere", "torus", "slanted_hole", "bicylinder", "airfoil", "gear" })
  {
    CheckEvaluations(manifest.GetSolid(solid)[0].Path, 4.0);
  }
  // A few faces that are much curved in both directions.
  for (const char* solid : { "ellipsoid", "spline_ring", "wavy_plate" })
  {
    CheckEvaluations(manifest.GetSolid(solid)[0].Path, 40.0);
  }
  CheckFilter(argv[2]);
  CheckEdits();
  return Finish();
}
