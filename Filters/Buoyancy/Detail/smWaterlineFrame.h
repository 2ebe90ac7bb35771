/**
 * @file smWaterlineFrame.h
 * @brief The plane of the waterline and, for each body, the coordinates in which heights above it are
 * integrated
 */
#ifndef smWaterlineFrame_h
#define smWaterlineFrame_h

#include "smBodyIntegrals.h"
#include "smSubmergedFace.h"

#include <array>

namespace sm
{
/// Plane of the waterline, by a point of it in world coordinates and its normal out of the water, of any
/// length but 0.
struct Waterline
{
  std::array<double, 3> Point{};
  std::array<double, 3> Up{};
};

/// Plane of the waterline and coordinate frame of the integrals, for one body.
struct WaterlineFrame
{
  /// Plane of the waterline in the model's coordinates.
  HeightPlane Plane;
  /// Transform from the model's coordinates to coordinates near the body with z = height.
  std::array<double, 12> Placement{};
  /// Directions of these x, y and z in the world, and the world position of their origin.
  std::array<std::array<double, 3>, 3> Axes{};
  std::array<double, 3> Origin{};
  /// World position of the origin's projection to the plane of the waterline, which moments of the section
  /// are about.
  std::array<double, 3> PlaneOrigin{};
  /// Middle of the body's box, in the model's coordinates and in the world's.
  std::array<double, 3> LocalMiddle{};
  std::array<double, 3> Middle{};
  /// Bound of the displacement of the body by rounding of its placement and by that of placing its points,
  /// and of the plane by rounding, against the body.
  double PlacementBound = 0.0;
  double PlaneBound = 0.0;
  /// Radius about the frame's origin within which all points of the body lie.
  double Reach = 0.0;

  /// The origin is near the body in the two directions across the normal, and in the plane along it.
  static WaterlineFrame Make(const BodyIntegrals& body, const Waterline& waterline);
  /// Moves plane and origin into the body. For a body that is entirely below the waterline any plane of this
  /// direction gives the same integrals; a plane through the body keeps the numbers small. PlaneOrigin stays
  /// on the waterline.
  void MoveToMiddle();
};
}

#endif
