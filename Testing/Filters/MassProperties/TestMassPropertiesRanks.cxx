// Under mpirun: faces shared among ranks give the bits of one process, put out once; edits, budgets, aborts
// and ranks that cannot take part. Every rank runs this program; the first has the bodies.
#include "smRankComparison.h"
#include "smRatedFilter.h"

#include <vtkComputeContext.h>
#include <vtkDataSetAttributes.h>
#include <vtkNURBSDeform.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#if __has_include(<vtkBuoyancy.h>)
#include <vtkBuoyancy.h>
#define HAS_BUOYANCY
#endif
#if __has_include(<vtkSchemeMassPropertiesGPU.h>)
#include <vtkSchemeMassPropertiesGPU.h>
#define HAS_MOMENT_SCHEMES
#endif

#include <functional>

namespace
{
using namespace smtest;
namespace names = sm::names;

void TestValues(const std::vector<std::string>& files, int backend)
{
  for (const std::string& file : files)
  {
    const std::string name = file.substr(file.rfind('/') + 1);
    Pair pair(file, backend);
    pair.Compare(name, 1);
    CheckTrue(name + ": backend",
      rank != 0 ||
        pair.Shared.Mass->GetBackendName() == (backend == vtkSurfaceIntegralGPU::CPU ? "cpu" : "opengl"),
      pair.Shared.Mass->GetBackendName());
    // At another tolerance every face is planned and integrated again, where it was before.
    pair.Shared.Mass->SetRelativeTolerance(1e-6);
    pair.Alone.Mass->SetRelativeTolerance(1e-6);
    pair.Compare(name + " at 1e-6", 1);
    pair.Shared.Mass->SetMaximumEvaluations(1);
    pair.Alone.Mass->SetMaximumEvaluations(1);
    pair.Compare(name + " at 1 evaluation", 1);
  }
  // One with as many faces as there are ranks, and more.
  Pair again(files.front(), backend);
  again.Compare("the first again", ranks);
}

void TestEdits(const std::string& file)
{
  Pair pair(file, vtkSurfaceIntegralGPU::AUTOMATIC);
  vtkNew<vtkNURBSDeform> deform[2];
  Pipeline* pipelines[2] = { &pair.Shared, &pair.Alone };
  for (int i = 0; i < 2; ++i)
  {
    deform[i]->SetInputConnection(pipelines[i]->Reader->GetOutputPort());
    pipelines[i]->Mass->SetInputConnection(deform[i]->GetOutputPort());
    deform[i]->SetRadius(12.0);
  }
  pair.Compare("before the edit", ranks);
  const vtkTypeInt64 all = pair.Shared.Mass->GetEvaluations();
  // Back to the first, whose faces are remembered.
  for (const double dz : { 0.5, 0.7, 0.0 })
  {
    for (int i = 0; i < 2; ++i)
    {
      deform[i]->SetDisplacement(0.0, 0.0, dz);
    }
    const std::string what = "moved by " + std::to_string(dz);
    pair.Compare(what, 1);
    const vtkTypeInt64 some = pair.Shared.Mass->GetEvaluations();
    CheckTrue(what + ": only what changed is evaluated", rank != 0 || some < all,
      std::to_string(some) + " of " + std::to_string(all));
  }
}

/// Calls back at every progress.
struct Watch
{
  vtkNew<vtkCallbackCommand> Callback;
  std::function<void(double)> Then;
  Watch(vtkAlgorithm* filter, std::function<void(double)> then)
    : Then(std::move(then))
  {
    this->Callback->SetClientData(this);
    this->Callback->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { static_cast<Watch*>(self)->Then(vtkAlgorithm::SafeDownCast(caller)->GetProgress()); });
    filter->AddObserver(vtkCommand::ProgressEvent, this->Callback);
  }
};

