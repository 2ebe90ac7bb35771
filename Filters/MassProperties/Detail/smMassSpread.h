/**
 * @file smMassSpread.h
 * @brief How far mass properties move if the gaps of bodies are closed in another way
 *
 * The closings are those of smClosingSpread.h.
 */
#ifndef smMassSpread_h
#define smMassSpread_h

#include "smFiltersMassPropertiesModule.h"
#include "smMoments.h"

#include <array>
#include <vector>

namespace sm
{
struct BodyIntegrals;

/// The largest changes of volume, centre, of any entry of the inertia about it, and of a principal moment;
/// with densities as weight, of the mass and its moments. NaN if not known.
struct SMFILTERSMASSPROPERTIES_EXPORT MassSpread
{
  double Volume;
  double Center;
  double Inertia;
  double Principal;

  /// Sets all values to NaN.
  MassSpread();
  /// Returns the spread of the mass and its moments at `factor` kg a volume of 1.
  MassSpread GetWeighted(double factor) const;
};

/// Returns moments in the world about the centre of a body of which the values are 0 and the bounds are the
/// largest changes by other closings; NaN if these are not known.
SMFILTERSMASSPROPERTIES_EXPORT Moments GetSpreadMoments(const BodyIntegrals& body);

/// Returns the spread of bodies together from their GetSpreadMoments(), their volume, or mass, and its
/// centre.
SMFILTERSMASSPROPERTIES_EXPORT MassSpread ComputeSpread(
  const std::vector<Moments>& spreads, double volume, const std::array<double, 3>& center);
}

#endif
