#include "smSurfaceIntegrator.h"

#include "smComputeBuffer.h"
#include "smContextScope.h"
#include "smGaussLegendre.h"
#include "smIntegrationOrders.h"
#include "smIntegrationPrograms.h"
#include "smReduction.h"
#include "smResidentFaces.h"
#include "smWorkItems.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <map>
#include <utility>

namespace sm
{
namespace
{
// Invocations per work group, as in the shaders.
constexpr unsigned int LocalSize = 32;
// Estimated cost (evaluations times the degree's share) of one dispatch: some 50 ms on two CPU cores, so that
// abort is heard and no driver's watchdog fires.
constexpr std::int64_t CostPerDispatch = 4000000;
// Items of one batch: bounds the memory of rows and lists.
constexpr std::size_t ItemsPerBatch = 262144;
// Gauss-Newton steps to the foot point of a gap.
constexpr int FootPointSteps = 3;
// Halvings of t and xi after the ladder's end.
constexpr int MaximumBisections = 6;

double Now()
{
  return vtkTimerLog::GetUniversalTime();
}
}

struct SurfaceIntegrator::Internals
{
  explicit Internals(vtkComputeContext* context)
    : Context(context)
    , Resident(context)
    , Programs(context)
    , Sums(context)
    , Work(context)
    , Parameters(context)
    , Rows(context)
    , StatusFlags(context)
  {
  }

  vtkSmartPointer<vtkComputeContext> Context;
  ResidentFaces Resident;
  IntegrationPrograms Programs;
  Reduction Sums;
  ComputeBuffer Work;
  ComputeBuffer Parameters;
  ComputeBuffer Rows;
  ComputeBuffer StatusFlags;
  std::vector<Integrand> Integrands;
  bool UsePlacements = false;
  double Perturbation = 1.0;
  bool Configured = false;
  std::int64_t MaximumEvaluations = 2000000000;

  std::string Error;
  bool Aborted = false;
  std::int64_t Evaluations = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double IntegrateSeconds = 0.0;

  Progress Report;
  std::size_t ItemsDone = 0;
  std::size_t ItemsTotal = 1;
  unsigned int PlacementOffset = 0;

  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }
  bool Tell(const Progress& progress, double fraction);
  /// Items that one pass may have: their rows and work records fit into a storage block each.
  std::size_t GetRowLimit() const;
  bool Configure();
  bool WarmUp(const std::vector<ResidentFace>& locations, double& seconds);
  bool UploadParameters(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    const std::vector<ResidentFace>& places);
  bool RunBatch(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    const std::vector<ResidentFace>& places, std::vector<FaceIntegrals>& results);
  bool RunItems(int page, std::vector<WorkItem>& items, const std::vector<std::size_t>& batch, int depth,
    std::vector<FaceIntegrals>& results);
  bool RunDispatch(int page, const ProgramKey& key, std::size_t begin, std::size_t count);
  bool RunLevel(int page, std::vector<WorkItem>& items, std::vector<std::size_t>& active);
  bool Accumulate(const std::vector<WorkItem>& items, const std::vector<std::size_t>& batch,
    std::vector<FaceIntegrals>& results);
};

bool SurfaceIntegrator::Internals::Tell(const Progress& progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    this->Aborted = true;
    return this->Fail("aborted");
  }
  return true;
}

std::size_t SurfaceIntegrator::Internals::GetRowLimit() const
{
  const std::size_t bytes = std::max(this->Programs.GetStride() * sizeof(double), sizeof(WorkRecord));
  const auto block = static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize());
  return std::clamp<std::size_t>(block / bytes, 1, ItemsPerBatch);
}

bool SurfaceIntegrator::Internals::Configure()
{
  if (!this->Configured)
  {
    this->Programs.Configure(this->Integrands, OrderLadder(this->Integrands).GetStripPoints(),
      this->UsePlacements, this->Perturbation);
    this->Configured = true;
  }
  return !this->Integrands.empty() || this->Fail("there is nothing to integrate: add an integrand");
}

