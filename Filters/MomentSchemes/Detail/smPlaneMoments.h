/**
 * @file smPlaneMoments.h
 * @brief The paper's integrals over a planar face, by triangles of its trim polygon
 */
#ifndef smPlaneMoments_h
#define smPlaneMoments_h

#include "smFiltersMomentSchemesModule.h"

#include "smSubPatches.h"

#include <array>

namespace sm
{
/**
 * Integrals of the flux along z (Eq. 16-28), with n the outward normal du dv and coordinates as stored
 * (relative to the model's origin): V = z nz; X = x z nz; Y = y z nz; Z = z^2/2 nz; XX = x^2 z nz; YY = y^2 z
 * nz; ZZ = z^3/3 nz; XY = x y z nz; YZ = y z^2/2 nz; XZ = x z^2/2 nz; then the vector area nx, ny, nz and the
 * area |n|. In this order, that of MassIntegrand.
 *
 * The result is exact up to rounding for the face bounded by `Polygons`: every edge of a polygon makes one
 * signed triangle with a fixed point, so that holes and loops of either orientation contribute with the
 * correct sign. Reversed changes the sign of n, and not the area.
 *
 * Requires that `face.Planar` is true and `face.Error` is empty; otherwise all results are 0. Thread safe.
 */
SMFILTERSMOMENTSCHEMES_EXPORT std::array<double, 14> ComputePlaneMoments(const SubPatchFace& face);
}

#endif
