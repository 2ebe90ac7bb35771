/**
 * @file smMassTable.h
 * @brief Columns of the mass properties of a body or of all bodies, and their summary as text
 */
#ifndef smMassTable_h
#define smMassTable_h

#include "Detail/smMassSpread.h"
#include "Detail/smReferenceFrame.h"
#include "smColumns.h"
#include "smFiltersMassPropertiesModule.h"
#include "smLengthUnits.h"
#include "smMoments.h"

#include <array>
#include <cstddef>
#include <string>

namespace sm
{
/// All values that are written for one body, or for the total.
struct SMFILTERSMASSPROPERTIES_EXPORT MassRow
{
  MassProperties Properties;
  double Area;
  double AreaBound;
  /// The parts of the bounds of volume, area, centre and inertia that are estimated: they rest on measured
  /// constants (Bounds.md). The rest of a bound is a theorem, except for areas that are estimated as a whole.
  std::array<double, 4> MeasuredBounds;
  /// Mass and its inertia; NaN without a density.
  double Mass;
  double MassBound;
  std::array<double, 9> MassInertia;
  double MassInertiaBound;
  /// The uncertainty of the mass, in kg: their sum; by the tolerance of the density; by the gaps of the model
  /// (the spread of the mass); by the numerical bound; by the tolerance of masses that override volume times
  /// density. NaN without a mass, and where a share is not known.
  /// The share of gaps bounds what other closings may change, not the distance to the designer's part.
  std::array<double, 5> MassUncertainty;
  /// The part of the mass that materials state instead of a density; NaN without a mass.
  double OverriddenMass;
  /// The part of the stated mass of a product that this solid has; 0 for a solid that shares none.
  double ShareOfProduct = 0.0;
  /// Properties with the density as weight: kg, kg L, kg L^2. For all bodies together only if each has a
  /// density.
  MassProperties Weighted;
  /// Material, and density in kg/m^3; empty and NaN without one, or if bodies differ. Where the mass
  /// overrides it, the mean density.
  std::string Material;
  double Density;
  /// Mass of those bodies that have a density. Only of the total.
  double KnownMass;
  double KnownMassBound;
  /// Properties in the frame of reference, at density 1 and with the densities as weight.
  FrameProperties InFrame;
  FrameProperties WeightedInFrame;
  /// What other closings of the gaps may change: volume, centre, inertia and principal moments; mass and its
  /// moments; area.
  MassSpread Spread;
  MassSpread WeightedSpread;
  double AreaSpread;
  double ClosureCorrection;
  double GapSquared;
  double MaxGap;
  double GapArea;
  double ClosureResidual;

  /// Sets all values but ShareOfProduct to NaN.
  MassRow();
  /// Returns kg of a volume 1 that is added to the solid: 0 where its mass is stated; where it shares the
  /// stated mass of a product, what the others do not lose. NaN without a mass.
  double GetAddedDensity() const;
  /// Sets all bounds to NaN.
  void RemoveBounds();
};

/// Adds columns named as in smMassPropertyNames.h with a row for each of `rows`.
SMFILTERSMASSPROPERTIES_EXPORT void WriteMassRows(
  const MassRow* rows, std::size_t count, bool withMass, bool withFrame, columns::Writer& writer);

/// Returns a summary in a few lines: the number of solids, volume, area, centre, principal moments and mass.
/// `weighed` of the `weighable` solids with a volume have a density.
SMFILTERSMASSPROPERTIES_EXPORT std::string FormatSummary(
  const MassRow& total, const std::string& unit, int solids, int weighed, int weighable);
}

#endif
