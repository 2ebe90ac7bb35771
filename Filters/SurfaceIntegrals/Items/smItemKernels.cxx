#include "smItemKernels.h"

#include "smItemLanes.h"
#include "smNURBSSurface.h"

#include "smPortableCxx.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace sm
{
SampleFormulas::SampleFormulas(const std::vector<Integrand>& integrands, const RowLayout& layout)
{
  for (const Integrand& integrand : integrands)
  {
    assert(integrand.Form != Integrand::Kind::User);
    std::vector<int> axes;
    int base = integrand.Form == Integrand::Kind::VolumeMoment ? 0
      : integrand.Form == Integrand::Kind::HeightMoment        ? 4
                                                               : 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (integrand.Form == Integrand::Kind::VectorArea)
      {
        base = integrand.Powers[axis] > 0 ? 2 + axis : base;
      }
      else
      {
        axes.insert(axes.end(), integrand.Powers[axis], axis);
      }
    }
    const int more = static_cast<int>(this->More.size());
    axes.resize(std::max<std::size_t>(axes.size(), 2), 3);
    this->More.insert(this->More.end(), axes.begin() + 2, axes.end());
    this->Terms.push_back({ base, integrand.Factor, axes[0], axes[1], more,
      static_cast<int>(this->More.size()), integrand.ClosedChain });
  }
  for (const int integrand : layout.GetMagnitudes())
  {
    this->Magnitudes.push_back(
      { integrands[integrand].MagnitudeFactor, integrands[integrand].MagnitudePower });
  }
}

namespace
{
#define SM_INTEGRANDS static_cast<int>(this->smIntegrandCount)
#define SM_MIN_ERROR_SHARE 1e-3

/// The end of an item: its sums are compared with those of a lower order, and stored.
class ItemEnd
{
public:
  ItemEnd(const KernelData& data, KernelScratch& scratch)
    : Data(data)
    , Values(scratch.Values.data())
    , Roundings(scratch.Roundings.data())
    , smRoundingOf(data.Layout->GetRoundingOf().data())
    , smIntegrandCount(data.Layout->GetNumberOfIntegrands())
    , smRoundingCount(data.Layout->GetNumberOfRoundings())
    , smToleranceOffset(data.ToleranceOffset)
    , smErrorColumn(data.Layout->GetError(0))
    , smRoundingColumn(data.Layout->GetFirstRounding())
    , smDifferenceColumn(data.Layout->GetDifference(0))
    , smStride(data.Layout->GetStride())
  {
  }

  /// Stores the sums that are lane `lane` of `lanes`. Returns false if the differences are above the
  /// tolerances.
  bool Store(const WorkItem& item, const ItemLanes& sums, int lane, int lanes)
  {
    for (uint k = 0; k < smIntegrandCount; ++k)
    {
      this->Values[k] = sums.Values[k * lanes + lane];
    }
    for (uint k = 0; k < smRoundingCount; ++k)
    {
      this->Roundings[k] = sums.Roundings[k * lanes + lane];
    }
    const std::uint32_t* i = item.Work.Item;
    const std::uint32_t* d = item.Work.Detail;
    const double* r = item.Work.Range;
    const smWorkRecord work = { uvec4(i[0], i[1], i[2], i[3]), uvec4(d[0], d[1], d[2], d[3]),
      dvec4(r[0], r[1], r[2], r[3]) };
    const bool kept = smFinish(0u, work);
    const dvec3 gaps = item.Kind == ItemKind::Ribbon
      ? dvec3(sums.Gaps[lane], sums.Gaps[lanes + lane], sums.Gaps[2 * lanes + lane])
      : dvec3(0.0);
    smStoreGaps(work, kept, gaps);
    return this->Converged;
  }

private:
// The types are included first.
#include "glsl/smWorkRecord.glsl"

#include "glsl/smFinish.glsl"

  double smResult(uint k) const
  {
    return this->Values[k];
  }
  double smNoise(uint k) const
  {
    return smUnitRoundoff * this->Roundings[k];
  }
  double smParameter(uint at) const
  {
    return this->Data.Parameters[at];
  }
  double smGetRow(uint at) const
  {
    return this->Data.Rows[at];
  }
  void smSetRow(uint at, double value)
  {
    this->Data.Rows[at] = value;
  }
  void smSetStatus(uint, bool converged)
  {
    this->Converged = converged;
  }

