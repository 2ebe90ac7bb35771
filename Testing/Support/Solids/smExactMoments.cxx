#include "smExactMoments.h"

#include <cmath>
#include <limits>

namespace smtest
{
namespace
{
constexpr Real Unknown = std::numeric_limits<Real>::quiet_NaN();

Matrix Diagonal(Real x, Real y, Real z)
{
  return { { { x, 0, 0 }, { 0, y, 0 }, { 0, 0, z } } };
}

Matrix Product(const Matrix& a, const Matrix& b)
{
  Matrix c{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        c[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return c;
}

Matrix Transposed(const Matrix& a)
{
  Matrix t{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      t[i][j] = a[j][i];
    }
  }
  return t;
}

/// A body symmetric about its centre, given by its central moments.
ExactMoments Symmetric(Real volume, Real area, const Vector& center, const Matrix& central)
{
  ExactMoments body;
  body.Volume = volume;
  body.Area = area;
  body.Center = center;
  body.Central = central;
  return body;
}

/// Integral over [0,1] of B_i B_j in the cubic Bernstein basis.
Real BernsteinProduct(int i, int j)
{
  const Real binomial3[] = { 1, 3, 3, 1 };
  const Real binomial6[] = { 1, 6, 15, 20, 15, 6, 1 };
  return binomial3[i] * binomial3[j] / binomial6[i + j] / 7;
}
}

Matrix ExactMoments::GetInertia() const
{
  const Real trace = this->Central[0][0] + this->Central[1][1] + this->Central[2][2];
  Matrix inertia = Diagonal(trace, trace, trace);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inertia[i][j] -= this->Central[i][j];
    }
  }
  return inertia;
}

Matrix ExactMoments::GetSecondMoments() const
{
  Matrix second = this->Central;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      second[i][j] += this->Volume * this->Center[i] * this->Center[j];
    }
  }
  return second;
}

ExactMoments FromOrigin(Real volume, Real area, const Vector& first, const Matrix& second)
{
  ExactMoments body;
  body.Volume = volume;
  body.Area = area;
  for (int i = 0; i < 3; ++i)
  {
    body.Center[i] = first[i] / volume;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      body.Central[i][j] = second[i][j] - first[i] * first[j] / volume;
    }
  }
  return body;
}

ExactMoments Moved(const ExactMoments& body, const Placement& placement)
{
  const Real s = placement.Scale;
  ExactMoments moved;
  moved.Volume = s * s * s * body.Volume;
  moved.Area = s * s * body.Area;
  moved.Central = Product(Product(placement.Rotation, body.Central), Transposed(placement.Rotation));
  for (int i = 0; i < 3; ++i)
  {
    moved.Center[i] = placement.Translation[i];
    for (int j = 0; j < 3; ++j)
    {
      moved.Center[i] += s * placement.Rotation[i][j] * body.Center[j];
      moved.Central[i][j] *= s * s * s * s * s;
    }
  }
  return moved;
}

ExactMoments Combined(const ExactMoments& a, const ExactMoments& b, int sign)
{
  Vector first{};
  Matrix second = a.GetSecondMoments();
  const Matrix secondB = b.GetSecondMoments();
  for (int i = 0; i < 3; ++i)
  {
    first[i] = a.Volume * a.Center[i] + sign * b.Volume * b.Center[i];
    for (int j = 0; j < 3; ++j)
    {
      second[i][j] += sign * secondB[i][j];
    }
  }
  return FromOrigin(a.Volume + sign * b.Volume, a.Area + b.Area, first, second);
}

ExactMoments Box(Real a, Real b, Real c)
{
  const Real v = a * b * c;
  return Symmetric(v, 2 * (a * b + b * c + c * a), { a / 2, b / 2, c / 2 },
    Diagonal(v * a * a / 12, v * b * b / 12, v * c * c / 12));
}

ExactMoments Cylinder(Real r, Real h)
{
  const Real v = Pi * r * r * h;
  return Symmetric(
    v, 2 * Pi * r * (r + h), { 0, 0, h / 2 }, Diagonal(v * r * r / 4, v * r * r / 4, v * h * h / 12));
}

ExactMoments ConeFrustum(Real r, Real t, Real h)
{
  // With radius rho(s) = r + (t - r) s at z = h s: integrals of pi rho^2, pi rho^2 z, pi rho^2 z^2, pi rho^4
  // / 4.
  const Real v = Pi * h * (r * r + r * t + t * t) / 3;
  const Real z1 = Pi * h * h * (r * r + 2 * r * t + 3 * t * t) / 12;
  const Real z2 = Pi * h * h * h * (r * r + 3 * r * t + 6 * t * t) / 30;
  const Real x2 =
    Pi * h * (r * r * r * r + r * r * r * t + r * r * t * t + r * t * t * t + t * t * t * t) / 20;
  const Real side = Pi * (r + t) * std::sqrt((r - t) * (r - t) + h * h);
  return FromOrigin(v, side + Pi * (r * r + t * t), { 0, 0, z1 }, Diagonal(x2, x2, z2));
}

