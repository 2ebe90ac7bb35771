#include "smSurfaceIntegrator.h"

#include "smIntegrationOrders.h"
#include "smSurfaceIntegratorInternals.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace sm
{
namespace
{
// Fractions of the progress for cutting, planning and the preparation by the runner; the integration takes
// the rest.
constexpr double CutShare = 0.2;
constexpr double PlanShare = 0.3;
constexpr double AcquireShare = 0.1;
constexpr double PreparedShare = CutShare + PlanShare + AcquireShare;
// Approximate number of evaluations of a batch, whose results are lost if the run is stopped.
constexpr std::int64_t EvaluationsPerBatch = 20000000;
// Largest number of items whose memory is kept between runs: some 7 MB.
constexpr std::size_t MaxKeptItems = 65536;

double Now()
{
  return vtkTimerLog::GetUniversalTime();
}
}

bool SurfaceIntegrator::Internals::ReportProgress(double fraction)
{
  this->TimedOut = this->TimedOut || (this->Seconds > 0.0 && Now() - this->Start > this->Seconds);
  this->Aborted = this->Aborted || this->TimedOut || (this->Progress && !this->Progress(fraction));
  return !this->Aborted || this->Fail("aborted");
}

bool SurfaceIntegrator::Internals::AddUpPlans(std::int64_t& evaluations)
{
  const auto own = static_cast<double>(evaluations);
  double total = own;
  if (!this->Agree(total))
  {
    return false;
  }
  if (own < total)
  {
    this->Allowance = static_cast<std::int64_t>(own / total * static_cast<double>(this->RunMaximum));
  }
  const bool isForced = this->ForcedLoosenings >= 0;
  const bool isLoose = this->Plans.GetLoosenings() >= this->ForcedLoosenings;
  evaluations = !isForced ? static_cast<std::int64_t>(total)
    : isLoose             ? 0
                          : std::numeric_limits<std::int64_t>::max();
  return true;
}

bool SurfaceIntegrator::Internals::ReportItemProgress()
{
  const double done = std::min(1.0, static_cast<double>(this->ItemsDone) / this->ItemsTotal);
  return this->ReportProgress(PreparedShare + (1.0 - PreparedShare) * done);
}

void SurfaceIntegrator::Internals::Configure()
{
  if (this->Configured)
  {
    return;
  }
  this->Results.Clear();
  this->Chosen.clear();
  this->ChosenIntegrands.clear();
  this->Obstacles.clear();
  for (std::size_t k = 0; k < this->Integrands.size(); ++k)
  {
    this->Obstacles.push_back(this->Runner->GetObstacle(this->Integrands[k]));
    if (this->Obstacles.back().empty())
    {
      this->Chosen.push_back(k);
      this->ChosenIntegrands.push_back(this->Integrands[k]);
    }
  }
  const int stripPoints = OrderLadder(this->ChosenIntegrands).GetStripPoints();
  this->Planned = this->Plans.SetIntegrands(this->ChosenIntegrands, stripPoints);
  this->Runner->Configure({ this->ChosenIntegrands, stripPoints, this->UsePlacements, this->Perturbation });
  this->Configured = true;
}

std::size_t SurfaceIntegrator::Internals::GetNumberOfItems(std::size_t face) const
{
  if (!this->Runner->GetFaceError(face).empty())
  {
    return 0;
  }
  return this->Planned ? this->Plans.Get(face).Items.size() : this->Faces[face]->GetNumberOfItems();
}

FaceResultKey SurfaceIntegrator::Internals::GetResultKey(const FaceTask& task, std::size_t index) const
{
  FaceResultKey question;
  question.Tolerances = task.Tolerances;
  question.Placement = this->UsePlacements ? task.Placement : question.Placement;
  question.PlacementBound = task.PlacementBound;
  question.Request = this->Planned ? this->Plans.GetRequest(index) : question.Request;
  return question;
}

void SurfaceIntegrator::Internals::Skip(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& faces, std::vector<FaceIntegrals>& results) const
{
  for (const std::size_t face : faces)
  {
    FaceIntegrals& result = results[face];
    result.Skipped = true;
    result.GapSquared = result.GapArea = result.MaxGap = 0.0;
    result.Gaps.clear();
    for (std::size_t k = 0; k < this->Chosen.size(); ++k)
    {
      const std::size_t to = this->Chosen[k];
      result.Face[to] = result.Closing[to] = result.Rounding[to] = result.Conversion[to] = 0.0;
      result.Residual[to] = 0.0;
      result.QuadratureError[to] = std::numeric_limits<double>::infinity();
      if (this->Planned)
      {
        const FacePlan& plan = this->Plans.Get(face);
        result.QuadratureError[to] = plan.Magnitude[this->Plans.GetClass(k)];
        result.Residual[to] = plan.ResidualBound[this->Plans.GetClass(k)];
        const BoundClass& integrand = this->Plans.GetBoundClass(k);
        result.Conversion[to] = plan.ConversionBound[this->Plans.GetClass(k)] +
          plan.Reading.GetBound(integrand, plan.Area, plan.Area) +
          tasks[face].PlacementBound.GetBound(integrand, plan.Area, plan.Area, plan.Reading.Reach);
      }
    }
  }
}

void SurfaceIntegrator::Internals::MakeBatches(const std::vector<FaceTask>& tasks,
  std::vector<FaceIntegrals>& results, std::vector<std::vector<std::size_t>>& batches)
{
  std::map<int, std::vector<std::size_t>> groups;
  this->ItemsTotal = 1;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    const CutFace& cut = *this->Faces[i];
    const std::shared_ptr<const FaceIntegrals>* known = this->CacheFaceResults
      ? this->Results.Find(tasks[i].Source->Id, this->GetResultKey(tasks[i], i))
      : nullptr;
    if (known)
    {
      results[i] = **known;
      continue;
    }
    this->ItemsTotal += this->GetNumberOfItems(i);
    results[i].Error = cut.Error.empty() ? this->Runner->GetFaceError(i) : cut.Error;
    results[i].CoverageDefects = cut.Panels.CoverageDefects;
    results[i].Overlap = cut.Panels.Overlap;
    results[i].Outside = cut.Panels.Outside;
    results[i].IsContinued = !cut.Panels.AreTrimsMoved;
    if (cut.Panels.AreTrimsMoved)
    {
      results[i].Outside.Distance = std::numeric_limits<double>::infinity();
    }
    groups[this->Runner->GetGroup(i)].push_back(i);
  }
  const std::size_t rowLimit = groups.empty() ? 0 : this->Runner->GetRowLimit();
  for (const auto& [group, members] : groups)
  {
    batches.emplace_back();
    std::size_t items = 0;
    std::int64_t evaluations = 0;
    for (const std::size_t face : members)
    {
      const std::size_t more = this->GetNumberOfItems(face);
      const std::int64_t cost = this->Planned ? this->Plans.Get(face).Evaluations : 0;
      if (items + more > rowLimit || evaluations + cost > EvaluationsPerBatch)
      {
        batches.emplace_back();
        items = 0;
        evaluations = 0;
      }
      if (more > 0)
      {
        batches.back().push_back(face);
        items += more;
        evaluations += cost;
      }
    }
  }
  batches.erase(
    std::remove_if(batches.begin(), batches.end(), [](const auto& batch) { return batch.empty(); }),
    batches.end());
}