void TestLimits(const std::string& file)
{
  countsDiffer = true;
  {
    Pair pair(file, vtkSurfaceIntegralGPU::AUTOMATIC);
    pair.Shared.Mass->SetMaximumSeconds(1e-9);
    UpdateTogether(pair.Shared.Mass);
    CheckTrue("no time: said", rank != 0 || Says(pair.Shared.Mass, "the maximum seconds were over"),
      GetMessages(pair.Shared.Mass));
    CheckTrue("no time: nothing computed", rank != 0 || std::isnan(pair.Shared.Mass->GetVolume()));
    pair.Shared.Mass->SetMaximumSeconds(0.0);
    pair.Compare("time again", ranks);
  }
  // Stopped before and while integrating, by the first rank and by the last.
  for (const int who : { 0, ranks - 1 })
  {
    for (const double when : { 0.1, 0.6 })
    {
      Pair pair(file, vtkSurfaceIntegralGPU::CPU);
      Watch watch(pair.Shared.Mass,
        [&](double fraction)
        {
          // Not the 1 that the executive reports after the run.
          if (rank == who && fraction >= when && fraction < 1.0)
          {
            pair.Shared.Mass->SetAbortExecute(1);
          }
        });
      const std::string what = "stopped by rank " + std::to_string(who) + " at " + std::to_string(when);
      UpdateTogether(pair.Shared.Mass);
      if (rank == 0)
      {
        CheckTrue(what + ": said", Says(pair.Shared.Mass, "aborted"), GetMessages(pair.Shared.Mass));
        // Before the orders are planned nothing is computed, later what was integrated counts.
        CheckEqual(what + ": status",
          when < 0.5 ? sm::names::StatusNotComputed : sm::names::StatusToleranceNotMet,
          pair.Shared.Mass->GetStatus());
      }
      // Whoever was stopped runs again when all do.
      watch.Then = [](double) {};
      pair.Shared.Mass->SetRelativeTolerance(1e-10);
      pair.Alone.Mass->SetRelativeTolerance(1e-10);
      pair.Compare(what + ", then again", ranks);
    }
  }
}

/// The last rank has no OpenGL: `backend` decides whether the run fails or goes on.
void TestNoOpenGL(const std::string& file, int backend)
{
  if (rank == ranks - 1)
  {
    setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
  }
  Pipeline shared(file);
  shared.Mass->SetController(controller);
  shared.Mass->SetBackend(backend);
  // With a source of its own AUTOMATIC takes a software renderer, too.
  shared.Mass->GetComputeContext()->SetSource(vtkComputeContext::EGL);
  MessageTrap trap(shared.Mass);
  UpdateTogether(shared.Mass);
  CheckEqual("errors", 0, trap.NumberOfErrors);
  if (rank != 0)
  {
    CheckEmpty("another rank", shared.Mass);
    CheckEqual("its backend",
      rank < ranks - 1                             ? "opengl"
        : backend == vtkSurfaceIntegralGPU::OPENGL ? "none"
                                                   : "cpu",
      shared.Mass->GetBackendName());
    return;
  }
  const std::string last = "rank " + std::to_string(ranks - 1);
  Pipeline alone(file);
  alone.Mass->SetController(nullptr);
  alone.Mass->Update();
  CheckEqual("status", "ok", shared.Mass->GetStatus());
  if (backend == vtkSurfaceIntegralGPU::OPENGL)
  {
    CheckTrue("said who did nothing", Says(shared.Mass, last + " integrated nothing, others did its share"),
      GetMessages(shared.Mass));
    CompareOutputs("the others", alone.Mass, shared.Mass);
    CheckEqual("ranks", ranks - 1, shared.Mass->GetNumberOfRanks());
    return;
  }
  CheckEqual("backend", "opengl+cpu", shared.Mass->GetBackendName());
  CheckTrue("said who computed on the CPU", Says(shared.Mass, last + " computed on the CPU, without OpenGL"),
    GetMessages(shared.Mass));
  CheckTrue("said that devices differ", Says(shared.Mass, "different devices"));
  CheckEqual("ranks", ranks, shared.Mass->GetNumberOfRanks());
  Check("volume", alone.Mass->GetVolume(), shared.Mass->GetVolume(),
    alone.Mass->GetVolumeBound() + shared.Mass->GetVolumeBound(), "the sum of the bounds");
}

