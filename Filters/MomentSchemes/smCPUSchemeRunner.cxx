#include "Detail/smCPUSchemeRunner.h"

#include "smRowSums.h"

#include "smParallelFor.h"
#include "smPortableCxx.h"

#include <algorithm>
#include <atomic>

namespace sm
{
namespace
{
// Number of sub-patches per task of a thread.
constexpr std::size_t SubPatchesPerTask = 64;
// Estimated cost between two calls of shouldContinue: some tens of milliseconds of one core.
constexpr std::int64_t CostPerPart = 4000000;

/// The lists that kernels read and write. Different threads may process different tiles, rows of texels and
/// sub-patches.
struct SchemeLists
{
  const SchemeBatch& Batch;
  const SchemeRunner::Setup& Setup;
  std::vector<std::int32_t> Texels;
  std::vector<double> Rows;
};

#define SM_DEGREE_S (DegreeS > 0 ? DegreeS : static_cast<int>(source.shape.y))
#define SM_DEGREE_R (DegreeR > 0 ? DegreeR : static_cast<int>(source.shape.z))
#define SM_BASIS_SIZE BasisSize
#define SM_ROW_SIZE RowSize

/// The shader chunks and the functions they need, for patches of the given degrees (0: any).
template <int DegreeS, int DegreeR>
class Kernel
{
public:
  explicit Kernel(SchemeLists& lists)
    : Lists(lists)
    , smPoints(lists.Setup.Points)
    , smPerturbation(lists.Setup.Perturbation)
  {
  }

  void DrawTrims(const SchemeTile& from)
  {
    const smSchemeTile tile = Convert(from);
    for (uint i = 0; i < from.Texels[1] && from.Shape[2] > 0; ++i)
    {
      smDrawTrim(tile, i);
    }
  }

  void SweepTexels(const SchemeTile& from)
  {
    const smSchemeTile tile = Convert(from);
    for (uint row = 0; row < from.Shape[2] * from.Grid[3]; ++row)
    {
      smSweepTexels(tile, row);
    }
  }

  uint Integrate(const SchemeTile& from, uint index)
  {
    return smIntegrateSubPatch(
      Convert(from), index, static_cast<uint>(NumberOfSchemeColumns) * (from.Begin[0] + index));
  }

private:
  static constexpr int RowSize = DegreeS > 0 ? DegreeS + 1 : MaximumDegree + 1;
  static constexpr int BasisSize = DegreeS > 0 ? (DegreeS > DegreeR ? DegreeS : DegreeR) : MaximumDegree;

// The types are included first.
#include "glsl/smSchemeTile.glsl"

#include "glsl/smErrorFree.glsl"

#include "glsl/smBernstein.glsl"
#include "glsl/smPatch.glsl"
#include "glsl/smSubPatch.glsl"
#include "glsl/smTrimTexture.glsl"

  static uvec4 Convert(const std::uint32_t (&v)[4])
  {
    return uvec4(v[0], v[1], v[2], v[3]);
  }
  static smSchemeTile Convert(const SchemeTile& tile)
  {
    return { Convert(tile.Begin), Convert(tile.Grid), Convert(tile.Shape), Convert(tile.Values),
      Convert(tile.Texels) };
  }

  double smValue(uint at) const
  {
    return this->Lists.Batch.Values[at];
  }
  double smCoefficient(uint at) const
  {
    return this->Lists.Batch.Values[at];
  }
  dvec4 smControlPoint(uint index) const
  {
    const std::array<double, 4>& p = this->Lists.Batch.Points[index];
    return dvec4(p[0], p[1], p[2], p[3]);
  }
  smSchemePatch smGetSource(uint index) const
  {
    const SchemePatch& patch = this->Lists.Batch.Patches[index];
    return { dvec4(patch.Center[0], patch.Center[1], patch.Center[2], 0.0), Convert(patch.Shape) };
  }
  void smAddTexel(uint at, int change)
  {
    this->Lists.Texels[at] += change;
  }
  int smGetTexel(uint at) const
  {
    return this->Lists.Texels[at];
  }
  void smSetTexel(uint at, int value)
  {
    this->Lists.Texels[at] = value;
  }
  void smSetResult(uint at, double value)
  {
    this->Lists.Rows[at] = value;
  }

