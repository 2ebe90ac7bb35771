#include "smGPUItemRunnerInternals.h"

#include "Engine/smFaceIntegrals.h"
#include "smContextScope.h"
#include "smParallelFor.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <map>
#include <optional>

namespace sm
{
namespace
{
// Largest number of rows at a time, which limits the memory of rows and lists.
constexpr std::size_t MaximumRows = 262144;
// Estimated cost (evaluations times a factor for the degree) and lines of a portion: for a software renderer
// some 50 ms on two CPU cores, and for a GPU, which evaluates a hundred times as fast, no more, so that a run
// can be aborted and the driver's watchdog does not interrupt it.
constexpr PortionLimits SoftwareLimits = { 4000000, 65536, true };
constexpr PortionLimits DeviceLimits = { 400000000, 131072, false };

// Records that a thread makes at a time.
constexpr std::size_t RecordsOfTask = 4096;
}

GPUItemRunner::GPUItemRunner(vtkComputeContext* context)
  : Implementation(new Internals(context))
{
}

GPUItemRunner::~GPUItemRunner() = default;

std::string GPUItemRunner::GetObstacle(const Integrand& integrand) const
{
  return this->Implementation->Programs.FindError(integrand);
}

PortionLimits GPUItemRunner::Internals::GetLimits(const RowLayout& layout) const
{
  PortionLimits limits = this->IsSoftware() ? SoftwareLimits : DeviceLimits;
  const auto block = static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize());
  // A portion has one item at least, which has at most 255 lines.
  limits.Lines = std::clamp<std::size_t>(block / GetLineBytes(layout), 255, limits.Lines);
  return limits;
}

void GPUItemRunner::OnConfigure()
{
  this->Implementation->Programs.Configure(this->Configured, this->Layout);
}

bool GPUItemRunner::Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress)
{
  Internals& self = *this->Implementation;
  this->StartSeconds = 0.0;
  self.Slots.clear();
  // The last report is for the shaders: ParaView shows a text when the percentage changes.
  const auto uploading = [&progress](double fraction) { return !progress || progress(0.9 * fraction); };
  if (!self.Resident.Acquire(faces, self.Places, uploading))
  {
    self.Places.clear();
    return this->Fail(self.Resident.GetError());
  }
  if (!self.Reserve(this->Layout, faces, this->GetRowLimit()))
  {
    return this->Fail("the results do not fit on the GPU: " + self.GetBufferErrors());
  }
  const double start = vtkTimerLog::GetUniversalTime();
  std::string error;
  const bool isWarm = self.WarmUp(faces, progress, error);
  this->StartSeconds = vtkTimerLog::GetUniversalTime() - start;
  return isWarm || this->Fail(error);
}

bool GPUItemRunner::Internals::Reserve(
  const RowLayout& layout, const std::vector<CutFacePointer>& faces, std::size_t maximumRows)
{
  if (this->IsSoftware())
  {
    return true;
  }
  std::size_t items = 0;
  for (const CutFacePointer& face : faces)
  {
    items += face->GetNumberOfItems();
  }
  const std::size_t rows = std::clamp<std::size_t>(items, 1, maximumRows);
  // An item has some six lines, and hardly an item is a part of its own.
  const std::size_t lines = std::min(6 * rows, this->GetLimits(layout).Lines);
  return this->Work.Allocate(rows * sizeof(WorkRecord)) &&
    this->Rows.Allocate(rows * layout.GetStride() * sizeof(double)) &&
    this->LineSums.Allocate(lines * GetLineBytes(layout)) &&
    this->StatusFlags.Allocate(rows * sizeof(std::uint32_t)) &&
    this->BlockSums.Allocate((rows / 4 + 1) * GetBlockBytes(layout));
}

