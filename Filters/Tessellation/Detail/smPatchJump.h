/**
 * @file smPatchJump.h
 * @brief Bound of the jump of a derivative between two Bézier patches
 */
#ifndef smPatchJump_h
#define smPatchJump_h

#include "smBernsteinNet.h"

namespace sm
{
/// Bound of the jump of the derivative across the common side of two nets, the second one after the first in
/// a direction; widths are those of the spans. `scale`: about the derivative.
double BoundJump(const BernsteinNet& before, const BernsteinNet& after, int direction,
  const double (&width)[2], double& scale);
}

#endif
