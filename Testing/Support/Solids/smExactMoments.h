/**
 * @file smExactMoments.h
 * @brief Mass properties in closed form: the truth that the value tests compare with
 *
 * Unit density, extended precision. Lengths are millimetres.
 */
#ifndef smExactMoments_h
#define smExactMoments_h

#include <array>

namespace smtest
{
using Real = long double;
using Vector = std::array<Real, 3>;
using Matrix = std::array<Vector, 3>;

constexpr Real Pi = 3.14159265358979323846264338327950288L;

/// x -> Scale * Rotation * x + Translation. A rotation of determinant -1 mirrors.
struct Placement
{
  Matrix Rotation{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  Vector Translation{ 0, 0, 0 };
  Real Scale = 1;
};

struct ExactMoments
{
  Real Volume = 0;
  /// NaN: no closed form.
  Real Area = 0;
  Vector Center{ 0, 0, 0 };
  /// Integrals of (x - c)_i (x - c)_j over the volume.
  Matrix Central{};

  /// Inertia about the centre: trace(Central) - Central.
  Matrix GetInertia() const;
  /// Integrals of x_i x_j about the origin.
  Matrix GetSecondMoments() const;
};

/// From the integrals of 1, x_i and x_i x_j about the origin.
ExactMoments FromOrigin(Real volume, Real area, const Vector& first, const Matrix& second);

ExactMoments Moved(const ExactMoments& body, const Placement& placement);

/// The union of two bodies that do not overlap (sign +1), or a body less a part of it (sign -1). The area is
/// the sum in both cases: right when the boundaries do not meet.
ExactMoments Combined(const ExactMoments& a, const ExactMoments& b, int sign);

// Bodies. Corner or base at the origin, symmetry axis z, unless said otherwise.
ExactMoments Box(Real a, Real b, Real c);
ExactMoments Cylinder(Real radius, Real height);
ExactMoments ConeFrustum(Real bottomRadius, Real topRadius, Real height);
ExactMoments Sphere(Real radius);
ExactMoments Torus(Real majorRadius, Real minorRadius);
ExactMoments Ellipsoid(Real a, Real b, Real c);
/// x^2 + z^2 <= r^2 and y^2 + z^2 <= r^2 (Steinmetz): volume 16/3 r^3.
ExactMoments Bicylinder(Real radius);
/// The box a x b x c less a cylinder through (x0, y0, 0) along (tangent, 0, 1), which leaves through bottom
/// and top.
ExactMoments SlantedHole(Real a, Real b, Real c, Real radius, Real x0, Real y0, Real tangent);
/// The bicubic Bézier graph over [0,a] x [0,b] with heights z_ij (u index first), extruded by `thickness`
/// along z. Without its area, for which there is no closed form: NaN.
ExactMoments ExtrudedGraph(Real a, Real b, const double heights[4][4], Real thickness);
}

#endif
