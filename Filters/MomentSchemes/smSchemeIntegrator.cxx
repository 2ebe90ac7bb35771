#include "Detail/smSchemeIntegrator.h"

#include "Detail/smPlaneMoments.h"
#include "Detail/smSchemeRunner.h"
#include "smCompensatedSum.h"
#include "smFormat.h"
#include "smMassIntegrands.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <set>

namespace sm
{
namespace
{
// Fraction of the progress for the preparation; the integration takes the rest.
constexpr double PreparedShare = 0.3;

/// Compensated sums of the columns. After an overflow the carry is NaN, and the sum alone is the result.
struct ColumnSums
{
  std::array<CompensatedSum, NumberOfSchemeColumns> Columns;

  void Add(const double* values)
  {
    for (int i = 0; i < NumberOfSchemeColumns; ++i)
    {
      this->Columns[i].Add(values[i]);
    }
  }
  double Get(int i) const
  {
    const CompensatedSum& column = this->Columns[i];
    return std::isfinite(column.Sum) ? column.Get() : column.Sum;
  }
};

double CountSubPatches(const NURBSSurface& surface, int factor)
{
  // Computed as a double, since the product may exceed any integer type.
  double count = 1.0;
  for (int d = 0; d < 2; ++d)
  {
    count *= static_cast<double>(surface.GetSpanBreaks(d).size() - 1) * factor;
  }
  return count;
}

TrimTexture MakeTexture(const SubPatchFace& face, int factor)
{
  TrimTexture texture;
  texture.Width = face.Grid.GetNumberOfColumns() * factor;
  texture.Height = face.Grid.GetNumberOfRows() * factor;
  texture.Spacing = { (face.Grid.U.back() - face.Grid.U.front()) / texture.Width,
    (face.Grid.V.back() - face.Grid.V.front()) / texture.Height };
  texture.Origin = { face.Grid.U.front() + 0.5 * texture.Spacing[0],
    face.Grid.V.front() + 0.5 * texture.Spacing[1] };
  texture.Texels.assign(static_cast<std::size_t>(texture.Width) * texture.Height, 0);
  return texture;
}

void CopyTexels(const TileRange& range, const std::int32_t* texels, int factor, TrimTexture& texture)
{
  const std::size_t columns = static_cast<std::size_t>(range.Columns) * factor;
  const std::size_t rows = static_cast<std::size_t>(range.Rows) * factor;
  for (std::size_t row = 0; row < rows; ++row)
  {
    unsigned char* to = texture.Texels.data() +
      (static_cast<std::size_t>(range.Row) * factor + row) * texture.Width +
      static_cast<std::size_t>(range.Column) * factor;
    std::copy_n(texels + row * columns, columns, to);
  }
}
}

struct SchemeIntegrator::Internals
{
  std::unique_ptr<SchemeRunner> Runner;
  PreparedFaces Prepared;

  std::string Error;
  bool Aborted = false;
  bool TimedOut = false;
  std::int64_t Evaluations = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double IntegrateSeconds = 0.0;

  /// Data of the current Integrate().
  ProgressCallback Progress;
  Setup Chosen;
  double Start = 0.0;
  std::vector<ColumnSums> Sums;
  std::size_t SubPatchesDone = 0;
  std::size_t SubPatchesTotal = 1;