/// All ranks take the backend that the one with the bodies prefers by its estimate: they seek a GPU, or make
/// no context.
void TestChoice(const std::string& file, bool prefersGPU)
{
  Pipeline pipeline(file);
  vtkNew<RatedFilter<vtkMassPropertiesGPU>> mass;
  mass->SetInputConnection(pipeline.Reader->GetOutputPort());
  mass->SetController(controller);
  mass->SetRates((rank == 0) == prefersGPU ? MakeGPURates(1e-9) : sm::BackendRates());
  UpdateTogether(mass);
  const int status = mass->GetComputeContext()->GetStatus();
  CheckTrue(prefersGPU ? "a GPU was sought" : "no GPU was sought",
    (status != vtkComputeContext::NOT_STARTED) == prefersGPU, std::to_string(status));
  CheckTrue("no rank differs", rank != 0 || !Says(mass, "different devices"), GetMessages(mass));
  CheckTrue("all took part", rank != 0 || mass->GetNumberOfRanks() == ranks);
}

/// The rank that has the bodies cannot compute: the others are not kept waiting.
void TestNothing(const std::string& file)
{
  if (rank == 0)
  {
    setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
  }
  Pipeline mass(file);
  mass.Mass->SetController(controller);
  mass.Mass->SetBackend(vtkSurfaceIntegralGPU::OPENGL);
  UpdateTogether(mass.Mass);
  CheckEqual("without OpenGL: ranks", 0, mass.Mass->GetNumberOfRanks());
  CheckTrue(
    "without OpenGL: said", rank != 0 || Says(mass.Mass, "nothing was computed"), GetMessages(mass.Mass));
  mass.Mass->SetBackend(vtkSurfaceIntegralGPU::CPU);
  UpdateTogether(mass.Mass);
  CheckEqual("then on the CPU: ranks", rank == 0 ? ranks : 0, mass.Mass->GetNumberOfRanks());

  // No integrand, and none that the CPU can evaluate.
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetInputConnection(mass.Reader->GetOutputPort());
  integral->SetController(controller);
  integral->SetBackend(vtkSurfaceIntegralGPU::CPU);
  UpdateTogether(integral);
  CheckTrue(
    "no integrand: said", rank != 0 || Says(integral, "there is no integrand"), GetMessages(integral));
  integral->AddIntegrand("wave", "sin(position.x) * dA");
  UpdateTogether(integral);
  CheckTrue("an expression on the CPU: said", rank != 0 || Says(integral, "wave was not computed"),
    GetMessages(integral));
  integral->AddVolumeMoment("volume", 0, 0, 0);
  UpdateTogether(integral);
  CheckEqual("and a moment: ranks", rank == 0 ? ranks : 0, integral->GetNumberOfRanks());
}

void CompareIntegrals(const std::string& what, const std::string& file, bool isOdd)
{
  // Each rank is given its integrands by itself.
  const auto make = [&](vtkSurfaceIntegralGPU* filter, double scale)
  {
    filter->AddConstant("k", scale);
    filter->AddIntegrand("wave", "sin(k * position.x) * dA");
    filter->AddVolumeMoment("x4", 4, 0, 0);
    filter->AddBendingEnergy("bending");
  };
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkSurfaceIntegralGPU> shared;
  shared->SetInputConnection(reader->GetOutputPort());
  shared->SetController(controller);
  make(shared, isOdd && rank == ranks - 1 ? 0.3 : 0.2);
  UpdateTogether(shared);
  if (rank != 0)
  {
    CheckEmpty(what, shared);
    return;
  }
  vtkNew<vtkSurfaceIntegralGPU> alone;
  alone->SetInputConnection(reader->GetOutputPort());
  alone->SetController(nullptr);
  make(alone, 0.2);
  alone->Update();
  CompareOutputs(what, alone, shared);
  CheckEqual(what + ": ranks", isOdd ? ranks - 1 : ranks, shared->GetNumberOfRanks());
  CheckTrue(what + ": said", !isOdd || Says(shared, "its integrands are not the same"), GetMessages(shared));
}

