#include "smSurfaceIntegrator.h"

#include "smIntegrationOrders.h"
#include "smSurfaceIntegratorInternals.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace sm
{
namespace
{
// Halvings of t and xi after the ladder's end.
constexpr int MaximumBisections = 6;
// Of the progress: cutting, then planning, then what the runner needs of the faces; integrating is the rest.
constexpr double CutShare = 0.2;
constexpr double PlanShare = 0.3;
constexpr double AcquireShare = 0.1;
constexpr double PreparedShare = CutShare + PlanShare + AcquireShare;
// Evaluations of a batch, about: what is lost when the run is stopped.
constexpr std::int64_t EvaluationsPerBatch = 20000000;

/// Adds what was measured along a part of a coedge, counted through all loops of the face.
void AddGap(const Face& face, int index, const CoedgeGap& measured, std::vector<CoedgeGap>& gaps)
{
  CoedgeGap gap = measured;
  gap.Coedge = index;
  while (gap.Coedge >= static_cast<int>(face.Loops[gap.Loop].Coedges.size()))
  {
    gap.Coedge -= static_cast<int>(face.Loops[gap.Loop].Coedges.size());
    ++gap.Loop;
  }
  const auto found = std::find_if(gaps.begin(), gaps.end(),
    [&gap](const CoedgeGap& other) { return other.Loop == gap.Loop && other.Coedge == gap.Coedge; });
  if (found == gaps.end())
  {
    gaps.push_back(gap);
    return;
  }
  found->GapSquared += gap.GapSquared;
  found->GapArea += gap.GapArea;
  found->MaxGap = GetLargerGap(found->MaxGap, gap.MaxGap);
}

double Now()
{
  return vtkTimerLog::GetUniversalTime();
}
}

bool SurfaceIntegrator::Internals::Tell(double fraction)
{
  this->TimedOut = this->TimedOut || (this->Seconds > 0.0 && Now() - this->Start > this->Seconds);
  this->Aborted = this->Aborted || this->TimedOut || (this->Report && !this->Report(fraction));
  return !this->Aborted || this->Fail("aborted");
}

bool SurfaceIntegrator::Internals::FailAlone(const std::string& what)
{
  if (!this->IsShared || this->Aborted)
  {
    return this->Fail(what);
  }
  this->Failure = what;
  return true;
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
    this->Allowance = static_cast<std::int64_t>(own / total * static_cast<double>(this->MaximumEvaluations));
  }
  const bool isForced = this->ForcedLoosenings >= 0;
  const bool isLoose = this->Plans.GetLoosenings() >= this->ForcedLoosenings;
  evaluations = !isForced ? static_cast<std::int64_t>(total)
    : isLoose             ? 0
                          : std::numeric_limits<std::int64_t>::max();
  return true;
}

bool SurfaceIntegrator::Internals::TellItems()
{
  const double done = std::min(1.0, static_cast<double>(this->ItemsDone) / this->ItemsTotal);
  return this->Tell(PreparedShare + (1.0 - PreparedShare) * done);
}

void SurfaceIntegrator::Internals::Configure()
{
  if (this->Configured)
  {
    return;
  }
  this->Memory.Forget();
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

FaceQuestion SurfaceIntegrator::Internals::GetQuestion(const FaceTask& task, std::size_t index) const
{
  FaceQuestion question;
  question.Tolerances = task.Tolerances;
  question.Placement = this->UsePlacements ? task.Placement : question.Placement;
  question.Request = this->Planned ? this->Plans.GetRequest(index) : question.Request;
  return question;
}

void SurfaceIntegrator::Internals::Keep(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, const std::vector<FaceIntegrals>& results)
{
  // With the budget spent, results depend on what was evaluated before them.
  for (std::size_t i = 0; i < batch.size() && this->KeepFaces && this->Evaluations < this->Allowance; ++i)
  {
    const FaceTask& task = tasks[batch[i]];
    this->Memory.Keep(task.Source->Id, this->GetQuestion(task, batch[i]), results[batch[i]]);
  }
}

void SurfaceIntegrator::Internals::Skip(
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
      result.QuadratureError[to] = this->Planned ? this->Plans.Get(face).Magnitude[this->Plans.GetClass(k)]
                                                 : std::numeric_limits<double>::infinity();
    }
  }
}

