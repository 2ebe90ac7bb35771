/**
 * @file smItemKernels.h
 * @brief The chunks of glsl/ compiled as C++: evaluates one item of integration
 */
#ifndef smItemKernels_h
#define smItemKernels_h

#include "smFacePanelsCache.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smItemRunner.h"

#include <cstdint>
#include <vector>

namespace sm
{
/// The formulas of a list of integrands (none of them a User's), flat, as a sample needs them.
class SMFILTERSSURFACEINTEGRALS_EXPORT SampleFormulas
{
public:
  SampleFormulas() = default;
  SampleFormulas(const std::vector<Integrand>& integrands, const RowLayout& layout);

  struct Term
  {
    /// Into flux, area element, normal x, y, z.
    int Base;
    double Factor;
    /// Two coordinates that multiply it, 3 stands for 1; and the others of higher degrees, in More.
    int First, Second;
    int MoreBegin, MoreEnd;
    bool ClosedChain;
  };
  struct Magnitude
  {
    double Factor;
    int Power;
  };
  std::vector<Term> Terms;
  std::vector<int> More;
  std::vector<Magnitude> Magnitudes;
};

/// What all items of a batch read and write. Items of different rows may be evaluated by different threads.
struct KernelData
{
  const ItemRunner::Setup* Setup = nullptr;
  const RowLayout* Layout = nullptr;
  const SampleFormulas* Formulas = nullptr;
  /// See BatchParameters.
  const double* Parameters = nullptr;
  std::uint32_t ToleranceOffset = 0;
  std::uint32_t PlacementOffset = 0;
  /// Layout->GetStride() doubles a row.
  double* Rows = nullptr;
};

struct KernelResult
{
  bool Converged = true;
  std::uint32_t Evaluations = 0;
};

/// Sums of one item at a time; every thread has its own.
class KernelScratch
{
public:
  explicit KernelScratch(const RowLayout& layout)
    : Integrands(layout.GetNumberOfIntegrands())
    , Roundings(layout.GetNumberOfRoundings())
    , Values(2 * (this->Integrands + this->Roundings))
  {
  }
  double* GetValues() { return this->Values.data(); }
  double* GetResults() { return this->Values.data() + this->Integrands; }
  double* GetRoundings() { return this->Values.data() + 2 * this->Integrands; }
  double* GetNoises() { return this->Values.data() + 2 * this->Integrands + this->Roundings; }

private:
  int Integrands;
  int Roundings;
  std::vector<double> Values;
};

/// Evaluates the item as glsl/sm{Panel,Ribbon,Cap}CS.glsl does and writes its row.
SMFILTERSSURFACEINTEGRALS_EXPORT KernelResult EvaluateItem(
  const KernelData& data, const FacePanels& face, const WorkItem& item, KernelScratch& scratch);
}

#endif
