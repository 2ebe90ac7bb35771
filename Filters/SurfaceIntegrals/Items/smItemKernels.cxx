#include "smItemKernels.h"

#include "smNURBSSurface.h"

#include "smPortableCxx.h"

#include <algorithm>
#include <cassert>

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
#define SM_INTEGRANDS this->smIntegrandsHere
#define SM_ROUNDINGS this->smRoundingsHere
#define SM_PLACEMENT this->smIsPlaced
#define SM_MIN_ERROR_SHARE 1e-3
#define SM_PERTURBATION this->smPerturbation
#define SM_SAMPLE_DETAIL 0
#define SM_STRIP_POINTS this->smStripPoints
#define SM_DEGREE_S (DegreeS > 0 ? DegreeS : static_cast<int>(patchRecord.shape.y))
#define SM_DEGREE_R (DegreeR > 0 ? DegreeR : static_cast<int>(patchRecord.shape.z))
#define SM_BASIS_SIZE BasisSize
#define SM_ROW_SIZE RowSize

/// The shader chunks and the functions they need, for patches of the given degrees (0: any).
template <int DegreeS, int DegreeR>
class Kernel
{
public:
  Kernel(const KernelData& data, const FacePanels& face, KernelScratch& scratch)
    : Data(data)
    , Face(face)
    , smValues(scratch.GetValues())
    , smResults(scratch.GetResults())
    , smRoundings(scratch.GetRoundings())
    , smNoises(scratch.GetNoises())
    , smRoundingOf(data.Layout->GetRoundingOf().data())
    , smIntegrandsHere(data.Layout->GetNumberOfIntegrands())
    , smRoundingsHere(data.Layout->GetNumberOfRoundings())
    , smIsPlaced(data.Setup->UsePlacements)
    , smPerturbation(data.Setup->Perturbation)
    , smStripPoints(data.Setup->StripPoints)
    , smIntegrandCount(smIntegrandsHere)
    , smRoundingCount(smRoundingsHere)
    , smToleranceOffset(data.ToleranceOffset)
    , smPlacementOffset(data.PlacementOffset)
    , smErrorColumn(data.Layout->GetError(0))
    , smRoundingColumn(data.Layout->GetFirstRounding())
    , smDifferenceColumn(data.Layout->GetDifference(0))
    , smStride(data.Layout->GetStride())
  {
  }

  KernelResult EvaluatePanel(const WorkRecord& record)
  {
    const smWorkRecord work = Convert(record);
    smClear();
    this->Result.Evaluations = smIntegratePanel(work);
    smFinish(0u, work);
    return this->Result;
  }

  KernelResult EvaluateRibbon(const WorkRecord& record)
  {
    const smWorkRecord work = Convert(record);
    smClear();
    dvec3 gaps;
    this->Result.Evaluations = smIntegrateRibbon(work, gaps);
    const bool kept = smFinish(0u, work);
    smStoreGaps(work, kept, gaps);
    return this->Result;
  }

  KernelResult EvaluateCap(const WorkRecord& record)
  {
    const smWorkRecord work = Convert(record);
    smClear();
    smIntegrateCap(work);
    smFinish(0u, work);
    return this->Result;
  }

private:
  static constexpr int RowSize = DegreeS > 0 ? DegreeS + 1 : MaximumDegree + 1;
  static constexpr int BasisSize = DegreeS > 0 ? (DegreeS > DegreeR ? DegreeS : DegreeR) : MaximumDegree;

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

  static smWorkRecord Convert(const WorkRecord& record)
  {
    const std::uint32_t* i = record.Item;
    const std::uint32_t* d = record.Detail;
    const double* r = record.Range;
    return { uvec4(i[0], i[1], i[2], i[3]), uvec4(d[0], d[1], d[2], d[3]), dvec4(r[0], r[1], r[2], r[3]) };
  }

  double smCoefficient(uint index) const
  {
    return this->Face.Coefficients[index];
  }

  dvec4 smControlPoint(uint index) const
  {
    const std::array<double, 4>& p = this->Face.Points[index];
    return dvec4(p[0], p[1], p[2], p[3]);
  }

  smPatchRecord smGetPatch(uint index) const
  {
    const Patch& patch = this->Face.Patches[index];
    return { dvec4(patch.Center[0], patch.Center[1], patch.Center[2], patch.Radius),
      dvec4(patch.Start[0], patch.Start[1], patch.Width[0], patch.Width[1]),
      uvec4(patch.FirstPoint, patch.Degree[0], patch.Degree[1], patch.Exchanged ? 1u : 0u),
      dvec2(patch.Stretch[0], patch.Stretch[1]) };
  }

