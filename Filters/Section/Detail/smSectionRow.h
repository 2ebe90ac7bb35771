/**
 * @file smSectionRow.h
 * @brief One row of the results of a section, from the moments of both sides of the plane
 */
#ifndef smSectionRow_h
#define smSectionRow_h

#include "smBuoyancy.h"
#include "smFiltersSectionModule.h"

#include <array>
#include <functional>
#include <string>

namespace sm
{
/// Volume, centre and mass of the part on one side of the plane; NaN where not known.
struct SectionSide
{
  double Volume = std::numeric_limits<double>::quiet_NaN();
  double VolumeBound = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 3> Center{ Volume, Volume, Volume };
  double CenterBound = std::numeric_limits<double>::quiet_NaN();
  double Mass = std::numeric_limits<double>::quiet_NaN();
  double MassBound = std::numeric_limits<double>::quiet_NaN();
};

/// Results of one body or of all bodies; NaN where not known.
class SectionRow
{
public:
  SectionRow();
  /// Sets everything but the masses.
  SectionRow(const SectionMoments& section, const DisplacedMoments& below, const DisplacedMoments& above);
  /// Sets the masses of both sides. `density` is in kg per cubic length unit; NaN gives no mass.
  void SetMass(double density);
  /// Adds the masses of another body to those of this row; no mass if either has none.
  void AddMass(const SectionRow& other);

  /// Receives the name of a quantity, its values, and its bound or null.
  using Visitor =
    std::function<void(const std::string& name, const double* values, int components, const double* bound)>;
  /// Visits all quantities in the order of the columns.
  void Visit(const Visitor& visit) const;

  double Area;
  double AreaBound;
  SectionProperties Properties;
  SectionSide Below;
  SectionSide Above;
};

/// Compares the section as computed from below the plane with that from above it. Returns a message if areas,
/// centroids or second moments differ by more than their bounds, or a centroid is off the plane by more than
/// its bound; empty if there is no contradiction.
SMFILTERSSECTION_EXPORT std::string FindContradiction(
  const SectionMoments& fromBelow, const SectionMoments& fromAbove, const Waterline& plane);
}

#endif
