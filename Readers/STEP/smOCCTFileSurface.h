/**
 * @file smOCCTFileSurface.h
 * @brief Spline surfaces of a STEP file that OpenCASCADE changed when it made them periodic
 */
#ifndef smOCCTFileSurface_h
#define smOCCTFileSurface_h

#include "smOCCTSurface.h"

#include <Geom_BSplineSurface.hxx>

namespace sm
{
/**
 * A B-spline surface as the file has it. OpenCASCADE makes one periodic whose borders are less than 1e-7 mm
 * apart, or that is closed by its weights alone: the last row of control points and weights is replaced by
 * the first one, and values change by up to 1e-8 of the size.
 */
struct FileSurface
{
  /// Null if OpenCASCADE's surface is that of the file. It has the same parameters, and the coordinates of
  /// the face's surface.
  Handle(Geom_BSplineSurface) Surface;
  /// Bound of the distance of the two at equal parameters of its domain, in mm.
  double Distance = 0.0;
};

/// Compares a surface with the periodic one that OpenCASCADE made of it.
FileSurface CompareSurfaces(
  const Handle(Geom_BSplineSurface) & own, const Handle(Geom_BSplineSurface) & read);

/// Returns the file's surface, moved by whole periods of OpenCASCADE's surface to the parameters of `box`;
/// null if the box extends beyond its domain, because a face that crosses the seam needs the periodic
/// surface.
SMREADERSSTEP_EXPORT Handle(Geom_Surface)
  CoverBox(const FileSurface& file, const Handle(Geom_Surface) & periodic, const NativeBox& box);
}

#endif
