// Evaluation of a batch of faces in a SurfaceIntegrator: its items, by levels or as planned, and their sums.
#include "Items/smRunnerCheck.h"
#include "smCoedgeGaps.h"
#include "smIntegrationOrders.h"
#include "smParallelFor.h"
#include "smSurfaceIntegratorInternals.h"
#include "smUnitRoundoff.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace sm
{
namespace
{
// Largest number of halvings of t and xi after the last order of the ladder.
constexpr int MaximumBisections = 6;
// Items that a thread takes at a time.
constexpr std::size_t ItemsOfTask = 4096;

/// Calls work(index in the batch, face) for all faces of a batch, on all threads. A thread takes one face at
/// a time: a plate has nearly all of its items in two, which are neighbours.
template <class F>
void ForFaces(const std::vector<std::size_t>& batch, F&& work)
{
  ParallelFor(batch.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        work(i, batch[i]);
      }
    });
}

/// Parts of consecutive rows, those of `items` in [begin, end).
std::vector<RowPart> FindParts(const WorkItems& items, std::size_t begin, std::size_t end)
{
  std::vector<RowPart> parts;
  for (std::size_t row = begin; row < end; ++row)
  {
    const WorkItem& item = items[row];
    if (parts.empty() || !parts.back().Continues(item.GetSlot(), item.Kind, item.Coedge))
    {
      const auto first = static_cast<std::uint32_t>(row);
      parts.push_back({ item.GetSlot(), item.Kind, item.Coedge, first, first });
    }
    parts.back().End = static_cast<std::uint32_t>(row + 1);
  }
  return parts;
}

/// Parts of consecutive rows of all items.
std::vector<RowPart> FindParts(const WorkItems& items)
{
  std::vector<std::vector<RowPart>> found((items.size() + ItemsOfTask - 1) / ItemsOfTask);
  ParallelFor(found.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t task = begin; task < end; ++task)
      {
        const std::size_t from = task * ItemsOfTask;
        found[task] = FindParts(items, from, std::min(from + ItemsOfTask, items.size()));
      }
    });
  std::vector<RowPart> parts;
  for (const std::vector<RowPart>& more : found)
  {
    auto next = more.begin();
    if (!parts.empty() && parts.back().Continues(next->Slot, next->Kind, next->Coedge))
    {
      parts.back().End = next->End;
      ++next;
    }
    parts.insert(parts.end(), next, more.end());
  }
  return parts;
}
}

void SurfaceIntegrator::Internals::Store(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& batch, const std::vector<FaceIntegrals>& results)
{
  // After the budget is spent, results depend on earlier evaluations and are not kept.
  if (!this->CacheFaceResults || this->Evaluations >= this->Allowance)
  {
    return;
  }
  struct Entry
  {
    FaceResultKey Key;
    std::shared_ptr<const FaceIntegrals> Result;
    std::size_t Bytes = 0;
  };
  std::vector<Entry> entries(batch.size());
  ForFaces(batch,
    [&](std::size_t i, std::size_t face)
    {
      auto result = std::make_shared<const FaceIntegrals>(results[face]);
      const std::size_t bytes = CountBytes(*result);
      entries[i] = { this->GetResultKey(tasks[face], face), std::move(result), bytes };
    });
  for (std::size_t i = 0; i < batch.size(); ++i)
  {
    this->Results.Store(
      tasks[batch[i]].Source->Id, std::move(entries[i].Key), std::move(entries[i].Result), entries[i].Bytes);
  }
}

