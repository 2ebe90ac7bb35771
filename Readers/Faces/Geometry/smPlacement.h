/**
 * @file smPlacement.h
 * @brief Similarities of space that place a shape, and sums of vectors
 */
#ifndef smPlacement_h
#define smPlacement_h

#include "smGeometricSurface.h"
#include "smParameterMap.h"

namespace sm
{
/// A rotation or reflection, a uniform scale and a translation, as a matrix.
using Placement = AffineMap;

inline Vector3 Sum(const Vector3& a, const Vector3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Vector3 Multiply(double factor, const Vector3& v)
{
  return { factor * v[0], factor * v[1], factor * v[2] };
}

/// Returns the placement that applies `second` and then `first`.
SMREADERSFACES_EXPORT Placement Compose(const Placement& first, const Placement& second);
SMREADERSFACES_EXPORT Placement Invert(const Placement& placement);
SMREADERSFACES_EXPORT bool IsIdentity(const Placement& placement);
SMREADERSFACES_EXPORT Placement MakeScale(double factor);
/// Returns the rotation and translation that bring the axes of the world to those of a frame.
SMREADERSFACES_EXPORT Placement MakeMotion(const GeometricFrame& frame);

/// Returns a curve that was moved. Its parameter is the same except for the unit of lengths. Throws
/// std::runtime_error with a short reason.
SMREADERSFACES_EXPORT CurvePointer<3> MoveCurve(const CurvePointer<3>& curve, const Placement& placement);
/// The same for a surface.
SMREADERSFACES_EXPORT SurfacePointer MoveSurface(const SurfacePointer& surface, const Placement& placement);
}

#endif