bool SurfaceIntegrator::Internals::WarmUp(const std::vector<ResidentFace>& locations, double& seconds)
{
  const double start = Now();
  std::map<ProgramKey, int> needed;
  for (const ResidentFace& face : locations)
  {
    const std::pair<ItemKind, std::size_t> counts[] = { { ItemKind::Panel, face.Panels->Panels.size() },
      { ItemKind::Ribbon, face.Panels->Ribbons.size() }, { ItemKind::Cap, face.Panels->Caps.size() } };
    for (const auto& [kind, count] : counts)
    {
      if (count > 0)
      {
        needed[IntegrationPrograms::ChooseProgram(kind, face.Degree[0], face.Degree[1])] = face.Page;
      }
    }
  }
  if (!this->Work.Allocate(sizeof(WorkRecord)) || !this->Parameters.Allocate(sizeof(double)) ||
    !this->Rows.Allocate(sizeof(double)) || !this->StatusFlags.Allocate(sizeof(std::uint32_t)))
  {
    return this->Fail(this->Work.GetError() + this->Parameters.GetError());
  }
  const ContextScope scope(this->Context);
  if (!scope)
  {
    return this->Fail(this->Context->GetReason());
  }
  for (const auto& [key, page] : needed)
  {
    ComputeProgram* program = this->Programs.Get(key);
    if (!program)
    {
      return this->Fail(this->Programs.GetError());
    }
    // Drivers finish compiling at the first dispatch: one with nothing to do.
    const bool bound =
      std::get<0>(key) == ItemKind::Cap ? this->Resident.BindCaps(page) : this->Resident.Bind(page);
    if (!bound || !this->Work.Bind(3) || !this->Parameters.Bind(4) || !this->Rows.Bind(5) ||
      !this->StatusFlags.Bind(6) || !program->SetUniform("smWorkCount", 0u) ||
      !program->Dispatch(1, LocalSize))
    {
      return this->Fail("a shader could not be run: " + program->GetError());
    }
  }
  seconds += Now() - start;
  return true;
}

bool SurfaceIntegrator::Internals::UploadParameters(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, const std::vector<ResidentFace>& places)
{
  std::vector<double> parameters = MakeRuleTable();
  for (const std::size_t task : batch)
  {
    const FacePanels& panels = *places[task].Panels;
    const std::size_t count = panels.Panels.size() + panels.Ribbons.size() + panels.Caps.size();
    for (const double tolerance : tasks[task].Tolerances)
    {
      parameters.push_back(tolerance / std::max<std::size_t>(count, 1));
    }
  }
  if (this->UsePlacements)
  {
    for (const std::size_t task : batch)
    {
      parameters.insert(parameters.end(), tasks[task].Placement.begin(), tasks[task].Placement.end());
    }
  }
  return this->Parameters.Upload(parameters) || this->Fail(this->Parameters.GetError());
}