bool SurfaceIntegrator::Internals::RunAll(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  std::vector<std::vector<std::size_t>> batches;
  this->MakeBatches(tasks, results, batches);
  return this->RunBatches(tasks, batches, results);
}

bool SurfaceIntegrator::Internals::RunBatches(const std::vector<FaceTask>& tasks,
  const std::vector<std::vector<std::size_t>>& batches, std::vector<FaceIntegrals>& results)
{
  // In a shared run all ranks take part in the agreement after every batch, including those without batches
  // left, until no rank has any left.
  for (std::size_t next = 0;;)
  {
    if (next < batches.size())
    {
      const bool ran = this->RunBatch(tasks, batches[next], results);
      if (!ran && !this->Aborted)
      {
        return false;
      }
      next += ran ? 1 : 0;
    }
    auto left = static_cast<double>(batches.size() - next);
    if (!this->Agree(left, true))
    {
      for (; next < batches.size(); ++next)
      {
        this->Skip(tasks, batches[next], results);
      }
      return true;
    }
    if (left == 0.0)
    {
      return true;
    }
  }
}

bool SurfaceIntegrator::Internals::Prepare(const std::vector<FaceTask>& tasks)
{
  const double start = Now();
  std::vector<FacePointer> faces;
  faces.reserve(tasks.size());
  for (const FaceTask& task : tasks)
  {
    if (!task.Cut)
    {
      faces.push_back(task.Source);
    }
  }
  const auto cutting = [this](double fraction) { return this->ReportProgress(CutShare * fraction); };
  std::vector<CutFacePointer> cut;
  if (!faces.empty() && !this->Cuts.Acquire(faces, cut, cutting) && !this->Aborted)
  {
    return this->Fail(this->Cuts.GetError());
  }
  double nothing = 0.0;
  if (!this->Agree(nothing))
  {
    return false;
  }
  this->Faces.clear();
  auto next = cut.begin();
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    this->Faces.push_back(tasks[i].Cut ? tasks[i].Cut : *next++);
  }
  const double planStart = Now();
  this->CutSeconds += planStart - start;
  const auto planning = [this](double fraction)
  { return this->ReportProgress(CutShare + PlanShare * fraction); };
  const auto addUp = [this](std::int64_t& evaluations) { return this->AddUpPlans(evaluations); };
  if (this->Planned &&
    !this->Plans.Plan(
      tasks, this->Faces, this->Chosen, this->UsePlacements, this->RunMaximum, planning, addUp))
  {
    return this->Fail("aborted");
  }
  this->PlanSeconds += Now() - planStart;
  this->Loosened = this->Planned && this->Plans.WasLoosened();
  const auto acquiring = [this](double fraction)
  { return this->ReportProgress(CutShare + PlanShare + AcquireShare * fraction); };
  if (!tasks.empty() && !this->Runner->Acquire(this->Faces, acquiring) && !this->Aborted)
  {
    return this->FailByRunner();
  }
  return this->Agree(nothing);
}

