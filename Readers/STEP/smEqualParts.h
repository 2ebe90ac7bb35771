/**
 * @file smEqualParts.h
 * @brief Bodies of a file that are one another moved, so that they are converted once
 */
#ifndef smEqualParts_h
#define smEqualParts_h

#include "smDocument.h"

#include <vector>

namespace sm
{
/// The first body of a file with the geometry of a body.
struct EqualPart
{
  /// Index of the first body; that of the body itself if it is the first one.
  std::size_t First = 0;
  /// True for a first body that others equal.
  bool HasCopies = false;
  /// From the first body to this one, in the unit of the document.
  Vector3 Shift{};
  /// Bound of the distance in x, y and z, in the unit of the document, by which this body and its copies are
  /// elsewhere than the conversion of the first one, moved by Shift as rounded.
  Vector3 Moved{};
};

/**
 * Finds the bodies that equal an earlier one except for a translation (CompareBodies()), are both solids or
 * both not, and have neither lost faces nor a scale of their own. `roundings`: roundings of a coordinate in
 * the conversion of the file's unit to that of the document; `isScaled`: the output has another unit.
 */
std::vector<EqualPart> FindEqualParts(const std::vector<PartBody>& bodies, int roundings, bool isScaled);
}

#endif
