/**
 * @file smPeriodicSurface.h
 * @brief Closed splines as periodic ones, whose seam does not divide a face
 */
#ifndef smPeriodicSurface_h
#define smPeriodicSurface_h

#include "smConvertedSurface.h"
#include "smGeometricSurface.h"

namespace sm
{
/// A B-spline surface as the file has it, where a periodic one was made of it.
struct FileSurface
{
  /// Null if the periodic surface has the same points. It has the same parameters.
  SurfacePointer Surface;
  /// Bound of the distance of the two at equal parameters of its domain.
  double Distance = 0.0;
};

/**
 * Returns a B-spline surface as a periodic one in the directions in which its first and last rows of control
 * points are the same, to 1e-7 mm and 1e-9 of their weights, and its knots either have full multiplicity at
 * the ends or repeat, too; of a surface swept along a closed spline that along the periodic one. The last
 * rows are replaced by the first ones: `own` gets the surface of the file if that changes it. Other surfaces
 * are returned as they are.
 */
SMREADERSFACES_EXPORT SurfacePointer MakePeriodic(const SurfacePointer& surface, FileSurface& own);

/// Returns a closed spline of space as a periodic one, likewise, if its first and last control points and
/// weights are the same within a relative `tolerance`; null for any other curve.
SMREADERSFACES_EXPORT CurvePointer<3> MakePeriodic(const CurvePointer<3>& curve, double tolerance);

/// Returns the file's surface, moved by whole periods of the periodic one to the parameters of `box`; null if
/// the box extends beyond its domain, because a face that crosses the seam needs the periodic surface.
SMREADERSFACES_EXPORT SurfacePointer CoverBox(
  const FileSurface& file, const SurfacePointer& periodic, const NativeBox& box);
}

#endif
