/**
 * @file smSubmergedStrips.h
 * @brief Ribbons and caps of the part of a face below a plane, see smSubmergedFace.h
 */
#ifndef smSubmergedStrips_h
#define smSubmergedStrips_h

#include "smFacePanels.h"
#include "smHeightNet.h"
#include "smSubmergedFace.h"

namespace sm
{
/// Appends the ribbons and caps below the plane to `to`. Strips between a curve of the face and a curve of
/// the edge on opposite sides of the plane are omitted. Returns bounds of the integrals over all regions that
/// were omitted or included wrongly; the residuals of the face's trim curves and of its edges count as
/// displacements of its strips.
CutErrors CutStripsBelow(const Face& face, const FacePanels& from, const HeightPlane& plane,
  const CutLimits& limits, FacePanels& to);

/// Returns a bound of how far the residuals of trim and edge curves may move a point of the face's border.
double GetBorderResidual(const Face& face, const FacePanels& panels);

/// Returns an upper bound of the area of a face's ribbons and caps; computed once for a face. Thread safe.
double GetStripArea(const CutFace& face);
}

#endif
