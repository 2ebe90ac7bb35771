/**
 * @file smPlacementError.h
 * @brief Bounds of what rounding of a placement that was read may change integrals by
 *
 * Every entry of the rotation is off by some u, and the translation by as much of itself. A placed body is then moved by an affine map:
 * stretched and turned by Turned at most, and no point of it by more than Moved.
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
  /// Rounding of an entry of a placement, and of a translation relative to itself: decimals, directions made orthogonal and of length 1,
  /// units, and products of the placements of nested assemblies. An estimate, which counts in BoundsMeasured.
  static constexpr double Rounding = 32.0 * UnitRoundoff;
  /// Norm of a matrix whose nine entries are off by that.
  static constexpr double Turned = 3.0 * Rounding;

  /// 0: the placement is exact.
  double Moved = 0.0;

  bool operator==(const PlacementError& other) const { return this->Moved == other.Moved; }

  /// Returns true if a placement that is not the identity was read from a file with the body, or is applied to what was.
  static bool IsRounded(const BodyIntegrals& body);
  static PlacementError Make(const BodyIntegrals& body);
  /// The bound for an integral of this class over a face whose area is at most `area`, and that of its ribbons `gaps`. All of it
  /// is within `reach` of the point that moments are about.
  double GetBound(const BoundClass& integrand, double area, double gaps, double reach) const;
};
}

#endif
