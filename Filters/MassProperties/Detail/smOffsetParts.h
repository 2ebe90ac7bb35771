/**
 * @file smOffsetParts.h
 * @brief The measurements that smOffsetGeometry.h consists of
 */
#ifndef smOffsetParts_h
#define smOffsetParts_h

#include "Detail/smOffsetGeometry.h"

namespace sm
{
/// Measures the curvatures of a face, whose outward normal is that of the face alone.
OffsetFace MeasureOffsetFace(const Face& source);

/// Largest angle of a crease, in radians, that counts as an error of the curvature's integral; a sharper one
/// is an edge that nothing measures.
constexpr double MaxCrease = 0.03;

/// Finds creases of a face at which it has no edges: borders of a face without loops that are neither closed
/// smoothly nor smooth poles, and knot lines at which normals turn.
void FindCreases(const Face& source, OffsetFace& face);
}

#endif
