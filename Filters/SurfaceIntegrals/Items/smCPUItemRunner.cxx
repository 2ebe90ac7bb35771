#include "smCPUItemRunner.h"

#include "Engine/smFaceIntegrals.h"
#include "smBatchParameters.h"
#include "smFormat.h"
#include "smItemKernels.h"
#include "smParallelFor.h"
#include "smRowSums.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <unordered_map>

namespace sm
{
namespace
{
// Largest number of rows at a time: they, and their items, stay in the processor's caches.
constexpr std::size_t RowsOfChunk = 4096;
// Estimated cost between two calls of shouldContinue: some tens of milliseconds of one core.
constexpr std::int64_t CostPerPart = 4000000;
// Smallest number of segments per task of a thread, and number of tasks of each thread: every task has
// buffers of its own.
constexpr std::size_t SegmentsPerTask = 64;
constexpr std::size_t TasksPerThread = 16;

/// Number of `count` parts of work per task.
std::size_t GetGrain(std::size_t count, std::size_t minimum)
{
  const auto threads = static_cast<std::size_t>(std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1));
  return std::max(count / (TasksPerThread * threads), minimum);
}

/// Lanes for so many items: four half as wide take less time than eight that are half empty. Fewer have no
/// fused multiply-add.
int GetLanesOf(int count, int widest)
{
  return widest == 8 && count <= 4 ? 4 : widest;
}

/// Indices in a range, those of one shape side by side, in groups that fill the lanes.
struct ShapeGroups
{
  std::vector<std::size_t> Order;
  /// The first index of each group in Order, and the end.
  std::vector<std::size_t> Firsts;

  template <class GetShape>
  ShapeGroups(std::size_t begin, std::size_t end, int lanes, const GetShape& getShape)
    : Order(end - begin)
  {
    std::unordered_map<std::uint64_t, std::size_t> known;
    std::vector<std::size_t> shapes;
    std::vector<std::size_t> counts;
    shapes.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i)
    {
      const auto [shape, isNew] = known.try_emplace(getShape(i), counts.size());
      if (isNew)
      {
        counts.push_back(0);
      }
      shapes.push_back(shape->second);
      ++counts[shape->second];
    }
    std::size_t first = 0;
    for (std::size_t& count : counts)
    {
      const std::size_t last = first + count;
      count = first;
      for (; first < last; first = std::min(first + static_cast<std::size_t>(lanes), last))
      {
        this->Firsts.push_back(first);
      }
    }
    this->Firsts.push_back(first);
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Order[counts[shapes[i - begin]]++] = i;
    }
  }
};

double FindLargest(const double* rows, std::size_t count, int stride)
{
  double largest = count > 0 ? rows[0] : 0.0;
  for (std::size_t row = 1; row < count; ++row)
  {
    const double value = rows[row * stride];
    largest = value > largest || std::isnan(value) ? value : largest;
  }
  return largest;
}
}

struct CPUItemRunner::Internals
{
  SampleFormulas Formulas;
  std::vector<CutFacePointer> Faces;
  /// Faces of the last BeginBatch().
  std::vector<const FacePanels*> Slots;
  BatchParameters Batch;
  std::vector<double> Rows;
  /// One flag for each item of the last Run().
  std::vector<std::uint8_t> Unconverged;

  /// Evaluates items[active[i]] for i in [begin, end) and returns the number of evaluations.
  std::int64_t RunPart(const KernelData& data, const WorkItems& items, const ActiveItems& active,
    std::size_t begin, std::size_t end, int lanes, std::vector<std::uint8_t>& unconverged) const;
};

std::int64_t CPUItemRunner::Internals::RunPart(const KernelData& data, const WorkItems& items,
  const ActiveItems& active, std::size_t begin, std::size_t end, int lanes,
  std::vector<std::uint8_t>& unconverged) const
{
  const auto getItem = [&](std::size_t i) {
    return KernelItem{ this->Slots[items[active[i]].GetSlot()], &items[active[i]] };
  };
  const ShapeGroups groups(begin, end, lanes, [&](std::size_t i) { return GetItemShape(getItem(i)); });
  // An integer, so that the sum does not depend on the order.
  std::atomic<std::int64_t> spent{ 0 };
  const std::vector<std::size_t>& firsts = groups.Firsts;
  ParallelFor(firsts.size() - 1, GetGrain(firsts.size() - 1, 1),
    [&](std::size_t from, std::size_t to)
    {
      KernelScratch scratch(*data.Layout);
      std::int64_t sum = 0;
      for (std::size_t group = from; group < to; ++group)
      {
        KernelItem together[MaxLanes];
        KernelResult results[MaxLanes];
        const int count = static_cast<int>(firsts[group + 1] - firsts[group]);
        for (int lane = 0; lane < count; ++lane)
        {
          together[lane] = getItem(groups.Order[firsts[group] + lane]);
        }
        EvaluateItems(data, together, count, GetLanesOf(count, lanes), scratch, results);
        for (int lane = 0; lane < count; ++lane)
        {
          unconverged[groups.Order[firsts[group] + lane]] = results[lane].Converged ? 0 : 1;
          sum += results[lane].Evaluations;
        }
      }
      spent += sum;
    });
  return spent;
}

CPUItemRunner::CPUItemRunner()
  : Implementation(new Internals)
  , LaneCount(GetLaneCounts().back())
{
}

CPUItemRunner::~CPUItemRunner() = default;

std::string CPUItemRunner::GetDescription()
{
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  return "CPU, " + FormatCount(threads, "thread", "threads");
}

std::string CPUItemRunner::GetObstacle(const Integrand& integrand) const
{
  return integrand.Form != Integrand::Kind::User ? ""
                                                 : "the expression of " + integrand.Name +
      " is GLSL, which is not computed on the CPU: it needs OpenGL 4.3 with doubles (Mesa's llvmpipe has "
      "them)";
}

