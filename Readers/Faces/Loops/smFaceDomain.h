/**
 * @file smFaceDomain.h
 * @brief The part of a surface on which a face lies, where its formula repeats or it reaches its axis
 */
#ifndef smFaceDomain_h
#define smFaceDomain_h

#include "smDraftFace.h"

namespace sm
{
/**
 * Sets Surface, Period, FormulaPeriod, Low and High of a face whose Source and Location are set.
 *
 * The formula of a surface may repeat where the surface itself is not periodic: a sphere's in v after 360
 * degrees, that of a swept surface with the parameter of its trimmed conic. These directions get a
 * FormulaPeriod.
 *
 * A surface that is swept along a curve that was trimmed to a whole period is replaced by the one along the
 * curve itself, which is periodic.
 *
 * A surface of revolution whose profile meets its axis has poles there, as a sphere has. It is replaced by
 * the part between two poles (or a pole and the end of the profile) on which the edges of the face lie. If a
 * face without edges has several different parts, such as the outer and the inner part of a circle that is
 * revolved about a chord, then its HasSeveralParts is set.
 */
void FindFaceDomain(DraftFace& face);

/**
 * Moves a trim curve by whole periods of the formula into the domain; on a surface that is symmetric to a
 * pole also to its other side, which is the same curve in space. Returns false, and leaves the trim curve as
 * it is, if no move leads into the domain, or if it is not the curve of its edge.
 */
bool MoveIntoDomain(const DraftFace& face, const EdgeShape& edge, NativeTrim& trim);

/// Exchanges the part of a surface of revolution for the other one with the same points and opposite normals
/// (OtherSurface). Returns false if there is none, or if its trim curves cannot be moved there.
bool TakeOtherPart(DraftFace& face);

/// Returns true if a box of parameters leads beyond a pole of the surface by more than rounding.
bool LeavesDomain(const DraftFace& face, const NativeBox& box);
}

#endif