bool SurfaceIntegrator::Internals::RunDispatch(
  int page, const ProgramKey& key, std::size_t begin, std::size_t count)
{
  // A scope for each dispatch: progress is reported between them, and whoever watches may render elsewhere.
  const ContextScope scope(this->Context);
  if (!scope)
  {
    return this->Fail("the OpenGL context was lost: " + this->Context->GetReason());
  }
  ComputeProgram* program = this->Programs.Get(key);
  if (!program)
  {
    return this->Fail(this->Programs.GetError());
  }
  const bool isCap = std::get<0>(key) == ItemKind::Cap;
  program->SetUniform("smFirstWork", static_cast<unsigned int>(begin));
  program->SetUniform(
    "smToleranceOffset", static_cast<unsigned int>(MaximumRuleSize * (MaximumRuleSize + 1)));
  program->SetUniform("smPlacementOffset", this->PlacementOffset);
  program->SetUniform("smIntegrandCount", static_cast<unsigned int>(this->Integrands.size()));
  program->SetUniform("smGapSteps", FootPointSteps);
  program->SetUniform("smRoundingCount", static_cast<unsigned int>(this->Programs.GetNumberOfRoundings()));
  if (!(isCap ? this->Resident.BindCaps(page) : this->Resident.Bind(page)) || !this->Work.Bind(3) ||
    !this->Parameters.Bind(4) || !this->Rows.Bind(5) || !this->StatusFlags.Bind(6) ||
    !program->SetUniform("smWorkCount", static_cast<unsigned int>(count)) ||
    !program->Dispatch(static_cast<unsigned int>(count), LocalSize))
  {
    return this->Fail("a dispatch failed: " + program->GetError() + this->Work.GetError() +
      this->Parameters.GetError() + this->Rows.GetError() + this->StatusFlags.GetError());
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunLevel(
  int page, std::vector<WorkItem>& items, std::vector<std::size_t>& active)
{
  // By program and order, so that neighbouring invocations do the same; stable within.
  std::stable_sort(active.begin(), active.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::tie(items[a].Program, items[a].Work.Detail[0]) <
        std::tie(items[b].Program, items[b].Work.Detail[0]);
    });
  std::vector<WorkRecord> work;
  work.reserve(active.size());
  for (const std::size_t index : active)
  {
    work.push_back(items[index].Work);
  }
  const std::uint32_t zero = 0;
  if (!this->Work.Upload(work) || !this->StatusFlags.Allocate((active.size() + 1) * sizeof(std::uint32_t)) ||
    !this->StatusFlags.Upload(&zero, sizeof(zero)))
  {
    return this->Fail("the work list does not fit on the GPU: " + this->Work.GetError());
  }
  for (std::size_t begin = 0; begin < active.size();)
  {
    const ProgramKey key = items[active[begin]].Program;
    std::size_t end = begin;
    std::int64_t cost = 0;
    while (end < active.size() && items[active[end]].Program == key && cost < CostPerDispatch)
    {
      const WorkItem& item = items[active[end]];
      const std::uint32_t detail = item.Work.Detail[0];
      cost += static_cast<std::int64_t>((detail >> 8) & 255u) * ((detail >> 16) & 255u) * item.Cost;
      ++end;
    }
    if (!this->RunDispatch(page, key, begin, end - begin))
    {
      return false;
    }
    begin = end;
    const double done = std::min(1.0, static_cast<double>(this->ItemsDone) / this->ItemsTotal);
    if (!this->Tell(this->Report, 0.5 + 0.5 * done))
    {
      return false;
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::Accumulate(const std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  // Rows of a face lie together, its panels first.
  const std::size_t faces = batch.size();
  std::vector<std::pair<unsigned int, unsigned int>> segments(2 * faces, { 0u, 0u });
  for (std::size_t row = 0; row < items.size(); ++row)
  {
    const bool isPanel = std::get<0>(items[row].Program) == ItemKind::Panel;
    auto& segment = segments[2 * items[row].Work.Item[3] + (isPanel ? 0 : 1)];
    segment.first = segment.second == 0 ? static_cast<unsigned int>(row) : segment.first;
    segment.second = static_cast<unsigned int>(row + 1);
  }
  const auto stride = static_cast<unsigned int>(this->Programs.GetStride());
  std::vector<double> sums;
  std::vector<double> largest;
  if (!this->Sums.Reduce(this->Rows, stride, stride, segments, Reduction::Operation::SUM, sums) ||
    !this->Sums.Reduce(this->Rows, stride, 1, segments, Reduction::Operation::MAXIMUM, largest))
  {
    return this->Fail("the reduction failed: " + this->Sums.GetError());
  }
  const std::size_t count = this->Integrands.size();
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
      const double* sum = sums.data() + segment * stride;
      std::vector<double>& values = part == 0 ? result.Face : result.Closing;
      for (std::size_t k = 0; k < count; ++k)
      {
        values[k] += sum[3 + k];
        result.QuadratureError[k] += sum[3 + count + k];
        result.Rounding[k] += sum[3 + 2 * count + this->Programs.GetRoundingOf(static_cast<int>(k))];
      }
      result.GapSquared += sum[1];
      result.GapArea += sum[2];
      // Not std::max, which loses a NaN.
      result.MaxGap = largest[segment] <= result.MaxGap ? result.MaxGap : largest[segment];
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunItems(int page, std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
{
  const OrderLadder ladder(this->Integrands);
  const std::size_t rowBytes = this->Programs.GetStride() * sizeof(double);
  if (!this->Rows.Allocate(items.size() * rowBytes) || !this->Rows.Clear())
  {
    return this->Fail("the results do not fit on the GPU: " + this->Rows.GetError());
  }
  std::vector<std::size_t> active(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    active[i] = i;
    items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::size_t> bisected;
  std::vector<std::uint32_t> status;
  for (int level = 0; !active.empty(); ++level)
  {
    const bool mayBisect = depth < MaximumBisections && this->Evaluations < this->MaximumEvaluations;
    for (const std::size_t index : active)
    {
      WorkItem& item = items[index];
      const Orders orders = GetItemOrders(ladder, item);
      SetItemOrders(item, orders, mayBisect);
    }
    if (!this->RunLevel(page, items, active))
    {
      return false;
    }
    status.resize(active.size() + 1);
    if (!this->StatusFlags.Read(status.data(), status.size() * sizeof(status[0])))
    {
      return this->Fail(this->StatusFlags.GetError());
    }
    this->Evaluations += status[0];

    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < active.size(); ++i)
    {
      WorkItem& item = items[active[i]];
      const Orders orders = GetItemOrders(ladder, item);
      const bool compared = item.Level > 0 || orders.Exact;
      if (orders.Exact || (compared && status[1 + i] == 0))
      {
        continue;
      }
      if (orders.Last && mayBisect)
      {
        bisected.push_back(active[i]);
      }
      else if (orders.Last || (compared && this->Evaluations >= this->MaximumEvaluations))
      {
        ++results[batch[item.Work.Item[3]]].Unconverged;
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
  if (!this->Accumulate(items, batch, results))
  {
    return false;
  }
  if (bisected.empty())
  {
    return true;
  }
  std::sort(bisected.begin(), bisected.end());
  std::vector<WorkItem> children;
  for (const std::size_t index : bisected)
  {
    BisectItem(items[index], children);
  }
  // In portions that fit into the buffers; the results of a face add up in order.
  const std::size_t portion = this->GetRowLimit();
  for (std::size_t begin = 0; begin < children.size(); begin += portion)
  {
    const std::size_t end = std::min(begin + portion, children.size());
    std::vector<WorkItem> part(children.begin() + static_cast<std::ptrdiff_t>(begin),
      children.begin() + static_cast<std::ptrdiff_t>(end));
    if (!this->RunItems(page, part, batch, depth + 1, results))
    {
      return false;
    }
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunBatch(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, const std::vector<ResidentFace>& places,
  std::vector<FaceIntegrals>& results)
{
  std::vector<WorkItem> items;
  for (std::size_t slot = 0; slot < batch.size(); ++slot)
  {
    AddItems(places[batch[slot]], static_cast<std::uint32_t>(slot), items);
  }
  this->PlacementOffset = static_cast<unsigned int>(
    MaximumRuleSize * (MaximumRuleSize + 1) + batch.size() * this->Integrands.size());
  if (!this->UploadParameters(tasks, batch, places))
  {
    return false;
  }
  // More than one portion only for a face that alone exceeds the limit.
  const std::size_t portion = this->GetRowLimit();
  for (std::size_t begin = 0; begin < items.size(); begin += portion)
  {
    const std::size_t end = std::min(begin + portion, items.size());
    std::vector<WorkItem> part(
      items.begin() + static_cast<std::ptrdiff_t>(begin), items.begin() + static_cast<std::ptrdiff_t>(end));
    if (!this->RunItems(places[batch.front()].Page, part, batch, 0, results))
    {
      return false;
    }
  }
  return true;
}

SurfaceIntegrator::SurfaceIntegrator(vtkComputeContext* context)
  : Implementation(new Internals(context))
{
}

SurfaceIntegrator::~SurfaceIntegrator() = default;

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
  const std::size_t count = self.Integrands.size();
  results.assign(tasks.size(), FaceIntegrals());
  for (FaceIntegrals& result : results)
  {
    result.Face.assign(count, 0.0);
    result.Closing.assign(count, 0.0);
    result.QuadratureError.assign(count, 0.0);
    result.Rounding.assign(count, 0.0);
  }
  if (!self.Configure())
  {
    return false;
  }
  if (tasks.empty())
  {
    return true;
  }

  // Preparing and integrating take about the same time.
  const double start = Now();
  std::vector<FacePointer> faces;
  for (const FaceTask& task : tasks)
  {
    faces.push_back(task.Source);
  }
  std::vector<ResidentFace> places;
  const auto preparing = [&](double fraction) { return self.Tell(progress, 0.5 * fraction); };
  if (!self.Resident.Acquire(faces, places, preparing))
  {
    return self.Fail(self.Error.empty() ? self.Resident.GetError() : self.Error);
  }
  self.PrepareSeconds = Now() - start;
  if (!self.WarmUp(places, self.StartSeconds))
  {
    return false;
  }

  const double begin = Now();
  std::map<int, std::vector<std::size_t>> pages;
  self.ItemsTotal = 1;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    const FacePanels& panels = *places[i].Panels;
    self.ItemsTotal += panels.Panels.size() + panels.Ribbons.size() + panels.Caps.size();
    results[i].Error = places[i].Error;
    results[i].CoverageDefects = panels.CoverageDefects;
    results[i].Outside = panels.Outside;
    pages[places[i].Page].push_back(i);
  }
  self.Report = progress;
  bool ok = true;
  const std::size_t rowLimit = self.GetRowLimit();
  for (const auto& [page, members] : pages)
  {
    std::vector<std::size_t> batch;
    std::size_t items = 0;
    for (std::size_t i = 0; ok && i < members.size(); ++i)
    {
      const FacePanels& panels = *places[members[i]].Panels;
      const std::size_t more = panels.Panels.size() + panels.Ribbons.size() + panels.Caps.size();
      if (!batch.empty() && items + more > rowLimit)
      {
        ok = self.RunBatch(tasks, batch, places, results);
        batch.clear();
        items = 0;
      }
      if (more > 0)
      {
        batch.push_back(members[i]);
        items += more;
      }
    }
    ok = ok && (batch.empty() || self.RunBatch(tasks, batch, places, results));
  }
  self.Report = nullptr;
  self.IntegrateSeconds = Now() - begin;
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
