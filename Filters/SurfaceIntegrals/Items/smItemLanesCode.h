/**
 * @file smItemLanesCode.h
 * @brief The shader chunks of glsl/ compiled for SM_LANES items side by side; included by
 * smItemLanes<SM_LANES>.cxx only
 *
 * Nothing here may leave the file that is compiled for an instruction set: see smPortableLanes.h.
 */
#include "smItemLanes.h"

#include "smPortableLanes.h"

namespace sm
{
namespace
{
template <int Count>
struct NumberOf
{
  using Type = Lanes<Count>;
};
template <>
struct NumberOf<1>
{
  using Type = double;
};

#define SM_PLACEMENT this->Items.UsePlacements
#define SM_PERTURBATION this->Items.Perturbation
#define SM_SAMPLE_DETAIL 0
#define SM_STRIP_POINTS this->Items.StripPoints
#define SM_DEGREE_S (DegreeS > 0 ? DegreeS : static_cast<int>(patchRecord.shape.y))
#define SM_DEGREE_R (DegreeR > 0 ? DegreeR : static_cast<int>(patchRecord.shape.z))
#define SM_BASIS_SIZE BasisSize
#define SM_ROW_SIZE RowSize

/// The shader chunks and the functions they need, for patches of the given degrees (0: any).
template <class Number, int DegreeS, int DegreeR>
class LaneKernel
{
public:
  explicit LaneKernel(const ItemLanes& items)
    : Items(items)
    , Values(reinterpret_cast<Number*>(items.Values))
    , Roundings(reinterpret_cast<Number*>(items.Roundings))
  {
  }

  // Everything is compiled into these: vectors as arguments of functions would go through memory.
  __attribute__((flatten)) unsigned int IntegratePanel()
  {
    this->Clear();
    const smWorkRecord work = this->MakeWork();
    return smIntegratePanel(work, 0, smGetNodes(work));
  }
  __attribute__((flatten)) unsigned int IntegrateRibbon()
  {
    dvec3 gaps;
    this->Clear();
    const smWorkRecord work = this->MakeWork();
    const unsigned int evaluations = smIntegrateRibbon(work, 0, smGetNodes(work), gaps);
    auto* stored = reinterpret_cast<Number*>(this->Items.Gaps);
    stored[0] = gaps.x;
    stored[1] = gaps.y;
    stored[2] = gaps.z;
    return evaluations;
  }
  __attribute__((flatten)) unsigned int IntegrateCap()
  {
    this->Clear();
    smIntegrateCap(this->MakeWork(), 0, SM_STRIP_POINTS);
    return 0u;
  }

private:
  static constexpr int RowSize = DegreeS > 0 ? DegreeS + 1 : MaximumDegree + 1;
  static constexpr int BasisSize = DegreeS > 0 && DegreeR > 0 ? (DegreeS > DegreeR ? DegreeS : DegreeR)
                                                              : MaximumDegree;

  using dvec2 = LaneVector2<Number>;
  using dvec3 = LaneVector3<Number>;
  using dvec4 = LaneVector4<Number>;
  using uvec4 = LaneIndices;
#define double Number
// The types are included first.
#include "glsl/smPatchRecord.glsl"
#include "glsl/smWorkRecord.glsl"

#include "glsl/smErrorFree.glsl"

#include "glsl/smBernstein.glsl"
#include "glsl/smCap.glsl"
#include "glsl/smPanel.glsl"
#include "glsl/smPatch.glsl"
#include "glsl/smRibbon.glsl"
#include "glsl/smWork.glsl"
#undef double

