/**
 * @file smOutsideFaces.h
 * @brief Faces of which a repair takes the wrong part of their surface
 */
#ifndef smOutsideFaces_h
#define smOutsideFaces_h

#include "Shapes/smShape.h"

#include <vector>

namespace sm
{
/**
 * Returns the faces of a body on a closed surface, such as a sphere or torus, that lie outside their loops
 * (AddNaturalBoundary()). OpenCASCADE's repair reverses such loops, so that the part inside remains and the
 * sides of the other faces are adapted to it: the result is closed, and wrong.
 */
SMREADERSFACES_EXPORT std::vector<const FaceShape*> FindOutsideFaces(const BodyShape& body);
}

#endif
