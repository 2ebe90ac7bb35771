/**
 * @file smSTEPFrames.h
 * @brief Frames of a STEP file: placements and axes of operators, with the default values of ISO 10303-42
 */
#ifndef smSTEPFrames_h
#define smSTEPFrames_h

#include "smSTEPAttributes.h"
#include "smVector.h"

#include <array>

namespace sm
{

/// A rigid motion: unit vectors of its axes, and its origin.
struct STEPFrame
{
  std::array<Vector3, 3> Axes = { Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 },
    Vector3{ 0.0, 0.0, 1.0 } };
  Vector3 Origin = { 0.0, 0.0, 0.0 };
};

constexpr STEPAttribute RatiosOfDirection = { "DIRECTION", 0, 1, "direction ratios" };
constexpr STEPAttribute LocationOfPlacement = { "PLACEMENT", 0, 1, "location" };
constexpr STEPAttribute AxisOfPlacement = { "AXIS2_PLACEMENT_3D", 0, 2, "axis" };
constexpr STEPAttribute ReferenceOfPlacement = { "AXIS2_PLACEMENT_3D", 1, 3, "reference direction" };

/// Reads the unit vector of a DIRECTION in space; returns false if it has none.
bool ReadSTEPDirection(const STEPAttributes& entities, Part21File::Index direction, Vector3& unit);

/// The function first_proj_axis: the unit vector normal to the unit vector `z` that is nearest to
/// `reference`. By default that is the x axis, or the y axis if `z` is parallel to x. Returns false if
/// `reference` is parallel to `z`.
SMREADERSPART21_EXPORT bool ProjectFirstAxis(const Vector3& z, const Vector3* reference, Vector3& x);

/// The function base_axis: the axes of an operator of which some are given, others null. They may be a
/// reflection. Returns false if one is parallel to another; this may also be the default of y.
SMREADERSPART21_EXPORT bool MakeBaseAxes(
  const std::array<const Vector3*, 3>& given, std::array<Vector3, 3>& axes);

/// Reads an AXIS2_PLACEMENT_3D. Returns false if it is damaged or has no x axis.
SMREADERSPART21_EXPORT bool ReadSTEPFrame(
  const STEPAttributes& entities, Part21File::Index placement, STEPFrame& frame);
}

#endif
