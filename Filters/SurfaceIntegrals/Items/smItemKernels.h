/**
 * @file smItemKernels.h
 * @brief The shader chunks of glsl/ compiled as C++: evaluates items of integration
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
/// The formulas of a list of integrands (without user integrands) in the flat form in which samples are
/// evaluated.
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
    /// Indices of two coordinates that multiply the term, where 3 stands for 1; the range in More has those
    /// of higher degrees.
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

/// Buffers for the items that are evaluated together; every thread has its own.
struct KernelScratch
{
  /// Input data of items one after another and side by side, and their sums.
  std::vector<double> Copies, Inputs, Sums;
  /// Sums of a single item.
  std::vector<double> Values, Roundings;

  explicit KernelScratch(const RowLayout& layout)
    : Values(layout.GetNumberOfIntegrands())
    , Roundings(layout.GetNumberOfRoundings())
  {
  }
};

/// An item and its face.
struct KernelItem
{
  const FacePanels* Face;
  const WorkItem* Item;
};

/// Largest number of items that are evaluated side by side.
constexpr int MaxLanes = 8;
/// Returns the numbers of items, ascending from 1, that this processor can evaluate side by side.
SMFILTERSSURFACEINTEGRALS_EXPORT const std::vector<int>& GetLaneCounts();
/// Returns a number that is equal for items which may be evaluated side by side: those of equal kind,
/// degrees, orders and signs.
SMFILTERSSURFACEINTEGRALS_EXPORT std::uint64_t GetItemShape(const KernelItem& item);

/// Evaluates `count` items of one shape, at most `lanes` of them, by the mathematics of
/// glsl/sm{Panel,Ribbon,Cap}CS.glsl, and writes their rows. A row is bitwise independent of the number of
/// lanes and of the other items.
SMFILTERSSURFACEINTEGRALS_EXPORT void EvaluateItems(const KernelData& data, const KernelItem* items,
  int count, int lanes, KernelScratch& scratch, KernelResult* results);
}

#endif
