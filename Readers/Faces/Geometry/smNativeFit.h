/**
 * @file smNativeFit.h
 * @brief The surface of revolution whose control points are closest to those of a B-spline
 */
#ifndef smNativeFit_h
#define smNativeFit_h

#include "smNativeSurface.h"

#include <array>
#include <vector>

namespace sm
{
/// A control point of a profile: radius and height, homogeneous.
struct ProfilePole
{
  double Radius = 0.0;
  double Height = 0.0;
  double Weight = 1.0;
};

/// Returns the control points of the profile of a cylinder, cone, sphere or torus, along its axis, for the
/// second parameter of the B-spline from `start` on: two, or an odd number for arcs.
std::vector<ProfilePole> MakeProfile(const NativeSurface& native, const std::array<double, 2>& domain);

/**
 * Changes frame, radii, angle and parameters of a cone, sphere or torus that is approximately the B-spline,
 * so that the squares of the distances of its control points have the smallest sum: Gauss's and Newton's
 * method in extended precision. Arcs of a small angle do not determine all of these well, but well enough for
 * the points.
 */
void FitNative(const NURBSSurface& surface, NativeSurface& native);
}

#endif