void SurfaceIntegrator::Internals::Begin(const ProgressCallback& progress)
{
  this->Error.clear();
  this->Distrust.clear();
  this->Aborted = this->TimedOut = this->Loosened = false;
  this->Start = Now();
  this->Seconds = this->MaximumSeconds;
  this->Allowance = this->RunMaximum = this->MaximumEvaluations;
  this->ForcedLoosenings = -1;
  this->Evaluations = 0;
  this->StartSeconds = this->PrepareSeconds = this->IntegrateSeconds = 0.0;
  this->CutSeconds = this->PlanSeconds = 0.0;
  this->ItemsDone = 0;
  this->Progress = progress;
  this->Ranks.clear();
}

FaceIntegrals SurfaceIntegrator::Internals::MakeZeroResult() const
{
  FaceIntegrals nothing;
  for (const std::string& obstacle : this->Obstacles)
  {
    const double value = obstacle.empty() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    for (std::vector<double>* values : { &nothing.Face, &nothing.Closing, &nothing.QuadratureError,
           &nothing.Rounding, &nothing.Conversion, &nothing.Residual })
    {
      values->push_back(value);
    }
  }
  return nothing;
}

bool SurfaceIntegrator::Internals::Run(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  results.assign(tasks.size(), this->MakeZeroResult());
  const double start = Now();
  bool ok = this->Prepare(tasks);
  const double starting = ok && !tasks.empty() ? this->Runner->GetStartSeconds() : 0.0;
  this->StartSeconds += starting;
  this->PrepareSeconds += Now() - start - starting;
  if (ok)
  {
    const double begin = Now();
    ok = this->RunAll(tasks, results);
    this->IntegrateSeconds += Now() - begin;
  }
  if (this->Runner)
  {
    this->Runner->Release();
  }
  this->Faces.clear();
  if (this->Items.capacity() > MaxKeptItems)
  {
    this->Items = WorkItems();
  }
  return ok;
}

SurfaceIntegrator::SurfaceIntegrator()
  : Implementation(new Internals)
{
}

SurfaceIntegrator::~SurfaceIntegrator() = default;

