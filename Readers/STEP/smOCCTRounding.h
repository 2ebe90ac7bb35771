/**
 * @file smOCCTRounding.h
 * @brief Bounds of the displacement of a surface by rounding, from the decimals of the file to the model
 */
#ifndef smOCCTRounding_h
#define smOCCTRounding_h

#include "Geometry/smParameterMap.h"
#include "smNURBSSurface.h"
#include "smOCCTSurface.h"

#include <Geom_Surface.hxx>

namespace sm
{
/**
 * Returns NURBSSurface::Rounding of `converted`, which was made of `source` on `box` by `map`. It includes
 * the conversion of decimals to doubles, the conversion of the length unit (`roundings` of every coordinate),
 * placements, the frames of elementary surfaces and profiles, weights and knots, and the subtraction of the
 * model's origin (Filters/Quadrature/Bounds.md, section 4). It does not include digits that the file itself
 * omits.
 */
std::array<double, 3> GetReadingRounding(const Handle(Geom_Surface) & source, const NativeBox& box,
  const AffineMap& map, const double origin[3], int roundings, const NURBSSurface& converted);
}

#endif
