/**
 * @file smFaceTrims.h
 * @brief Trim curves of a face in the parameters of its surface: projection, added edges, covered range
 */
#ifndef smFaceTrims_h
#define smFaceTrims_h

#include "Loops/smDraftFace.h"
#include "smFace.h"

#include <memory>
#include <vector>

namespace sm
{
/// Returns the trim curve of an edge without a pcurve on a plane, where u and v are linear in the position.
/// `face.Surface` is a plane.
TrimCurve ProjectOnPlane(const DraftFace& face, const AffineMap& map, const EdgeCurve& curve);

/// Makes the edges of poles and seams that CompleteLoops() added; their curves are the images of their trim
/// curves. `map` is for the face, `toModel` for vertices; the rounding of coordinates is that of numbers as
/// large as `magnitude`.
std::vector<std::shared_ptr<const Edge>> MakeAddedEdges(
  const DraftFace& face, const AffineMap& map, const AffineMap& toModel, double magnitude);

/// Returns the range of native parameters that the trim curves cover; never empty. `projected` has a curve
/// for every coedge, which is used if the coedge is projected. Throws std::runtime_error if there are no
/// loops and the surface is infinite.
NativeBox GetCoveredBox(const DraftFace& face, const std::vector<std::vector<TrimCurve>>& projected);

/// Moves trim curves of constant parameter that are within rounding (1e-14 of the domain) of a knot line onto
/// it; the displacement is added to the curve's residual. `knots` are the breaks of u and of v, ascending.
void SnapToKnots(const std::vector<double> knots[2], TrimCurve& curve);
}

#endif
