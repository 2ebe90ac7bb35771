#include "Detail/smGPUSchemeRunner.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smReduction.h"
#include "smResidentFaces.h"
#include "smShaderSource.h"

#include "smDrawTrimsCS.h"
#include "smSchemeStorage.h"
#include "smSchemeTile.h"
#include "smSubPatch.h"
#include "smSubPatchCS.h"
#include "smSweepTexelsCS.h"
#include "smTexelStorage.h"
#include "smTrimTexture.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>

namespace sm
{
namespace
{
// Number of invocations per work group, as in the shaders.
constexpr unsigned int LocalSize = 32;
// Estimated cost of one dispatch in bicubic evaluations: some 50 ms on two CPU cores, so that the run can be
// aborted between dispatches and the driver's watchdog does not interrupt it.
constexpr std::int64_t CostPerDispatch = 4000000;
// Number of parts of trim curves per dispatch, each of which crosses up to 64 rows of texels, and number of
// rows of texels.
constexpr std::uint32_t TrimsPerDispatch = 4096;
constexpr std::uint32_t TexelRowsPerDispatch = 65536;

/// Steps of a batch: two make the trim texture, the third evaluates the sub-patches.
enum class Step
{
  DrawTrims,
  SweepTexels,
  Integrate
};
using ProgramKey = std::pair<Step, SchemeKernel>;

ShaderSource MakeSource(const ProgramKey& key)
{
  const char* const texts[] = { smDrawTrimsCS, smSweepTexelsCS, smSubPatchCS };
  const char* const names[] = { "smDrawTrimsCS", "smSweepTexelsCS", "smSubPatchCS" };
  ShaderSource source(names[static_cast<int>(key.first)], texts[static_cast<int>(key.first)]);
  for (const char* chunk : { "smBernstein", "smPatch" })
  {
    source.AddChunk(chunk, GetNURBSShaderChunk(chunk));
  }
  const std::pair<const char*, const char*> chunks[] = { { "smSchemeStorage", smSchemeStorage },
    { "smSchemeTile", smSchemeTile }, { "smSubPatch", smSubPatch }, { "smTexelStorage", smTexelStorage },
    { "smTrimTexture", smTrimTexture } };
  for (const auto& [name, text] : chunks)
  {
    source.AddChunk(name, text);
  }
  const auto [degreeS, degreeR] = key.second;
  source.Define("SM_DEGREE_S", degreeS > 0 ? std::to_string(degreeS) : "int(source.shape.y)");
  source.Define("SM_DEGREE_R", degreeR > 0 ? std::to_string(degreeR) : "int(source.shape.z)");
  source.Define("SM_ROW_SIZE", degreeS > 0 ? degreeS + 1 : MaximumDegree + 1);
  source.Define("SM_BASIS_SIZE", degreeR > 0 ? std::max(degreeS, degreeR) : MaximumDegree);
  return source;
}
}

struct GPUSchemeRunner::Internals
{
  explicit Internals(vtkComputeContext* context)
    : Context(context)
    , Points(context)
    , Patches(context)
    , Values(context)
    , Tiles(context)
    , Texels(context)
    , Rows(context)
    , Counts(context)
    , Sums(context)
  {
  }

  vtkSmartPointer<vtkComputeContext> Context;
  std::map<ProgramKey, ComputeProgram> Programs;
  ComputeBuffer Points;
  ComputeBuffer Patches;
  ComputeBuffer Values;
  ComputeBuffer Tiles;
  ComputeBuffer Texels;
  ComputeBuffer Rows;
  ComputeBuffer Counts;
  Reduction Sums;
  /// Number of tiles, options and error of the current Run().
  std::uint32_t NumberOfTiles = 0;
  Setup Chosen;
  std::string Error;

