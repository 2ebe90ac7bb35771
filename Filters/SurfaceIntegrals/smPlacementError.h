/**
 * @file smPlacementError.h
 * @brief Bounds of the change of integrals by the rounding of a placement
 *
 * Every entry of the rotation has an error of some units of roundoff u, and so has the translation, relative
 * to its length. A placement that was not read is exact, but to how it deviates from a rotation: a matrix in
 * decimals does so by more than rounding. A placed body is then moved by an affine map: stretched and rotated
 * by Rotated at most, and no point of it by more than Moved.
 */
#ifndef smPlacementError_h
#define smPlacementError_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smUnitRoundoff.h"

namespace sm
{
struct BodyIntegrals;
struct BoundClass;

struct SMFILTERSSURFACEINTEGRALS_EXPORT PlacementError
{
  /// Rounding of an entry of a placement, and of a translation relative to itself: decimals, directions made
  /// orthogonal and of length 1, units, and products of the placements of nested assemblies. An estimate,
  /// which counts in BoundsMeasured.
  static constexpr double Rounding = 32.0 * UnitRoundoff;
  /// Bound of the displacement of any point of the body, a length; 0: no placement.
  double Moved = 0.0;
  /// Bound of the norm of the error of the rotation.
  double Rotated = 0.0;

  bool operator==(const PlacementError& other) const
  {
    return this->Moved == other.Moved && this->Rotated == other.Rotated;
  }

  /// Returns true if the body has a placement other than the identity and was read from a file, so that the
  /// placement may be rounded.
  static bool IsRounded(const BodyIntegrals& body);
  /// Returns Rotated: 3 Rounding, the norm of nine entries, if the placement is rounded, and what makes it no
  /// rotation.
  static double GetRotated(const BodyIntegrals& body);
  /// `withSamples`: Moved has the rounding of samples that this placement and the model's origin place.
  static PlacementError Make(const BodyIntegrals& body, bool withSamples = true);
  /// Returns the bound for an integral of this class over a face. `area` and `gaps` are upper bounds of the
  /// areas of the face and of its ribbons; `reach` is one of their distance from the point that moments are
  /// about.
  double GetBound(const BoundClass& integrand, double area, double gaps, double reach) const;
};
}

#endif