  bool Fail(const std::string& what)
  {
    this->Error = this->Aborted ? "aborted" : what;
    return false;
  }
  bool ReportProgress(double fraction)
  {
    this->TimedOut = this->TimedOut ||
      (this->Chosen.MaximumSeconds > 0.0 &&
        vtkTimerLog::GetUniversalTime() - this->Start > this->Chosen.MaximumSeconds);
    this->Aborted = this->Aborted || this->TimedOut || (this->Progress && !this->Progress(fraction));
    return !this->Aborted || this->Fail("aborted");
  }
  bool CheckCost(const std::vector<SchemeTask>& tasks);
  bool PrepareFaces(const std::vector<SchemeTask>& tasks);
  bool PrepareRunner();
  std::vector<TileRange> MakeAllTiles();
  bool RunBatch(const SchemeBatch& batch, std::vector<SchemeResult>& results);
  bool RunAll(std::vector<SchemeResult>& results);
  void Finish(std::vector<SchemeResult>& results) const;
};

bool SchemeIntegrator::Internals::CheckCost(const std::vector<SchemeTask>& tasks)
{
  double evaluations = 0.0;
  for (const SchemeTask& task : tasks)
  {
    evaluations += CountEvaluations(task.Source->Surface, this->Chosen);
  }
  if (evaluations > static_cast<double>(this->Chosen.MaximumEvaluations))
  {
    return this->Fail("the scheme takes " + FormatDigits(evaluations, 3) +
      " evaluations, and the maximum is " +
      FormatDigits(static_cast<double>(this->Chosen.MaximumEvaluations), 3) +
      ": divide into fewer sub-patches");
  }
  return true;
}

bool SchemeIntegrator::Internals::PrepareFaces(const std::vector<SchemeTask>& tasks)
{
  return this->ReportProgress(0.0) &&
    this->Prepared.Prepare(tasks, this->Chosen.Options,
      [this](double fraction) { return this->ReportProgress(PreparedShare * fraction); });
}

bool SchemeIntegrator::Internals::PrepareRunner()
{
  const double start = vtkTimerLog::GetUniversalTime();
  std::set<SchemeKernel> kernels;
  for (const PreparedFace& face : this->Prepared.Get())
  {
    if (face->Error.empty() && !face->Planar)
    {
      kernels.insert(ChooseSchemeKernel(*face));
    }
  }
  const bool ok = this->Runner->Prepare(kernels);
  this->StartSeconds = vtkTimerLog::GetUniversalTime() - start;
  return ok || this->Fail(this->Runner->GetError());
}

std::vector<TileRange> SchemeIntegrator::Internals::MakeAllTiles()
{
  // Faces of one kernel are adjacent, in their original order.
  const std::vector<PreparedFace>& faces = this->Prepared.Get();
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&faces](std::size_t a, std::size_t b)
    { return ChooseSchemeKernel(*faces[a]) < ChooseSchemeKernel(*faces[b]); });
  std::vector<TileRange> all;
  for (const std::size_t i : order)
  {
    const SubPatchFace& face = *faces[i];
    if (face.Error.empty() && !face.Planar &&
      SchemeBatch::GetFaceBytes(face) <= this->Runner->GetMaximumBytes())
    {
      const std::vector<TileRange> tiles = MakeTiles(i, face, this->Chosen.Options.TextureFactor);
      all.insert(all.end(), tiles.begin(), tiles.end());
    }
  }
  return all;
}

bool SchemeIntegrator::Internals::RunBatch(const SchemeBatch& batch, std::vector<SchemeResult>& results)
{
  const auto shouldContinue = [this]()
  {
    const double done = static_cast<double>(this->SubPatchesDone) / this->SubPatchesTotal;
    return this->ReportProgress(PreparedShare + (1.0 - PreparedShare) * done);
  };
  SchemeRunner::Results found;
  if (!this->Runner->Run(batch, { this->Chosen.Points, this->Chosen.Perturbation, this->Chosen.KeepTextures },
        found, shouldContinue))
  {
    return this->Fail(this->Runner->GetError());
  }
  this->Evaluations += found.Evaluations;
  const int factor = this->Chosen.Options.TextureFactor;
  for (std::size_t i = 0; i < batch.Tiles.size(); ++i)
  {
    const TileRange& range = batch.Ranges[i];
    this->Sums[range.Face].Add(found.Sums.data() + i * NumberOfSchemeColumns);
    if (!found.Texels.empty() && batch.Tiles[i].Shape[2] > 0)
    {
      TrimTexture& texture = results[range.Face].Texture;
      if (texture.Texels.empty())
      {
        texture = MakeTexture(*this->Prepared.Get()[range.Face], factor);
      }
      CopyTexels(range, found.Texels.data() + batch.Tiles[i].Texels[0], factor, texture);
    }
  }
  this->SubPatchesDone += batch.SubPatches;
  return shouldContinue();
}

bool SchemeIntegrator::Internals::RunAll(std::vector<SchemeResult>& results)
{
  const std::vector<TileRange> tiles = this->MakeAllTiles();
  this->SubPatchesTotal = 1;
  for (const TileRange& tile : tiles)
  {
    this->SubPatchesTotal += tile.GetNumberOfSubPatches();
  }
  this->Sums.assign(this->Prepared.Get().size(), ColumnSums());
  SchemeBatch batch;
  const auto add = [&](const TileRange& tile)
  {
    return batch.Add(tile, *this->Prepared.Get()[tile.Face], this->Chosen.Options.TextureFactor,
      this->Runner->GetMaximumBytes());
  };
  for (const TileRange& tile : tiles)
  {
    if (add(tile))
    {
      continue;
    }
    if (!this->RunBatch(batch, results))
    {
      return false;
    }
    batch = SchemeBatch();
    add(tile);
  }
  return batch.Tiles.empty() || this->RunBatch(batch, results);
}

