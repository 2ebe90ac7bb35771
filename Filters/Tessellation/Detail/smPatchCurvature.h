/**
 * @file smPatchCurvature.h
 * @brief Bounds of the second derivatives of a Bézier patch
 */
#ifndef smPatchCurvature_h
#define smPatchCurvature_h

#include "smBernsteinNet.h"
#include "smCurvatureBounds.h"

namespace sm
{
/// Bounds on the net, by its own parameters. `rational`: the weights differ. `normal`: a unit vector or 0.
/// `enough`: bounds that are good enough.
CurvatureBounds BoundSecondDerivatives(
  const BernsteinNet& net, bool rational, const Vector3& normal, const EnoughBound& enough);
}

#endif