  const KernelData& Data;
  bool Converged = true;
  double* const Values;
  double* const Roundings;
  const int* const smRoundingOf;
  const uint smIntegrandCount;
  const uint smRoundingCount;
  const uint smToleranceOffset;
  static constexpr uint smValueColumn = RowLayout::FirstValue;
  const uint smErrorColumn;
  const uint smRoundingColumn;
  const uint smDifferenceColumn;
  const uint smStride;
};

/// Sizes of the arrays that items read.
struct InputSizes
{
  std::size_t Trim = 0, Edge = 0, Cap = 0, Points = 0, Placement = 0;

  InputSizes(const WorkItem& item, const Patch* patch, bool isPlaced)
    : Placement(isPlaced ? 12 : 0)
  {
    const std::uint32_t* detail = item.Work.Detail;
    if (patch)
    {
      this->Trim = 2 * ((detail[0] & 255u) + 1);
      this->Edge = item.Kind == ItemKind::Ribbon ? 3 * (detail[2] + 1) : 0;
      this->Points = 4 * static_cast<std::size_t>(patch->Degree[0] + 1) * (patch->Degree[1] + 1);
    }
    else
    {
      this->Cap = 9;
    }
  }
  // Where the arrays begin: ranges, patches, coefficients, points, placements.
  static constexpr std::size_t PatchBegin = 4;
  static constexpr std::size_t CoefficientsBegin = PatchBegin + 10;
  std::size_t GetPointsBegin() const { return CoefficientsBegin + this->Trim + this->Edge + this->Cap; }
  std::size_t GetPlacementBegin() const { return this->GetPointsBegin() + this->Points; }
  /// The number of doubles of an item, and more up to a multiple of the lanes: arrays are interleaved in
  /// squares.
  std::size_t GetTotal() const
  {
    return (this->GetPlacementBegin() + this->Placement + MaxLanes - 1) / MaxLanes * MaxLanes;
  }
};

const Patch* GetPatch(const KernelItem& item)
{
  return item.Item->Kind == ItemKind::Cap ? nullptr : &item.Face->Patches[item.Item->Work.Item[0]];
}

/// Copies what an item reads, in the order of InputSizes.
void CopyInputs(const KernelData& data, const KernelItem& item, const InputSizes& sizes, double* to)
{
  const WorkRecord& work = item.Item->Work;
  const auto copy = [&to](const double* from, std::size_t size)
  {
    std::memcpy(to, from, size * sizeof(double));
    to += size;
  };
  copy(work.Range, 4);
  if (const Patch* patch = GetPatch(item))
  {
    // Centre, radius, start and width are one after another.
    static_assert(offsetof(Patch, Width) - offsetof(Patch, Center) == 6 * sizeof(double));
    copy(patch->Center, 8);
    copy(patch->Stretch, 2);
    copy(item.Face->Coefficients.data() + work.Item[1], sizes.Trim);
    copy(item.Face->Coefficients.data() + work.Detail[1], sizes.Edge);
    copy(item.Face->Points[patch->FirstPoint].data(), sizes.Points);
  }
  else
  {
    to += InputSizes::CoefficientsBegin - InputSizes::PatchBegin;
    const Cap& cap = item.Face->Caps[work.Item[1] / 9u];
    copy(cap.Apex.data(), 3);
    copy(cap.From.data(), 3);
    copy(cap.To.data(), 3);
  }
  copy(data.Parameters + data.PlacementOffset + 12 * work.Item[3], sizes.Placement);
}

/// Writes what items read, side by side. Lanes beyond the last item repeat it.
void WriteLanes(const KernelData& data, const KernelItem* items, int count, int lanes,
  const InputSizes& sizes, KernelScratch& scratch)
{
  const std::size_t total = sizes.GetTotal();
  if (scratch.Inputs.size() < total * lanes)
  {
    scratch.Inputs.resize(total * lanes);
    scratch.Copies.resize(total * lanes);
  }
  std::array<const double*, MaxLanes> from{};
  for (int lane = 0; lane < lanes; ++lane)
  {
    double* copy = scratch.Copies.data() + std::min(lane, count - 1) * total;
    if (lane < count)
    {
      CopyInputs(data, items[lane], sizes, copy);
    }
    from[lane] = copy;
  }
  double* to = scratch.Inputs.data();
  switch (lanes)
  {
#ifdef SM_WIDE_LANES
    case 8:
      return InterleaveLanes8(from.data(), total, to);
    case 4:
      return InterleaveLanes4(from.data(), total, to);
#endif
    case 2:
      return InterleaveLanes2(from.data(), total, to);
    default:
      std::copy_n(from[0], total, to);
  }
}

/// Returns the next address that is aligned for the widest vector registers.
double* Align(double* address)
{
  constexpr std::uintptr_t alignment = sizeof(double) * MaxLanes;
  const std::uintptr_t misfit = reinterpret_cast<std::uintptr_t>(address) % alignment;
  return misfit == 0 ? address : address + (alignment - misfit) / sizeof(double);
}

std::uint32_t Integrate(const ItemLanes& items, int lanes)
{
  switch (lanes)
  {
#ifdef SM_WIDE_LANES
    case 8:
      return IntegrateLanes8(items);
    case 4:
      return IntegrateLanes4(items);
#endif
    case 2:
      return IntegrateLanes2(items);
    default:
      return IntegrateLanes1(items);
  }
}
}

