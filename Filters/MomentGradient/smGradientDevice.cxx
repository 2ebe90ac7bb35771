#include "Detail/smGradientDevice.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smFormat.h"
#include "smGaussLegendre.h"
#include "smGradientLinesCS.h"
#include "smGradientRowsCS.h"
#include "smGradientSample.h"
#include "smGradientStorage.h"
#include "smGradientSumsCS.h"
#include "smParallelFor.h"
#include "smShaderSource.h"
#include "smUnitRoundoff.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sm
{
namespace
{
// Invocations of a work group, as in the shaders.
constexpr unsigned int RowGroup = 64;
constexpr unsigned int LineGroup = 32;
constexpr unsigned int SumGroup = 64;
// Fours of a row's sums, and of a control point, as in smGradientStorage.
constexpr std::size_t RowFours = 14;
constexpr std::size_t PointFours = channel::Count / 4 + 1;
using Four = std::array<double, 4>;
// Rows of a batch: 58 MB of sums on a GPU; some 0.1 s of a software renderer on two cores.
constexpr std::size_t RowsOfBatch = 131072;
constexpr std::size_t RowsOfSoftwareBatch = 8192;
// Mesa's llvmpipe ends all loops of an invocation, without an error, after 65,535 iterations together.
constexpr std::size_t LinesOfPatch = 60000;
// Patches of one batch that are compared with the processor.
constexpr std::size_t ComparedPatches = 6;

/// Patches that are evaluated by the same three dispatches.
struct GradientBatch
{
  std::vector<std::size_t> Tasks;
  std::vector<std::uint32_t> Patches, Lines, Rows, Entries;
  std::vector<Four> Nets;
  std::vector<double> Numbers;
  /// First numbers of the rules by their numbers of nodes.
  std::map<int, std::uint32_t> Rules;

  std::uint32_t AddRule(int size);
  void AddPatch(std::size_t index, const PatchTask& task, const std::vector<PatchLine>& lines);
};

std::uint32_t GetCount(std::size_t size)
{
  return static_cast<std::uint32_t>(size);
}

std::uint32_t GradientBatch::AddRule(int size)
{
  const auto [found, isNew] = this->Rules.insert({ size, GetCount(this->Numbers.size()) });
  if (isNew)
  {
    const auto first = GetRuleTable().begin() + static_cast<std::ptrdiff_t>(size) * (size - 1);
    this->Numbers.insert(this->Numbers.end(), first, first + 2 * static_cast<std::ptrdiff_t>(size));
  }
  return found->second;
}

void GradientBatch::AddPatch(std::size_t index, const PatchTask& task, const std::vector<PatchLine>& lines)
{
  const int* degree = task.GetPatch().Degree;
  const int p = degree[0];
  const int q = degree[1];
  const std::size_t points = static_cast<std::size_t>(p + 1) * (q + 1);
  const std::uint32_t patch = GetCount(this->Tasks.size());
  const std::size_t lineCount = this->Lines.size() / 5;
  this->Tasks.push_back(index);
  this->Patches.insert(this->Patches.end(),
    { static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q), GetCount(this->Nets.size()),
      GetCount(this->Numbers.size()), GetCount(lineCount), GetCount(lines.size()),
      GetCount(this->Entries.size()) });
  this->Nets.insert(this->Nets.end(), task.GetPoints(), task.GetPoints() + points);
  this->Entries.insert(this->Entries.end(), points, patch);
  const PatchConstants own = MakePatchConstants(task);
  this->Numbers.insert(this->Numbers.end(),
    { own.Origin[0], own.Origin[1], own.Origin[2], own.Radius, own.Stretch[0], own.Stretch[1], own.Off,
      own.OffSlope[0], own.OffSlope[1], own.Roundings, own.Additions });
  for (const PatchLine& line : lines)
  {
    const std::uint32_t rule = this->AddRule(line.Across);
    this->Lines.insert(this->Lines.end(),
      { patch, GetCount(this->Numbers.size()), rule, static_cast<std::uint32_t>(line.Across),
        GetCount(this->Rows.size()) });
    this->Rows.insert(this->Rows.end(), p + 1, GetCount(this->Lines.size() / 5 - 1));
    this->Numbers.insert(this->Numbers.end(),
      { line.Coverage, line.Side, line.EdgeS, line.Growth, line.TrimRounding, line.Weight, line.XiStart,
        line.XiWidth });
    const DerivedBasis inR(q, line.R);
    for (const double* values : { inR.Values, inR.Lower, inR.Slopes })
    {
      this->Numbers.insert(this->Numbers.end(), values, values + q + 1);
    }
  }
}

/// The bound of the roundings of a number of the sums; that of the areas is `ofArea`.
double GetNoise(const PatchSums& sums, const double* of, int place)
{
  if (place >= channel::Noise)
  {
    return 0.0;
  }
  if (place >= channel::Area)
  {
    return UnitRoundoff * sums.AreaNoise[place == channel::Area + 3 ? 1 : 0];
  }
  return UnitRoundoff * of[channel::Noise + MomentDegrees[place / 4] + (place % 4 == channel::Flux ? 1 : 0)];
}

/// Returns a sentence about the first number in which both differ by more than their bounds; bounds
/// themselves may differ by 1e-9 of their size.
std::string FindDifference(const PatchSums& own, const PatchSums& known)
{
  for (std::size_t at = 0; at < known.Sums.size(); ++at)
  {
    const int place = static_cast<int>(at % channel::Count);
    const std::size_t first = at - place;
    const double value = own.Sums[at];
    const double right = known.Sums[at];
    const double allowed = place >= channel::Noise
      ? 1e-9 * right
      : GetNoise(own, own.Sums.data() + first, place) + GetNoise(known, known.Sums.data() + first, place);
    if (!(std::abs(value - right) <= allowed))
    {
      return "computes a gradient wrong: integral " + std::to_string(place) + " of control point " +
        std::to_string(at / channel::Count) + " is " + FormatDigits(value, 17) + " for " +
        FormatDigits(right, 17);
    }
  }
  for (int c = 0; c < 2; ++c)
  {
    if (!(std::abs(own.AreaNoise[c] - known.AreaNoise[c]) <= 1e-9 * known.AreaNoise[c]))
    {
      return "computes the bound of an area's gradient wrong: " + FormatDigits(own.AreaNoise[c], 17) +
        " for " + FormatDigits(known.AreaNoise[c], 17);
    }
  }
  return "";
}

bool IsFinite(const PatchSums& sums)
{
  return std::all_of(sums.Sums.begin(), sums.Sums.end(), [](double x) { return std::isfinite(x); }) &&
    std::isfinite(sums.AreaNoise[0]) && std::isfinite(sums.AreaNoise[1]);
}
}

