#include "Detail/smSectionRow.h"

#include "smSectionNames.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

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

namespace
{
/// Returns true if values differ by more than the bound, false where one of them is NaN.
template <std::size_t Size>
bool Differ(const std::array<double, Size>& a, const std::array<double, Size>& b, double bound)
{
  for (std::size_t i = 0; i < Size; ++i)
  {
    if (std::abs(a[i] - b[i]) > bound)
    {
      return true;
    }
  }
  return false;
}

bool IsOffPlane(const SectionProperties& section, const Waterline& plane)
{
  const double height = Dot(Normalized(plane.Up), Subtract(section.Centroid, plane.Point));
  return std::abs(height) >
    section.CentroidBound + 16.0 * UnitRoundoff * (Norm(section.Centroid) + Norm(plane.Point));
}
}

std::string FindContradiction(
  const SectionMoments& fromBelow, const SectionMoments& fromAbove, const Waterline& plane)
{
  const SectionProperties below = fromBelow.ComputeProperties();
  const SectionProperties above = fromAbove.ComputeProperties();
  const bool differentAreas =
    std::abs(fromBelow.Area - fromAbove.Area) > fromBelow.AreaBound + fromAbove.AreaBound;
  const char* quantity = differentAreas                                                 ? "areas"
    : Differ(below.Centroid, above.Centroid, below.CentroidBound + above.CentroidBound) ? "centroids"
    : Differ(below.Second, above.Second, below.SecondBound + above.SecondBound)         ? "second moments"
                                                                                        : nullptr;
  if (quantity)
  {
    return std::string("the ") + quantity +
      " of the section from below and from above differ by more than their bounds: the faces do not close";
  }
  return IsOffPlane(below, plane) || IsOffPlane(above, plane)
    ? "the centroid of the section is off the plane by more than its bound: the faces do not close"
    : "";
}
}
