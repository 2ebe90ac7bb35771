/**
 * @file smSubmergedStrips.h
 * @brief The ribbons and caps of a face below a plane, see smSubmergedFace.h
 */
#ifndef smSubmergedStrips_h
#define smSubmergedStrips_h

#include "smFacePanels.h"
#include "smHeightNet.h"

namespace sm
{
/// Appends what lies below to `to`, and returns a bound of the integral of |h| |n| over what was left out or in wrongly: the
/// strips between a curve of the face below the plane and one of the edge above it, or the other way round, which are left out.
double CutStripsBelow(const FacePanels& from, const HeightPlane& plane, double tolerance, FacePanels& to);
}

#endif