  void Clear()
  {
    for (int k = 0; k < this->Items.NumberOfTerms; ++k)
    {
      this->Values[k] = Number(0.0);
    }
    for (int k = 0; k < this->Items.NumberOfMagnitudes; ++k)
    {
      this->Roundings[k] = Number(0.0);
    }
  }
  static Number Load(const double* lanes, unsigned int entry)
  {
    Number number;
    __builtin_memcpy(&number, lanes + SM_LANES * entry, sizeof(Number));
    return number;
  }
  smWorkRecord MakeWork() const
  {
    const unsigned int* detail = this->Items.Detail;
    return { { 0u, 0u, 0u, 0u }, { detail[0], detail[1], detail[2], detail[3] },
      LoadVector(this->Items.Range) };
  }
  static dvec4 LoadVector(const double* lanes, unsigned int vector = 0)
  {
    return { Load(lanes, 4 * vector), Load(lanes, 4 * vector + 1), Load(lanes, 4 * vector + 2),
      Load(lanes, 4 * vector + 3) };
  }
  Number smCoefficient(unsigned int index) const
  {
    return Load(this->Items.Coefficients, index);
  }
  Number smCap(unsigned int index) const
  {
    return Load(this->Items.Coefficients, index);
  }
  dvec4 smControlPoint(unsigned int index) const
  {
    return LoadVector(this->Items.Points, index);
  }
  smPatchRecord smGetPatch(unsigned int) const
  {
    const double* patch = this->Items.Patch;
    return { LoadVector(patch), LoadVector(patch, 1), { 0u, this->Items.Shape[0], this->Items.Shape[1], 0u },
      { Load(patch, 8), Load(patch, 9) } };
  }
  Number smParameter(unsigned int at) const
  {
    return at < smPlacementOffset ? Number(this->Items.Rules[at])
                                  : Load(this->Items.Placement, at - smPlacementOffset);
  }
  void smAccumulateFace(const Number& weight, const Number& noise, const dvec3& position, const dvec3& normal)
  {
    this->Accumulate(weight, noise, position, normal, false);
  }
  void smAccumulateChain(
    const Number& weight, const Number& noise, const dvec3& position, const dvec3& normal)
  {
    this->Accumulate(weight, noise, position, normal, true);
  }

  /// Multiplies the factors from left to right, as in the shaders' generated text; a multiplication by 1 is
  /// exact.
  void Accumulate(
    const Number& weight, const Number& noise, const dvec3& position, const dvec3& normal, bool chainOnly)
  {
    const Number bases[5] = { dot(position, normal), length(normal), normal.x, normal.y, normal.z };
    const Number coordinates[4] = { position.x, position.y, position.z, Number(1.0) };
    for (int k = 0; k < this->Items.NumberOfTerms; ++k)
    {
      const SampleFormulas::Term& term = this->Items.Terms[k];
      if (!chainOnly || term.ClosedChain)
      {
        Number product = term.Factor * bases[term.Base] * coordinates[term.First] * coordinates[term.Second];
        for (int i = term.MoreBegin; i < term.MoreEnd; ++i)
        {
          product *= coordinates[this->Items.More[i]];
        }
        this->Values[k] += weight * product;
      }
    }
    const Number size = length(position);
    for (int k = 0; k < this->Items.NumberOfMagnitudes; ++k)
    {
      Number product(this->Items.Magnitudes[k].Factor);
      for (int i = 0; i < this->Items.Magnitudes[k].Power; ++i)
      {
        product *= size;
      }
      this->Roundings[k] += noise * product;
    }
  }

  const ItemLanes& Items;
  Number* const Values;
  Number* const Roundings;
  /// Above all indices of rules.
  static constexpr unsigned int smPlacementOffset = 0x10000u;
  static constexpr int smGapSteps = FootPointSteps;
};

template <int DegreeS, int DegreeR>
using Kernel = LaneKernel<NumberOf<SM_LANES>::Type, DegreeS, DegreeR>;

/// Error-free sums of Numbers.
template <class Number>
struct LaneSums
{
  using dvec2 = LaneVector2<Number>;
#define double Number
#include "glsl/smErrorFree.glsl"
#undef double

