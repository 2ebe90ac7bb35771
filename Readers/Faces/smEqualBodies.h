/**
 * @file smEqualBodies.h
 * @brief Bodies that differ from another one by a translation: found, and copied from its conversion
 */
#ifndef smEqualBodies_h
#define smEqualBodies_h

#include "smBodyConversion.h"

#include <cstddef>

namespace sm
{
/**
 * How a body follows from another one: each number of its geometry is the same, except for points, which are
 * moved by Shift and at most Deviation. A parameter at which an edge ends may differ by what moves the end as
 * little.
 *
 * As the points of a surface are convex combinations of its control points, or rotations of a profile about
 * an axis, every point of faces and edges is where the other body has it, moved by Shift, to Deviation.
 */
struct BodyShift
{
  bool IsEqual = false;
  /// In the unit of the bodies.
  Vector3 Shift{};
  /// Bound of the distance from the translated body in x, y and z.
  Vector3 Deviation{};
  /// Largest magnitude of x, y and z of a point of the geometry, of both bodies.
  Vector3 Reach{};
};

/**
 * Compares two bodies: their shells, faces, wires and edges in the order of the file, shared edges and
 * vertices, surfaces, curves, orientations, and whether loops were completed alike. Ids, names and colours
 * may differ. Deviations of points of more than 16 roundings of their largest coordinate make bodies
 * different. Offset and composite curves, offset surfaces, curves on surfaces, closed splines that were made
 * periodic, repaired faces and bodies with placements in them are never equal.
 */
SMREADERSFACES_EXPORT BodyShift CompareBodies(const BodyShape& one, const BodyShape& other);

/// Returns a number that equal bodies have in common.
SMREADERSFACES_EXPORT std::size_t GetShapeHash(const BodyShape& body);

/**
 * Returns the conversion of `body`, which is equal to `converted`, by a copy of the conversion of that one:
 * the faces and edges have the same coordinates relative to their origin and new ids, and entity numbers,
 * names and colours of `body`. Throws std::runtime_error if edges or faces do not correspond.
 */
SMREADERSFACES_EXPORT ConvertedBody CopyConversion(
  const ConvertedBody& conversion, const BodyShape& converted, const BodyShape& body);
}

#endif
