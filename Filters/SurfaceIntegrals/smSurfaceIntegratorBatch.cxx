// Evaluation of a batch of faces in a SurfaceIntegrator: its items, by levels or as planned, and their sums.
#include "Items/smRunnerCheck.h"
#include "smCoedgeGaps.h"
#include "smIntegrationOrders.h"
#include "smParallelFor.h"
#include "smSurfaceIntegratorInternals.h"
#include "smUnitRoundoff.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sm
{
namespace
{
// Largest number of halvings of t and xi after the last order of the ladder.
constexpr int MaximumBisections = 6;
}

void SurfaceIntegrator::Internals::Store(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, const std::vector<FaceIntegrals>& results)
{
  // After the budget is spent, results depend on earlier evaluations and are not kept.
  for (std::size_t i = 0; i < batch.size() && this->CacheFaceResults && this->Evaluations < this->Allowance;
       ++i)
  {
    const FaceTask& task = tasks[batch[i]];
    auto result = std::make_shared<const FaceIntegrals>(results[batch[i]]);
    const std::size_t bytes = CountBytes(*result);
    this->Results.Store(task.Source->Id, this->GetResultKey(task, batch[i]), std::move(result), bytes);
  }
}

void SurfaceIntegrator::Internals::AddBounds(const std::vector<FaceTask>& tasks,
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
    double area = plan.Area;
    for (std::size_t k = 0; k < this->Chosen.size(); ++k)
    {
      // In a planned run the rows have errors only for the area of compared items, and for values that are
      // not finite.
      double& error = result.QuadratureError[this->Chosen[k]];
      const bool compared = this->Plans.GetBoundClass(k).Kind == BoundClass::AreaMoment;
      error = compared || !std::isfinite(error) ? error : 0.0;
      error += plan.QuadratureBound[this->Plans.GetClass(k)];
      result.Conversion[this->Chosen[k]] += plan.ConversionBound[this->Plans.GetClass(k)];
      result.Residual[this->Chosen[k]] += plan.ResidualBound[this->Plans.GetClass(k)];
      if (this->Plans.GetBoundClass(k) == PlainArea)
      {
        area = std::fmin(area, result.Face[this->Chosen[k]] + result.GetBound(this->Chosen[k]));
      }
    }
    LimitByMagnitude(tasks[face], plan, result);
    for (std::size_t k = 0; k < this->Chosen.size(); ++k)
    {
      const BoundClass& integrand = this->Plans.GetBoundClass(k);
      result.Conversion[this->Chosen[k]] += plan.Reading.GetBound(integrand, area, result.GapArea) +
        tasks[face].PlacementBound.GetBound(integrand, area, result.GapArea, plan.Reading.Reach);
    }
  }
}

void SurfaceIntegrator::Internals::LimitByMagnitude(
  const FaceTask& task, const FacePlan& plan, FaceIntegrals& result) const
{
  for (std::size_t k = 0; k < this->Chosen.size() && plan.IsLimitedByHull; ++k)
  {
    const std::size_t to = this->Chosen[k];
    const double magnitude = plan.Magnitude[this->Plans.GetClass(k)];
    const bool isUseless = !(result.QuadratureError[to] + result.Rounding[to] <= magnitude);
    if (isUseless)
    {
      result.LeftOut = result.LeftOut || magnitude > task.Tolerances[to];
      result.Face[to] = result.Closing[to] = result.Rounding[to] = 0.0;
      result.QuadratureError[to] = magnitude;
    }
  }
}

