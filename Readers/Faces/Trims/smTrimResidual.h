/**
 * @file smTrimResidual.h
 * @brief How far a trim curve is from its edge in the parameters of the surface
 */
#ifndef smTrimResidual_h
#define smTrimResidual_h

#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"
#include "smReadersFacesModule.h"

namespace sm
{
/// Returns a bound of the area of the parameters between a trim curve and the curve from which it differs by
/// its residual.
SMREADERSFACES_EXPORT double GetSweptArea(const TrimCurve& curve);

/// Replaces the residual of a trim curve, from the foot points, by the measured distance from its edge, where
/// the area between the two is less: a line may be nearer to the edge than the foot points.
SMREADERSFACES_EXPORT void LowerResidual(const NURBSSurface& surface, const EdgeCurve& edge, TrimCurve& trim);
}

#endif
