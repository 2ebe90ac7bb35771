/**
 * @file smOCCTSurface.h
 * @brief Exact conversion of OpenCASCADE surfaces to rational B-splines, with the map between their
 * parameters
 */
#ifndef smOCCTSurface_h
#define smOCCTSurface_h

#include "Geometry/smConvertedSurface.h"
#include "smReadersSTEPModule.h"

#include <Geom_Surface.hxx>
#include <Standard_Handle.hxx>

namespace sm
{
/// Returns the basis surface of rectangular trimmed surfaces, which has the same parameters.
SMREADERSSTEP_EXPORT Handle(Geom_Surface) GetBasisSurface(Handle(Geom_Surface) surface);

/// Converts a surface. Throws std::runtime_error with the reason if that is not possible.
SMREADERSSTEP_EXPORT ConvertedSurface ConvertSurface(
  const Handle(Geom_Surface) & surface, const NativeBox& box, const AffineMap& map);
}

#endif