ExactMoments Sphere(Real r)
{
  const Real v = 4 * Pi * r * r * r / 3;
  return Symmetric(v, 4 * Pi * r * r, { 0, 0, 0 }, Diagonal(v * r * r / 5, v * r * r / 5, v * r * r / 5));
}

ExactMoments Torus(Real major, Real minor)
{
  const Real v = 2 * Pi * Pi * major * minor * minor;
  const Real x2 = v * (4 * major * major + 3 * minor * minor) / 8;
  return Symmetric(v, 4 * Pi * Pi * major * minor, { 0, 0, 0 }, Diagonal(x2, x2, v * minor * minor / 4));
}

ExactMoments Ellipsoid(Real a, Real b, Real c)
{
  const Real v = 4 * Pi * a * b * c / 3;
  // Legendre: a > b > c, cos(phi) = c/a, k^2 = a^2 (b^2 - c^2) / (b^2 (a^2 - c^2)).
  const Real phi = std::acos(c / a);
  const Real k = a / b * std::sqrt((b * b - c * c) / (a * a - c * c));
  const Real area = 2 * Pi * c * c +
    2 * Pi * a * b / std::sin(phi) *
      (std::ellint_2(k, phi) * std::sin(phi) * std::sin(phi) + std::ellint_1(k, phi) * c * c / (a * a));
  return Symmetric(v, area, { 0, 0, 0 }, Diagonal(v * a * a / 5, v * b * b / 5, v * c * c / 5));
}

ExactMoments Bicylinder(Real r)
{
  // The section at height z is a square of half side s = sqrt(r^2 - z^2).
  const Real r5 = r * r * r * r * r;
  return Symmetric(
    16 * r * r * r / 3, 16 * r * r, { 0, 0, 0 }, Diagonal(64 * r5 / 45, 64 * r5 / 45, 16 * r5 / 15));
}

ExactMoments SlantedHole(Real a, Real b, Real c, Real r, Real x0, Real y0, Real tangent)
{
  // The hole's section at height z is an ellipse of half axes e = r sqrt(1 + tangent^2) and r about (x0 + z
  // tangent, y0).
  const Real slant = std::sqrt(1 + tangent * tangent);
  const Real e = r * slant;
  const Real section = Pi * e * r;
  const Real z1 = c * c / 2;
  const Real z2 = c * c * c / 3;
  const Real x1 = x0 * c + tangent * z1;
  const Real x2 = x0 * x0 * c + 2 * x0 * tangent * z1 + tangent * tangent * z2;
  const Real xz = x0 * z1 + tangent * z2;
  Matrix second{};
  second[0][0] = section * (x2 + c * e * e / 4);
  second[1][1] = section * c * (y0 * y0 + r * r / 4);
  second[2][2] = section * z2;
  second[0][1] = second[1][0] = section * y0 * x1;
  second[1][2] = second[2][1] = section * y0 * z1;
  second[0][2] = second[2][0] = section * xz;
  // Parallel cuts: the wall's area is circumference times length along the axis.
  const ExactMoments hole =
    FromOrigin(section * c, 2 * Pi * r * c * slant, { section * x1, section * y0 * c, section * z1 }, second);
  ExactMoments body = Combined(Box(a, b, c), hole, -1);
  body.Area -= 2 * section;
  return body;
}

ExactMoments ExtrudedGraph(Real a, Real b, const double heights[4][4], Real thickness)
{
  // z runs from h(x,y) to h + d: integrals of d, d x.., (h + d/2) d, ((h + d)^3 - h^3) / 3.
  const Real d = thickness;
  const Real ab = a * b;
  Real h = 0;
  Real hx = 0;
  Real hy = 0;
  Real hh = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      // Integral of s B_i(s) over [0,1] is (i + 1) / 20.
      h += heights[i][j] / 16.0L * ab;
      hx += heights[i][j] * (i + 1) / 80.0L * ab * a;
      hy += heights[i][j] * (j + 1) / 80.0L * ab * b;
      for (int k = 0; k < 4; ++k)
      {
        for (int l = 0; l < 4; ++l)
        {
          hh += static_cast<Real>(heights[i][j]) * heights[k][l] * BernsteinProduct(i, k) *
            BernsteinProduct(j, l) * ab;
        }
      }
    }
  }
  Matrix second{};
  second[0][0] = d * ab * a * a / 3;
  second[1][1] = d * ab * b * b / 3;
  second[2][2] = d * hh + d * d * h + d * d * d * ab / 3;
  second[0][1] = second[1][0] = d * ab * a * b / 4;
  second[0][2] = second[2][0] = d * hx + d * d / 2 * ab * a / 2;
  second[1][2] = second[2][1] = d * hy + d * d / 2 * ab * b / 2;
  return FromOrigin(ab * d, Unknown, { d * ab * a / 2, d * ab * b / 2, d * h + d * d * ab / 2 }, second);
}
}