void SurfaceIntegrator::SetRunner(std::unique_ptr<ItemRunner> runner)
{
  this->Implementation->Runner = std::move(runner);
  this->Implementation->Configured = false;
}

void SurfaceIntegrator::SetIntegrands(const std::vector<Integrand>& integrands)
{
  this->Implementation->Integrands = integrands;
  this->Implementation->Configured = false;
}

void SurfaceIntegrator::SetUsePlacements(bool use)
{
  this->Implementation->Configured =
    this->Implementation->Configured && this->Implementation->UsePlacements == use;
  this->Implementation->UsePlacements = use;
}

void SurfaceIntegrator::SetPerturbation(double factor)
{
  this->Implementation->Configured =
    this->Implementation->Configured && this->Implementation->Perturbation == factor;
  this->Implementation->Perturbation = factor;
}

void SurfaceIntegrator::SetCacheFaceResults(bool cache)
{
  this->Implementation->CacheFaceResults = cache;
  if (!cache)
  {
    this->ForgetFaces();
  }
}

void SurfaceIntegrator::ForgetFaces()
{
  this->Implementation->Results.Clear();
}

void SurfaceIntegrator::ReleaseMemory()
{
  Internals& self = *this->Implementation;
  self.Runner.reset();
  self.Configured = false;
  self.Cuts.Clear();
  self.Results.Clear();
  self.Plans.Clear();
  self.Shares.Forget();
  self.Received.Clear();
  self.Items = WorkItems();
}

void SurfaceIntegrator::SetMaximumEvaluations(std::int64_t evaluations)
{
  this->Implementation->MaximumEvaluations = evaluations;
}

void SurfaceIntegrator::SetMaximumSeconds(double seconds)
{
  this->Implementation->MaximumSeconds = seconds;
}

bool SurfaceIntegrator::Integrate(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results, const ProgressCallback& progress)
{
  Internals& self = *this->Implementation;
  self.Begin(progress);
  self.Configure();
  if (tasks.empty() || self.Chosen.empty())
  {
    results.assign(tasks.size(), self.MakeZeroResult());
    this->FinishSharing("");
    return !self.Integrands.empty() || self.Fail("there is no integrand: add one, for example area = dA");
  }
  if (self.Sharing.IsOpen())
  {
    results.assign(tasks.size(), self.MakeZeroResult());
  }
  const bool ok = self.Sharing.IsOpen() ? self.IntegrateShared(tasks, results) : self.Run(tasks, results);
  if (ok)
  {
    // A run that was stopped earlier has requested no faces.
    self.Results.EndRun();
  }
  if (self.Sharing.IsOpen())
  {
    this->FinishSharing(self.Error.c_str());
    // It is unknown how much the others received.
    self.Shares.Forget();
  }
  self.Progress = nullptr;
  return ok;
}

const std::string& SurfaceIntegrator::GetDistrust() const
{
  return this->Implementation->Distrust;
}

const std::string& SurfaceIntegrator::GetError() const
{
  return this->Implementation->Error;
}

bool SurfaceIntegrator::WasAborted() const
{
  return this->Implementation->Aborted;
}

bool SurfaceIntegrator::WasTimedOut() const
{
  return this->Implementation->TimedOut;
}

bool SurfaceIntegrator::WasLoosened() const
{
  return this->Implementation->Loosened;
}

std::string SurfaceIntegrator::GetObstacle(std::size_t integrand) const
{
  return integrand < this->Implementation->Obstacles.size() ? this->Implementation->Obstacles[integrand] : "";
}

std::int64_t SurfaceIntegrator::GetEvaluations() const
{
  return this->Implementation->Evaluations;
}

double SurfaceIntegrator::GetStartSeconds() const
{
  return this->Implementation->StartSeconds;
}

double SurfaceIntegrator::GetPrepareSeconds() const
{
  return this->Implementation->PrepareSeconds;
}

double SurfaceIntegrator::GetCutSeconds() const
{
  return this->Implementation->CutSeconds;
}

double SurfaceIntegrator::GetPlanSeconds() const
{
  return this->Implementation->PlanSeconds;
}

double SurfaceIntegrator::GetIntegrateSeconds() const
{
  return this->Implementation->IntegrateSeconds;
}
}
