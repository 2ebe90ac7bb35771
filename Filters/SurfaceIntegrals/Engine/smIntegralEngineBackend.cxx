// The choice of the engine's backend: by the user, or by an estimate of what the run takes on either.
#include "Items/smCPUItemRunner.h"
#include "Items/smGPUItemRunner.h"
#include "Items/smItemKernels.h"
#include "smIntegralEngine.h"
#include "smOpenGLLibrary.h"
#include "smParallelFor.h"

#include "vtkTimerLog.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sm
{
namespace
{
// Below this weight of a control point a driver that takes subnormal numbers for 0 is not used: an operation
// is off by up to 2.3e-308, and so by 1e-208 relative to a weight.
constexpr double MinimumFlushedWeight = 1e-100;

double FindMinimumWeight(vtkTrimmedNURBSModel* model)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (const FacePointer& face : model->GetFaces())
  {
    for (const std::array<double, 4>& point : face->Surface.ControlPoints)
    {
      minimum = std::min(minimum, std::abs(point[3]));
    }
  }
  return minimum;
}

/// The faces of a model that are to be integrated.
RunSize EstimateModel(const IntegralRequest& request, vtkTrimmedNURBSModel* model)
{
  RunSize size;
  for (const FacePointer& face : model->GetFaces())
  {
    if (request.FaceIds.empty() || request.FaceIds.count(face->FileId) > 0)
    {
      size.Add(request.EstimateFace ? request.EstimateFace(*face) : EstimateSize(*face));
    }
  }
  return size;
}
}

bool IntegralRequest::HasExpressions() const
{
  return std::any_of(this->Integrands.begin(), this->Integrands.end(),
    [](const Integrand& integrand) { return integrand.Form == Integrand::Kind::User; });
}

void IntegralEngine::EstimateBackends(
  const IntegralRequest& request, const std::vector<BodyIntegrals>& bodies)
{
  RunSize all;
  this->MinimumWeight = std::numeric_limits<double>::infinity();
  std::map<vtkTrimmedNURBSModel*, RunSize> known;
  for (const BodyIntegrals& body : bodies)
  {
    const auto [model, isNew] = known.try_emplace(body.Model);
    if (isNew)
    {
      model->second = EstimateModel(request, body.Model);
      this->MinimumWeight = std::min(this->MinimumWeight, FindMinimumWeight(body.Model));
    }
    // A model with the faces of an earlier one has its results.
    const bool isCopy = request.FaceIds.empty() && body.Model->GetEqualFaces() != body.Model->GetFaces();
    if ((isNew && !isCopy) || request.UsePlacements)
    {
      all.Add(model->second);
    }
  }
  const ProcessorSize processor{ vtkSMPTools::GetEstimatedNumberOfThreads(), GetLaneCounts().back() };
  this->Report.Estimate = sm::EstimateBackends(all, request.Integrands.size(), processor, this->Rates);
  this->PrefersOpenGL = this->Report.Estimate.PrefersOpenGL();
}

std::string IntegralEngine::DescribeEstimate(bool hasOpenGL) const
{
  const std::string cpu = FormatEstimate(this->Report.Estimate.CPUSeconds);
  const std::string gpu = FormatEstimate(this->Report.Estimate.OpenGLSeconds);
  const char* obstacle = hasOpenGL || !this->PrefersOpenGL        ? ""
    : this->Context->GetStatus() <= vtkComputeContext::NO_CONTEXT ? "no GPU; "
                                                                  : "no usable GPU; ";
  return hasOpenGL ? "estimated " + gpu + "; CPU " + cpu
                   : obstacle + ("estimated " + cpu) + "; OpenGL " + gpu;
}

std::string IntegralEngine::FindContextProblem(BackendChoice backend) const
{
  const bool isDistrusted =
    backend == BackendChoice::Automatic && this->DistrustedGeneration == this->Context->GetGeneration();
  return isDistrusted ? this->Distrust
    : this->Context->FlushesSubnormals() && this->MinimumWeight < MinimumFlushedWeight
    ? this->Context->GetRenderer() +
      " takes numbers below 2.3e-308 for 0, and a weight may be below 1e-100; take the CPU"
    : std::string();
}

bool IntegralEngine::ChooseRunner(const IntegralRequest& request, BackendChoice backend)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const bool isByEstimate = backend == BackendChoice::Automatic && !request.HasExpressions() &&
    !this->Context->GetWindow() && this->Context->GetSource() == vtkComputeContext::AUTOMATIC;
  const bool isWanted = isByEstimate ? this->PrefersOpenGL : backend != BackendChoice::CPU;
  bool hasOpenGL = isWanted &&
    (isByEstimate ? this->Context->StartOnGPU() : this->Context->Start() == vtkComputeContext::READY);
  std::string problem = hasOpenGL ? this->FindContextProblem(backend) : std::string();
  if (isWanted && !hasOpenGL)
  {
    GetOpenGLLibrary(problem); // the reason why there is none; empty if there is one
  }
  hasOpenGL = hasOpenGL && problem.empty();
  this->Report.StartSeconds = vtkTimerLog::GetUniversalTime() - start;
  if (!hasOpenGL && backend == BackendChoice::OpenGL)
  {
    this->Report.SetReason(
      "nothing was computed: " + (problem.empty() ? this->Context->GetReason() : problem));
    return false;
  }
  // A machine without a GPU is nothing to report; a GPU that cannot be used is.
  if (isWanted && !hasOpenGL && (!isByEstimate || this->Context->GetStatus() > vtkComputeContext::NO_CONTEXT))
  {
    this->Report.FallbackReason = !problem.empty() ? problem : this->Context->GetReason();
  }
  this->Report.BackendReason = !problem.empty()         ? problem
    : isByEstimate                                      ? this->DescribeEstimate(hasOpenGL)
    : !hasOpenGL || backend != BackendChoice::Automatic ? ""
    : this->Context->GetWindow()                        ? "in the render window"
    : request.HasExpressions()                          ? "expressions need OpenGL"
                                                        : "a source was chosen";
  this->SetRunner(hasOpenGL);
  return true;
}

bool IntegralEngine::MustLeaveOpenGL(const IntegralLimits& limits) const
{
  return limits.Backend == BackendChoice::Automatic && !this->Integrator.GetDistrust().empty();
}

void IntegralEngine::LeaveOpenGL(const std::string& distrust)
{
  this->DistrustedGeneration = this->Context->GetGeneration();
  this->Distrust = this->Context->GetRenderer() + " " + distrust;
  this->Report.FallbackReason = this->Report.BackendReason = this->Distrust;
  this->SetRunner(false);
}

void IntegralEngine::SetRunner(bool hasOpenGL)
{
  // Another context may use another device, with different rounding.
  const vtkTypeUInt64 generation = hasOpenGL ? this->Context->GetGeneration() : 0;
  if (this->Generation != generation)
  {
    this->Integrator.ForgetFaces();
    this->Generation = generation;
  }
  this->Report.Backend = hasOpenGL ? names::BackendOpenGL : names::BackendCPU;
  this->Report.Renderer = hasOpenGL ? this->Context->GetRenderer() : CPUItemRunner::GetDescription();
  if (this->Runner == this->Report.Backend)
  {
    return;
  }
  std::unique_ptr<ItemRunner> runner;
  if (hasOpenGL)
  {
    runner = std::make_unique<GPUItemRunner>(this->Context);
  }
  else
  {
    runner = std::make_unique<CPUItemRunner>();
  }
  this->Integrator.SetRunner(std::move(runner));
  this->Runner = this->Report.Backend;
}
}
