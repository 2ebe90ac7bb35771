#include "vtkPlaneCutBase.h"

#include "smBodyMeshes.h"
#include "smBuoyancy.h"
#include "smFormat.h"
#include "smIntegralEngine.h"

#include "vtkMath.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
bool AreFinite(double x, double y, double z)
{
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}
}

vtkPlaneCutBase::vtkPlaneCutBase(bool withSection, const char* volume)
  : Integrator(new sm::BuoyancyIntegrator(withSection))
  , Volume(volume)
{
}

vtkPlaneCutBase::~vtkPlaneCutBase() = default;

void vtkPlaneCutBase::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Point: " << this->Point[0] << " " << this->Point[1] << " " << this->Point[2] << "\n"
     << indent << "Normal: " << this->Normal[0] << " " << this->Normal[1] << " " << this->Normal[2] << "\n"
     << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n";
}

void vtkPlaneCutBase::SetPoint(double x, double y, double z)
{
  if (!AreFinite(x, y, z))
  {
    vtkErrorMacro(
      "The point " << sm::FormatTriple(x, y, z) << " of the plane is not used: give finite coordinates.");
    return;
  }
  const double point[3] = { x, y, z };
  if (!std::equal(point, point + 3, this->Point))
  {
    std::copy_n(point, 3, this->Point);
    this->Modified();
  }
}

void vtkPlaneCutBase::SetNormal(double x, double y, double z)
{
  if (!AreFinite(x, y, z) || (x == 0.0 && y == 0.0 && z == 0.0))
  {
    vtkErrorMacro("The normal " << sm::FormatTriple(x, y, z)
                                << " of the plane is not used: give a finite vector that is not 0 0 0.");
    return;
  }
  const double normal[3] = { x, y, z };
  if (!std::equal(normal, normal + 3, this->Normal))
  {
    std::copy_n(normal, 3, this->Normal);
    this->Modified();
  }
}

sm::IntegralRequest vtkPlaneCutBase::MakeRequest() const
{
  sm::IntegralRequest request;
  request.Integrands = this->Integrator->MakeIntegrands();
  request.Integrands[0].Name = this->Volume;
  request.ReportSmallGaps = false;
  return request;
}

std::vector<sm::MeshArray> vtkPlaneCutBase::GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const
{
  const auto getVolume = [&bodies](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = bodies[body].Faces ? &(*bodies[body].Faces)[face] : nullptr;
    return result && result->Error.empty() ? result->Face[0] + result->Closing[0] : vtkMath::Nan();
  };
  return { { this->Volume, getVolume } };
}

void vtkPlaneCutBase::ReleaseKept()
{
  this->Integrator->ReleaseMemory();
}

bool vtkPlaneCutBase::IntegrateSide(const sm::IntegralRequest& request,
  const std::vector<sm::BodyIntegrals>& bodies, bool opposite, double begin, double end,
  std::vector<sm::BodyBuoyancy>& results)
{
  sm::IntegralEngine& engine = this->GetEngine();
  sm::RunReport& report = engine.GetReport();
  sm::IntegralLimits limits = this->MakeLimits(begin, end);
  limits.MaximumSeconds *= end - begin;
  limits.MaximumEvaluations =
    std::max<std::int64_t>(1, limits.MaximumEvaluations / std::lround(1.0 / (end - begin)));
  if (!engine.CheckPlacements(bodies) || !engine.ChooseRunner(request, limits.Backend))
  {
    return false;
  }
  engine.Configure(request, limits);
  sm::SurfaceIntegrator& integrator = engine.GetIntegrator();
  const double sign = opposite ? -1.0 : 1.0;
  const sm::Waterline waterline{ { this->Point[0], this->Point[1], this->Point[2] },
    { sign * this->Normal[0], sign * this->Normal[1], sign * this->Normal[2] } };
  const vtkTypeUInt64 dispatches = engine.GetContext()->GetNumberOfDispatches();
  // The time limit counts from here; the integrator starts to count only after the faces are cut.
  const double start = vtkTimerLog::GetUniversalTime();
  bool isTimeOver = false;
  const auto progress = [&limits, &isTimeOver, start](double fraction)
  {
    isTimeOver = isTimeOver ||
      (limits.MaximumSeconds > 0.0 && vtkTimerLog::GetUniversalTime() - start > limits.MaximumSeconds);
    return !isTimeOver && (!limits.Progress || limits.Progress(fraction));
  };
  const bool done =
    this->Integrator->Integrate(integrator, bodies, waterline, this->RelativeTolerance, progress, results);
  isTimeOver = isTimeOver || integrator.WasTimedOut();
  const std::string& cutError = this->Integrator->GetCutError();
  const bool isCut = cutError.empty() && !this->Integrator->WasAbortedInCut();
  if (isCut)
  {
    engine.AddEffort(dispatches);
  }
  report.PrepareSeconds += this->Integrator->GetCutSeconds();
  if (!done)
  {
    results.clear();
    report.SetReason(!cutError.empty()        ? "nothing was computed: " + cutError
        : isTimeOver                          ? "nothing was computed: the maximum seconds were over"
        : this->Integrator->WasAbortedInCut() ? "the run was aborted while faces were cut at the plane"
        : integrator.WasAborted()             ? "the run was aborted"
                                              : "nothing was computed: " + integrator.GetError());
    return false;
  }
  if (integrator.WasAborted())
  {
    report.SetReason(isTimeOver
        ? "the maximum seconds were over before all faces were integrated on one side of the plane"
        : "the run was stopped before all faces were integrated on one side of the plane");
  }
  if (integrator.WasLoosened())
  {
    report.Messages.push_back(
      "the maximum evaluations are too few for the tolerance on one side of the plane, which was "
      "loosened; the bounds show the accuracy reached");
  }
  return true;
}
