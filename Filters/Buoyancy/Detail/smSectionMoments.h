/**
 * @file smSectionMoments.h
 * @brief Area, first and second moments of the section of bodies with a plane, and the centroid and central
 * moments that follow, with bounds
 */
#ifndef smSectionMoments_h
#define smSectionMoments_h

#include "smFiltersBuoyancyModule.h"

#include <array>

namespace sm
{
/// Centroid, and second moments about it, of a section. NaN where the area may be 0 by its bound.
struct SectionProperties
{
  /// World coordinates.
  std::array<double, 3> Centroid{};
  double CentroidBound = 0.0;
  /// Integrals of xx, yy, zz, xy, yz and xz about the centroid, along the world's axes; the bound is that of
  /// each.
  std::array<double, 6> Second{};
  double SecondBound = 0.0;
  /// Smallest and largest second moment about the centroid along a direction of the plane, and these
  /// directions in the world, NaN if the two may be equal by their bound.
  std::array<double, 2> Principal{};
  double PrincipalBound = 0.0;
  std::array<std::array<double, 3>, 2> Directions{};
};

/// Moments of a section about a point of its plane, in coordinates of the plane.
struct SMFILTERSBUOYANCY_EXPORT SectionMoments
{
  /// The point, and the directions of the coordinates, in the world.
  std::array<double, 3> Origin{};
  std::array<std::array<double, 3>, 2> Axes{};
  double Area = 0.0;
  double AreaBound = 0.0;
  std::array<double, 2> First{};
  std::array<double, 2> FirstBound{};
  /// Integrals of xx, yy and xy.
  std::array<double, 3> Second{};
  std::array<double, 3> SecondBound{};

  /// Adds the moments of another body in the same plane and with the same Axes, shifted to this Origin.
  void Add(const SectionMoments& other);
  SectionProperties ComputeProperties() const;
};
}

#endif