#ifdef HAS_BUOYANCY
/// The rank that has the bodies integrates what is below a plane; the others do not wait for it, and share
/// the next filter's faces.
void CompareBuoyancy(const std::string& what, const std::string& file, bool isFollowed)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkBuoyancy> shared;
  vtkNew<vtkBuoyancy> alone;
  for (vtkBuoyancy* filter : { shared.Get(), alone.Get() })
  {
    filter->SetInputConnection(reader->GetOutputPort());
    filter->SetController(filter == shared ? controller : nullptr);
    filter->SetPoint(0.0, 0.0, 3.0);
    filter->SetNormal(0.1, 0.0, 1.0);
  }
  vtkNew<vtkSurfaceIntegralGPU> volume;
  volume->SetInputConnection(reader->GetOutputPort());
  volume->SetController(controller);
  volume->AddVolumeMoment("volume", 0, 0, 0);
  UpdateTogether(shared);
  if (isFollowed)
  {
    UpdateTogether(volume);
    CheckEqual(what + ": ranks of the volume", rank == 0 ? ranks : 0, volume->GetNumberOfRanks());
  }
  if (rank != 0)
  {
    CheckEmpty(what, shared);
    return;
  }
  alone->Update();
  CompareOutputs(what, alone, shared);
  CheckTrue(what + ": something is below", shared->GetDisplacedVolume() > 1.0,
    std::to_string(shared->GetDisplacedVolume()));
  CheckEqual(what + ": ranks", 1, shared->GetNumberOfRanks());
}
#endif

/// Solids are chosen where they are; none chosen keeps nobody waiting.
void CompareChosen(const std::string& file)
{
  Pair pair(file, vtkSurfaceIntegralGPU::AUTOMATIC);
  for (const char* selector : { "//Bolt", "//NoSuchNode" })
  {
    for (Pipeline* pipeline : { &pair.Shared, &pair.Alone })
    {
      pipeline->Mass->ClearSelectors();
      pipeline->Mass->AddSelector(selector);
    }
    pair.Compare(std::string("chosen by ") + selector, 0);
    pair.Shared.Mass->ClearSelectors();
    pair.Alone.Mass->ClearSelectors();
    pair.Compare("all again", 1);
  }
}

