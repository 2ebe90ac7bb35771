/**
 * @file smShapeBounds.h
 * @brief The approximate bounding box of a body of a file
 */
#ifndef smShapeBounds_h
#define smShapeBounds_h

#include "smShape.h"

namespace sm
{
/**
 * Gets xmin xmax ymin ... of the edges of a body; of a face without edges also of some points of its surface.
 * Splines are known by some points of each span. Faces without edges on surfaces without ends are left out,
 * and counted in `unbounded`. Returns false if nothing is left.
 */
SMREADERSFACES_EXPORT bool GetShapeBounds(const BodyShape& body, double bounds[6], int* unbounded = nullptr);
}

#endif