bool SurfaceIntegrator::Internals::Accumulate(const std::vector<WorkItem>& items,
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  std::vector<RowPart> parts;
  for (std::uint32_t row = 0; row < items.size(); ++row)
  {
    const WorkItem& item = items[row];
    if (parts.empty() || parts.back().Slot != item.GetSlot() || parts.back().Kind != item.Kind ||
      parts.back().Coedge != item.Coedge)
    {
      parts.push_back({ item.GetSlot(), item.Kind, item.Coedge, row, row });
    }
    parts.back().End = row + 1;
  }
  std::vector<std::size_t> faces;
  std::vector<FaceTotals> totals;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (i == 0 || parts[i].Slot != parts[i - 1].Slot)
    {
      faces.push_back(batch[parts[i].Slot]);
      totals.push_back(this->GetTotals(results[faces.back()]));
    }
  }
  std::vector<RowGaps> gaps;
  if (!this->Runner->AddUp(parts, totals, gaps))
  {
    return this->FailByRunner();
  }
  std::size_t part = 0;
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    FaceIntegrals& result = results[faces[i]];
    this->SetTotals(totals[i], result);
    CoedgeGaps coedges(*this->Faces[faces[i]]->Source, result.Gaps);
    for (const std::uint32_t slot = parts[part].Slot; part < parts.size() && parts[part].Slot == slot; ++part)
    {
      if (parts[part].Coedge >= 0)
      {
        coedges.Add(parts[part].Coedge, { 0, 0, gap->Squared, gap->Area, gap->Largest });
        ++gap;
      }
    }
  }
  return true;
}

FaceTotals SurfaceIntegrator::Internals::GetTotals(const FaceIntegrals& result) const
{
  FaceTotals totals(this->Chosen.size());
  for (std::size_t k = 0; k < this->Chosen.size(); ++k)
  {
    totals.Face[k] = result.Face[this->Chosen[k]];
    totals.Chain[k] = result.Closing[this->Chosen[k]];
    totals.Error[k] = result.QuadratureError[this->Chosen[k]];
    totals.Rounding[k] = result.Rounding[this->Chosen[k]];
  }
  totals.Gaps = { result.MaxGap, result.GapSquared, result.GapArea };
  return totals;
}

void SurfaceIntegrator::Internals::SetTotals(const FaceTotals& totals, FaceIntegrals& result) const
{
  for (std::size_t k = 0; k < this->Chosen.size(); ++k)
  {
    result.Face[this->Chosen[k]] = totals.Face[k];
    result.Closing[this->Chosen[k]] = totals.Chain[k];
    result.QuadratureError[this->Chosen[k]] = totals.Error[k];
    result.Rounding[this->Chosen[k]] = totals.Rounding[k];
  }
  result.MaxGap = totals.Gaps.Largest;
  result.GapSquared = totals.Gaps.Squared;
  result.GapArea = totals.Gaps.Area;
}

bool SurfaceIntegrator::Internals::RunLevels(
  std::vector<WorkItem>& items, int depth, std::vector<std::size_t>& bisected)
{
  const OrderLadder ladder(this->ChosenIntegrands);
  const auto shouldContinue = [this]() { return this->ReportItemProgress(); };
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
    if (!this->Runner->Run(items, active, this->Evaluations, shouldContinue) ||
      !this->Runner->GetUnconverged(unconverged))
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
  std::vector<WorkItem>& items, int depth, std::vector<std::size_t>& candidates)
{
  std::vector<std::size_t> compared;
  std::vector<std::size_t> all(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    all[i] = i;
    items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
    if (items[i].Compared)
    {
      compared.push_back(i);
    }
  }
  const auto shouldContinue = [this]() { return this->ReportItemProgress(); };
  if (!this->Runner->Run(items, all, this->Evaluations, shouldContinue))
  {
    return this->FailByRunner();
  }
  this->ItemsDone += depth == 0 ? items.size() : 0;
  if (compared.empty())
  {
    return true;
  }
  // The plan's bounds of everything but the area also hold for the parts, since their ellipses lie in that of
  // the whole item.
  const bool mayBisect = depth < MaximumBisections && this->Evaluations < this->Allowance;
  for (const std::size_t i : compared)
  {
    DoubleOrders(items[i], mayBisect);
  }
  if (!this->Runner->Run(items, compared, this->Evaluations, shouldContinue))
  {
    return this->FailByRunner();
  }
  if (mayBisect)
  {
    candidates = std::move(compared);
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
  std::vector<std::size_t> candidates;
  const bool ran =
    this->Planned ? this->RunPlanned(items, depth, candidates) : this->RunLevels(items, depth, bisected);
  if (!ran || !this->Accumulate(items, batch, results))
  {
    return false;
  }
  std::vector<std::uint8_t> unconverged;
  if (!candidates.empty() && !this->Runner->GetUnconverged(unconverged))
  {
    return this->FailByRunner();
  }
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (unconverged[i] != 0)
    {
      bisected.push_back(candidates[i]);
    }
  }
  std::vector<WorkItem> children;
  for (const std::size_t index : bisected)
  {
    // The parts share their parent's tolerance. Along a line with vanishing normals, half of the quarters
    // need no part of it.
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
  // Items are evaluated in portions that have room for their rows; the results of a face are added up in
  // order. The end of a portion within a face must not depend on other faces: it is before the face, or where
  // the face has filled entire portions of its own.
  const std::size_t portion = this->Runner->GetRowLimit();
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < items.size(); begin = end)
  {
    end = std::min(begin + portion, items.size());
    if (begin == 0 && end == items.size())
    {
      return this->RunItems(items, batch, depth, results);
    }
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

void SurfaceIntegrator::Internals::MakeItems(
  const std::vector<std::size_t>& batch, std::vector<WorkItem>& items) const
{
  std::vector<std::size_t> firsts;
  std::size_t count = 0;
  for (const std::size_t face : batch)
  {
    firsts.push_back(count);
    count += this->GetNumberOfItems(face);
  }
  items.resize(count);
  ParallelFor(batch.size(), 0,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t slot = begin; slot < end; ++slot)
      {
        MakePlannedItems(*this->Faces[batch[slot]], this->Plans.Get(batch[slot]),
          static_cast<std::uint32_t>(slot), items.data() + firsts[slot]);
      }
    });
}