bool GPUItemRunner::Internals::WarmUp(
  const std::vector<CutFacePointer>& faces, const ProgressCallback& progress, std::string& error)
{
  std::map<ProgramKey, int> needed;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const CutFace& face = *faces[i];
    const std::pair<ItemKind, std::size_t> counts[] = { { ItemKind::Panel, face.Panels.Panels.size() },
      { ItemKind::Ribbon, face.Panels.Ribbons.size() }, { ItemKind::Cap, face.Panels.Caps.size() } };
    for (const auto& [kind, count] : counts)
    {
      if (count > 0 && this->Places[i].Error.empty())
      {
        const int page = this->Places[i].Page;
        needed[IntegrationPrograms::ChooseProgram(kind, face.Degree[0], face.Degree[1], this->IsSoftware())] =
          page;
        needed[FinishProgram] = needed[RowBlockProgram] = needed[FaceSumProgram] = page;
      }
    }
  }
  std::vector<ProgramKey> missing;
  for (const auto& [key, page] : needed)
  {
    if (!this->Programs.IsBuilt(key))
    {
      missing.push_back(key);
    }
  }
  if (missing.empty())
  {
    return true;
  }
  // Outside the scope below, since an observer may draw.
  this->Context->InvokeEvent(vtkComputeContext::COMPILE_EVENT);
  if (progress && !progress(1.0))
  {
    error = "aborted";
    return false;
  }
  const ContextScope scope(this->Context);
  if (!scope)
  {
    error = this->Context->GetReason();
    return false;
  }
  if (!this->Programs.Build(missing))
  {
    error = this->Programs.GetError();
    return false;
  }
  for (const ProgramKey& key : missing)
  {
    // Drivers finish compilation at the first dispatch; this one is empty, as counts are 0.
    ComputeProgram* program = this->Programs.Get(key);
    const unsigned int size = std::get<0>(key) == ProgramKind::RowBlocks ? LocalSizeOfBlocks : LocalSize;
    if (!this->Bind(key, needed[key]) || !program->Dispatch(1, size))
    {
      error = "a shader could not be run: " + program->GetError() + this->GetBufferErrors();
      return false;
    }
  }
  return true;
}

std::string GPUItemRunner::GetFaceError(std::size_t face) const
{
  return this->Implementation->Places[face].Error;
}

int GPUItemRunner::GetGroup(std::size_t face) const
{
  return this->Implementation->Places[face].Page;
}

std::size_t GPUItemRunner::GetRowLimit() const
{
  // A row may be a block of its own.
  const std::size_t bytes = std::max({ this->Layout.GetStride() * sizeof(double), sizeof(WorkRecord),
    Internals::GetBlockBytes(this->Layout) });
  const auto block = static_cast<std::size_t>(this->Implementation->Context->GetMaximumStorageBlockSize());
  return std::clamp<std::size_t>(block / bytes, 1, MaximumRows);
}

bool GPUItemRunner::IsProved(const WorkItem& item) const
{
  const Internals& self = *this->Implementation;
  const ProgramKey key = self.ChooseProgram(item);
  return self.ProvedGeneration == self.Context->GetGeneration() && self.Proved.count(key) > 0;
}

void GPUItemRunner::SetProved(const WorkItem& item)
{
  Internals& self = *this->Implementation;
  if (self.ProvedGeneration != self.Context->GetGeneration())
  {
    self.Proved.clear();
    self.ProvedGeneration = self.Context->GetGeneration();
  }
  self.Proved.insert(self.ChooseProgram(item));
}

void GPUItemRunner::ForgetProofs()
{
  this->Implementation->Proved.clear();
}

bool GPUItemRunner::BeginBatch(const std::vector<BatchFace>& faces)
{
  Internals& self = *this->Implementation;
  self.Slots.clear();
  for (const BatchFace& face : faces)
  {
    self.Slots.push_back(&self.Places[face.Face]);
  }
  self.Batch = BatchParameters(faces, this->Configured.UsePlacements);
  self.IsBatchUploaded = false;
  return true;
}

bool GPUItemRunner::BeginRows(std::size_t rows)
{
  // Rows have no meaning until their item ran, so that they are not cleared.
  Internals& self = *this->Implementation;
  return self.Rows.Allocate(rows * this->Layout.GetStride() * sizeof(double)) ||
    this->Fail("the results do not fit on the GPU: " + self.Rows.GetError());
}

bool GPUItemRunner::Internals::DispatchLines(
  const RowLayout& layout, const WorkPortion& portion, const LineRange& range)
{
  ComputeProgram* program = this->Programs.Get(range.Program);
  if (!program || !this->Bind(range.Program, this->Slots.front()->Page))
  {
    return false;
  }
  const std::pair<const char*, std::uint32_t> numbers[] = { { "smFirstShape", range.FirstShape },
    { "smShapeCount", range.ShapeCount }, { "smFirstLine", range.FirstLine },
    { "smLineStride", portion.LineCount }, { "smPlacementOffset", this->Batch.PlacementOffset },
    { "smIntegrandCount", static_cast<std::uint32_t>(layout.GetNumberOfIntegrands()) },
    { "smRoundingCount", static_cast<std::uint32_t>(layout.GetNumberOfRoundings()) } };
  for (const auto& [name, value] : numbers)
  {
    // Programs have those of them that they use.
    if (program->HasUniform(name) && !program->SetUniform(name, value))
    {
      return false;
    }
  }
  return (!program->HasUniform("smGapSteps") || program->SetUniform("smGapSteps", FootPointSteps)) &&
    program->SetUniform("smLineCount", range.LineCount) &&
    program->Dispatch(range.LineCount, LocalSize, ComputeProgram::Barrier::None);
}

