/**
 * @file smNativeShapes.h
 * @brief Native curves and surfaces for tests, in general position
 */
#ifndef smNativeShapes_h
#define smNativeShapes_h

#include "Geometry/smGeometryConversion.h"
#include "smTesting.h"
#include "smVector.h"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace smtest
{
/// Rounding of coordinates of about 10.
constexpr double Limit = 1e-13;

inline std::mt19937& GetRandom()
{
  static std::mt19937 random(11);
  return random;
}

inline double Uniform(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(GetRandom());
}

template <int Dimension>
double GetGap(const std::array<double, Dimension>& a, const std::array<double, Dimension>& b)
{
  double square = 0.0;
  for (int c = 0; c < Dimension; ++c)
  {
    square += (a[c] - b[c]) * (a[c] - b[c]);
  }
  return std::sqrt(square);
}

template <int Dimension>
sm::CurvePointer<Dimension> MakeCurve(typename sm::GeometricCurve<Dimension>::Variant value)
{
  std::string problem;
  const auto curve = sm::GeometricCurve<Dimension>::Make(std::move(value), problem);
  CheckEqual("the curve is consistent", "", problem);
  return curve;
}

inline sm::SurfacePointer MakeSurface(sm::GeometricSurface::Variant value)
{
  std::string problem;
  const auto surface = sm::GeometricSurface::Make(std::move(value), problem);
  CheckEqual("the surface is consistent", "", problem);
  return surface;
}

/// A frame in general position.
inline sm::GeometricFrame MakeFrame()
{
  sm::GeometricFrame frame;
  frame.Origin = { 3.0, -2.0, 1.0 };
  frame.Axes[2] = sm::Normalized<double>({ 0.3, -0.5, 0.8 });
  frame.Axes[0] = sm::Normalized(sm::Cross(frame.Axes[2], sm::Vector3{ 1.0, 0.7, 0.2 }));
  frame.Axes[1] = sm::Cross(frame.Axes[2], frame.Axes[0]);
  return frame;
}

template <int Dimension>
sm::ConicCurve<Dimension> MakeConic(typename sm::ConicCurve<Dimension>::Type kind, double a, double b)
{
  sm::ConicCurve<Dimension> conic;
  conic.Kind = kind;
  if constexpr (Dimension == 3)
  {
    const sm::GeometricFrame frame = MakeFrame();
    conic.Center = frame.Origin;
    conic.X = frame.Axes[0];
    conic.Y = frame.Axes[1];
  }
  else
  {
    conic.Center = { 0.5, -0.25 };
    conic.X = { 0.8, 0.6 };
    conic.Y = { -0.6, 0.8 };
  }
  conic.Radii[0] = a;
  conic.Radii[1] = b;
  return conic;
}

template <int Dimension>
sm::SplineCurve<Dimension> MakeSpline(bool isRational)
{
  sm::SplineCurve<Dimension> spline;
  spline.Basis.Degree = 3;
  spline.Basis.Knots = { 0.0, 1.0, 2.5, 4.0 };
  spline.Basis.Multiplicities = { 4, 1, 2, 4 };
  for (int i = 0; i < 7; ++i)
  {
    std::array<double, Dimension> pole{};
    for (double& x : pole)
    {
      x = Uniform(-2.0, 2.0);
    }
    pole[0] += 2.0 * i;
    spline.Poles.push_back(pole);
    if (isRational)
    {
      spline.Weights.push_back(Uniform(0.5, 2.0));
    }
  }
  return spline;
}

inline sm::ElementarySurface MakeElementary(sm::ElementarySurface::Type kind, double radius, double other)
{
  sm::ElementarySurface surface;
  surface.Kind = kind;
  surface.Frame = MakeFrame();
  surface.Radii[0] = radius;
  surface.Radii[1] = other;
  surface.Angle = 0.4;
  return surface;
}
}

#endif
