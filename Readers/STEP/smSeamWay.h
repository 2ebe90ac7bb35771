/**
 * @file smSeamWay.h
 * @brief A way through the parameters of a periodic face for a seam that crosses none of its loops
 */
#ifndef smSeamWay_h
#define smSeamWay_h

#include "smOCCTLoop.h"

#include <array>
#include <vector>

namespace sm
{
/// Corners of a way from a to b, across the periodic `direction`, on which no loop is crossed, whatever its period: the straight one, or
/// one round a hole. Empty when there is none.
std::vector<std::array<double, 2>> FindSeamWay(const DraftFace& face, const std::array<double, 2>& a,
  const std::array<double, 2>& b, int direction, bool isStraight);
}

#endif