struct GradientDevice::Internals
{
  explicit Internals(vtkComputeContext* context)
    : Context(context)
    , Words(context)
    , Nets(context)
    , Numbers(context)
    , RowBuffer(context)
    , LineSums(context)
    , Sums(context)
  {
  }

  vtkSmartPointer<vtkComputeContext> Context;
  ComputeProgram Rows, Lines, Points;
  ComputeBuffer Words, Nets, Numbers, RowBuffer, LineSums, Sums;
  vtkTypeUInt64 Generation = 0;
  bool IsCompared = false;
  std::string Error;

  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }
  std::string GetErrors() const
  {
    std::string errors;
    for (const ComputeBuffer* buffer :
      { &this->Words, &this->Nets, &this->Numbers, &this->RowBuffer, &this->LineSums, &this->Sums })
    {
      errors += buffer->GetError();
    }
    return errors + this->Rows.GetError() + this->Lines.GetError() + this->Points.GetError();
  }
  bool Prepare();
  bool Begin(ComputeProgram& program, const char* name, const char* text);
  bool Upload(const GradientBatch& batch);
  bool Dispatch(ComputeProgram& program, const GradientBatch& batch, std::size_t list, std::size_t count,
    unsigned int group);
  bool Run(const GradientBatch& batch, std::vector<PatchSums>& sums);
  bool Compare(
    const GradientBatch& batch, const std::vector<PatchTask>& tasks, const std::vector<PatchSums>& sums);
};

