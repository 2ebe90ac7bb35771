/**
 * @file smOCCTAxialProfile.h
 * @brief The profile of a surface of revolution, as distance from the axis and height along it
 */
#ifndef smOCCTAxialProfile_h
#define smOCCTAxialProfile_h

#include <Geom_Curve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Ax1.hxx>

#include <vector>

namespace sm
{
/// Returns the curve of which this one is a part, or a part of a part.
Handle(Geom_Curve) GetUntrimmed(Handle(Geom_Curve) curve);

/// Returns a torus as the surface of revolution of its circle, with the same parameters.
Handle(Geom_SurfaceOfRevolution) RevolveTorus(const Handle(Geom_ToroidalSurface) & torus);

/// A profile in the half-plane of its distance from an axis and its height along it.
class AxialProfile
{
public:
  struct Point
  {
    double Radius;
    double Height;
  };

  explicit AxialProfile(const Handle(Geom_SurfaceOfRevolution) & surface);

  bool IsFinite() const;
  double GetFirst() const { return this->First; }
  double GetLast() const { return this->Last; }
  /// Size of the half-plane's box that contains the profile and part of the axis.
  double GetExtent() const { return this->Extent; }

  Point Locate(const gp_Pnt& point) const;
  Point Evaluate(double t) const { return this->Locate(this->Curve->Value(t)); }

  /// Returns true if the profile meets the axis at a parameter.
  bool MeetsAxis(double t) const;

  /// Returns the parameters at which the profile meets the axis, ascending. Both ends of a periodic profile
  /// are one parameter, the first.
  std::vector<double> FindPoles() const;

  /// Returns the distance of a point from the part of the profile between two parameters.
  double GetDistance(const Point& point, double first, double last) const;

private:
  Handle(Geom_Curve) Curve;
  gp_Ax1 Axis;
  double First;
  double Last;
  double Extent = 0.0;
  std::vector<double> Parameters;
  std::vector<Point> Points;
};
}

#endif
