/**
 * @file smSeamWay.h
 * @brief Finds a path in the parameters of a periodic face for a seam that crosses none of its loops
 */
#ifndef smSeamWay_h
#define smSeamWay_h

#include "smDraftFace.h"

#include <array>
#include <vector>

namespace sm
{
/// Returns the corners of a path from a to b, across the periodic `direction`, that crosses no loop nor its
/// copies in other periods: the straight line if `isStraight`, else one with a detour along
/// `direction`, smaller ones tried first. Empty if none is found.
std::vector<std::array<double, 2>> FindSeamWay(const DraftFace& face, const std::array<double, 2>& a,
  const std::array<double, 2>& b, int direction, bool isStraight);
}

#endif
