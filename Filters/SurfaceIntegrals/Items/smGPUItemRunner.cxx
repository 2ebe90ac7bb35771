#include "smGPUItemRunner.h"

#include "smBatchParameters.h"
#include "smComputeBuffer.h"
#include "smContextScope.h"
#include "smIntegrationPrograms.h"
#include "smReduction.h"
#include "smResidentFaces.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <map>

namespace sm
{
namespace
{
// Number of invocations per work group, as in the shaders.
constexpr unsigned int LocalSize = 32;
// Estimated cost (evaluations times a factor for the degree) of one dispatch: some 50 ms on two CPU cores, so that the run can be
// aborted between dispatches and the driver's watchdog does not interrupt it.
constexpr std::int64_t CostPerDispatch = 4000000;
// Largest number of rows at a time, and of lines of panels in a dispatch, which limit the memory of rows, lists and sums.
constexpr std::size_t RowsOfBlock = 262144;
constexpr std::size_t LinesOfDispatch = 65536;
// Largest number of lines of a panel: a record has eight bits for it.
constexpr std::size_t LinesOfPanel = 255;

/// A line of a panel in the layout of smLines in glsl/smPanelCS.glsl.
struct LineRecord
{
  std::uint32_t Work;
  std::uint32_t Node;
};
static_assert(sizeof(LineRecord) == 8, "layout of a uvec2");

/// Returns true if the invocations of a program integrate lines of panels instead of whole items.
bool IsOfLines(const ProgramKey& key)
{
  return std::get<0>(key) == ProgramKind::Panels;
}

/// The uniform that says how many invocations of a program have work.
const char* GetCounter(const ProgramKey& key)
{
  return IsOfLines(key) ? "smLineCount" : "smWorkCount";
}

/// Returns the number of lines of a panel.
std::uint32_t GetLines(const WorkRecord& panel)
{
  return (panel.Detail[0] >> 8) & 255u;
}

ProgramKey ChooseProgram(const WorkItem& item)
{
  return IntegrationPrograms::ChooseProgram(item.Kind, item.Degree[0], item.Degree[1]);
}
}

struct GPUItemRunner::Internals
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
    , Lines(context)
    , LineSums(context)
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
  /// The lines of all panels of a Run(), and the sums of those of a dispatch.
  ComputeBuffer Lines;
  ComputeBuffer LineSums;

  /// Places of the faces of the last Acquire().
  std::vector<ResidentFace> Places;
  /// Places of the faces of the last BeginBatch(), by slot; all are on one page.
  std::vector<const ResidentFace*> Slots;
  BatchParameters Batch;

  bool Bind(const ProgramKey& key, int page)
  {
    const ProgramKind kind = std::get<0>(key);
    if (!this->Work.Bind(3) || !this->Parameters.Bind(4))
    {
      return false;
    }
    if (IsOfLines(key))
    {
      return this->Resident.Bind(page) && this->Lines.Bind(6) && this->LineSums.Bind(7);
    }
    return (kind == ProgramKind::Caps         ? this->Resident.BindCaps(page)
               : kind == ProgramKind::Ribbons ? this->Resident.Bind(page)
                                              : this->LineSums.Bind(7)) &&
      this->Rows.Bind(5) && this->StatusFlags.Bind(6);
  }

  std::string GetBufferErrors() const
  {
    return this->Work.GetError() + this->Parameters.GetError() + this->Rows.GetError() +
      this->StatusFlags.GetError() + this->Lines.GetError() + this->LineSums.GetError();
  }

  /// Returns the record with indices into the page's data of its face.
  WorkRecord MakeRecord(const WorkItem& item) const
  {
    const ResidentFace& place = *this->Slots[item.GetSlot()];
    WorkRecord record = item.Work;
    if (item.Kind == ItemKind::Cap)
    {
      record.Item[1] += 9 * place.FirstCap;
      return record;
    }
    record.Item[0] += place.FirstPatch;
    record.Item[1] += place.FirstCoefficient;
    if (item.Kind == ItemKind::Ribbon)
    {
      record.Detail[1] += place.FirstCoefficient;
    }
    return record;
  }

  /// Builds the programs that the faces need and runs each once, as drivers finish compilation at the first dispatch.
  bool WarmUp(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress, std::string& error);
  /// The work [begin, end) of a dispatch, and the lines of its panels.
  struct Portion
  {
    std::size_t Begin, End;
    std::uint32_t FirstLine, LineCount;
  };
  /// Runs a program for a portion: for its lines, or for its items.
  bool Dispatch(const Setup& setup, const RowLayout& layout, const ProgramKey& key, const Portion& portion,
    std::string& error);
};

GPUItemRunner::GPUItemRunner(vtkComputeContext* context)
  : Implementation(new Internals(context))
{
}