bool GPUItemRunner::Internals::DispatchFinish(const RowLayout& layout, const WorkPortion& portion)
{
  ComputeProgram* program = this->Programs.Get(FinishProgram);
  if (!program || !this->Bind(FinishProgram, 0))
  {
    return false;
  }
  return program->SetUniform("smFirstShape", portion.FirstShape) &&
    program->SetUniform("smShapeCount", portion.ShapeCount) &&
    program->SetUniform("smFirstItem", portion.FirstItem) &&
    program->SetUniform("smItemCount", portion.ItemCount) &&
    program->SetUniform("smLineStride", portion.LineCount) &&
    program->SetUniform("smToleranceOffset", this->Batch.ToleranceOffset) &&
    program->SetUniform("smIntegrandCount", static_cast<unsigned int>(layout.GetNumberOfIntegrands())) &&
    program->SetUniform("smRoundingCount", static_cast<unsigned int>(layout.GetNumberOfRoundings())) &&
    program->Dispatch(portion.ItemCount, LocalSize);
}

bool GPUItemRunner::Internals::RunPortion(
  const RowLayout& layout, const WorkPortion& portion, std::string& error)
{
  ComputeProgram* last = nullptr;
  for (const LineRange& range : portion.Ranges)
  {
    last = this->Programs.Get(range.Program);
    if (!this->DispatchLines(layout, portion, range))
    {
      error = "a dispatch failed: " + (last ? last->GetError() : this->Programs.GetError()) +
        this->GetBufferErrors();
      return false;
    }
  }
  ComputeProgram::PlaceBarrier();
  last = this->Programs.Get(FinishProgram);
  if (!this->DispatchFinish(layout, portion))
  {
    error =
      "a dispatch failed: " + (last ? last->GetError() : this->Programs.GetError()) + this->GetBufferErrors();
    return false;
  }
  return true;
}

bool GPUItemRunner::Run(const WorkItems& items, const ActiveItems& active, std::int64_t& evaluations,
  const ContinueCallback& shouldContinue)
{
  Internals& self = *this->Implementation;
  const WorkList list(items, active, self.GetLimits(this->Layout));
  self.Order = list.GetOrder();
  self.HasComparisons = list.HasComparisons();
  std::optional<ContextScope> scope;
  scope.emplace(self.Context);
  const auto fillRecords = [&](WorkRecord* records)
  {
    ParallelFor(self.Order.size(), RecordsOfTask,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t at = begin; at < end; ++at)
        {
          records[at] = self.MakeRecord(items[active[self.Order[at]]]);
        }
      });
  };
  if (!(self.IsBatchUploaded || self.Parameters.Upload(self.Batch.Values)) ||
    !self.Work.Fill<WorkRecord>(active.size(), fillRecords) || !self.Shapes.Upload(list.GetShapes()) ||
    !self.StatusFlags.Allocate(active.size() * sizeof(std::uint32_t)) ||
    !self.LineSums.Allocate(list.GetMaximumLines() * Internals::GetLineBytes(this->Layout)))
  {
    return this->Fail("the work list does not fit on the GPU: " + self.GetBufferErrors());
  }
  self.IsBatchUploaded = true;
  for (const WorkPortion& portion : list.GetPortions())
  {
    if (!scope)
    {
      scope.emplace(self.Context);
    }
    if (!*scope)
    {
      return this->Fail("the OpenGL context was lost: " + self.Context->GetReason());
    }
    std::string error;
    if (!self.RunPortion(this->Layout, portion, error))
    {
      return this->Fail(error);
    }
    // An observer of the progress may render in another window.
    scope.reset();
    if (shouldContinue && !shouldContinue())
    {
      return this->Fail("aborted");
    }
  }
  evaluations += list.GetEvaluations();
  return true;
}

bool GPUItemRunner::GetUnconverged(std::vector<std::uint8_t>& unconverged)
{
  Internals& self = *this->Implementation;
  unconverged.assign(self.Order.size(), 0);
  if (!self.HasComparisons)
  {
    return true;
  }
  std::vector<std::uint32_t> status(self.Order.size());
  if (!self.StatusFlags.Read(status.data(), status.size() * sizeof(status[0])))
  {
    return this->Fail(self.StatusFlags.GetError());
  }
  for (std::size_t at = 0; at < status.size(); ++at)
  {
    unconverged[self.Order[at]] = status[at] != 0 ? 1 : 0;
  }
  return true;
}

void GPUItemRunner::Release()
{
  this->Implementation->Slots.clear();
  this->Implementation->Places.clear();
  this->Implementation->Resident.EndRun();
}
}
