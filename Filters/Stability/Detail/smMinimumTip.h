/**
 * @file smMinimumTip.h
 * @brief Rotation and rise of the centre of mass until a body tips, in one direction and the minimum over all
 * directions; not installed
 *
 * Formulas and frame: smStability.h. In a direction d of the ground's plane the body tips over the supporting
 * line of the polygon that is perpendicular to d. The distance of the centre from that line is m(d) =
 * (largest p.d of the polygon) - c.d, and the angle and the rise grow with m. So their minimum values over
 * all directions grow with the polygon: a polygon of certain contacts gives a lower bound, one that encloses
 * all possible contacts an upper bound. The minimum values over the sides alone do not grow with the polygon:
 * tangents of a curved contact correspond to corners of an inscribed polygon.
 */
#ifndef smMinimumTip_h
#define smMinimumTip_h

#include "smSupportPolygon.h"

#include <array>

namespace sm
{
struct Tip
{
  double Angle;
  double AngleBound;
  double Rise;
  double RiseBound;
};

/// Returns angle and rise for one side. m: distance of the centre from the side; z: its height; uv, uh:
/// components of the upward direction; `bound`: of the error of (m, z).
Tip ComputeTip(double m, double z, double uv, double uh, double bound);

/// The centre of mass over the ground, and the direction against gravity.
struct TipCase
{
  Point2 Center;
  double Height;
  std::array<double, 3> Up;
};

/// Enclosures of the minimum angle and the minimum rise.
struct MinimumTip
{
  double Angle[2];
  double Rise[2];
};

/// Extends the enclosures, which hold for the sides of the polygon, to all directions. Centre and polygon may
/// be off by `bound`, which is less than the height.
void IncludeCorners(const SupportPolygon& polygon, const TipCase& body, double bound, MinimumTip& minimum);
}

#endif