  /// Adds up as many columns as a Number holds.
  static void SumColumns(const double* rows, std::size_t count, std::size_t stride, double* sums)
  {
    Number sum(0.0);
    Number error(0.0);
    for (std::size_t row = 0; row < count; ++row)
    {
      Number value;
      __builtin_memcpy(&value, rows + row * stride, sizeof(Number));
      const dvec2 next = LaneSums().smTwoSum(sum, value);
      sum = next.x;
      error += next.y;
    }
    // The accumulated errors of an infinite sum are NaN.
    sum += SelectLanes(abs(sum) < Number(__builtin_inf()), error, Number(0.0));
    __builtin_memcpy(sums, &sum, sizeof(Number));
  }
};

#if SM_LANES > 1
/// Transposes a square of Numbers: in halves, quarters and so on, as it takes the fewest moves.
inline void Transpose(NumberOf<SM_LANES>::Type::Vector (&rows)[SM_LANES])
{
  using Vector = NumberOf<SM_LANES>::Type::Vector;
  using Indices = NumberOf<SM_LANES>::Type::Mask;
  // Unrolled, the indices are constants.
#pragma GCC unroll 4
  for (int half = SM_LANES / 2; half > 0; half /= 2)
  {
    Indices low{};
    Indices high{};
#pragma GCC unroll 8
    for (int i = 0; i < SM_LANES; ++i)
    {
      low[i] = (i & half) == 0 ? i : SM_LANES + i - half;
      high[i] = (i & half) == 0 ? i + half : SM_LANES + i;
    }
#pragma GCC unroll 8
    for (int i = 0; i < SM_LANES; ++i)
    {
      if ((i & half) == 0)
      {
        const Vector first = rows[i];
        const Vector second = rows[i + half];
        rows[i] = __builtin_shuffle(first, second, low);
        rows[i + half] = __builtin_shuffle(first, second, high);
      }
    }
  }
}

/// Entry i of array l goes to i * SM_LANES + l. The size is a multiple of SM_LANES.
inline void InterleaveInLanes(const double* const* from, std::size_t size, double* to)
{
  using Vector = NumberOf<SM_LANES>::Type::Vector;
  for (std::size_t i = 0; i < size; i += SM_LANES)
  {
    Vector rows[SM_LANES];
#pragma GCC unroll 8
    for (int lane = 0; lane < SM_LANES; ++lane)
    {
      __builtin_memcpy(&rows[lane], from[lane] + i, sizeof(Vector));
    }
    Transpose(rows);
    __builtin_memcpy(to + i * SM_LANES, rows, sizeof(rows));
  }
}
#endif

inline void SumRowsInLanes(const double* rows, std::size_t count, int stride, double* sums)
{
  int column = 0;
  for (; column + SM_LANES <= stride; column += SM_LANES)
  {
    LaneSums<NumberOf<SM_LANES>::Type>::SumColumns(rows + column, count, stride, sums + column);
  }
  for (; column < stride; ++column)
  {
    LaneSums<double>::SumColumns(rows + column, count, stride, sums + column);
  }
}

/// The common degrees are compiled with constants, others up to 6 with that of the inner direction, in which
/// most of the work is done.
unsigned int IntegratePanels(const ItemLanes& items)
{
  switch (100 * items.Degree[0] + items.Degree[1])
  {
    case 101:
      return Kernel<1, 1>(items).IntegratePanel();
    case 102:
      return Kernel<1, 2>(items).IntegratePanel();
    case 202:
      return Kernel<2, 2>(items).IntegratePanel();
    case 303:
      return Kernel<3, 3>(items).IntegratePanel();
  }
  switch (items.Degree[0])
  {
    case 1:
      return Kernel<1, 0>(items).IntegratePanel();
    case 2:
      return Kernel<2, 0>(items).IntegratePanel();
    case 3:
      return Kernel<3, 0>(items).IntegratePanel();
    case 4:
      return Kernel<4, 0>(items).IntegratePanel();
    case 5:
      return Kernel<5, 0>(items).IntegratePanel();
    case 6:
      return Kernel<6, 0>(items).IntegratePanel();
    default:
      return Kernel<0, 0>(items).IntegratePanel();
  }
}

unsigned int IntegrateRibbons(const ItemLanes& items)
{
  switch (items.Degree[0])
  {
    case 1:
      return Kernel<1, 0>(items).IntegrateRibbon();
    case 2:
      return Kernel<2, 0>(items).IntegrateRibbon();
    case 3:
      return Kernel<3, 0>(items).IntegrateRibbon();
    default:
      return Kernel<0, 0>(items).IntegrateRibbon();
  }
}

unsigned int IntegrateAnyDegree(const ItemLanes& items)
{
  return items.Kind == ItemKind::Panel ? IntegratePanels(items)
    : items.Kind == ItemKind::Ribbon   ? IntegrateRibbons(items)
                                       : Kernel<0, 0>(items).IntegrateCap();
}
}
}