bool GradientDevice::Internals::Begin(ComputeProgram& program, const char* name, const char* text)
{
  ShaderSource source(name, text);
  source.AddChunk("smGradientStorage", smGradientStorage);
  source.AddChunk("smGradientSample", smGradientSample);
  return (source.Assemble() || this->Fail(source.GetError())) &&
    (program.BeginBuild(this->Context, source.GetName(), source.GetSource()) ||
      this->Fail(program.GetError()));
}

bool GradientDevice::Internals::Prepare()
{
  if (this->Generation != 0 && this->Generation == this->Context->GetGeneration())
  {
    return true;
  }
  this->IsCompared = false;
  if (this->Context->Start() != vtkComputeContext::READY)
  {
    return this->Fail(this->Context->GetReason());
  }
  if (this->Context->FlushesSubnormals())
  {
    // Bounds do not count that.
    return this->Fail(this->Context->GetRenderer() + " takes numbers below 2.3e-308 for 0");
  }
  if (!this->Begin(this->Rows, "smGradientRowsCS", smGradientRowsCS) ||
    !this->Begin(this->Lines, "smGradientLinesCS", smGradientLinesCS) ||
    !this->Begin(this->Points, "smGradientSumsCS", smGradientSumsCS))
  {
    return false;
  }
  if (!this->Rows.FinishBuild() || !this->Lines.FinishBuild() || !this->Points.FinishBuild())
  {
    return this->Fail(this->GetErrors());
  }
  this->Generation = this->Context->GetGeneration();
  return true;
}

bool GradientDevice::Internals::Upload(const GradientBatch& batch)
{
  std::vector<std::uint32_t> words = batch.Patches;
  for (const std::vector<std::uint32_t>* list : { &batch.Lines, &batch.Rows, &batch.Entries })
  {
    words.insert(words.end(), list->begin(), list->end());
  }
  return this->Words.Upload(words) && this->Nets.Upload(batch.Nets) && this->Numbers.Upload(batch.Numbers) &&
    this->RowBuffer.Allocate(batch.Rows.size() * 3 * sizeof(Four)) &&
    this->LineSums.Allocate(batch.Rows.size() * RowFours * sizeof(Four)) &&
    this->Sums.Allocate(batch.Entries.size() * PointFours * sizeof(Four));
}

bool GradientDevice::Internals::Dispatch(ComputeProgram& program, const GradientBatch& batch,
  std::size_t list, std::size_t count, unsigned int group)
{
  return program.SetUniform("smFirstPatch", 0u) &&
    program.SetUniform("smFirstLine", GetCount(batch.Patches.size())) &&
    program.SetUniform("smFirstEntry", GetCount(list)) && program.SetUniform("smCount", GetCount(count)) &&
    program.Dispatch(GetCount(count), group);
}

