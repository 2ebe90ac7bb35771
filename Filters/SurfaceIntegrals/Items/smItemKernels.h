/**
 * @file smItemKernels.h
 * @brief The shader chunks of glsl/ compiled as C++: evaluates one item of integration
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
/// The formulas of a list of integrands (without user integrands) in the flat form in which samples are evaluated.
class SMFILTERSSURFACEINTEGRALS_EXPORT SampleFormulas
{
public:
  SampleFormulas() = default;
  SampleFormulas(const std::vector<Integrand>& integrands, const RowLayout& layout);

  /// A factor times a base times coordinates.
  struct Term
  {
    /// Index of the base: flux, area element, normal x, y, z.
    int Base;
    double Factor;
    /// Indices of two coordinates that multiply the term, where 3 stands for 1; the range in More has those of higher degrees.
    int First, Second;
    int MoreBegin, MoreEnd;
    bool ClosedChain;
  };
  /// A factor times a power of the distance from the origin, which scales a rounding error.
  struct Magnitude
  {
    double Factor;
    int Power;
  };
  std::vector<Term> Terms;
  std::vector<int> More;
  std::vector<Magnitude> Magnitudes;
};

/// Data that all items of a batch read and write. Different threads may evaluate items of different rows.
struct KernelData
{
  const ItemRunner::Setup* Setup = nullptr;
  const RowLayout* Layout = nullptr;
  const SampleFormulas* Formulas = nullptr;
  /// See BatchParameters.
  const double* Parameters = nullptr;
  std::uint32_t ToleranceOffset = 0;
  std::uint32_t PlacementOffset = 0;
  /// Result rows of Layout->GetStride() doubles each.
  double* Rows = nullptr;
};

/// Result of one item.
struct KernelResult
{
  bool Converged = true;
  std::uint32_t Evaluations = 0;
};

/// Buffer for the sums of one item; every thread has its own.
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

/// Evaluates an item by the mathematics of glsl/sm{Panel,Ribbon,Cap}CS.glsl and writes its row.
SMFILTERSSURFACEINTEGRALS_EXPORT KernelResult EvaluateItem(
  const KernelData& data, const FacePanels& face, const WorkItem& item, KernelScratch& scratch);
}

#endif