GPUItemRunner::~GPUItemRunner() = default;

std::string GPUItemRunner::GetObstacle(const Integrand& integrand) const
{
  return this->Implementation->Programs.FindError(integrand);
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
  const double start = vtkTimerLog::GetUniversalTime();
  std::string error;
  const bool isWarm = self.WarmUp(faces, progress, error);
  this->StartSeconds = vtkTimerLog::GetUniversalTime() - start;
  return isWarm || this->Fail(error);
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
        needed[IntegrationPrograms::ChooseProgram(kind, face.Degree[0], face.Degree[1])] =
          this->Places[i].Page;
        if (kind == ItemKind::Panel)
        {
          needed[IntegrationPrograms::GetPanelSums()] = this->Places[i].Page;
        }
      }
    }
  }
  if (!this->Work.Allocate(sizeof(WorkRecord)) || !this->Parameters.Allocate(sizeof(double)) ||
    !this->Rows.Allocate(sizeof(double)) || !this->StatusFlags.Allocate(sizeof(std::uint32_t)) ||
    !this->Lines.Allocate(sizeof(LineRecord)) || !this->LineSums.Allocate(sizeof(double)))
  {
    error = this->GetBufferErrors();
    return false;
  }
  if (std::any_of(needed.begin(), needed.end(),
        [this](const auto& program) { return !this->Programs.IsBuilt(program.first); }))
  {
    // Outside the scope below, since an observer may draw.
    this->Context->InvokeEvent(vtkComputeContext::COMPILE_EVENT);
    if (progress && !progress(1.0))
    {
      error = "aborted";
      return false;
    }
  }
  const ContextScope scope(this->Context);
  if (!scope)
  {
    error = this->Context->GetReason();
    return false;
  }
  for (const auto& [key, page] : needed)
  {
    ComputeProgram* program = this->Programs.Get(key);
    if (!program)
    {
      error = this->Programs.GetError();
      return false;
    }
    // Drivers finish compilation at the first dispatch; this one is empty.
    if (!this->Bind(key, page) || !program->SetUniform(GetCounter(key), 0u) ||
      !program->Dispatch(1, LocalSize))
    {
      error = "a shader could not be run: " + program->GetError();
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
  const std::size_t bytes = std::max(
    { this->Layout.GetStride() * sizeof(double), sizeof(WorkRecord), LinesOfPanel * sizeof(LineRecord) });
  const auto block = static_cast<std::size_t>(this->Implementation->Context->GetMaximumStorageBlockSize());
  return std::clamp<std::size_t>(block / bytes, 1, RowsOfBlock);
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
  return self.Parameters.Upload(self.Batch.Values) || this->Fail(self.Parameters.GetError());
}

bool GPUItemRunner::BeginRows(std::size_t rows)
{
  Internals& self = *this->Implementation;
  return (self.Rows.Allocate(rows * this->Layout.GetStride() * sizeof(double)) && self.Rows.Clear()) ||
    this->Fail("the results do not fit on the GPU: " + self.Rows.GetError());
}

bool GPUItemRunner::Internals::Dispatch(const Setup& setup, const RowLayout& layout, const ProgramKey& key,
  const Portion& portion, std::string& error)
{
  const ContextScope scope(this->Context);
  if (!scope)
  {
    error = "the OpenGL context was lost: " + this->Context->GetReason();
    return false;
  }
  ComputeProgram* program = this->Programs.Get(key);
  if (!program)
  {
    error = this->Programs.GetError();
    return false;
  }
  const auto count =
    IsOfLines(key) ? portion.LineCount : static_cast<std::uint32_t>(portion.End - portion.Begin);
  // Programs have those of the uniforms that they use.
  program->SetUniform("smFirstWork", static_cast<unsigned int>(portion.Begin));
  program->SetUniform("smFirstLine", portion.FirstLine);
  program->SetUniform("smLineCount", portion.LineCount);
  program->SetUniform("smToleranceOffset", this->Batch.ToleranceOffset);
  program->SetUniform("smPlacementOffset", this->Batch.PlacementOffset);
  program->SetUniform("smIntegrandCount", static_cast<unsigned int>(setup.Integrands.size()));
  program->SetUniform("smGapSteps", FootPointSteps);
  program->SetUniform("smRoundingCount", static_cast<unsigned int>(layout.GetNumberOfRoundings()));
  if (!this->Bind(key, this->Slots.front()->Page) || !program->SetUniform(GetCounter(key), count) ||
    !program->Dispatch(count, LocalSize))
  {
    error = "a dispatch failed: " + program->GetError() + this->GetBufferErrors();
    return false;
  }
  return true;
}

bool GPUItemRunner::Run(const std::vector<WorkItem>& items, const std::vector<std::size_t>& active,
  std::vector<std::uint8_t>& unconverged, std::int64_t& evaluations, const ContinueCallback& shouldContinue)
{
  Internals& self = *this->Implementation;
  // The items are sorted by program and order, so that neighbouring invocations do the same work; the sort is stable.
  std::vector<std::pair<ProgramKey, std::size_t>> order;
  order.reserve(active.size());
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    order.emplace_back(ChooseProgram(items[active[i]]), i);
  }
  std::stable_sort(order.begin(), order.end(),
    [&](const auto& a, const auto& b)
    {
      return std::tie(a.first, items[active[a.second]].Work.Detail[0]) <
        std::tie(b.first, items[active[b.second]].Work.Detail[0]);
    });
  std::vector<WorkRecord> work;
  std::vector<LineRecord> lines;
  work.reserve(active.size());
  for (const auto& [key, i] : order)
  {
    work.push_back(self.MakeRecord(items[active[i]]));
    if (IsOfLines(key))
    {
      work.back().Detail[1] = static_cast<std::uint32_t>(lines.size());
      for (std::uint32_t node = 0; node < GetLines(work.back()); ++node)
      {
        lines.push_back({ static_cast<std::uint32_t>(work.size() - 1), node });
      }
    }
  }
  const std::uint32_t zero = 0;
  const std::size_t bytes =
    (this->Layout.GetNumberOfIntegrands() + this->Layout.GetNumberOfRoundings()) * sizeof(double);
  const std::size_t mostLines =
    std::clamp(static_cast<std::size_t>(self.Context->GetMaximumStorageBlockSize()) / bytes, LinesOfPanel,
      LinesOfDispatch);
  if (!self.Work.Upload(work) || !self.StatusFlags.Allocate((active.size() + 1) * sizeof(std::uint32_t)) ||
    !self.StatusFlags.Upload(&zero, sizeof(zero)) || !self.Lines.Upload(lines) ||
    !self.LineSums.Allocate(std::min(lines.size(), mostLines) * bytes))
  {
    return this->Fail("the work list does not fit on the GPU: " + self.GetBufferErrors());
  }
  for (std::size_t begin = 0; begin < order.size();)
  {
    const ProgramKey key = order[begin].first;
    Internals::Portion portion = { begin, begin, work[begin].Detail[1], 0 };
    std::int64_t cost = 0;
    for (std::size_t& end = portion.End; end < order.size() && order[end].first == key; ++end)
    {
      const std::uint32_t more = IsOfLines(key) ? GetLines(work[end]) : 0;
      if (cost >= CostPerDispatch || portion.LineCount + more > mostLines)
      {
        break;
      }
      portion.LineCount += more;
      cost += items[active[order[end].second]].GetCost();
    }
    std::string error;
    if (!self.Dispatch(this->Configured, this->Layout, key, portion, error) ||
      (IsOfLines(key) &&
        !self.Dispatch(this->Configured, this->Layout, IntegrationPrograms::GetPanelSums(), portion, error)))
    {
      return this->Fail(error);
    }
    begin = portion.End;
    if (shouldContinue && !shouldContinue())
    {
      return this->Fail("aborted");
    }
  }
  std::vector<std::uint32_t> status(active.size() + 1);
  if (!self.StatusFlags.Read(status.data(), status.size() * sizeof(status[0])))
  {
    return this->Fail(self.StatusFlags.GetError());
  }
  evaluations += status[0];
  unconverged.assign(active.size(), 0);
  for (std::size_t at = 0; at < order.size(); ++at)
  {
    unconverged[order[at].second] = status[1 + at] != 0 ? 1 : 0;
  }
  return true;
}

void GPUItemRunner::Release()
{
  this->Implementation->Slots.clear();
  this->Implementation->Places.clear();
  this->Implementation->Resident.EndRun();
}

bool GPUItemRunner::Sum(
  const std::vector<Segment>& segments, std::vector<double>& sums, std::vector<double>& largestGaps)
{
  Internals& self = *this->Implementation;
  const auto stride = static_cast<unsigned int>(this->Layout.GetStride());
  // The largest gap is the first column.
  static_assert(RowLayout::LargestGap == 0, "the column that is reduced to its maximum");
  if (!self.Sums.Reduce(self.Rows, stride, stride, segments, Reduction::Operation::SUM, sums) ||
    !self.Sums.Reduce(self.Rows, stride, 1, segments, Reduction::Operation::MAXIMUM, largestGaps))
  {
    return this->Fail("the reduction failed: " + self.Sums.GetError());
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    largestGaps[i] = segments[i].first == segments[i].second ? 0.0 : largestGaps[i];
  }
  return true;
}
}