void SurfaceIntegrator::Internals::AddBounds(
  const FaceTask& task, std::size_t face, FaceIntegrals& result) const
{
  if (!this->Planned)
  {
    result.Estimated = true;
    return;
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
  this->LimitByMagnitude(task, plan, result);
  for (std::size_t k = 0; k < this->Chosen.size(); ++k)
  {
    const BoundClass& integrand = this->Plans.GetBoundClass(k);
    result.Conversion[this->Chosen[k]] += plan.Reading.GetBound(integrand, area, result.GapArea) +
      task.PlacementBound.GetBound(integrand, area, result.GapArea, plan.Reading.Reach);
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

bool SurfaceIntegrator::Internals::Accumulate(
  const WorkItems& items, const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results)
{
  const std::vector<RowPart> parts = FindParts(items);
  std::vector<std::size_t> faces;
  // The first part and the first coedge of each face, and their ends.
  std::vector<std::pair<std::size_t, std::size_t>> firsts;
  std::size_t coedges = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (i == 0 || parts[i].Slot != parts[i - 1].Slot)
    {
      faces.push_back(batch[parts[i].Slot]);
      firsts.emplace_back(i, coedges);
    }
    coedges += parts[i].Coedge >= 0 ? 1 : 0;
  }
  firsts.emplace_back(parts.size(), coedges);
  FaceTotals totals(faces.size(), this->Chosen.size());
  ForFaces(faces, [&](std::size_t i, std::size_t face) { this->SetTotals(results[face], totals, i); });
  std::vector<RowGaps> gaps;
  if (!this->Runner->AddUp(parts, totals, gaps))
  {
    return this->FailByRunner();
  }
  ForFaces(faces,
    [&](std::size_t i, std::size_t face)
    {
      this->TakeTotals(totals, i, results[face]);
      CoedgeGaps measured(*this->Faces[face]->Source, results[face].Gaps);
      auto gap = gaps.begin() + static_cast<std::ptrdiff_t>(firsts[i].second);
      for (std::size_t part = firsts[i].first; part < firsts[i + 1].first; ++part)
      {
        if (parts[part].Coedge >= 0)
        {
          measured.Add(parts[part].Coedge, { 0, 0, gap->Squared, gap->Area, gap->Largest });
          ++gap;
        }
      }
    });
  return true;
}

void SurfaceIntegrator::Internals::SetTotals(
  const FaceIntegrals& result, FaceTotals& totals, std::size_t face) const
{
  for (std::size_t k = 0; k < this->Chosen.size(); ++k)
  {
    totals.At(face, k) = { result.Face[this->Chosen[k]], result.Closing[this->Chosen[k]],
      result.QuadratureError[this->Chosen[k]], result.Rounding[this->Chosen[k]] };
  }
  totals.Gaps[face] = { result.MaxGap, result.GapSquared, result.GapArea };
}

void SurfaceIntegrator::Internals::TakeTotals(
  const FaceTotals& totals, std::size_t face, FaceIntegrals& result) const
{
  for (std::size_t k = 0; k < this->Chosen.size(); ++k)
  {
    const RowTotal& total = totals.At(face, k);
    result.Face[this->Chosen[k]] = total.Face;
    result.Closing[this->Chosen[k]] = total.Chain;
    result.QuadratureError[this->Chosen[k]] = total.Error;
    result.Rounding[this->Chosen[k]] = total.Rounding;
  }
  result.MaxGap = totals.Gaps[face].Largest;
  result.GapSquared = totals.Gaps[face].Squared;
  result.GapArea = totals.Gaps[face].Area;
}

bool SurfaceIntegrator::Internals::RunLevels(WorkItems& items, int depth, std::vector<std::size_t>& bisected)
{
  const OrderLadder ladder(this->ChosenIntegrands);
  const auto shouldContinue = [this]() { return this->ReportItemProgress(); };
  std::vector<std::size_t> active(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    active[i] = i;
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
  WorkItems& items, int depth, std::vector<std::size_t>& candidates)
{
  const auto shouldContinue = [this]() { return this->ReportItemProgress(); };
  if (!this->Runner->Run(items, ActiveItems(items), this->Evaluations, shouldContinue))
  {
    return this->FailByRunner();
  }
  this->ItemsDone += depth == 0 ? items.size() : 0;
  std::vector<std::size_t> compared;
  for (std::size_t i = 0; i < items.size() && this->HasCompared; ++i)
  {
    if (items[i].Compared)
    {
      compared.push_back(i);
    }
  }
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

bool SurfaceIntegrator::Internals::RunItems(
  WorkItems& items, const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
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
  WorkItems children;
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
  NumberRows(children);
  return this->RunPortions(children, batch, depth + 1, results);
}

bool SurfaceIntegrator::Internals::RunPortions(
  WorkItems& items, const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results)
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
    WorkItems part(
      items.begin() + static_cast<std::ptrdiff_t>(begin), items.begin() + static_cast<std::ptrdiff_t>(end));
    NumberRows(part);
    if (!this->RunItems(part, batch, depth, results))
    {
      return false;
    }
  }
  return true;
}

void SurfaceIntegrator::Internals::MakeItems(const std::vector<std::size_t>& batch)
{
  std::vector<std::size_t> firsts;
  std::size_t count = 0;
  for (const std::size_t face : batch)
  {
    firsts.push_back(count);
    count += this->GetNumberOfItems(face);
  }
  this->Items.resize(count);
  std::atomic<bool> hasCompared{ false };
  ForFaces(batch,
    [&](std::size_t slot, std::size_t face)
    {
      const FacePlan& plan = this->Plans.Get(face);
      MakePlannedItems(*this->Faces[face], plan, static_cast<std::uint32_t>(slot),
        static_cast<std::uint32_t>(firsts[slot]), this->Items.data() + firsts[slot]);
      if (std::any_of(plan.Items.begin(), plan.Items.end(), [](const auto& item) { return item.Compared; }))
      {
        hasCompared = true;
      }
    });
  this->HasCompared = hasCompared;
}

bool SurfaceIntegrator::Internals::CheckRunner(
  const std::vector<ItemRunner::BatchFace>& faces, const WorkItems& items)
{
  // Nothing is proved by expressions alone, which the CPU cannot evaluate.
  const bool isComparable = std::any_of(this->ChosenIntegrands.begin(), this->ChosenIntegrands.end(),
    [](const Integrand& integrand) { return integrand.Form != Integrand::Kind::User; });
  if (!isComparable)
  {
    return true;
  }
  WorkItems examples;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    const WorkItem& item = items[i];
    const bool isKnown = i > 0 && item.HasProgramOf(items[i - 1]);
    if (!isKnown && !this->Runner->IsProved(item))
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
  WorkItems& items = this->Items;
  items.clear();
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
    this->MakeItems(batch);
  }
  else
  {
    NumberRows(items);
  }
  if (!this->Runner->BeginBatch(faces))
  {
    return this->FailByRunner();
  }
  if (!this->CheckRunner(faces, items) || !this->RunPortions(items, batch, 0, results))
  {
    return false;
  }
  ForFaces(batch, [&](std::size_t, std::size_t face) { this->AddBounds(tasks[face], face, results[face]); });
  this->Store(tasks, batch, results);
  return true;
}
}