  double smCap(uint index) const
  {
    const Cap& cap = this->Face.Caps[index / 9u];
    const std::array<double, 3>* points[3] = { &cap.Apex, &cap.From, &cap.To };
    return (*points[index % 9u / 3u])[index % 3u];
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
    this->Result.Converged = converged;
  }

  void smAccumulateFace(double weight, double noise, const dvec3& position, const dvec3& normal)
  {
    this->Accumulate(weight, noise, position, normal, false);
  }
  void smAccumulateChain(double weight, double noise, const dvec3& position, const dvec3& normal)
  {
    this->Accumulate(weight, noise, position, normal, true);
  }

  /// Multiplies the factors from left to right, as in the shaders' generated text; a multiplication by 1 is exact.
  void Accumulate(double weight, double noise, const dvec3& position, const dvec3& normal, bool chainOnly)
  {
    const SampleFormulas& formulas = *this->Data.Formulas;
    const double bases[5] = { dot(position, normal), length(normal), normal.x, normal.y, normal.z };
    const double coordinates[4] = { position.x, position.y, position.z, 1.0 };
    double* value = this->smValues;
    for (const SampleFormulas::Term& term : formulas.Terms)
    {
      if (!chainOnly || term.ClosedChain)
      {
        double product = term.Factor * bases[term.Base] * coordinates[term.First] * coordinates[term.Second];
        for (int i = term.MoreBegin; i < term.MoreEnd; ++i)
        {
          product *= coordinates[formulas.More[i]];
        }
        *value += weight * product;
      }
      ++value;
    }
    const double size = length(position);
    double* rounding = this->smRoundings;
    for (const SampleFormulas::Magnitude& magnitude : formulas.Magnitudes)
    {
      double product = magnitude.Factor;
      for (int i = 0; i < magnitude.Power; ++i)
      {
        product *= size;
      }
      *rounding++ += noise * product;
    }
  }

  const KernelData& Data;
  const FacePanels& Face;
  KernelResult Result;

  double* const smValues;
  double* const smResults;
  double* const smRoundings;
  double* const smNoises;
  const int* const smRoundingOf;
  const int smIntegrandsHere;
  const int smRoundingsHere;
  const bool smIsPlaced;
  const double smPerturbation;
  const int smStripPoints;
  const uint smIntegrandCount;
  const uint smRoundingCount;
  const uint smToleranceOffset;
  const uint smPlacementOffset;
  static constexpr uint smValueColumn = RowLayout::FirstValue;
  const uint smErrorColumn;
  const uint smRoundingColumn;
  const uint smDifferenceColumn;
  const uint smStride;
  static constexpr int smGapSteps = FootPointSteps;
};

template <int DegreeS, int DegreeR>
KernelResult EvaluatePanelOf(
  const KernelData& data, const FacePanels& face, const WorkItem& item, KernelScratch& scratch)
{
  return Kernel<DegreeS, DegreeR>(data, face, scratch).EvaluatePanel(item.Work);
}

KernelResult EvaluatePanel(
  const KernelData& data, const FacePanels& face, const WorkItem& item, KernelScratch& scratch)
{
  // The common degrees are compiled with constants.
  switch (100 * item.Degree[0] + item.Degree[1])
  {
    case 101:
      return EvaluatePanelOf<1, 1>(data, face, item, scratch);
    case 102:
      return EvaluatePanelOf<1, 2>(data, face, item, scratch);
    case 202:
      return EvaluatePanelOf<2, 2>(data, face, item, scratch);
    case 303:
      return EvaluatePanelOf<3, 3>(data, face, item, scratch);
    default:
      return EvaluatePanelOf<0, 0>(data, face, item, scratch);
  }
}
}

KernelResult EvaluateItem(
  const KernelData& data, const FacePanels& face, const WorkItem& item, KernelScratch& scratch)
{
  switch (item.Kind)
  {
    case ItemKind::Panel:
      return EvaluatePanel(data, face, item, scratch);
    case ItemKind::Ribbon:
      return Kernel<0, 0>(data, face, scratch).EvaluateRibbon(item.Work);
    default:
      return Kernel<0, 0>(data, face, scratch).EvaluateCap(item.Work);
  }
}
}
