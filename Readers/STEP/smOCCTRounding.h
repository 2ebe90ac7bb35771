/**
 * @file smOCCTRounding.h
 * @brief How far rounding may have moved a surface on its way from the file's decimals to the model
 */
#ifndef smOCCTRounding_h
#define smOCCTRounding_h

#include "smNURBSSurface.h"
#include "smOCCTParameterMap.h"
#include "smOCCTSurface.h"

#include <Geom_Surface.hxx>

namespace sm
{
/**
 * NURBSSurface::Rounding of `converted`, which was made of `source` on `box` by `map`. Counted are decimals that become doubles, the conversion
 * of the length unit (`roundings` of every coordinate), placements, the frames of elementary surfaces and profiles, weights and knots,
 * and the subtraction of the model's origin (Filters/Quadrature/Bounds.md, section 4). Digits that the file itself leaves out
 * are not.
 */
std::array<double, 3> GetReadingRounding(const Handle(Geom_Surface) & source, const NativeBox& box,
  const AffineMap& map, const double origin[3], int roundings, const NURBSSurface& converted);
}

#endif
