/**
 * @file smGeometricSurface.h
 * @brief Surfaces as a file defines them: immutable values
 *
 * The surfaces of ISO 10303-42, clause 4.5, as points and derivatives. Lengths are in one unit, angles in
 * radians; O, X, Y, Z are origin and axes of a placement.
 *
 * | value | definition in its natural parameters (s,t) | entity, and (s,t) for its parameters (u,v) |
 * |---|---|---|
 * | ElementarySurface, plane | O + s X + t Y | plane: (u,v) |
 * | cylinder | O + R (cos s X + sin s Y) + t Z | cylindrical_surface: (u,v) |
 * | cone | O + (R + t sin a)(cos s X + sin s Y) + t cos a Z | conical_surface: (u, v / cos a) |
 * | sphere | O + R cos t (cos s X + sin s Y) + R sin t Z | spherical_surface: (u,v) |
 * | torus | O + (R + r cos t)(cos s X + sin s Y) + r sin t Z | (degenerate_)toroidal_surface: (u,v) |
 * | ExtrudedSurface | C(s) + t D, D a unit vector | surface_of_linear_extrusion: v times its length |
 * | RevolvedSurface | C(t) rotated by s about the axis | surface_of_revolution |
 * | SplineSurface | sum N_i(s) N_j(t) w_ij P_ij / sum N_i(s) N_j(t) w_ij | b_spline_surface: (u,v) |
 * | OffsetSurface | B(s,t) + d n, n the unit vector of B_s x B_t | offset_surface: those of the basis |
 *
 * The parameter along a swept curve is that of the curve. A rectangular_trimmed_surface or
 * curve_bounded_surface is its basis over a part of the domain, a surface_replica the transformed value.
 */
#ifndef smGeometricSurface_h
#define smGeometricSurface_h

#include "smGeometricCurve.h"
#include "smVector.h"

namespace sm
{
class GeometricSurface;
using SurfacePointer = std::shared_ptr<const GeometricSurface>;

/// Unit vectors of axes, and an origin. The axes may be left-handed: a mirrored placement.
struct GeometricFrame
{
  Vector3 Origin{};
  std::array<Vector3, 3> Axes = { Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 },
    Vector3{ 0.0, 0.0, 1.0 } };
};

struct ElementarySurface
{
  enum class Type : unsigned char
  {
    Plane,
    Cylinder,
    Cone,
    Sphere,
    Torus
  };
  /// Part of a torus whose radius is less than the minor one: it crosses its axis. Whole: both parts.
  enum class Part : unsigned char
  {
    Whole,
    Outer,
    Inner
  };
  Type Kind = Type::Plane;
  GeometricFrame Frame;
  /// Radius, and the minor radius of a torus. The radius of a cone may be 0, the major radius of a torus may
  /// be less than the minor one.
  double Radii[2] = { 0.0, 0.0 };
  /// Half the opening of a cone.
  double Angle = 0.0;
  Part Selected = Part::Whole;
};

struct ExtrudedSurface
{
  CurvePointer<3> Profile;
  /// Part of the profile.
  ParameterRange Range;
  Vector3 Direction{};
};

struct RevolvedSurface
{
  CurvePointer<3> Profile;
  /// Part of the profile.
  ParameterRange Range;
  Vector3 Origin{};
  /// A unit vector; s is positive by the right-hand rule.
  Vector3 Axis{};
};

struct SplineSurface
{
  SplineBasis Basis[2];
  /// First index fastest: pole i + j * Basis[0].GetCount().
  std::vector<Vector3> Poles;
  /// Positive; empty for a polynomial surface.
  std::vector<double> Weights;
};

struct OffsetSurface
{
  /// Not an offset surface: two offsets are one.
  SurfacePointer Basis;
  double Distance = 0.0;
};

/// Immutable. Const methods may be called by several threads.
class SMREADERSFACES_EXPORT GeometricSurface
{
public:
  using Variant =
    std::variant<ElementarySurface, ExtrudedSurface, RevolvedSurface, SplineSurface, OffsetSurface>;

  /// Point and partial derivatives: [i][j] is derived i times to s and j times to t.
  using Derivatives = std::array<std::array<Vector3, 3>, 3>;

  /// Makes a surface; null, with a short reason, if the value is not consistent.
  static SurfacePointer Make(Variant value, std::string& problem);

  const Variant& GetValue() const { return this->Value; }
  template <class T>
  const T* GetIf() const
  {
    return std::get_if<T>(&this->Value);
  }

  Vector3 Evaluate(double s, double t) const;
  /// Evaluates the derivatives with i + j <= order, at most GetMaxOrder(). They are NaN where an offset
  /// has no normal.
  void Evaluate(double s, double t, int order, Derivatives& result) const;
  /// 2; 1 for an offset surface, or along a curve that has no more.
  int GetMaxOrder() const { return this->MaxOrder; }

  /// Returns the natural domain of a direction: a whole turn from 0 for angles, -90 to 90 degrees for the
  /// latitude of a sphere, else infinite or that of the spline or curve.
  const ParameterRange& GetDomain(int direction) const { return this->Domain[direction]; }
  /// Returns the period of a direction; 0: not periodic.
  double GetPeriod(int direction) const { return this->Period[direction]; }
  /// Returns the parameters between `first` and `last` at which the surface may not be smooth, and both ends.
  std::vector<double> GetBreaks(int direction, double first, double last) const;

private:
  explicit GeometricSurface(Variant value)
    : Value(std::move(value))
  {
  }
  std::string Complete();

  Variant Value;
  ParameterRange Domain[2];
  double Period[2] = { 0.0, 0.0 };
  int MaxOrder = 2;
};

/// Returns an elementary surface of this kind; null for any other surface.
inline const ElementarySurface* FindElementary(const GeometricSurface& surface, ElementarySurface::Type kind)
{
  const auto* elementary = surface.GetIf<ElementarySurface>();
  return elementary && elementary->Kind == kind ? elementary : nullptr;
}
}

#endif