bool GradientDevice::Internals::Run(const GradientBatch& batch, std::vector<PatchSums>& sums)
{
  const ContextScope scope(this->Context);
  if (!scope)
  {
    return this->Fail("the OpenGL context was lost: " + this->Context->GetReason());
  }
  const std::size_t rows = batch.Patches.size() + batch.Lines.size();
  const std::size_t entries = rows + batch.Rows.size();
  std::vector<Four> results(batch.Entries.size() * PointFours);
  if (!this->Upload(batch) || !this->Words.Bind(0) || !this->Nets.Bind(1) || !this->Numbers.Bind(2) ||
    !this->RowBuffer.Bind(3) || !this->LineSums.Bind(4) || !this->Sums.Bind(5) ||
    !this->Dispatch(this->Rows, batch, rows, batch.Rows.size(), RowGroup) ||
    !this->Dispatch(this->Lines, batch, rows, batch.Rows.size(), LineGroup) ||
    !this->Dispatch(this->Points, batch, entries, results.size(), SumGroup) ||
    !this->Sums.Read(results.data(), results.size() * sizeof(Four)))
  {
    return this->Fail("a batch of gradients failed: " + this->GetErrors());
  }
  auto from = results.begin();
  for (const std::size_t task : batch.Tasks)
  {
    PatchSums& to = sums[task];
    to.AreaNoise[0] = from[PointFours - 1][0];
    to.AreaNoise[1] = from[PointFours - 1][1];
    for (auto number = to.Sums.begin(); number != to.Sums.end(); from += PointFours)
    {
      for (std::size_t four = 0; four + 1 < PointFours; ++four)
      {
        number = std::copy_n(from[four].begin(), 4, number);
      }
    }
  }
  return true;
}

/// Compares the first patch of each pair of degrees.
bool GradientDevice::Internals::Compare(
  const GradientBatch& batch, const std::vector<PatchTask>& tasks, const std::vector<PatchSums>& sums)
{
  std::set<std::pair<int, int>> degrees;
  for (const std::size_t task : batch.Tasks)
  {
    const int* own = tasks[task].GetPatch().Degree;
    if (degrees.size() < ComparedPatches && IsFinite(sums[task]) && degrees.insert({ own[0], own[1] }).second)
    {
      const std::string difference = FindDifference(sums[task], ComputePatchSums(tasks[task]));
      if (!difference.empty())
      {
        return this->Fail(this->Context->GetRenderer() + " " + difference);
      }
    }
  }
  this->IsCompared = true;
  return true;
}

GradientDevice::GradientDevice(vtkComputeContext* context)
  : Implementation(std::make_unique<Internals>(context))
{
}

GradientDevice::~GradientDevice() = default;

const std::string& GradientDevice::GetError() const
{
  return this->Implementation->Error;
}

bool GradientDevice::Compute(const std::vector<PatchTask>& tasks, std::vector<PatchSums>& sums)
{
  Internals& self = *this->Implementation;
  if (!self.Prepare())
  {
    return false;
  }
  std::vector<std::vector<PatchLine>> lines(tasks.size());
  sums.resize(tasks.size());
  ParallelFor(tasks.size(), 16,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        lines[i] = MakePatchLines(tasks[i]);
        sums[i] = MakePatchSums(tasks[i], lines[i]);
      }
    });
  const auto block = static_cast<std::size_t>(self.Context->GetMaximumStorageBlockSize());
  const std::size_t limit = std::min(
    self.Context->IsSoftware() ? RowsOfSoftwareBatch : RowsOfBatch, block / (RowFours * sizeof(Four)));
  std::vector<std::size_t> left;
  for (std::size_t begin = 0; begin < tasks.size();)
  {
    GradientBatch batch;
    std::size_t end = begin;
    for (; end < tasks.size(); ++end)
    {
      const std::size_t rows = lines[end].size() * (tasks[end].GetPatch().Degree[0] + 1);
      if (rows > limit || lines[end].size() > LinesOfPatch)
      {
        left.push_back(end);
        continue;
      }
      if (batch.Rows.size() + rows > limit)
      {
        break;
      }
      batch.AddPatch(end, tasks[end], lines[end]);
    }
    begin = end;
    if (batch.Tasks.empty())
    {
      continue;
    }
    if (!self.Run(batch, sums) || (!self.IsCompared && !self.Compare(batch, tasks, sums)))
    {
      return false;
    }
    std::copy_if(batch.Tasks.begin(), batch.Tasks.end(), std::back_inserter(left),
      [&sums](std::size_t task) { return !IsFinite(sums[task]); });
  }
  ParallelFor(left.size(), 1,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        sums[left[i]] = ComputePatchSums(tasks[left[i]]);
      }
    });
  return true;
}
}