void CPUItemRunner::SetLaneCount(int lanes)
{
  const std::vector<int>& possible = GetLaneCounts();
  this->LaneCount =
    std::find(possible.begin(), possible.end(), lanes) != possible.end() ? lanes : possible.back();
}

void CPUItemRunner::OnConfigure()
{
  this->Implementation->Formulas = SampleFormulas(this->Configured.Integrands, this->Layout);
}

bool CPUItemRunner::Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback&)
{
  this->Implementation->Slots.clear();
  this->Implementation->Faces = faces;
  return true;
}

std::string CPUItemRunner::GetFaceError(std::size_t) const
{
  return "";
}

int CPUItemRunner::GetGroup(std::size_t) const
{
  return 0;
}

std::size_t CPUItemRunner::GetRowLimit() const
{
  return RowsOfChunk;
}

bool CPUItemRunner::BeginBatch(const std::vector<BatchFace>& faces)
{
  Internals& self = *this->Implementation;
  self.Slots.clear();
  for (const BatchFace& face : faces)
  {
    self.Slots.push_back(&self.Faces[face.Face]->Panels);
  }
  self.Batch = BatchParameters(faces, this->Configured.UsePlacements);
  return true;
}

bool CPUItemRunner::BeginRows(std::size_t rows)
{
  try
  {
    // Memory that is new has zeros; other rows keep what they have until their item runs.
    this->Implementation->Rows.resize(rows * this->Layout.GetStride());
  }
  catch (const std::bad_alloc&)
  {
    return this->Fail("there is no memory for the results of " + std::to_string(rows) + " items");
  }
  return true;
}

bool CPUItemRunner::Run(const WorkItems& items, const ActiveItems& active, std::int64_t& evaluations,
  const ContinueCallback& shouldContinue)
{
  Internals& self = *this->Implementation;
  std::vector<std::uint8_t>& unconverged = self.Unconverged;
  const KernelData data = { &this->Configured, &this->Layout, &self.Formulas, self.Batch.Values.data(),
    self.Batch.ToleranceOffset, self.Batch.PlacementOffset, self.Rows.data() };
  unconverged.assign(active.size(), 0);
  for (std::size_t begin = 0; begin < active.size();)
  {
    std::size_t end = begin;
    for (std::int64_t cost = 0; end < active.size() && cost < CostPerPart; ++end)
    {
      cost += items[active[end]].GetCost();
    }
    evaluations += self.RunPart(data, items, active, begin, end, this->LaneCount, unconverged);
    begin = end;
    if (shouldContinue && !shouldContinue())
    {
      return this->Fail("aborted");
    }
  }
  return true;
}

bool CPUItemRunner::GetUnconverged(std::vector<std::uint8_t>& unconverged)
{
  unconverged = this->Implementation->Unconverged;
  return true;
}

void CPUItemRunner::Release()
{
  Internals& self = *this->Implementation;
  self.Slots.clear();
  self.Faces.clear();
  // The memory of a batch is not kept between runs.
  self.Rows = std::vector<double>();
}

bool CPUItemRunner::Sum(
  const std::vector<Segment>& segments, std::vector<double>& sums, std::vector<double>& largestGaps)
{
  const Internals& self = *this->Implementation;
  const int stride = this->Layout.GetStride();
  for (const auto& [first, last] : segments)
  {
    if (first > last || static_cast<std::size_t>(last) * stride > self.Rows.size())
    {
      return this->Fail("a segment of rows " + std::to_string(first) + " to " + std::to_string(last) +
        " is outside of the results");
    }
  }
  sums.assign(segments.size() * stride, 0.0);
  largestGaps.assign(segments.size(), 0.0);
  ParallelFor(segments.size(), GetGrain(segments.size(), SegmentsPerTask),
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        const auto [first, last] = segments[i];
        const double* rows = self.Rows.data() + static_cast<std::size_t>(first) * stride;
        SumRows(rows, last - first, stride, sums.data() + i * stride);
        largestGaps[i] = FindLargest(rows + RowLayout::MaxGap, last - first, stride);
      }
    });
  return true;
}

bool CPUItemRunner::AddUp(const std::vector<RowPart>& parts, FaceTotals& totals, std::vector<RowGaps>& gaps)
{
  std::vector<Segment> segments;
  segments.reserve(parts.size());
  for (const RowPart& part : parts)
  {
    segments.emplace_back(part.Begin, part.End);
  }
  std::vector<double> sums;
  std::vector<double> largest;
  if (!this->Sum(segments, sums, largest))
  {
    return false;
  }
  gaps.clear();
  std::size_t face = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    face += i > 0 && parts[i].Slot != parts[i - 1].Slot ? 1 : 0;
    const double* sum = sums.data() + i * this->Layout.GetStride();
    for (int k = 0; k < this->Layout.GetNumberOfIntegrands(); ++k)
    {
      RowTotal& total = totals.At(face, static_cast<std::size_t>(k));
      double& value = parts[i].Kind == ItemKind::Panel ? total.Face : total.Chain;
      const double before = value;
      value += sum[this->Layout.GetValue(k)];
      total.Rounding += before != 0.0 ? UnitRoundoff * std::abs(value) : 0.0;
      total.Error += sum[this->Layout.GetError(k)];
      total.Rounding += sum[this->Layout.GetRounding(k)];
    }
    const RowGaps own = { largest[i], sum[RowLayout::SquaredGap], sum[RowLayout::GapArea] };
    totals.Gaps[face].Add(own);
    if (parts[i].Coedge >= 0)
    {
      gaps.push_back(own);
    }
  }
  return true;
}
}
