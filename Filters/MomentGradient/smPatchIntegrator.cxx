#include "Detail/smPatchIntegrator.h"

#include "smParallelFor.h"

#include "vtkSMPTools.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <iterator>

namespace sm
{
namespace
{
// Seconds of the processor below which starting a context and compiling shaders does not pay.
constexpr double DevicePays = 1.0;
// Seconds of a point for each polynomial in s and for itself, on one thread, as measured
// (Documentation/Gradients.md, Cost).
constexpr double SecondsOfPolynomial = 4e-8;
constexpr double SecondsOfPoint = 2e-7;
// Patches between two reports of progress.
constexpr std::size_t PatchesPerReport = 1024;
}

PatchIntegrator::PatchIntegrator(BackendChoice backend, vtkComputeContext* context)
  : Backend(backend)
  , Context(context)
{
}

bool PatchIntegrator::WantsDevice(const std::vector<PatchTask>& tasks)
{
  if (this->Backend == BackendChoice::CPU || this->HasFailed || tasks.empty())
  {
    return false;
  }
  double seconds = 0.0;
  for (const PatchTask& task : tasks)
  {
    for (const PlannedItem& item : task.Plan->Items)
    {
      seconds += static_cast<double>(item.Along) * item.Across *
        (SecondsOfPoint + SecondsOfPolynomial * (task.GetPatch().Degree[0] + 1));
    }
  }
  const bool isForced = this->Backend == BackendChoice::OpenGL;
  if (!isForced && seconds < DevicePays * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()))
  {
    return false;
  }
  if (!this->Context)
  {
    this->Context = vtkSmartPointer<vtkComputeContext>::New();
  }
  if (isForced || this->Context->StartOnGPU())
  {
    return true;
  }
  this->HasFailed = true;
  this->Reason = this->Context->GetStatus() <= vtkComputeContext::NO_CONTEXT
    ? "no GPU"
    : "no usable GPU: " + this->Context->GetReason();
  return false;
}

/// Returns false where the processor is to compute the integrals.
bool PatchIntegrator::ComputeOnDevice(const std::vector<PatchTask>& tasks, std::vector<PatchSums>& sums)
{
  if (!this->Device)
  {
    this->Device = std::make_unique<GradientDevice>(this->Context);
  }
  this->IsUsed = this->Device->Compute(tasks, sums);
  if (!this->IsUsed)
  {
    this->HasFailed = true;
    this->Reason = "no OpenGL, the CPU computes: " + this->Device->GetError();
    this->Device = nullptr;
  }
  return this->IsUsed;
}

bool PatchIntegrator::Compute(
  const std::vector<PatchTask>& tasks, std::vector<PatchSums>& sums, const ProgressCallback& progress)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const bool wantsDevice = this->WantsDevice(tasks);
  sums.clear();
  for (std::size_t begin = 0; begin < tasks.size(); begin += PatchesPerReport)
  {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(tasks.size())))
    {
      return false;
    }
    const auto first = tasks.begin() + static_cast<std::ptrdiff_t>(begin);
    const std::vector<PatchTask> part(
      first, first + static_cast<std::ptrdiff_t>(std::min(PatchesPerReport, tasks.size() - begin)));
    std::vector<PatchSums> own(part.size());
    if (!wantsDevice || this->HasFailed || !this->ComputeOnDevice(part, own))
    {
      ParallelFor(part.size(), 1,
        [&](std::size_t from, std::size_t to)
        {
          for (std::size_t i = from; i < to; ++i)
          {
            own[i] = ComputePatchSums(part[i]);
          }
        });
    }
    std::move(own.begin(), own.end(), std::back_inserter(sums));
  }
  this->Seconds += vtkTimerLog::GetUniversalTime() - start;
  return true;
}
}
