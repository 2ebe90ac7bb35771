/**
 * @file smOCCTFaceTrims.h
 * @brief Where the trims of a face lie in the parameters of its surface
 */
#ifndef smOCCTFaceTrims_h
#define smOCCTFaceTrims_h

#include "smFace.h"
#include "smOCCTLoop.h"
#include "smOCCTSurface.h"

#include <memory>
#include <vector>

namespace sm
{
/// Trim curve of an edge on a plane that keeps no pcurve: u and v are linear in the position. `face.Surface` is a Geom_Plane.
TrimCurve ProjectOnPlane(const DraftFace& face, const AffineMap& map, const EdgeCurve& curve);

/// Poles and seams that CompleteLoops added: their curves are what their trims draw. `map` is that of the face, `toModel` that of vertices;
/// coordinates are rounded as if they were as large as `magnitude`.
std::vector<std::shared_ptr<const Edge>> MakeAddedEdges(
  const DraftFace& face, const AffineMap& map, const AffineMap& toModel, double magnitude);

/// Native parameters that the trims cover; never empty. `projected` has a curve for every coedge, which counts where the coedge
/// is projected. Throws std::runtime_error when there are no loops and the surface is infinite.
NativeBox GetCoveredBox(const DraftFace& face, const std::vector<std::vector<TrimCurve>>& projected);

/// Lines of constant parameter that are a knot line but for rounding (1e-14 of the domain) become the knot line; what that
/// moves is added to the curve's residual. `knots` are the breaks of u and of v, ascending.
void SnapToKnots(const std::vector<double> knots[2], TrimCurve& curve);
}

#endif
