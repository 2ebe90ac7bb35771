/**
 * @file smChainExtent.h
 * @brief Bounds of the extent and area of the closed chain of a cut face: patches, ribbons and caps
 */
#ifndef smChainExtent_h
#define smChainExtent_h

#include "smFacePanels.h"
#include "smSubmergedFace.h"

#include <array>

namespace sm
{
/// Returns the radius of a ball about `center` that contains the chain.
double GetReach(const FacePanels& panels, const std::array<double, 3>& center);

/// Returns an upper bound of the area of the chain; `stripArea` is that of its strips.
double GetMaxArea(const FacePanels& panels, double stripArea);

/// Returns false if all of the chain is further from the plane than the distance.
bool MayTouch(const FacePanels& panels, const HeightPlane& plane, double distance);
}

#endif