void SurfaceIntegrator::Internals::AddBounds(
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results) const
{
  for (const std::size_t face : batch)
  {
    FaceIntegrals& result = results[face];
    if (!this->Planned)
    {
      result.Estimated = true;
      continue;
    }
    const FacePlan& plan = this->Plans.Get(face);
    result.Estimated = plan.Estimated;
    for (std::size_t k = 0; k < this->Chosen.size(); ++k)
    {
      // What rows hold is the error of compared items, for the area; and what is not finite.
      double& error = result.QuadratureError[this->Chosen[k]];
      const bool compared = this->Plans.GetBoundClass(k).Kind == BoundClass::AreaMoment;
      error = compared || !std::isfinite(error) ? error : 0.0;
      error += plan.QuadratureBound[this->Plans.GetClass(k)];
      result.Conversion[this->Chosen[k]] += plan.ConversionBound[this->Plans.GetClass(k)];
    }
  }
}

bool SurfaceIntegrator::Internals::Accumulate(const std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  // Rows of a face lie together: its panels, its ribbons coedge by coedge, its caps. A segment for each.
  struct Part
  {
    std::uint32_t Slot;
    ItemKind Kind;
    int Coedge;
  };
  std::vector<ItemRunner::Segment> segments;
  std::vector<Part> parts;
  for (std::size_t row = 0; row < items.size(); ++row)
  {
    const WorkItem& item = items[row];
    if (parts.empty() || parts.back().Slot != item.GetSlot() || parts.back().Kind != item.Kind ||
      parts.back().Coedge != item.Coedge)
    {
      segments.emplace_back(static_cast<unsigned int>(row), static_cast<unsigned int>(row));
      parts.push_back({ item.GetSlot(), item.Kind, item.Coedge });
    }
    segments.back().second = static_cast<unsigned int>(row + 1);
  }
  std::vector<double> sums;
  std::vector<double> largest;
  if (!this->Runner->Sum(segments, sums, largest))
  {
    return this->FailByRunner();
  }
  const RowLayout& layout = this->Runner->GetLayout();
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    FaceIntegrals& result = results[batch[parts[i].Slot]];
    const double* sum = sums.data() + i * layout.GetStride();
    std::vector<double>& values = parts[i].Kind == ItemKind::Panel ? result.Face : result.Closing;
    for (int k = 0; k < layout.GetNumberOfIntegrands(); ++k)
    {
      const std::size_t to = this->Chosen[k];
      values[to] += sum[layout.GetValue(k)];
      result.QuadratureError[to] += sum[layout.GetError(k)];
      result.Rounding[to] += sum[layout.GetRounding(k)];
    }
    result.GapSquared += sum[RowLayout::SquaredGap];
    result.GapArea += sum[RowLayout::GapArea];
    result.MaxGap = GetLargerGap(result.MaxGap, largest[i]);
    if (parts[i].Coedge >= 0)
    {
      AddGap(*this->Faces[batch[parts[i].Slot]]->Source, parts[i].Coedge,
        { 0, 0, sum[RowLayout::SquaredGap], sum[RowLayout::GapArea], largest[i] }, result.Gaps);
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunLevels(
  std::vector<WorkItem>& items, int depth, std::vector<std::size_t>& bisected)
{
  const OrderLadder ladder(this->ChosenIntegrands);
  const auto goOn = [this]() { return this->TellItems(); };
  std::vector<std::size_t> active(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    active[i] = i;
    items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
  }
  std::vector<std::uint8_t> unconverged;
  for (int level = 0; !active.empty(); ++level)
  {
    const bool mayBisect = depth < MaximumBisections && this->Evaluations < this->Allowance;
    for (const std::size_t index : active)
    {
      SetItemOrders(items[index], GetItemOrders(ladder, items[index]), mayBisect);
    }
    if (!this->Runner->Run(items, active, unconverged, this->Evaluations, goOn))
    {
      return this->FailByRunner();
    }
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < active.size(); ++i)
    {
      WorkItem& item = items[active[i]];
      const Orders orders = GetItemOrders(ladder, item);
      const bool compared = item.Level > 0 || orders.Exact;
      if (orders.Exact || (compared && unconverged[i] == 0))
      {
        continue;
      }
      if (orders.Last && mayBisect)
      {
        bisected.push_back(active[i]);
      }
      else if (!orders.Last && !(compared && this->Evaluations >= this->Allowance))
      {
        ++item.Level;
        next.push_back(active[i]);
      }
    }
    active = std::move(next);
    if (depth == 0 && level == 1)
    {
      this->ItemsDone += items.size();
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunPlanned(
  std::vector<WorkItem>& items, int depth, std::vector<std::size_t>& bisected)
{
  std::vector<std::size_t> all(items.size());
  std::vector<std::size_t> compared;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    all[i] = i;
    items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
    if (items[i].Compared)
    {
      compared.push_back(i);
    }
  }
  const auto goOn = [this]() { return this->TellItems(); };
  std::vector<std::uint8_t> unconverged;
  if (!this->Runner->Run(items, all, unconverged, this->Evaluations, goOn))
  {
    return this->FailByRunner();
  }
  this->ItemsDone += depth == 0 ? items.size() : 0;
  if (compared.empty())
  {
    return true;
  }
  // The plan's bounds of everything but the area hold for the parts, too: their ellipses lie in the whole's.
  const bool mayBisect = depth < MaximumBisections && this->Evaluations < this->Allowance;
  for (const std::size_t i : compared)
  {
    DoubleOrders(items[i], mayBisect);
  }
  if (!this->Runner->Run(items, compared, unconverged, this->Evaluations, goOn))
  {
    return this->FailByRunner();
  }
  for (std::size_t i = 0; i < compared.size(); ++i)
  {
    if (mayBisect && unconverged[i] != 0)
    {
      bisected.push_back(compared[i]);
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunItems(std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
{
  if (!this->Runner->BeginRows(items.size()))
  {
    return this->FailByRunner();
  }
  std::vector<std::size_t> bisected;
  const bool ran =
    this->Planned ? this->RunPlanned(items, depth, bisected) : this->RunLevels(items, depth, bisected);
  if (!ran || !this->Accumulate(items, batch, results))
  {
    return false;
  }
  std::vector<WorkItem> children;
  for (const std::size_t index : bisected)
  {
    // Parts share their parent's tolerance. Along a line without normals half of the quarters need none of theirs.
    const bool quarters = items[index].Kind == ItemKind::Panel && !this->Planned;
    BisectItem(items[index], quarters ? 2 : 1, children);
  }
  if (this->Planned)
  {
    std::for_each(children.begin(), children.end(), HalveOrders);
  }
  return this->RunPortions(children, batch, depth + 1, results);
}

bool SurfaceIntegrator::Internals::RunPortions(std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
{
  // In portions that have room for their rows; the results of a face add up in order. Where a portion ends within a face must not
  // depend on other faces: it is cut before the face, or where the face has filled portions of its own.
  const std::size_t portion = this->Runner->GetRowLimit();
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < items.size(); begin = end)
  {
    end = std::min(begin + portion, items.size());
    if (end < items.size() && items[begin].GetSlot() != items[end].GetSlot())
    {
      while (items[end - 1].GetSlot() == items[end].GetSlot())
      {
        --end;
      }
    }
    std::vector<WorkItem> part(
      items.begin() + static_cast<std::ptrdiff_t>(begin), items.begin() + static_cast<std::ptrdiff_t>(end));
    if (!this->RunItems(part, batch, depth, results))
    {
      return false;
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunBatch(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  std::vector<WorkItem> items;
  std::vector<ItemRunner::BatchFace> faces;
  for (std::size_t slot = 0; slot < batch.size(); ++slot)
  {
    const FaceTask& task = tasks[batch[slot]];
    const CutFace& cut = *this->Faces[batch[slot]];
    if (this->Planned)
    {
      AddPlannedItems(cut, this->Plans.Get(batch[slot]), static_cast<std::uint32_t>(slot), items);
    }
    else
    {
      AddItems(cut, static_cast<std::uint32_t>(slot), items);
    }
    ItemRunner::BatchFace face{ batch[slot], {}, task.Placement };
    for (const std::size_t k : this->Chosen)
    {
      face.Tolerances.push_back(task.Tolerances[k] / std::max<std::size_t>(cut.GetNumberOfItems(), 1));
    }
    faces.push_back(std::move(face));
  }
  if (!this->Runner->BeginBatch(faces))
  {
    return this->FailByRunner();
  }
  if (!this->RunPortions(items, batch, 0, results))
  {
    return false;
  }
  this->AddBounds(batch, results);
  this->Keep(tasks, batch, results);
  return true;
}

bool SurfaceIntegrator::Internals::RunAll(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  std::map<int, std::vector<std::size_t>> groups;
  this->ItemsTotal = 1;
  for (std::size_t i = 0; i < tasks.size() && this->Failure.empty(); ++i)
  {
    const CutFace& cut = *this->Faces[i];
    const FaceIntegrals* known =
      this->KeepFaces ? this->Memory.Find(tasks[i].Source->Id, this->GetQuestion(tasks[i], i)) : nullptr;
    if (known)
    {
      results[i] = *known;
      continue;
    }
    this->ItemsTotal += this->GetNumberOfItems(i);
    results[i].Error = cut.Error.empty() ? this->Runner->GetFaceError(i) : cut.Error;
    results[i].CoverageDefects = cut.Panels.CoverageDefects;
    results[i].Outside = cut.Panels.Outside;
    groups[this->Runner->GetGroup(i)].push_back(i);
  }
  // Batches that have room for their rows, and that are not too much to lose.
  std::vector<std::vector<std::size_t>> batches;
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
  return this->RunBatches(tasks, batches, results);
}

bool SurfaceIntegrator::Internals::RunBatches(const std::vector<FaceTask>& tasks,
  const std::vector<std::vector<std::size_t>>& batches, std::vector<FaceIntegrals>& results)
{
  // Ranks of a shared run agree after every batch, those that are done too, until none has any left.
  for (std::size_t next = 0;;)
  {
    if (next < batches.size())
    {
      const bool ran = this->RunBatch(tasks, batches[next], results);
      if (!ran && !this->Aborted && !this->FailAlone(this->Error))
      {
        return false;
      }
      next = !this->Failure.empty() ? batches.size() : ran ? next + 1 : next;
    }
    auto left = static_cast<double>(batches.size() - next);
    if (!this->Agree(left))
    {
      for (; next < batches.size(); ++next)
      {
        this->Skip(batches[next], results);
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
  std::vector<FacePointer> faces;
  faces.reserve(tasks.size());
  for (const FaceTask& task : tasks)
  {
    if (!task.Cut)
    {
      faces.push_back(task.Source);
    }
  }
  const auto cutting = [this](double fraction) { return this->Tell(CutShare * fraction); };
  std::vector<CutFacePointer> cut;
  const bool hasCut = faces.empty() || this->Cuts.Acquire(faces, cut, cutting);
  bool ok = hasCut || this->FailAlone(this->Cuts.GetError());
  double nothing = 0.0;
  if (!this->Agree(nothing) || !ok)
  {
    return false;
  }
  this->Faces.clear();
  auto next = cut.begin();
  for (std::size_t i = 0; hasCut && i < tasks.size(); ++i)
  {
    this->Faces.push_back(tasks[i].Cut ? tasks[i].Cut : *next++);
  }
  const auto planning = [this](double fraction) { return this->Tell(CutShare + PlanShare * fraction); };
  const auto addUp = [this](std::int64_t& evaluations) { return this->AddUpPlans(evaluations); };
  const bool works = this->Failure.empty();
  if (this->Planned &&
    !this->Plans.Plan(works ? tasks : std::vector<FaceTask>(), this->Faces, this->Chosen, this->UsePlacements,
      this->MaximumEvaluations, planning, addUp))
  {
    return this->Fail("aborted");
  }
  this->Loosened = this->Planned && this->Plans.WasLoosened();
  const auto acquiring = [this](double fraction)
  { return this->Tell(CutShare + PlanShare + AcquireShare * fraction); };
  if (works && !tasks.empty())
  {
    ok = this->Runner->Acquire(this->Faces, acquiring) || this->FailAlone(this->Runner->GetError());
  }
  return this->Agree(nothing) && ok;
}

void SurfaceIntegrator::Internals::Begin(const Progress& progress)
{
  this->Error.clear();
  this->Failure.clear();
  this->Aborted = this->TimedOut = this->Loosened = this->IsShared = false;
  this->Start = Now();
  this->Seconds = this->MaximumSeconds;
  this->Allowance = this->MaximumEvaluations;
  this->ForcedLoosenings = -1;
  this->Evaluations = 0;
  this->StartSeconds = this->PrepareSeconds = this->IntegrateSeconds = 0.0;
  this->ItemsDone = 0;
  this->Report = progress;
  this->Ranks.clear();
}

FaceIntegrals SurfaceIntegrator::Internals::GetNothing() const
{
  FaceIntegrals nothing;
  for (const std::string& obstacle : this->Obstacles)
  {
    const double value = obstacle.empty() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    for (std::vector<double>* values :
      { &nothing.Face, &nothing.Closing, &nothing.QuadratureError, &nothing.Rounding, &nothing.Conversion })
    {
      values->push_back(value);
    }
  }
  return nothing;
}

bool SurfaceIntegrator::Internals::Run(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  results.assign(tasks.size(), this->GetNothing());
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

void SurfaceIntegrator::SetKeepFaces(bool keep)
{
  this->Implementation->KeepFaces = keep;
  if (!keep)
  {
    this->ForgetFaces();
  }
}

void SurfaceIntegrator::ForgetFaces()
{
  this->Implementation->Memory.Forget();
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
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results, const Progress& progress)
{
  Internals& self = *this->Implementation;
  self.Begin(progress);
  self.Configure();
  results.assign(tasks.size(), self.GetNothing());
  if (tasks.empty() || self.Chosen.empty())
  {
    this->Dismiss();
    return !self.Integrands.empty() || self.Fail("there is nothing to integrate: add an integrand");
  }
  const bool ok = self.Exchange ? self.IntegrateShared(tasks, results) : self.Run(tasks, results);
  if (ok)
  {
    // One that was stopped before asked for no face.
    self.Memory.EndRun();
  }
  self.Report = nullptr;
  return ok;
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

double SurfaceIntegrator::GetIntegrateSeconds() const
{
  return this->Implementation->IntegrateSeconds;
}
}
