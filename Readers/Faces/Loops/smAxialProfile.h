/**
 * @file smAxialProfile.h
 * @brief The profile of a surface of revolution, as distance from the axis and height along it
 */
#ifndef smAxialProfile_h
#define smAxialProfile_h

#include "Geometry/smGeometricSurface.h"

#include <vector>

namespace sm
{
/// Returns a torus as the surface of revolution of its circle, or of a part of it, with the same parameters.
SMREADERSFACES_EXPORT SurfacePointer RevolveTorus(
  const ElementarySurface& torus, const ParameterRange& range = {});

/// A profile in the half-plane of its distance from an axis and its height along it.
class AxialProfile
{
public:
  struct Point
  {
    double Radius;
    double Height;
  };

  /// `surface` is a surface of revolution, which lives longer.
  explicit AxialProfile(const GeometricSurface& surface);

  bool IsFinite() const;
  double GetFirst() const { return this->First; }
  double GetLast() const { return this->Last; }
  /// Size of the half-plane's box that contains the profile and part of the axis.
  double GetExtent() const { return this->Extent; }

  Point Locate(const Vector3& point) const;
  Point Evaluate(double t) const { return this->Locate(this->Surface->Profile->Evaluate(t)); }

  /// Returns true if the profile meets the axis at a parameter.
  bool MeetsAxis(double t) const;

  /// Returns the parameters at which the profile meets the axis, ascending. Both ends of a periodic profile
  /// are one parameter, the first.
  std::vector<double> FindPoles() const;

  /// Returns the distance of a point from the part of the profile between two parameters.
  double GetDistance(const Point& point, double first, double last) const;

private:
  /// Returns the parameters inside of the profile at which it crosses or touches the axis, ascending, however
  /// near each other they are.
  std::vector<double> FindZeros() const;

  const RevolvedSurface* Surface;
  bool IsPeriodic;
  double First;
  double Last;
  double Extent = 0.0;
  std::vector<double> Parameters;
  std::vector<Point> Points;
};
}

#endif
