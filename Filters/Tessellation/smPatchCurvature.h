/**
 * @file smPatchCurvature.h
 * @brief Bounds of the second derivatives of a Bézier patch
 */
#ifndef smPatchCurvature_h
#define smPatchCurvature_h

#include "smPatchNet.h"

#include <array>

namespace sm
{
/// Bounds of |S_uu|, |S_uv| and |S_vv| on the net, by its own parameters. `rational`: the weights differ.
std::array<double, 3> BoundSecondDerivatives(const PatchNet& net, bool rational);
}

#endif
