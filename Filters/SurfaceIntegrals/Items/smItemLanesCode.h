/**
 * @file smItemLanesCode.h
 * @brief The shader chunks of glsl/ compiled for SM_LANES items side by side; included by smItemLanes<SM_LANES>.cxx only
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

#define SM_INTEGRANDS this->Items.NumberOfTerms
#define SM_ROUNDINGS this->Items.NumberOfMagnitudes
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
    , smValues(reinterpret_cast<Number*>(items.Values))
    , smRoundings(reinterpret_cast<Number*>(items.Roundings))
  {
  }

  unsigned int Integrate()
  {
    const smWorkRecord work = { { 0u, 0u, 0u, 0u },
      { this->Items.Detail[0], this->Items.Detail[1], this->Items.Detail[2], this->Items.Detail[3] },
      this->LoadVector(this->Items.Range) };
    smClear();
    if constexpr (DegreeS == 0)
    {
      if (this->Items.Kind == ItemKind::Ribbon)
      {
        dvec3 gaps;
        const unsigned int evaluations = smIntegrateRibbon(work, gaps);
        auto* stored = reinterpret_cast<Number*>(this->Items.Gaps);
        stored[0] = gaps.x;
        stored[1] = gaps.y;
        stored[2] = gaps.z;
        return evaluations;
      }
      if (this->Items.Kind == ItemKind::Cap)
      {
        smIntegrateCap(work);
        return 0u;
      }
    }
    return smIntegratePanel(work);
  }

private:
  static constexpr int RowSize = DegreeS > 0 ? DegreeS + 1 : MaximumDegree + 1;
  static constexpr int BasisSize = DegreeS > 0 ? (DegreeS > DegreeR ? DegreeS : DegreeR) : MaximumDegree;

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

  static Number Load(const double* lanes, unsigned int entry)
  {
    Number number;
    __builtin_memcpy(&number, lanes + SM_LANES * entry, sizeof(Number));
    return number;
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

  /// Multiplies the factors from left to right, as in the shaders' generated text; a multiplication by 1 is exact.
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
        smValues[k] += weight * product;
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
      smRoundings[k] += noise * product;
    }
  }

  const ItemLanes& Items;
  Number* const smValues;
  Number* const smRoundings;
  /// Above all indices of rules.
  static constexpr unsigned int smPlacementOffset = 0x10000u;
  static constexpr int smGapSteps = FootPointSteps;
};

template <int DegreeS, int DegreeR>
unsigned int Integrate(const ItemLanes& items)
{
  return LaneKernel<NumberOf<SM_LANES>::Type, DegreeS, DegreeR>(items).Integrate();
}

/// The common degrees of panels are compiled with constants.
unsigned int IntegrateAnyDegree(const ItemLanes& items)
{
  switch (items.Kind == ItemKind::Panel ? 100 * items.Degree[0] + items.Degree[1] : 0)
  {
    case 101:
      return Integrate<1, 1>(items);
    case 102:
      return Integrate<1, 2>(items);
    case 202:
      return Integrate<2, 2>(items);
    case 303:
      return Integrate<3, 3>(items);
    default:
      return Integrate<0, 0>(items);
  }
}
}
}
