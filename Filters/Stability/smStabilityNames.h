/**
 * @file smStabilityNames.h
 * @brief Names of the arrays of vtkSolidStability, in addition to those of smMassPropertyNames.h
 *
 * Field data of port 0 and columns of the tables use the same names. L is the length unit of the model. A
 * quantity with a bound has
 * `<name>Bound` next to it (sm::names::BoundSuffix), in the same unit.
 */
#ifndef smStabilityNames_h
#define smStabilityNames_h

namespace sm
{
namespace names
{
constexpr const char* Stability = "Stability"; // string, one of the verdicts below
constexpr const char* Support = "Support";     // string: "area", "line", "point", "none"
constexpr const char* DecidedBy = "DecidedBy"; // string: "margin", "rolling", "none"
constexpr const char* StabilityMargin =
  "StabilityMargin"; // 1, L, with bound: signed distance from the projected centre of mass to the nearest
                     // edge of the support polygon, positive inside
constexpr const char* TipAngle = "TipAngle"; // 1, degrees, with bound: the minimum of all directions;
                                             // negative: the centre is beyond the polygon
constexpr const char* CenterOfMassRise =
  "CenterOfMassRise"; // 1, L, with bound: minimum rise of the centre of mass on the way to tipping
constexpr const char* TipEnergy =
  "TipEnergy"; // 1, J: mass times gravity times that rise; NaN without a density
constexpr const char* CenterHeight =
  "CenterHeight"; // 1, L, with bound: height of the centre of mass above the ground
constexpr const char* ProjectedCenterOfMass =
  "ProjectedCenterOfMass"; // 3, L: the centre of mass projected along gravity onto the ground
constexpr const char* Clearance =
  "Clearance"; // 1, L, with bound: height of the lowest point above the ground; 0 when resting
constexpr const char* ContactFaces = "ContactFaces"; // 1 (int), faces that touch with a patch or more
constexpr const char* ContactEdges = "ContactEdges"; // 1 (int), edges that touch along a piece or more
constexpr const char* RollingRadius =
  "RollingRadius"; // 1, L: radius of curvature at a point or line of contact
constexpr const char* RollingMargin = "RollingMargin"; // 1, L, with estimated bound: that radius minus
                                                       // CenterHeight (scaled on a slope, see smStability.h)

// Columns of the table of sides.
constexpr const char* SideFrom = "From"; // 3, L
constexpr const char* SideTo = "To";     // 3, L

// Cell data of the drawing.
constexpr const char* StabilityColor =
  "StabilityColor"; // 3 (unsigned char): green, red, amber; grey: no verdict

// Verdicts.
constexpr const char* VerdictStable = "stable";
constexpr const char* VerdictUnstable = "unstable";
constexpr const char* VerdictTooClose = "too-close";
constexpr const char* VerdictNoContact = "no-contact";
constexpr const char* VerdictBelowGround = "below-ground";
constexpr const char* VerdictUnknown = "unknown";
}
}

#endif
