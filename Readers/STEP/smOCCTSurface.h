/**
 * @file smOCCTSurface.h
 * @brief OpenCASCADE surfaces as rational B-splines without error, and the map between their parameters
 */
#ifndef smOCCTSurface_h
#define smOCCTSurface_h

#include "smNURBSSurface.h"
#include "smOCCTParameterMap.h"
#include "smReadersSTEPModule.h"

#include <Geom_Surface.hxx>
#include <Standard_Handle.hxx>

namespace sm
{
struct ConvertedSurface
{
  NURBSSurface Surface;
  ParameterMap Map[2];
};

/// Native parameters that the trims of a face cover.
struct NativeBox
{
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
};

/// The surface below rectangular trims, whose parameters it shares.
SMREADERSSTEP_EXPORT Handle(Geom_Surface) GetBasisSurface(Handle(Geom_Surface) surface);

/// Throws std::runtime_error with the reason when the surface cannot be carried over.
SMREADERSSTEP_EXPORT ConvertedSurface ConvertSurface(
  const Handle(Geom_Surface) & surface, const NativeBox& box, const AffineMap& map);

/// Tensor Chebyshev fit over the box; the last resort, used for offset surfaces. Residual is stated.
NURBSSurface FitSurface(const Handle(Geom_Surface) & surface, const NativeBox& box, const AffineMap& map);
}

#endif
