/**
 * @file smVariantScales.h
 * @brief Reference point and scales of the moments of a model, and the chains of its faces
 */
#ifndef smVariantScales_h
#define smVariantScales_h

#include "smProgressCallback.h"
#include "smVariantChain.h"
#include "smVariantPolynomial.h"

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
/// Returns why the options do not fit `directions`; empty if they do.
std::string FindProblem(const VariantOptions& options, int directions);

/// The middle of the model's LocalBounds, or of its control points without these, relative to its origin; and
/// scales from VolumeScale, or from the box.
VariantChainOptions MakeChainOptions(const VariantShape& shape, const VariantOptions& options);

/// Cuts and plans all faces, on the threads of vtkSMPTools. Returns false with the reason, which is
/// StoppedReason if `progress` returned false.
bool MakeChains(const VariantShape& shape, const VariantChainOptions& options,
  const ProgressCallback& progress, std::vector<VariantFaceChain>& chains, std::string& error);
constexpr const char* StoppedReason = "stopped before the variants were prepared: nothing can be evaluated";

/// The share of `progress` in [first, last]; empty if it is.
ProgressCallback GetPartOf(const ProgressCallback& progress, double first, double last);

/// The reason for an exception while variants are prepared, with the remedy.
std::string ExplainFailure(const std::exception_ptr& failure);

/// Sets the results of each of the n variants c[n][directions] that has a number which is not finite to NaN.
/// `results` are arrays of so many numbers for each variant, or null.
void HideNotFinite(const double* c, std::size_t directions, std::size_t n,
  const std::vector<std::pair<double*, std::size_t>>& results);

/// What each direction opens.
std::vector<VariantGap> FindGaps(const std::vector<VariantFaceChain>& chains, int directions);
}

#endif
