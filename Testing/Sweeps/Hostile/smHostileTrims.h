/**
 * @file smHostileTrims.h
 * @brief Sheets made into trimmed faces: random splits, edges good and bad, vertices off their corners
 *
 * Splitting a sheet along any curve and joining the parts changes no total, whatever the curve: the truth
 * stays that of the sheets. Neither does the edge's own curve matter, as long as both faces use the same one.
 */
#ifndef smHostileTrims_h
#define smHostileTrims_h

#include "smHostileShape.h"

#include "smFace.h"

#include <string>
#include <vector>

namespace smhostile
{
struct TrimmedSolid
{
  std::vector<sm::FacePointer> Faces;
  /// The applied operations, for the report of a failure.
  std::string Description;
};

/// Faces of a shape. With `insideOut` every normal points inwards.
TrimmedSolid TrimShape(const Shape& shape, bool insideOut, Random& random);
}

#endif