/// Inputs that are not on the first rank alone.
void TestInputs(const std::string& file, const std::string& nothing)
{
  {
    // A plain Update() is for the calling rank.
    Pipeline one(file);
    one.Mass->SetController(controller);
    if (rank == 0)
    {
      one.Mass->Update();
      CheckEqual("alone: status", "ok", one.Mass->GetStatus());
      CheckEqual("alone: ranks", 1, one.Mass->GetNumberOfRanks());
    }
  }
  {
    // All have it: each its own.
    Pipeline all(file);
    all.Mass->SetController(controller);
    all.Reader->UpdatePiece(0, 1, 0);
    all.Mass->SetInputDataObject(all.Reader->GetOutputDataObject(0));
    UpdateTogether(all.Mass);
    CheckEqual("all have it: status", "ok", all.Mass->GetStatus());
    CheckTrue("all have it: said", Says(all.Mass, std::to_string(ranks) + " ranks have bodies"),
      GetMessages(all.Mass));
  }
  {
    // The last has it.
    Pipeline last(file);
    last.Mass->SetController(controller);
    last.Reader->UpdatePiece(rank == ranks - 1 ? 0 : 1, 2, 0);
    last.Mass->SetInputDataObject(last.Reader->GetOutputDataObject(0));
    UpdateTogether(last.Mass);
    CheckEqual("the last has it: ranks", rank == ranks - 1 ? ranks : 0, last.Mass->GetNumberOfRanks());
  }
  {
    // Nobody has anything: said once.
    Pipeline empty(nothing);
    empty.Mass->SetController(controller);
    MessageTrap reader(empty.Reader);
    MessageTrap trap(empty.Mass);
    UpdateTogether(empty.Mass);
    CheckEqual("nothing: said", rank == 0 ? 1 : 0, empty.Mass->GetNumberOfMessages());
  }
  {
    // A mesh without exact geometry on one rank: it is rejected there, and a second update does not wait for
    // the others.
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.0);
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPartitionedDataSetCollection> none;
    mesh->SetPoints(points);
    vtkNew<vtkMassPropertiesGPU> mass;
    mass->SetController(controller);
    if (rank == 0)
    {
      mass->SetInputDataObject(mesh);
    }
    else
    {
      mass->SetInputDataObject(none);
    }
    MessageTrap trap(mass);
    MessageTrap executive(mass->GetExecutive());
    for (int run = 0; run < 2; ++run)
    {
      UpdateTogether(mass);
      CheckEqual("a mesh: status", rank == 0 ? names::StatusEmpty : "", mass->GetStatus());
    }
    CheckEqual("a mesh: errors", rank == 0 ? 1 : 0, trap.NumberOfErrors);
    CheckEqual("a mesh: errors of the pipeline, whose filters run on all ranks or on none", 0,
      executive.NumberOfErrors);
  }
#ifdef HAS_MOMENT_SCHEMES
  {
    // The paper's schemes stay on one rank.
    vtkNew<vtkSTEPReader> reader;
    reader->SetFileName(file.c_str());
    vtkNew<vtkSchemeMassPropertiesGPU> scheme;
    scheme->SetInputConnection(reader->GetOutputPort());
    scheme->SetController(controller);
    UpdateTogether(scheme);
    CheckEqual("scheme: ranks", rank == 0 ? 1 : 0, scheme->GetNumberOfRanks());
  }
#endif
}

void RunMode(const std::string& mode, const std::vector<std::string>& files)
{
  if (mode == "opengl" || mode == "cpu")
  {
    TestValues(files, mode == "cpu" ? vtkSurfaceIntegralGPU::CPU : vtkSurfaceIntegralGPU::OPENGL);
  }
  else if (mode == "edits")
  {
    TestEdits(files.at(0));
  }
  else if (mode == "limits")
  {
    TestLimits(files.at(0));
  }
  else if (mode == "mixed" || mode == "without")
  {
    TestNoOpenGL(
      files.at(0), mode == "mixed" ? vtkSurfaceIntegralGPU::AUTOMATIC : vtkSurfaceIntegralGPU::OPENGL);
  }
  else if (mode == "choice")
  {
    TestChoice(files.at(0), false);
    TestChoice(files.at(0), true);
  }
  else if (mode == "nothing")
  {
    TestNothing(files.at(0));
  }
  else if (mode == "integrals")
  {
    CompareIntegrals("equal integrands", files.at(0), false);
    CompareIntegrals("one rank has others", files.at(0), true);
#ifdef HAS_BUOYANCY
    CompareBuoyancy("buoyancy alone", files.at(0), false);
    CompareBuoyancy("buoyancy before a volume", files.at(0), true);
#endif
    CompareChosen(files.at(1));
  }
  else if (mode == "inputs")
  {
    TestInputs(files.at(0), files.at(1));
  }
}
}

int main(int argc, char* argv[])
{
  const auto checks = [&]()
  { RunMode(argc > 1 ? argv[1] : "", std::vector<std::string>(argv + std::min(argc, 2), argv + argc)); };
  return RunOnRanks(argc, argv, checks);
}
