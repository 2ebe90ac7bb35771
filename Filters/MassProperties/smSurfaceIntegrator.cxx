#include "smSurfaceIntegrator.h"

#include "smFacePanelsCache.h"
#include "smIntegrationOrders.h"
#include "smItemRunner.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace sm
{
namespace
{
// Halvings of t and xi after the ladder's end.
constexpr int MaximumBisections = 6;
// Of the progress: cutting, then what the runner needs of the faces; integrating is the rest.
constexpr double CutShare = 0.4;
constexpr double AcquireShare = 0.1;

double Now()
{
  return vtkTimerLog::GetUniversalTime();
}
}

struct SurfaceIntegrator::Internals
{
  std::unique_ptr<ItemRunner> Runner;
  FacePanelsCache Cuts;
  std::vector<Integrand> Integrands;
  bool UsePlacements = false;
  double Perturbation = 1.0;
  bool Configured = false;
  std::int64_t MaximumEvaluations = 2000000000;

  /// The integrands that the runner evaluates: which of all they are.
  std::vector<std::size_t> Chosen;
  std::vector<Integrand> ChosenIntegrands;
  std::vector<std::string> Obstacles;

  std::string Error;
  bool Aborted = false;
  std::int64_t Evaluations = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double IntegrateSeconds = 0.0;

  /// Of the running Integrate().
  Progress Report;
  std::vector<CutFacePointer> Faces;
  std::size_t ItemsDone = 0;
  std::size_t ItemsTotal = 1;

  bool Fail(const std::string& what)
  {
    // An abort is told by Tell(), whoever passes it on.
    this->Error = this->Aborted ? "aborted" : what;
    return false;
  }
  bool FailByRunner() { return this->Fail(this->Runner->GetError()); }
  bool Tell(double fraction);
  void Configure();
  bool Prepare(const std::vector<FaceTask>& tasks);
  std::size_t GetNumberOfItems(std::size_t face) const;
  bool RunAll(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  bool RunBatch(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    std::vector<FaceIntegrals>& results);
  bool RunPortions(std::vector<WorkItem>& items, const std::vector<std::size_t>& batch, int depth,
    std::vector<FaceIntegrals>& results);
  bool RunItems(std::vector<WorkItem>& items, const std::vector<std::size_t>& batch, int depth,
    std::vector<FaceIntegrals>& results);
  bool RunLevels(std::vector<WorkItem>& items, const std::vector<std::size_t>& batch, int depth,
    std::vector<std::size_t>& bisected, std::vector<FaceIntegrals>& results);
  bool Accumulate(const std::vector<WorkItem>& items, const std::vector<std::size_t>& batch,
    std::vector<FaceIntegrals>& results);
};

bool SurfaceIntegrator::Internals::Tell(double fraction)
{
  if (this->Report && !this->Report(fraction))
  {
    this->Aborted = true;
    return this->Fail("aborted");
  }
  return true;
}

void SurfaceIntegrator::Internals::Configure()
{
  if (this->Configured)
  {
    return;
  }
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
  this->Runner->Configure({ this->ChosenIntegrands, OrderLadder(this->ChosenIntegrands).GetStripPoints(),
    this->UsePlacements, this->Perturbation });
  this->Configured = true;
}

std::size_t SurfaceIntegrator::Internals::GetNumberOfItems(std::size_t face) const
{
  return this->Runner->GetFaceError(face).empty() ? this->Faces[face]->GetNumberOfItems() : 0;
}

bool SurfaceIntegrator::Internals::Accumulate(const std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  // Rows of a face lie together, its panels first.
  const std::size_t faces = batch.size();
  std::vector<ItemRunner::Segment> segments(2 * faces, { 0u, 0u });
  for (std::size_t row = 0; row < items.size(); ++row)
  {
    auto& segment = segments[2 * items[row].GetSlot() + (items[row].Kind == ItemKind::Panel ? 0 : 1)];
    segment.first = segment.second == 0 ? static_cast<unsigned int>(row) : segment.first;
    segment.second = static_cast<unsigned int>(row + 1);
  }
  std::vector<double> sums;
  std::vector<double> largest;
  if (!this->Runner->Sum(segments, sums, largest))
  {
    return this->FailByRunner();
  }
  const RowLayout& layout = this->Runner->GetLayout();
  for (std::size_t slot = 0; slot < faces; ++slot)
  {
    FaceIntegrals& result = results[batch[slot]];
    for (int part = 0; part < 2; ++part)
    {
      const std::size_t segment = 2 * slot + part;
      if (segments[segment].second == 0)
      {
        continue;
      }
      const double* sum = sums.data() + segment * layout.GetStride();
      std::vector<double>& values = part == 0 ? result.Face : result.Closing;
      for (int k = 0; k < layout.GetNumberOfIntegrands(); ++k)
      {
        const std::size_t to = this->Chosen[k];
        values[to] += sum[layout.GetValue(k)];
        result.QuadratureError[to] += sum[layout.GetError(k)];
        result.Rounding[to] += sum[layout.GetRounding(k)];
      }
      result.GapSquared += sum[RowLayout::SquaredGap];
      result.GapArea += sum[RowLayout::GapArea];
      // Not std::max, which loses a NaN.
      result.MaxGap = largest[segment] <= result.MaxGap ? result.MaxGap : largest[segment];
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunLevels(std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, int depth, std::vector<std::size_t>& bisected,
  std::vector<FaceIntegrals>& results)
{
  const OrderLadder ladder(this->ChosenIntegrands);
  const auto goOn = [this]()
  {
    const double done = std::min(1.0, static_cast<double>(this->ItemsDone) / this->ItemsTotal);
    return this->Tell(CutShare + AcquireShare + (1.0 - CutShare - AcquireShare) * done);
  };
  std::vector<std::size_t> active(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    active[i] = i;
    items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
  }
  std::vector<std::uint8_t> unconverged;
  for (int level = 0; !active.empty(); ++level)
  {
    const bool mayBisect = depth < MaximumBisections && this->Evaluations < this->MaximumEvaluations;
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
      else if (orders.Last || (compared && this->Evaluations >= this->MaximumEvaluations))
      {
        ++results[batch[item.GetSlot()]].Unconverged;
      }
      else
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

bool SurfaceIntegrator::Internals::RunItems(std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
{
  if (!this->Runner->BeginRows(items.size()))
  {
    return this->FailByRunner();
  }
  std::vector<std::size_t> bisected;
  if (!this->RunLevels(items, batch, depth, bisected, results) || !this->Accumulate(items, batch, results))
  {
    return false;
  }
  std::vector<WorkItem> children;
  for (const std::size_t index : bisected)
  {
    BisectItem(items[index], children);
  }
  return this->RunPortions(children, batch, depth + 1, results);
}

bool SurfaceIntegrator::Internals::RunPortions(std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
{
  // In portions that have room for their rows; the results of a face add up in order.
  const std::size_t portion = this->Runner->GetRowLimit();
  for (std::size_t begin = 0; begin < items.size(); begin += portion)
  {
    const std::size_t end = std::min(begin + portion, items.size());
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
    AddItems(cut, static_cast<std::uint32_t>(slot), items);
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
  return this->RunPortions(items, batch, 0, results);
}

bool SurfaceIntegrator::Internals::RunAll(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  std::map<int, std::vector<std::size_t>> groups;
  this->ItemsTotal = 1;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    const CutFace& cut = *this->Faces[i];
    this->ItemsTotal += this->GetNumberOfItems(i);
    results[i].Error = cut.Error.empty() ? this->Runner->GetFaceError(i) : cut.Error;
    results[i].CoverageDefects = cut.Panels.CoverageDefects;
    results[i].Outside = cut.Panels.Outside;
    groups[this->Runner->GetGroup(i)].push_back(i);
  }
  const std::size_t rowLimit = this->Runner->GetRowLimit();
  for (const auto& [group, members] : groups)
  {
    std::vector<std::size_t> batch;
    std::size_t items = 0;
    for (const std::size_t face : members)
    {
      const std::size_t more = this->GetNumberOfItems(face);
      if (!batch.empty() && items + more > rowLimit)
      {
        if (!this->RunBatch(tasks, batch, results))
        {
          return false;
        }
        batch.clear();
        items = 0;
      }
      if (more > 0)
      {
        batch.push_back(face);
        items += more;
      }
    }
    if (!batch.empty() && !this->RunBatch(tasks, batch, results))
    {
      return false;
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::Prepare(const std::vector<FaceTask>& tasks)
{
  std::vector<FacePointer> faces;
  faces.reserve(tasks.size());
  for (const FaceTask& task : tasks)
  {
    faces.push_back(task.Source);
  }
  const auto cutting = [this](double fraction) { return this->Tell(CutShare * fraction); };
  if (!this->Cuts.Acquire(faces, this->Faces, cutting))
  {
    return this->Fail(this->Cuts.GetError());
  }
  const auto acquiring = [this](double fraction) { return this->Tell(CutShare + AcquireShare * fraction); };
  return this->Runner->Acquire(this->Faces, acquiring) || this->FailByRunner();
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

void SurfaceIntegrator::SetMaximumEvaluations(std::int64_t evaluations)
{
  this->Implementation->MaximumEvaluations = evaluations;
}

bool SurfaceIntegrator::Integrate(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results, const Progress& progress)
{
  Internals& self = *this->Implementation;
  self.Error.clear();
  self.Aborted = false;
  self.Evaluations = 0;
  self.StartSeconds = self.PrepareSeconds = self.IntegrateSeconds = 0.0;
  self.ItemsDone = 0;
  self.Configure();
  FaceIntegrals nothing;
  for (const std::string& obstacle : self.Obstacles)
  {
    const double value = obstacle.empty() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    for (std::vector<double>* values :
      { &nothing.Face, &nothing.Closing, &nothing.QuadratureError, &nothing.Rounding })
    {
      values->push_back(value);
    }
  }
  results.assign(tasks.size(), nothing);
  if (self.Integrands.empty())
  {
    return self.Fail("there is nothing to integrate: add an integrand");
  }
  if (tasks.empty() || self.Chosen.empty())
  {
    return true;
  }
  self.Report = progress;
  const double start = Now();
  bool ok = self.Prepare(tasks);
  self.StartSeconds = ok ? self.Runner->GetStartSeconds() : 0.0;
  self.PrepareSeconds = Now() - start - self.StartSeconds;
  if (ok)
  {
    const double begin = Now();
    ok = self.RunAll(tasks, results);
    self.IntegrateSeconds = Now() - begin;
  }
  self.Runner->Release();
  self.Faces.clear();
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
