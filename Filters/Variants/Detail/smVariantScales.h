/**
 * @file smVariantScales.h
 * @brief Reference point and scales of the moments of a model, and the chains of its faces
 */
#ifndef smVariantScales_h
#define smVariantScales_h

#include "smVariantChain.h"
#include "smVariantPolynomial.h"

#include <string>
#include <vector>

namespace sm
{
/// Returns why the options do not fit `directions`; empty if they do.
std::string FindProblem(const VariantOptions& options, int directions);

/// The middle of the model's LocalBounds, or of its control points without these, relative to its origin; and
/// scales from VolumeScale, or from the box.
VariantChainOptions MakeChainOptions(const VariantShape& shape, const VariantOptions& options);

/// Cuts and plans all faces, on the threads of vtkSMPTools. Returns false with the reason.
bool MakeChains(const VariantShape& shape, const VariantChainOptions& options,
  std::vector<VariantFaceChain>& chains, std::string& error);

/// What each direction opens.
std::vector<VariantGap> FindGaps(const std::vector<VariantFaceChain>& chains, int directions);
}

#endif
