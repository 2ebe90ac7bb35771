/**
 * @file smPatchParts.h
 * @brief Parts of a rational Bézier patch as patches of their own
 */
#ifndef smPatchParts_h
#define smPatchParts_h

#include "smFiltersNURBSModule.h"

#include "smFacePanels.h"

#include <array>
#include <cstdint>

namespace sm
{
/**
 * Appends to `to` the part [low, high] (in the parameters of `from`'s trim pieces) of a patch of `from` as a
 * patch of its own, and returns its index. `exchange`: with s and r exchanged, so that its Ss x Sr points the
 * other way, and pieces of it have their coordinates exchanged. Displacement grows by the rounding bound.
 */
SMFILTERSNURBS_EXPORT std::uint32_t AppendPatchPart(const FacePanels& from, std::uint32_t patch,
  const std::array<double, 2>& low, const std::array<double, 2>& high, bool exchange, FacePanels& to);
}

#endif
