/**
 * @file smOCCTFaceInspection.h
 * @brief Inspection of a face: can it be taken as the file has it?
 */
#ifndef smOCCTFaceInspection_h
#define smOCCTFaceInspection_h

#include "smOCCTLoop.h"

#include <gp_Pnt.hxx>

#include <string>

namespace sm
{
struct FaceInspection
{
  /// Why the face should be repaired; empty when it should not.
  std::string Problem;
  /// Volume of the cone over the face from the origin, to a few percent, by the normal of the forward face.
  double ConeVolume = 0.0;
};

/**
 * CompleteLoops, and then a look at the loops together. Gaps up to `tolerance` in space leave a loop closed. Edges may lie beside the
 * surface by that, too, and beside it and beyond its border by `largestGap`, but for faces that are small beside it: ribbons close such gaps,
 * and the integrals state them.
 */
FaceInspection InspectFace(DraftFace& face, const gp_Pnt& origin, double tolerance, double largestGap);
}

#endif