const std::vector<int>& GetLaneCounts()
{
  static const std::vector<int> counts = []
  {
    std::vector<int> found = { 1, 2 };
#ifdef SM_WIDE_LANES
    const bool isFused = __builtin_cpu_supports("fma") != 0;
    if (isFused && __builtin_cpu_supports("avx2"))
    {
      found.push_back(4);
    }
    if (isFused && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    {
      found.push_back(8);
    }
#endif
    return found;
  }();
  return counts;
}

std::uint64_t GetItemShape(const KernelItem& item)
{
  const std::uint32_t* detail = item.Item->Work.Detail;
  const Patch* patch = GetPatch(item);
  std::uint64_t shape = static_cast<std::uint64_t>(item.Item->Kind);
  shape = shape << 5 | static_cast<std::uint64_t>(patch ? patch->Degree[0] : 0);
  shape = shape << 5 | static_cast<std::uint64_t>(patch ? patch->Degree[1] : 0);
  // The flags that only the end of an item reads may differ among the items of a shape.
  shape = shape << 32 | (detail[0] & ~((FlagFirst | FlagDiscard) << 24));
  return shape << 8 | detail[2];
}

void EvaluateItems(const KernelData& data, const KernelItem* items, int count, int lanes,
  KernelScratch& scratch, KernelResult* results)
{
  const WorkItem& first = *items[0].Item;
  const Patch* patch = GetPatch(items[0]);
  const InputSizes sizes(first, patch, data.Setup->UsePlacements);
  WriteLanes(data, items, count, lanes, sizes, scratch);
  const double* inputs = scratch.Inputs.data();
  const SampleFormulas& formulas = *data.Formulas;
  const std::size_t terms = formulas.Terms.size();
  const std::size_t magnitudes = formulas.Magnitudes.size();
  scratch.Sums.resize((terms + magnitudes + 3) * lanes + MaxLanes);
  ItemLanes batch;
  batch.Kind = first.Kind;
  for (int d = 0; d < 2; ++d)
  {
    batch.Degree[d] = first.Degree[d];
    batch.Shape[d] = patch ? patch->Degree[d] : 0;
  }
  std::copy_n(first.Work.Detail, 4, batch.Detail);
  batch.Detail[1] = static_cast<std::uint32_t>(sizes.Trim);
  batch.Range = inputs;
  batch.Patch = inputs + InputSizes::PatchBegin * lanes;
  batch.Placement = inputs + sizes.GetPlacementBegin() * lanes;
  batch.Coefficients = inputs + InputSizes::CoefficientsBegin * lanes;
  batch.Points = inputs + sizes.GetPointsBegin() * lanes;
  batch.Rules = data.Parameters;
  batch.UsePlacements = data.Setup->UsePlacements;
  batch.Perturbation = data.Setup->Perturbation;
  batch.StripPoints = data.Setup->StripPoints;
  batch.Terms = formulas.Terms.data();
  batch.NumberOfTerms = static_cast<int>(terms);
  batch.More = formulas.More.data();
  batch.Magnitudes = formulas.Magnitudes.data();
  batch.NumberOfMagnitudes = static_cast<int>(magnitudes);
  batch.Values = Align(scratch.Sums.data());
  batch.Roundings = batch.Values + terms * lanes;
  batch.Gaps = batch.Roundings + magnitudes * lanes;
  const std::uint32_t evaluations = Integrate(batch, lanes);
  for (int lane = 0; lane < count; ++lane)
  {
    const bool converged = ItemEnd(data, scratch).Store(*items[lane].Item, batch, lane, lanes);
    results[lane] = { converged, evaluations };
  }
}
}
