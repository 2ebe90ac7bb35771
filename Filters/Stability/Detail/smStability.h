/**
 * @file smStability.h
 * @brief Static stability of a body on the ground: stability margin, tip angles and rises of the centre of
 * mass, with bounds
 *
 * All quantities are in the frame of the ground (smGroundNet.h): a, b in its plane, h along its normal. The
 * body is rigid and does not slide. It is stable when its centre of mass, projected along gravity onto the
 * ground, lies inside the support polygon, the convex hull of the contacts.
 *
 * **Stability margin**: signed distance from the projected centre of mass to the nearest edge of the support
 * polygon, in the ground's plane, positive inside; minus the distance where the hull is a point or a segment.
 * Hulls from inside and outside of all contacts give an interval, and the bound of the centre widens it.
 *
 * **Tipping about a side** with unit inward normal v, in the plane: with m the signed distance of the centre
 * from the side along v, z its height above the ground, d = hypot(m, z), and u_v, u_h the components of the
 * upward direction along v and along the ground's normal, the centre is highest after a rotation by the angle
 * phi, and has risen by W then:
 *
 *     phi = atan2(m, z) - atan2(u_v, u_h),     W = hypot(u_v, u_h) d (1 - cos phi)        (0 where phi <= 0)
 *
 * On level ground phi = atan(m / z) and W = d - z. The rise W is a length; the energy is W times the weight.
 * The minimum angle and the minimum rise are those over all lines that touch the polygon from outside, at a
 * corner as well as along a side; their intervals follow from hulls from inside and outside, too
 * (smMinimumTip.h).
 *
 * **Rolling.** Where the contacts are one point, or lie on one line, the margin is not positive, and the
 * curvature decides. The height of the centre over the ground, as a function of the direction of the ground
 * seen from the body, is the support function of the body about the centre; its second derivative in a
 * direction of rolling is (radius of curvature) - z. So a balanced body returns to its position when the
 * radius of curvature of its surface at the contact, across the line of contacts, exceeds the height of the
 * centre: RollingMargin = radius - z. Corners and edges have radius 0. Between two contacts of a line the
 * radius counts linearly (upper concave envelope: the body lies on both). Where a surface ends at the
 * contact, the body tips over that border: the radius to that side is 0. On a slope z is multiplied by 1 /
 * cos^2 of the slope's angle across the axis of rolling. Radii come from derivatives at the contacts: the
 * bound of the rolling margin is an estimate and not proved.
 */
#ifndef smStability_h
#define smStability_h

#include "smGroundContact.h"
#include "smSupportPolygon.h"

#include <array>
#include <vector>

namespace sm
{
enum class Verdict
{
  Stable,
  Unstable,
  TooClose,
  NoContact,
  BelowGround,
  Unknown ///< there is no centre of mass, or no face
};

enum class SupportKind
{
  None,
  Point,
  Line,
  Area
};

struct StabilityCase
{
  /// Centre of mass in the ground's frame.
  std::array<double, 3> Center{};
  /// Bound of the distance from the true centre, a length; not finite: there is no centre.
  double CenterBound = 0.0;
  /// Unit vector against gravity; its h component is positive.
  std::array<double, 3> Up{ 0.0, 0.0, 1.0 };
  /// Enclosure of the height of the ground.
  HeightRange Ground{ 0.0, 0.0 };
  /// See ContactSearch::GetSize(), GetRounding() and GetResolution().
  double Size = 0.0;
  double Rounding = 0.0;
  double Resolution = 0.0;
  /// Contacts were searched within this distance of the ground, a length. A body whose projected centre
  /// misses the support by less counts as balanced.
  double Tolerance = 0.0;
};

struct StabilitySide
{
  Point2 From;
  Point2 To;
  /// Signed distance of the projected centre of mass from the side's line, in the ground's plane.
  double StabilityMargin;
  double StabilityMarginBound;
  /// Angle of the rotation until the body tips, in radians; negative: the centre is beyond the side already.
  double TipAngle;
  double TipAngleBound;
  /// Rise of the centre of mass, a length.
  double CenterOfMassRise;
  double CenterOfMassRiseBound;
};

struct StabilityResult
{
  Verdict Decision = Verdict::Unknown;
  SupportKind Support = SupportKind::None;
  /// True if the rolling margin decided because the stability margin could not.
  bool ByRolling = false;
  Point2 ProjectedCenter;
  double Height;
  double HeightBound;
  double StabilityMargin;
  double StabilityMarginBound;
  /// Minimum tip angle of all directions, in radians.
  double TipAngle;
  double TipAngleBound;
  double CenterOfMassRise;
  double CenterOfMassRiseBound;
  /// NaN unless the support is a point or a line.
  double RollingRadius;
  double RollingMargin;
  double RollingMarginBound;
  /// Support polygon of the certain contacts, counter-clockwise seen against the ground's normal; curved
  /// sides as chords, to a thousandth of the size.
  std::vector<Point2> Polygon;
  std::vector<StabilitySide> Sides;

  /// Sets all numbers to NaN.
  StabilityResult();
};

/// Computes the stability of a body. Refines its copy of `contacts` where the result depends on them.
StabilityResult ComputeStability(const StabilityCase& body, GroundContacts contacts);
}

#endif
