#include "smSectionRow.h"

#include "smSectionNames.h"
#include "smUnitRoundoff.h"

#include <cmath>

namespace sm
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

SectionSide MakeSide(const DisplacedMoments& moments)
{
  SectionSide side;
  side.Volume = moments.Volume;
  side.VolumeBound = moments.VolumeBound;
  side.Center = moments.GetCenter(side.CenterBound);
  return side;
}

void AddMasses(const SectionSide& other, SectionSide& side)
{
  side.Mass += other.Mass;
  side.MassBound += other.MassBound + 2.0 * UnitRoundoff * std::abs(side.Mass);
}
}

SectionRow::SectionRow()
  : Area(NaN)
  , AreaBound(NaN)
  , Properties(SectionMoments().ComputeProperties())
{
}

SectionRow::SectionRow(
  const SectionMoments& section, const DisplacedMoments& below, const DisplacedMoments& above)
  : Area(section.Area)
  , AreaBound(section.AreaBound)
  , Properties(section.ComputeProperties())
  , Below(MakeSide(below))
  , Above(MakeSide(above))
{
}

void SectionRow::SetMass(double density)
{
  for (SectionSide* side : { &this->Below, &this->Above })
  {
    side->Mass = density * side->Volume;
    // The density per cubic length unit is a rounded product.
    side->MassBound = density * side->VolumeBound + 8.0 * UnitRoundoff * std::abs(side->Mass);
  }
}

void SectionRow::AddMass(const SectionRow& other)
{
  AddMasses(other.Below, this->Below);
  AddMasses(other.Above, this->Above);
}

void SectionRow::Visit(const Visitor& visit) const
{
  const SectionProperties& section = this->Properties;
  visit(names::SectionArea, &this->Area, 1, &this->AreaBound);
  visit(names::SectionCentroid, section.Centroid.data(), 3, &section.CentroidBound);
  visit(names::SectionSecondMoments, section.Second.data(), 6, &section.SecondBound);
  visit(names::SectionPrincipalMoments, section.Principal.data(), 2, &section.PrincipalBound);
  visit(names::SectionPrincipalDirections, section.Directions[0].data(), 6, nullptr);
  visit(names::VolumeBelow, &this->Below.Volume, 1, &this->Below.VolumeBound);
  visit(names::CenterBelow, this->Below.Center.data(), 3, &this->Below.CenterBound);
  visit(names::MassBelow, &this->Below.Mass, 1, &this->Below.MassBound);
  visit(names::VolumeAbove, &this->Above.Volume, 1, &this->Above.VolumeBound);
  visit(names::CenterAbove, this->Above.Center.data(), 3, &this->Above.CenterBound);
  visit(names::MassAbove, &this->Above.Mass, 1, &this->Above.MassBound);
}
}
