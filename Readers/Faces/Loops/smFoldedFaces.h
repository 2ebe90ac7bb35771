/**
 * @file smFoldedFaces.h
 * @brief Faces whose sense contradicts those of their neighbours
 */
#ifndef smFoldedFaces_h
#define smFoldedFaces_h

#include "smShapeInspection.h"

#include <vector>

namespace sm
{
/**
 * On a closed surface the direction of a loop decides which part of it the face is, so that a wrong sense of
 * the face takes the other part instead of a loop that is evidently wrong. Returns such faces if they fold
 * back at an edge: their normal is opposite to that of the neighbour, with which they form a smooth edge if
 * their sense is the other one. `faces` has the completed loops of the body's faces.
 */
SMREADERSFACES_EXPORT std::vector<const FaceShape*> FindFoldedFaces(
  const BodyShape& body, const SoundFaceTable& faces);
}

#endif
