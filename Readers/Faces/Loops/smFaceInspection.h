/**
 * @file smFaceInspection.h
 * @brief Inspects if a face can be converted without a repair
 */
#ifndef smFaceInspection_h
#define smFaceInspection_h

#include "smDraftFace.h"

#include <string>

namespace sm
{
struct FaceInspection
{
  /// The reason why the face needs a repair; empty if it does not.
  std::string Problem;
  /// Signed volume of the cone from the origin over the face with forward orientation, to a few per cent.
  double ConeVolume = 0.0;
  /// True if the face is the part of a closed surface outside its loops.
  bool Outside = false;
};

/**
 * Calls ReverseEdges() and CompleteLoops() and then checks the loops together. A loop with gaps up to
 * `tolerance` in space is closed. Edges may be `tolerance` away from the surface, and up to `largestGap` away
 * from it or beyond its border unless the face is small compared with that: ribbons close such gaps, and the
 * integrals report them. If all loops are holes in a closed surface, its natural boundary is added
 * (smNaturalBoundary.h).
 */
SMREADERSFACES_EXPORT FaceInspection InspectFace(
  DraftFace& face, const Vector3& origin, double tolerance, double largestGap);
}

#endif
