/**
 * @file smReferenceFrame.h
 * @brief Centre of mass and inertia about any point, in the directions of any axes
 */
#ifndef smReferenceFrame_h
#define smReferenceFrame_h

#include "smFiltersMassPropertiesModule.h"
#include "smMoments.h"

#include <array>

namespace sm
{
/// A right-handed frame in the world: z is ZAxis, x the part of XAxis that is perpendicular to it, y = z x x.
struct SMFILTERSMASSPROPERTIES_EXPORT ReferenceFrame
{
  bool IsGiven = false;
  std::array<double, 3> Origin{};
  std::array<double, 3> ZAxis{ 0.0, 0.0, 1.0 };
  std::array<double, 3> XAxis{ 1.0, 0.0, 0.0 };

  /// Returns true if the directions are finite, not 0, and at least 1e-6 radians from parallel.
  bool IsValid() const;
};

/// Mass properties in the coordinates of a frame, about its origin; a quantity that does not exist is NaN.
struct SMFILTERSMASSPROPERTIES_EXPORT FrameProperties
{
  std::array<double, 3> Center;
  double CenterBound;
  std::array<double, 9> Inertia;
  double InertiaBound;
  /// Inertia about the centre, with the axes of the frame.
  std::array<double, 9> CentralInertia;
  double CentralInertiaBound;

  /// Sets all values to NaN.
  FrameProperties();
};

/// The frame must be valid. The bounds include the rounding of its axes.
SMFILTERSMASSPROPERTIES_EXPORT FrameProperties ComputeInFrame(Moments moments, const ReferenceFrame& frame);
}

#endif
