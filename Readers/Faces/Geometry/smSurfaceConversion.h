/**
 * @file smSurfaceConversion.h
 * @brief Surfaces of faces as rational B-splines, compared with their own evaluation
 */
#ifndef smSurfaceConversion_h
#define smSurfaceConversion_h

#include "smConvertedSurface.h"
#include "smGeometricSurface.h"

namespace sm
{
/// Returns a word for the kind of a surface, such as "cylinder".
SMREADERSFACES_EXPORT const char* GetKindName(const GeometricSurface& surface);

/// Returns the offset of an elementary surface as an elementary surface with the same parameters; null for
/// other surfaces, and where the offset passes the axis.
SMREADERSFACES_EXPORT SurfacePointer SimplifyOffset(const SurfacePointer& surface);

/// Converts a surface over a box of its parameters: exactly, or an offset surface by a fit. Throws
/// std::runtime_error with a short reason, also if the result differs from the surface at some points.
SMREADERSFACES_EXPORT ConvertedSurface ConvertSurface(
  const SurfacePointer& surface, const NativeBox& box, const AffineMap& map);
}

#endif