void SchemeIntegrator::Internals::Finish(std::vector<SchemeResult>& results) const
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const SubPatchFace& face = *this->Prepared.Get()[i];
    SchemeResult& result = results[i];
    FaceIntegrals& integrals = result.Integrals;
    integrals.Error = face.Error;
    if (face.Error.empty() && SchemeBatch::GetFaceBytes(face) > this->Runner->GetMaximumBytes())
    {
      integrals.Error = "face #" + std::to_string(face.Source->FileId) +
        " has more control points than a storage block of this GPU may have";
    }
    integrals.Face.assign(NumberOfMassIntegrands, 0.0);
    integrals.Closing.assign(NumberOfMassIntegrands, 0.0);
    integrals.QuadratureError.assign(NumberOfMassIntegrands, nan);
    integrals.Rounding.assign(NumberOfMassIntegrands, nan);
    integrals.Conversion.assign(NumberOfMassIntegrands, nan);
    integrals.Residual.assign(NumberOfMassIntegrands, nan);
    integrals.GapSquared = integrals.GapArea = integrals.MaxGap = nan;
    integrals.Outside.Distance = face.Outside;
    if (!integrals.Error.empty())
    {
      continue;
    }
    if (face.Planar)
    {
      const std::array<double, 14> moments = ComputePlaneMoments(face);
      std::copy(moments.begin(), moments.end(), integrals.Face.begin());
      continue;
    }
    for (int k = 0; k < NumberOfMassIntegrands; ++k)
    {
      integrals.Face[k] = this->Sums[i].Get(k);
    }
    result.Estimate = this->Sums[i].Get(SchemeEstimate);
    result.EstimateWithBoundary = this->Sums[i].Get(SchemeEstimateWithBoundary);
    result.SubPatches =
      static_cast<std::int64_t>(face.Grid.GetNumberOfColumns()) * face.Grid.GetNumberOfRows();
  }
}

SchemeIntegrator::SchemeIntegrator()
  : Implementation(new Internals)
{
}

SchemeIntegrator::~SchemeIntegrator() = default;

void SchemeIntegrator::SetRunner(std::unique_ptr<SchemeRunner> runner)
{
  this->Implementation->Runner = std::move(runner);
}

bool SchemeIntegrator::Integrate(const std::vector<SchemeTask>& tasks, const Setup& setup,
  std::vector<SchemeResult>& results, const ProgressCallback& progress)
{
  Internals& self = *this->Implementation;
  self.Error.clear();
  self.Aborted = self.TimedOut = false;
  self.Evaluations = 0;
  self.SubPatchesDone = 0;
  self.StartSeconds = self.PrepareSeconds = self.IntegrateSeconds = 0.0;
  self.Progress = progress;
  self.Chosen = setup;
  const double start = self.Start = vtkTimerLog::GetUniversalTime();
  results.assign(tasks.size(), SchemeResult());
  double begin = start;
  bool ok = false;
  try
  {
    ok = self.CheckCost(tasks) && self.PrepareFaces(tasks) && self.PrepareRunner();
    begin = vtkTimerLog::GetUniversalTime();
    self.PrepareSeconds = begin - start - self.StartSeconds;
    ok = ok && self.RunAll(results);
    if (ok)
    {
      self.Finish(results);
    }
  }
  catch (const std::bad_alloc&)
  {
    results.clear();
    self.Prepared.Release();
    self.Sums.clear();
    throw;
  }
  if (!ok)
  {
    results.clear();
  }
  self.IntegrateSeconds = vtkTimerLog::GetUniversalTime() - begin;
  self.Prepared.Release();
  self.Sums.clear();
  self.Progress = nullptr;
  return ok;
}

const PreparedFaces& SchemeIntegrator::GetPrepared() const
{
  return this->Implementation->Prepared;
}

const std::string& SchemeIntegrator::GetError() const
{
  return this->Implementation->Error;
}

bool SchemeIntegrator::WasAborted() const
{
  return this->Implementation->Aborted;
}

bool SchemeIntegrator::WasTimedOut() const
{
  return this->Implementation->TimedOut;
}

double SchemeIntegrator::CountEvaluations(const NURBSSurface& surface, const Setup& setup)
{
  return surface.Check().empty() && !IsPlanar(surface)
    ? CountSubPatches(surface, setup.Options.Factor) * setup.Points * setup.Points
    : 0.0;
}

std::int64_t SchemeIntegrator::GetEvaluations() const
{
  return this->Implementation->Evaluations;
}

double SchemeIntegrator::GetStartSeconds() const
{
  return this->Implementation->StartSeconds;
}

double SchemeIntegrator::GetPrepareSeconds() const
{
  return this->Implementation->PrepareSeconds;
}

double SchemeIntegrator::GetIntegrateSeconds() const
{
  return this->Implementation->IntegrateSeconds;
}
}
