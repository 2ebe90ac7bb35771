// TestSurfaceIntegralMemory FOLDER failures|limits|release opengl|cpu: memory that is short while a filter
// runs, and memory that it gives back. An allocation that fails ends in a status, not in the end of the
// process, and the next run has the bits of an undisturbed one.
#include "smCacheBudget.h"
#include "smShortFilter.h"
#include "smTestManifest.h"

#include <vtkSMPTools.h>

#if __has_include(<vtkSchemeMassPropertiesGPU.h>)
#include <vtkSchemeMassPropertiesGPU.h>
#define HAS_MOMENT_SCHEMES
#endif

#include <cstdio>
#include <type_traits>

namespace
{
using namespace smtest;
namespace names = sm::names;

int Backend = vtkSurfaceIntegralBase::CPU;

bool AreSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return !a.empty() && a.size() == b.size() &&
    std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double GetValue(vtkMassPropertiesBase* filter)
{
  return filter->GetVolume();
}

double GetValue(vtkSurfaceIntegralGPU* filter)
{
  return filter->GetIntegral("volume");
}

#ifdef HAS_BUOYANCY
double GetValue(vtkBuoyancy* filter)
{
  return filter->GetDisplacedVolume();
}
#endif

/// Tolerances of filters that have one.
template <class Filter>
auto SetTolerance(Filter* filter, double tolerance, int) -> decltype(filter->SetRelativeTolerance(tolerance))
{
  filter->SetRelativeTolerance(tolerance);
}

template <class Filter>
void SetTolerance(Filter*, double, long)
{
}

/// A filter on a file, and what it computes undisturbed.
template <class Filter>
struct Subject
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<ShortFilter<Filter>> Probe;
  MessageTrap Trap{ Probe };
  std::vector<double> Undisturbed;
  std::string Status;

  explicit Subject(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    this->Probe->SetInputConnection(this->Reader->GetOutputPort());
    this->Probe->SetBackend(Backend);
    this->Probe->SetController(nullptr);
    SetUp(this->Probe);
    this->Run({});
    this->Undisturbed = GetFieldNumbers(this->Probe);
    this->Status = this->Probe->GetStatus();
    CheckTrue("it has values", std::isfinite(GetValue(this->Probe)), this->Status);
  }
  void Run(const Shortage& memory)
  {
    this->Probe->Memory = memory;
    this->Probe->Modified();
    this->Probe->Update();
  }
  /// A run with all that it has to do, short of memory, and one with enough. True when the first was not
  /// disturbed.
  bool CheckShortage(const std::string& what, const Shortage& memory)
  {
    if (Backend == vtkSurfaceIntegralBase::CPU)
    {
      this->Probe->ReleaseMemory();
    }
    else
    {
      // Plans anew with the shaders that are there: Mesa ends the process where it has no memory to compile.
      SetTolerance(this->Probe.Get(), 2e-9, 0);
    }
    this->Run(memory);
    const std::string status = this->Probe->GetStatus();
    const bool isWhole = status == this->Status && std::isfinite(GetValue(this->Probe));
    CheckTrue(what + ": no exception leaves it", !this->Probe->Memory.HasEscaped);
    CheckTrue(what + ": status", isWhole || status == names::StatusNotComputed, status);
    CheckEqual(what + ": status in the field data", status,
      GetFieldText(this->Probe->GetOutput()->GetFieldData(), names::Status));
    CheckTrue(what + ": values",
      !isWhole
        ? std::isnan(GetValue(this->Probe))
        : Backend != vtkSurfaceIntegralBase::CPU || AreSame(this->Undisturbed, GetFieldNumbers(this->Probe)));
    CheckTrue(what + ": it says why", isWhole || Says(this->Probe, "memory"), GetMessages(this->Probe));
    SetTolerance(this->Probe.Get(), 1e-9, 0);
    this->Run({});
    CheckTrue(what + ": then the bits of an undisturbed run",
      this->Probe->GetStatus() == this->Status && AreSame(this->Undisturbed, GetFieldNumbers(this->Probe)),
      this->Probe->GetStatus());
    return isWhole;
  }
};

/// Single allocations fail, one a run, evenly spread over a run.
template <class Filter>
void CheckFailures(const std::string& name, const std::string& path)
{
  std::printf("--- %s\n", name.c_str());
  Subject<Filter> subject(path);
  subject.Probe->ReleaseMemory();
  subject.Run({});
  const long count = subject.Probe->Memory.Allocations;
  constexpr int Runs = 40;
  int failed = 0;
  for (int i = 0; i < Runs; ++i)
  {
    Shortage memory;
    memory.Failing = 1 + i * (count - 1) / (Runs - 1);
    char label[80];
    std::snprintf(label, sizeof(label), "allocation %ld of %ld fails", memory.Failing, count);
    failed += subject.CheckShortage(label, memory) ? 0 : 1;
  }
  CheckRange("runs that were not computed", Runs / 2, failed, Runs);
}

