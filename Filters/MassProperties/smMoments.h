/**
 * @file smMoments.h
 * @brief Moments of order 0 to 2 with bounds: their translation, their sums, and the mass properties that
 * follow from them
 *
 * The inequalities hold as long as the bound of the volume is below the volume.
 */
#ifndef smMoments_h
#define smMoments_h

#include "smFiltersMassPropertiesModule.h"
#include <array>
#include <vector>

namespace sm
{
/// Moments of a body. Symmetric second moments are stored as XX YY ZZ XY YZ XZ.
struct SMFILTERSMASSPROPERTIES_EXPORT Moments
{
  /// World point that first and second moments refer to. It should be near the body, as distance causes
  /// cancellation.
  std::array<double, 3> Reference{};
  /// Upper bound of the distance between the true reference point and Reference.
  double ReferenceBound = 0.0;
  double Volume = 0.0;
  std::array<double, 3> First{};
  std::array<double, 6> Second{};
  double VolumeBound = 0.0;
  std::array<double, 3> FirstBound{};
  std::array<double, 6> SecondBound{};

  /// Applies a row-major 4x4 placement (rotation or reflection, translation) to the body.
  void Place(const double placement[16]);
  /// Changes the reference of the moments to another world point.
  void MoveReference(const std::array<double, 3>& reference);
  /// Adds the moments of another body, after a change to this reference.
  void Add(Moments other);
  /// Returns the sum over all bodies about their common centre, as a distant reference would enlarge the
  /// bounds; zero for no bodies.
  static Moments Sum(const std::vector<Moments>& bodies);
  /// Negates all moments, as for a body whose orientation is reversed.
  void Negate();
};

/// Quantities that follow from the moments; NaN for a quantity that does not exist.
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
  /// Largest angular error of an axis in radians; NaN if the axes are not determined.
  double AxesBound;
  bool AxesDegenerate;
  std::array<double, 3> Gyration;
  double GyrationBound;

  /// Sets all values to NaN.
  MassProperties();
};

SMFILTERSMASSPROPERTIES_EXPORT MassProperties ComputeMassProperties(const Moments& moments);
}

#endif