bool SurfaceIntegrator::Internals::CheckRunner(
  const std::vector<ItemRunner::BatchFace>& faces, const std::vector<WorkItem>& items)
{
  // Nothing is proved by expressions alone, which the CPU cannot evaluate.
  const bool isComparable = std::any_of(this->ChosenIntegrands.begin(), this->ChosenIntegrands.end(),
    [](const Integrand& integrand) { return integrand.Form != Integrand::Kind::User; });
  if (!isComparable)
  {
    return true;
  }
  std::vector<WorkItem> examples;
  for (const WorkItem& item : items)
  {
    if (!this->Runner->IsProved(item))
    {
      this->Runner->SetProved(item);
      examples.push_back(item);
      if (!this->Planned)
      {
        SetItemOrders(examples.back(), GetItemOrders(OrderLadder(this->ChosenIntegrands), item), false);
      }
    }
  }
  if (examples.empty())
  {
    return true;
  }
  const ItemRunner::Setup setup = { this->ChosenIntegrands,
    OrderLadder(this->ChosenIntegrands).GetStripPoints(), this->UsePlacements, this->Perturbation };
  const double start = vtkTimerLog::GetUniversalTime();
  this->Distrust = FindRunnerDifference(*this->Runner, setup, this->Faces, faces, examples);
  // It belongs to the start of a context, not to the part.
  const double seconds = vtkTimerLog::GetUniversalTime() - start;
  this->StartSeconds += seconds;
  this->IntegrateSeconds -= seconds;
  if (!this->Distrust.empty())
  {
    // The next run must not take the programs for proved.
    this->Runner->ForgetProofs();
    return this->Fail(this->Distrust);
  }
  return true;
}

bool SurfaceIntegrator::Internals::RunBatch(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  std::vector<WorkItem> items;
  std::vector<ItemRunner::BatchFace> faces;
  faces.reserve(batch.size());
  for (std::size_t slot = 0; slot < batch.size(); ++slot)
  {
    const FaceTask& task = tasks[batch[slot]];
    const CutFace& cut = *this->Faces[batch[slot]];
    if (!this->Planned)
    {
      AddItems(cut, static_cast<std::uint32_t>(slot), items);
    }
    ItemRunner::BatchFace face{ batch[slot], {}, task.Placement };
    for (const std::size_t k : this->Chosen)
    {
      face.Tolerances.push_back(
        task.Tolerances[k] / (this->Planned ? 1 : std::max<std::size_t>(cut.GetNumberOfItems(), 1)));
    }
    faces.push_back(std::move(face));
  }
  if (this->Planned)
  {
    this->MakeItems(batch, items);
  }
  if (!this->Runner->BeginBatch(faces))
  {
    return this->FailByRunner();
  }
  if (!this->CheckRunner(faces, items) || !this->RunPortions(items, batch, 0, results))
  {
    return false;
  }
  this->AddBounds(tasks, batch, results);
  this->Store(tasks, batch, results);
  return true;
}
}
