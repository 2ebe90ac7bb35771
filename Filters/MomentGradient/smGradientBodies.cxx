#include "Detail/smGradientBodies.h"

#include "smFileState.h"

#include "vtkDataObject.h"

#include <algorithm>

namespace sm
{
std::string FindWrongIndex(const std::vector<int>& indices, std::size_t count, const char* what)
{
  for (const int index : indices)
  {
    if (index < 0 || static_cast<std::size_t>(index) >= count)
    {
      return std::string("there is no ") + what + " " + std::to_string(index) + "; give indices from 0 to " +
        std::to_string(static_cast<long long>(count) - 1);
    }
  }
  return {};
}

bool GradientBodies::Compute(vtkDataObject* model, const std::vector<int>& solids, double relativeTolerance,
  const ProgressCallback& progress)
{
  IntegralEngine engine;
  engine.SetController(nullptr);
  RunReport& report = engine.GetReport();
  RejectedInput rejected;
  std::vector<BodyIntegrals> bodies = CollectBodies(model, rejected);
  if (bodies.empty())
  {
    report.RejectInput(rejected.Withheld > 0);
    this->Status = GetText(sm::Status::Empty);
    this->Reason = report.Messages.empty() ? "the input has no exact solid" : report.Messages.back();
    return false;
  }
  this->Reason = FindWrongIndex(solids, bodies.size(), "solid");
  if (!this->Reason.empty())
  {
    this->Status = GetText(sm::Status::NotComputed);
    return false;
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (solids.empty() || std::find(solids.begin(), solids.end(), static_cast<int>(i)) != solids.end())
    {
      this->Bodies.push_back(bodies[i]);
      this->Indices.push_back(static_cast<int>(i));
    }
  }
  report.AddBodies(this->Bodies, rejected);
  report.AddFile(GetFileState(model), true, true);
  const Tolerance tolerance{ std::max(relativeTolerance, 1e-15), 0.0 };
  MassAnalysisOptions wanted;
  wanted.Tolerance = { tolerance, tolerance, tolerance, tolerance };
  IntegralLimits limits;
  limits.Backend = BackendChoice::CPU;
  limits.CacheFaceResults = false;
  limits.Progress = progress;
  const IntegralRequest request = MakeMassRequest(wanted.Tolerance);
  const bool computed = engine.Integrate(request, limits, this->Bodies);
  engine.Sum(request, computed, wanted.GapLimit, this->Bodies);
  this->Analysis = AnalyzeMass(this->Bodies, wanted);
  report.AddStatuses(this->Bodies);
  this->Status = GetText(report.Status);
  this->Reason = report.Status == sm::Status::Ok ? "" : report.FindReason(this->Bodies);
  this->Messages = report.Messages;
  if (!computed)
  {
    this->Status = GetText(sm::Status::NotComputed);
    this->Reason = report.Reason.empty() ? "aborted" : report.Reason;
  }
  return computed;
}

std::vector<double> GradientBodies::GetSides(std::size_t body) const
{
  const BodyIntegrals& source = this->Bodies[body];
  std::vector<double> sides;
  for (std::size_t f = 0; f < source.Model->GetFaces().size(); ++f)
  {
    sides.push_back((source.InsideOut ? -1.0 : 1.0) * source.GetSide(f));
  }
  return sides;
}
}
