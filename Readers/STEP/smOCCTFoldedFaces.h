/**
 * @file smOCCTFoldedFaces.h
 * @brief Faces whose sense contradicts those of their neighbours
 */
#ifndef smOCCTFoldedFaces_h
#define smOCCTFoldedFaces_h

#include "smOCCTRepair.h"

#include <vector>

namespace sm
{
/**
 * On a closed surface the direction of a loop decides which part of it the face is, so that a wrong sense of
 * the face takes the other part instead of a loop that is evidently wrong. Returns such faces if they fold
 * back at an edge: their normal is opposite to that of the neighbour, with which they form a smooth edge if
 * their sense is the other one. `faces` has the completed loops of the body's faces.
 */
std::vector<TopoDS_Shape> FindFoldedFaces(const TopoDS_Shape& body, const SoundFaceTable& faces);
}

#endif
