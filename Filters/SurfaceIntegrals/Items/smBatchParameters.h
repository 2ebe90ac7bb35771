/**
 * @file smBatchParameters.h
 * @brief Constants that the items of a batch read: Gauss rules, tolerances, placements
 */
#ifndef smBatchParameters_h
#define smBatchParameters_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smItemRunner.h"

#include <cstdint>
#include <vector>

namespace sm
{
/// Constants in the layout of smParameters in glsl/smWorkStorage.glsl.
struct SMFILTERSSURFACEINTEGRALS_EXPORT BatchParameters
{
  std::vector<double> Values;
  std::uint32_t ToleranceOffset = 0;
  std::uint32_t PlacementOffset = 0;

  BatchParameters() = default;
  BatchParameters(const std::vector<ItemRunner::BatchFace>& faces, bool usePlacements);
};
}

#endif
