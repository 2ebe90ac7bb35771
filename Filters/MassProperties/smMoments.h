/**
 * @file smMoments.h
 * @brief Moments of order 0 to 2 with their bounds: moved, added, and turned into mass properties
 *
 * All inequalities are those of NUMERICS 6: exact as long as the bound of the volume is below the volume.
 */
#ifndef smMoments_h
#define smMoments_h

#include "smFiltersMassPropertiesModule.h"
#include <array>
#include <vector>

namespace sm
{
/// Symmetric second moments are stored as XX YY ZZ XY YZ XZ.
struct SMFILTERSMASSPROPERTIES_EXPORT Moments
{
  /// World point that first and second moments are about. Near the body, so that no digits are lost.
  std::array<double, 3> Reference{};
  /// How far the true point may be from Reference.
  double ReferenceBound = 0.0;
  double Volume = 0.0;
  std::array<double, 3> First{};
  std::array<double, 6> Second{};
  double VolumeBound = 0.0;
  std::array<double, 3> FirstBound{};
  std::array<double, 6> SecondBound{};

  /// Applies a row-major 4x4 placement (rotation or reflection, translation) to the body.
  void Place(const double placement[16]);
  /// Refers the moments to another world point.
  void MoveReference(const std::array<double, 3>& reference);
  /// Adds a body; it is moved to this one's reference.
  void Add(Moments other);
  /// All bodies together, about their common centre: the farther the reference, the larger the bounds. No bodies: zero.
  static Moments Sum(const std::vector<Moments>& bodies);
  /// All moments of a body turned inside out.
  void Negate();
};

/// What follows from the moments. NaN where it does not exist.
struct SMFILTERSMASSPROPERTIES_EXPORT MassProperties
{
  double Volume, VolumeBound;
  std::array<double, 3> Center;
  double CenterBound;
  std::array<double, 3> First;
  double FirstBound;
  std::array<double, 6> Second;
  double SecondBound;
  std::array<double, 9> Inertia;
  double InertiaBound;
  std::array<double, 9> InertiaAtOrigin;
  double InertiaAtOriginBound;
  std::array<double, 3> Principal;
  double PrincipalBound;
  std::array<double, 9> Axes;
  /// Largest angle (radians) that an axis may be off; NaN when axes are not determined.
  double AxesBound;
  bool AxesDegenerate;
  std::array<double, 3> Gyration;
  double GyrationBound;

  /// Everything NaN.
  MassProperties();
};

SMFILTERSMASSPROPERTIES_EXPORT MassProperties ComputeMassProperties(const Moments& moments);
}

#endif