/// Leaves less and less address space, down to none. Returns the number of runs that failed: a run on few
/// faces may find the memory that it needs in the heap.
template <class Filter>
int CheckLimits(const std::string& name, const std::string& path)
{
  std::printf("--- %s\n", name.c_str());
  Subject<Filter> subject(path);
  // Blocks from the system, so that what earlier runs gave back is not taken from the heap.
  mallopt(M_MMAP_THRESHOLD, 16 << 10);
  int failed = 0;
  // With OpenGL so little that planning fails, before Mesa asks for memory.
  const long maximum = Backend == vtkSurfaceIntegralBase::CPU ? 64L << 20 : 16L << 10;
  for (long headroom = maximum; headroom >= 4096; headroom /= 2)
  {
    Shortage memory;
    memory.Headroom = headroom;
    failed += subject.CheckShortage(std::to_string(headroom >> 10) + " KiB are left", memory) ? 0 : 1;
  }
  return failed;
}

/// ReleaseMemory() keeps outputs and getters; the next run evaluates all again, with the same bits.
template <class Filter>
void CheckRelease(const std::string& name, const std::string& path, bool hasCache)
{
  std::printf("--- %s\n", name.c_str());
  Subject<Filter> subject(path);
  ShortFilter<Filter>* filter = subject.Probe;
  const vtkTypeInt64 evaluations = filter->GetEvaluations();
  CheckTrue("evaluations of the first run", evaluations > 0);
  subject.Run({});
  CheckEqual("evaluations of the next", hasCache ? 0 : evaluations, filter->GetEvaluations());
  const double value = GetValue(filter);
  // All filters keep their data within one budget of the process, and this one is alone.
  const sm::CacheBudget& budget = sm::CacheBudget::GetProcessBudget();
  CheckTrue("what is kept counts in the budget of the process", budget.GetBytes() > 0);
  filter->ReleaseMemory();
  CheckEqual("bytes kept after the release", 0LL, static_cast<long long>(budget.GetBytes()));
  Check("the value stays", value, GetValue(filter), 0.0);
  CheckTrue("the output stays", AreSame(subject.Undisturbed, GetFieldNumbers(filter)));
  CheckEqual("the status stays", subject.Status, filter->GetStatus());
  filter->ReleaseDataFlagOn();
  for (int run = 0; run < 3; ++run)
  {
    subject.Run({});
    CheckTrue("the same bits without what was kept", AreSame(subject.Undisturbed, GetFieldNumbers(filter)));
    CheckEqual("evaluations", evaluations, filter->GetEvaluations());
  }
}
}

int main(int argc, char* argv[])
{
  RequireUsage(argc == 4, "TestSurfaceIntegralMemory FOLDER failures|limits|release opengl|cpu");
  const Manifest manifest(argv[1]);
  const std::string mode = argv[2];
  Backend = std::string(argv[3]) == "cpu" ? vtkSurfaceIntegralBase::CPU : vtkSurfaceIntegralBase::OPENGL;
  // Exceptions of other threads end the process.
  vtkSMPTools::SetBackend("Sequential");
  const std::string path = manifest.GetSolid("slanted_hole", "plain").front().Path;
  int failedByLimits = 0;
  const auto check = [&](const std::string& name, auto* type, bool hasCache)
  {
    using Filter = std::remove_pointer_t<decltype(type)>;
    if (mode == "failures")
    {
      CheckFailures<Filter>(name, path);
    }
    else if (mode == "limits")
    {
      failedByLimits += CheckLimits<Filter>(name, path);
    }
    else if (mode == "release")
    {
      CheckRelease<Filter>(name, path, hasCache);
    }
  };
  check("mass properties", static_cast<vtkMassPropertiesGPU*>(nullptr), true);
  check("integrals", static_cast<vtkSurfaceIntegralGPU*>(nullptr), true);
#ifdef HAS_BUOYANCY
  check("buoyancy", static_cast<vtkBuoyancy*>(nullptr), true);
#endif
#ifdef HAS_MOMENT_SCHEMES
  if (mode != "limits" || Backend == vtkSurfaceIntegralBase::CPU)
  {
    check("schemes", static_cast<vtkSchemeMassPropertiesGPU*>(nullptr), false);
  }
#endif
  if (mode == "limits")
  {
    CheckRange("runs that were not computed", 1, failedByLimits, 60);
  }
  return Finish();
}
