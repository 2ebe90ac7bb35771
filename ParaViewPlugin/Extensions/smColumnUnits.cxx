#include "smColumnUnits.h"

#include "smMassPropertyNames.h"
#if VTK_MODULE_ENABLE_SolidMoments_FiltersBuoyancy
#include "smBuoyancyNames.h"
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
#include "smSectionNames.h"
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
#include "smStabilityNames.h"
#endif

#include <cstddef>

namespace sm
{
namespace
{
/// A quantity in `Factor` times the length unit to the power `Power`.
struct Unit
{
  const char* Quantity;
  const char* Factor;
  int Power;
};

constexpr Unit Units[] = {
  { names::Volume, "", 3 },
  { names::SurfaceArea, "", 2 },
  { names::CenterOfMass, "", 1 },
  { names::FirstMoments, "", 4 },
  { names::SecondMoments, "", 5 },
  { names::VolumeInertia, "", 5 },
  { names::VolumeInertiaAtOrigin, "", 5 },
  { names::PrincipalMoments, "", 5 },
  { names::RadiiOfGyration, "", 1 },
  { names::Mass, "kg", 0 },
  { names::MassInAll, "kg", 0 },
  { names::KnownMassInAll, "kg", 0 },
  { names::MassInertia, "kg", 2 },
  { names::MassCenter, "", 1 },
  { names::MassPrincipalMoments, "kg", 2 },
  { names::MassRadiiOfGyration, "", 1 },
  { names::Density, "kg/m^3", 0 },
  { names::MassUncertainty, "kg", 0 },
  { names::OverriddenMass, "kg", 0 },
  { names::KnownMass, "kg", 0 },
  { names::ClosureCorrection, "", 3 },
  { names::ClosureSpread, "", 3 },
  { names::VolumePerOffset, "", 2 },
  { names::SurfaceAreaPerOffset, "", 1 },
  { names::PrincipalMomentsPerOffset, "", 4 },
  { names::VolumeLower, "", 3 },
  { names::VolumeUpper, "", 3 },
  { names::VolumeDeviation, "", 3 },
  { names::MassLower, "kg", 0 },
  { names::MassUpper, "kg", 0 },
  { names::MassDeviation, "kg", 0 },
  { names::CenterOfMassReach, "", 1 },
  { names::CenterOfMassDeviation, "", 1 },
  { names::VolumeInertiaReach, "", 5 },
  { names::VolumeInertiaDeviation, "", 5 },
  { names::PrincipalMomentsReach, "", 5 },
  { names::PrincipalMomentsDeviation, "", 5 },
  { names::ToleranceLower, "", 1 },
  { names::ToleranceUpper, "", 1 },
  { names::VolumeByTolerance, "", 3 },
  { names::MassByTolerance, "kg", 0 },
  { names::GapSquared, "", 3 },
  { names::MaxGap, "", 1 },
  { names::GapArea, "", 2 },
  { names::VolumeOfWholeSolid, "", 3 },
  { names::MassOfWholeSolid, "kg", 0 },
  { names::FaceArea, "", 2 },
  { names::FaceGap, "", 1 },
  { names::FaceBound, "", 3 },
#if VTK_MODULE_ENABLE_SolidMoments_FiltersBuoyancy
  { names::DisplacedVolume, "", 3 },
  { names::DisplacedFirstMoments, "", 4 },
  { names::CenterOfBuoyancy, "", 1 },
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
  { names::SectionArea, "", 2 },
  { names::SectionCentroid, "", 1 },
  { names::SectionSecondMoments, "", 4 },
  { names::SectionPrincipalMoments, "", 4 },
  { names::VolumeBelow, "", 3 },
  { names::CenterBelow, "", 1 },
  { names::MassBelow, "kg", 0 },
  { names::VolumeAbove, "", 3 },
  { names::CenterAbove, "", 1 },
  { names::MassAbove, "kg", 0 },
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
  { names::StabilityMargin, "", 1 },
  { names::TipAngle, "degrees", 0 },
  { names::CenterOfMassRise, "", 1 },
  { names::TipEnergy, "J", 0 },
  { names::CenterHeight, "", 1 },
  { names::Clearance, "", 1 },
  { names::RollingRadius, "", 1 },
  { names::RollingMargin, "", 1 },
  { names::ProjectedCenterOfMass, "", 1 },
#endif
};

std::string RemoveEnding(const std::string& text)
{
  for (const std::string suffix : { names::BoundSuffix, names::SpreadSuffix })
  {
    if (text.size() > suffix.size() && text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0)
    {
      return text.substr(0, text.size() - suffix.size());
    }
  }
  // The suffix by which the spreadsheet names components.
  const std::size_t line = text.rfind('_');
  const bool isComponent =
    line != std::string::npos && line + 2 == text.size() && text[line + 1] >= '0' && text[line + 1] <= '9';
  return isComponent ? text.substr(0, line) : text;
}
}

std::string GetColumnUnit(const std::string& column, const std::string& lengthUnit)
{
  for (const Unit& unit : Units)
  {
    if (column == unit.Quantity || RemoveEnding(column) == unit.Quantity)
    {
      const std::string length = unit.Power == 0 ? ""
        : unit.Power == 1                        ? lengthUnit
                                                 : lengthUnit + "^" + std::to_string(unit.Power);
      return *unit.Factor && !length.empty() ? unit.Factor + (" " + length) : unit.Factor + length;
    }
  }
  return {};
}
}
