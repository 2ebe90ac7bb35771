/**
 * @file smReadingRounding.h
 * @brief Bounds of the displacement of a surface by rounding, from the decimals of the file to the model
 */
#ifndef smReadingRounding_h
#define smReadingRounding_h

#include "smConvertedSurface.h"
#include "smGeometricSurface.h"

namespace sm
{
/**
 * Returns NURBSSurface::Rounding of `converted`, which was made of `source` on `box` by `map`. It includes
 * the conversion of decimals to doubles, the conversion of the length unit (`roundings` of every coordinate),
 * placements, the frames of elementary surfaces and profiles, weights and knots, and the subtraction of the
 * model's origin (Filters/Quadrature/Bounds.md, section 4). It does not include digits that the file itself
 * omits.
 */
SMREADERSFACES_EXPORT std::array<double, 3> GetReadingRounding(const GeometricSurface& source,
  const NativeBox& box, const AffineMap& map, const double origin[3], int roundings,
  const NURBSSurface& converted);
}

#endif
