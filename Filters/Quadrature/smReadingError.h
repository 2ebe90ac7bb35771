/**
 * @file smReadingError.h
 * @brief Largest change of a face's integrals by rounding of the numbers that it was read from
 *
 * Surface and edges move together by a displacement d with |d| <= Moved, a B-spline surface as they are
 * (NURBSSurface::Rounding), so the chain of a body stays closed. Its volume integrals change by the flux of
 * d, an area by the change of the tangents and by what d sweeps along the border. See Bounds.md, section 4.
 */
#ifndef smReadingError_h
#define smReadingError_h

#include "smFacePanels.h"
#include "smFiltersQuadratureModule.h"
#include "smPatchMajorants.h"

namespace sm
{
struct SMFILTERSQUADRATURE_EXPORT ReadingError
{
  /// Largest displacement of a point, a length; 0: nothing was rounded.
  double Moved = 0.0;
  /// Bound of the integral of |d.n| over the whole patches.
  double Swept = 0.0;
  /// Bound of the change of the area, and of the length of the edges.
  double Area = 0.0;
  double Border = 0.0;
  /// Largest distance from the point that moments are about.
  double Reach = 0.0;

  /// Computes the errors of a face; `reach` is stored in Reach.
  static ReadingError Make(const Face& face, const FacePanels& panels, double reach);
  /// Returns the bound for an integral of this class over a face; `area` and `gaps` are upper bounds of the
  /// areas of its panels and of its ribbons.
  double GetBound(const BoundClass& integrand, double area, double gaps) const;
};

/// Bound of the change of a patch's area, over the distance by which its control points move.
double GetRotatedLength(const Patch& patch);
}

#endif