  SchemeLists& Lists;
  const int smPoints;
  const double smPerturbation;
};

/// Evaluates the sub-patches [first, last) of the batch and returns the number of evaluations.
template <int DegreeS, int DegreeR>
std::int64_t IntegrateRange(SchemeLists& lists, std::uint32_t first, std::uint32_t last)
{
  Kernel<DegreeS, DegreeR> kernel(lists);
  const std::vector<SchemeTile>& tiles = lists.Batch.Tiles;
  auto tile = std::upper_bound(tiles.begin(), tiles.end(), first,
    [](std::uint32_t at, const SchemeTile& other) { return at < other.Begin[0]; });
  std::int64_t evaluations = 0;
  for (std::uint32_t i = first; i < last; ++i)
  {
    while (tile != tiles.end() && tile->Begin[0] <= i)
    {
      ++tile;
    }
    const SchemeTile& own = *(tile - 1);
    evaluations += kernel.Integrate(own, i - own.Begin[0]);
  }
  return evaluations;
}

std::int64_t Integrate(
  SchemeLists& lists, const SchemeKernel& kernel, std::uint32_t first, std::uint32_t last)
{
  switch (100 * kernel.first + kernel.second)
  {
    case 102:
      return IntegrateRange<1, 2>(lists, first, last);
    case 201:
      return IntegrateRange<2, 1>(lists, first, last);
    case 202:
      return IntegrateRange<2, 2>(lists, first, last);
    case 303:
      return IntegrateRange<3, 3>(lists, first, last);
    default:
      return IntegrateRange<0, 0>(lists, first, last);
  }
}
}

bool CPUSchemeRunner::Run(
  const SchemeBatch& batch, const Setup& setup, Results& results, const ContinueCallback& shouldContinue)
{
  SchemeLists lists{ batch, setup, {}, {} };
  lists.Texels.assign(batch.Texels, 0);
  lists.Rows.assign(static_cast<std::size_t>(batch.SubPatches) * NumberOfSchemeColumns, 0.0);
  const std::size_t tiles = batch.Tiles.size();
  ParallelFor(tiles, 1,
    [&](std::size_t from, std::size_t to)
    {
      Kernel<0, 0> kernel(lists);
      for (std::size_t i = from; i < to; ++i)
      {
        kernel.DrawTrims(batch.Tiles[i]);
        kernel.SweepTexels(batch.Tiles[i]);
      }
    });
  std::atomic<std::int64_t> evaluations{ 0 };
  for (const SchemeBatch::Part& part : batch.Parts)
  {
    const auto step =
      static_cast<std::uint32_t>(std::max<std::int64_t>(CostPerPart / GetCost(part, setup.Points), 1));
    for (std::uint32_t first = part.First; first < part.Last;)
    {
      const std::uint32_t last = first + std::min(step, part.Last - first);
      ParallelFor(last - first, SubPatchesPerTask,
        [&](std::size_t from, std::size_t to)
        {
          evaluations += Integrate(lists, part.Kernel, first + static_cast<std::uint32_t>(from),
            first + static_cast<std::uint32_t>(to));
        });
      first = last;
      if (shouldContinue && !shouldContinue())
      {
        return this->Fail("aborted");
      }
    }
  }
  results.Evaluations = evaluations;
  results.Sums.assign(batch.Tiles.size() * NumberOfSchemeColumns, 0.0);
  ParallelFor(tiles, 1,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        const std::size_t begin = static_cast<std::size_t>(batch.Tiles[i].Begin[0]) * NumberOfSchemeColumns;
        SumRows(lists.Rows.data() + begin, batch.Ranges[i].GetNumberOfSubPatches(), NumberOfSchemeColumns,
          results.Sums.data() + i * NumberOfSchemeColumns);
      }
    });
  results.Texels.clear();
  if (setup.KeepTexels)
  {
    results.Texels = std::move(lists.Texels);
  }
  return true;
}
}