  std::string GetBufferErrors() const
  {
    return this->Points.GetError() + this->Patches.GetError() + this->Values.GetError() +
      this->Tiles.GetError() + this->Texels.GetError() + this->Rows.GetError() + this->Counts.GetError();
  }
  bool Bind()
  {
    return this->Points.Bind(0) && this->Patches.Bind(1) && this->Values.Bind(2) && this->Tiles.Bind(3) &&
      this->Texels.Bind(4) && this->Rows.Bind(5) && this->Counts.Bind(6);
  }
  ComputeProgram* GetProgram(const ProgramKey& key);
  bool Upload(const SchemeBatch& batch);
  bool Dispatch(const ProgramKey& key, std::uint32_t first, std::uint32_t count);
  bool DispatchAll(const ProgramKey& key, std::uint32_t first, std::uint32_t last, std::uint32_t step,
    const ContinueCallback& shouldContinue);
};

ComputeProgram* GPUSchemeRunner::Internals::GetProgram(const ProgramKey& key)
{
  ComputeProgram& program = this->Programs[key];
  if (program.IsBuilt())
  {
    return &program;
  }
  ShaderSource source = MakeSource(key);
  const std::string label =
    source.GetName() + " " + std::to_string(key.second.first) + "x" + std::to_string(key.second.second);
  if (!source.Assemble())
  {
    this->Error = source.GetError();
    return nullptr;
  }
  if (!program.Build(this->Context, label, source.GetSource()))
  {
    this->Error = program.GetError();
    return nullptr;
  }
  return &program;
}

bool GPUSchemeRunner::Internals::Upload(const SchemeBatch& batch)
{
  this->NumberOfTiles = static_cast<std::uint32_t>(batch.Tiles.size());
  const std::uint32_t zero = 0;
  const bool fits = this->Points.Upload(batch.Points) && this->Patches.Upload(batch.Patches) &&
    this->Values.Upload(batch.Values) && this->Tiles.Upload(batch.Tiles) &&
    this->Texels.Allocate(std::max<std::size_t>(batch.Texels, 1) * sizeof(std::int32_t)) &&
    this->Texels.Clear() &&
    this->Rows.Allocate(
      static_cast<std::size_t>(batch.SubPatches) * NumberOfSchemeColumns * sizeof(double)) &&
    this->Counts.Allocate(sizeof(zero)) && this->Counts.Upload(&zero, sizeof(zero));
  if (!fits)
  {
    this->Error = "the sub-patches do not fit on the GPU: " + this->GetBufferErrors();
  }
  return fits;
}

bool GPUSchemeRunner::Internals::Dispatch(const ProgramKey& key, std::uint32_t first, std::uint32_t count)
{
  const ContextScope scope(this->Context);
  if (!scope)
  {
    this->Error = "the OpenGL context was lost: " + this->Context->GetReason();
    return false;
  }
  ComputeProgram* program = this->GetProgram(key);
  if (!program)
  {
    return false;
  }
  program->SetUniform("smFirstWork", first);
  program->SetUniform("smTileCount", this->NumberOfTiles);
  program->SetUniform("smPoints", this->Chosen.Points);
  program->SetUniform("smPerturbation", this->Chosen.Perturbation);
  // At least one invocation runs, as drivers finish compilation at the first dispatch.
  if (!this->Bind() || !program->SetUniform("smWorkCount", count) ||
    !program->Dispatch(std::max(count, 1u), LocalSize))
  {
    this->Error = "a dispatch failed: " + program->GetError() + this->GetBufferErrors();
    return false;
  }
  return true;
}

bool GPUSchemeRunner::Internals::DispatchAll(const ProgramKey& key, std::uint32_t first, std::uint32_t last,
  std::uint32_t step, const ContinueCallback& shouldContinue)
{
  while (first < last)
  {
    const std::uint32_t count = std::min(step, last - first);
    if (!this->Dispatch(key, first, count))
    {
      return false;
    }
    first += count;
    if (shouldContinue && !shouldContinue())
    {
      this->Error = "aborted";
      return false;
    }
  }
  return true;
}

GPUSchemeRunner::GPUSchemeRunner(vtkComputeContext* context)
  : Implementation(new Internals(context))
{
}

GPUSchemeRunner::~GPUSchemeRunner() = default;

std::size_t GPUSchemeRunner::GetMaximumBytes() const
{
  return static_cast<std::size_t>(this->Implementation->Context->GetMaximumStorageBlockSize());
}

bool GPUSchemeRunner::Prepare(const std::set<SchemeKernel>& kernels)
{
  Internals& self = *this->Implementation;
  if (kernels.empty())
  {
    return true;
  }
  SchemeBatch nothing;
  nothing.Points.resize(1);
  nothing.Patches.resize(1);
  nothing.Values.resize(1);
  nothing.Tiles.resize(1);
  nothing.SubPatches = 1;
  bool ok = self.Upload(nothing) && self.Dispatch({ Step::DrawTrims, {} }, 0, 0) &&
    self.Dispatch({ Step::SweepTexels, {} }, 0, 0);
  for (auto kernel = kernels.begin(); ok && kernel != kernels.end(); ++kernel)
  {
    ok = self.Dispatch({ Step::Integrate, *kernel }, 0, 0);
  }
  return ok || this->Fail(self.Error);
}

bool GPUSchemeRunner::Run(
  const SchemeBatch& batch, const Setup& setup, Results& results, const ContinueCallback& shouldContinue)
{
  Internals& self = *this->Implementation;
  self.Chosen = setup;
  bool ok = self.Upload(batch) &&
    self.DispatchAll({ Step::DrawTrims, {} }, 0, batch.Trims, TrimsPerDispatch, shouldContinue) &&
    self.DispatchAll({ Step::SweepTexels, {} }, 0, batch.TexelRows, TexelRowsPerDispatch, shouldContinue);
  for (auto part = batch.Parts.begin(); ok && part != batch.Parts.end(); ++part)
  {
    const std::int64_t step = std::max<std::int64_t>(CostPerDispatch / GetCost(*part, setup.Points), 1);
    ok = self.DispatchAll({ Step::Integrate, part->Kernel }, part->First, part->Last,
      static_cast<std::uint32_t>(step), shouldContinue);
  }
  std::uint32_t evaluations = 0;
  if (!ok || !self.Counts.Read(&evaluations, sizeof(evaluations)))
  {
    return this->Fail(self.Error + self.Counts.GetError());
  }
  results.Evaluations = evaluations;
  results.Texels.assign(setup.KeepTexels ? batch.Texels : 0, 0);
  if (!results.Texels.empty() &&
    !self.Texels.Read(results.Texels.data(), results.Texels.size() * sizeof(std::int32_t)))
  {
    return this->Fail(self.Texels.GetError());
  }
  std::vector<std::pair<unsigned int, unsigned int>> segments;
  for (std::size_t i = 0; i < batch.Tiles.size(); ++i)
  {
    const std::uint32_t first = batch.Tiles[i].Begin[0];
    segments.emplace_back(first, first + static_cast<std::uint32_t>(batch.Ranges[i].GetNumberOfSubPatches()));
  }
  return self.Sums.Reduce(self.Rows, NumberOfSchemeColumns, NumberOfSchemeColumns, segments,
           Reduction::Operation::SUM, results.Sums) ||
    this->Fail("the reduction failed: " + self.Sums.GetError());
}
}
