/**
 * @file smOCCTSphereAxes.h
 * @brief Chooses the poles of a sphere so that the loops of its face avoid them
 */
#ifndef smOCCTSphereAxes_h
#define smOCCTSphereAxes_h

#include "smOCCTLoop.h"

#include <Geom_SphericalSurface.hxx>
#include <gp_Dir.hxx>

#include <vector>

namespace sm
{
/// Returns the same sphere with another axis.
Handle(Geom_Surface) TurnSphere(const Handle(Geom_SphericalSurface) & sphere, const gp_Dir& axis);

/// Returns true if the largest loop runs clockwise or encloses nothing, as a seam does that ends at no pole:
/// the loops do not bound the face from outside.
bool HasOnlyHoles(const DraftFace& face);

/// Returns axes to try for a sphere: through the ends of its seam, those of its loops, which make a circle a
/// line of constant parameter, then fixed ones.
std::vector<gp_Dir> ListSphereAxes(const DraftFace& face, const Handle(Geom_SphericalSurface) & sphere);
}

#endif
