#include "smExactSpline.h"

#include "smGaussRule.h"

#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>

namespace smtest
{
namespace
{
using Point = std::array<double, 2>;

struct SplineSample
{
  Real Position[2];
  /// With respect to the spline's parameter.
  Real Derivative[2];
};

/// De Boor's scheme in extended precision on the span [knot i, knot i + 1].
SplineSample Evaluate(const ClosedSpline& spline, std::size_t span, Real t)
{
  Real d[4][2];
  for (int j = 0; j < 4; ++j)
  {
    d[j][0] = spline.Poles[span - 3 + j][0];
    d[j][1] = spline.Poles[span - 3 + j][1];
  }
  SplineSample sample{};
  for (int level = 1; level <= 3; ++level)
  {
    if (level == 3)
    {
      const Real width = static_cast<Real>(spline.Knots[span + 1]) - spline.Knots[span];
      for (int c = 0; c < 2; ++c)
      {
        sample.Derivative[c] = 3 * (d[3][c] - d[2][c]) / width;
      }
    }
    for (int j = 3; j >= level; --j)
    {
      const Real low = spline.Knots[span - 3 + j];
      const Real high = spline.Knots[span + 1 + j - level];
      const Real x = (t - low) / (high - low);
      d[j][0] = (1 - x) * d[j - 1][0] + x * d[j][0];
      d[j][1] = (1 - x) * d[j - 1][1] + x * d[j][1];
    }
  }
  sample.Position[0] = d[3][0];
  sample.Position[1] = d[3][1];
  return sample;
}

template <typename Integrand>
Real Integrate(const ClosedSpline& spline, const GaussRule& rule, int pieces, Integrand&& f)
{
  Real sum = 0;
  for (std::size_t span = 3; span + 4 < spline.Knots.size(); ++span)
  {
    const Real start = spline.Knots[span];
    const Real width = (spline.Knots[span + 1] - start) / pieces;
    for (int piece = 0; piece < pieces && width > 0; ++piece)
    {
      for (std::size_t k = 0; k < rule.Nodes.size(); ++k)
      {
        const Real t = start + width * (piece + rule.Nodes[k]);
        sum += rule.Weights[k] * width * f(Evaluate(spline, span, t));
      }
    }
  }
  return sum;
}

double RoundedTo12Digits(double x)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.11e", x);
  return std::strtod(text, nullptr);
}

/// Poles of the uniform closed cubic spline through the points: (p_{i-1} + 4 p_i + p_{i+1}) / 6 = q_i.
/// Jacobi's iteration converges by a factor 2 a step.
std::vector<Point> SolveClosed(const std::vector<Point>& q)
{
  const std::size_t n = q.size();
  std::vector<Point> p = q;
  for (int iteration = 0; iteration < 80; ++iteration)
  {
    std::vector<Point> next(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      for (int c = 0; c < 2; ++c)
      {
        next[i][c] = (6 * q[i][c] - p[(i + n - 1) % n][c] - p[(i + 1) % n][c]) / 4;
      }
    }
    p.swap(next);
  }
  return p;
}
}

ClosedSpline InterpolateClosed(const std::vector<Point>& points)
{
  const std::vector<Point> p = SolveClosed(points);
  const int n = static_cast<int>(p.size());
  // Uniform to clamped: knot 0 inserted three times at the start, knot n at the end. By blossoms f(a,b,c) of
  // the first span, with pole f(i-1, i, i+1) of the uniform spline called p_i: f(0,0,0), f(0,0,1), f(0,1,2).
  auto pole = [&](int i) { return p[((i % n) + n) % n]; };
  auto mix = [](const Point& a, double wa, const Point& b, double wb, const Point& c, double wc) {
    return Point{ wa * a[0] + wb * b[0] + wc * c[0], wa * a[1] + wb * b[1] + wc * c[1] };
  };
  ClosedSpline spline;
  const Point seam = mix(pole(-1), 1.0 / 6, pole(0), 4.0 / 6, pole(1), 1.0 / 6);
  spline.Poles.push_back(seam);
  spline.Poles.push_back(mix(pole(0), 2.0 / 3, pole(1), 1.0 / 3, pole(0), 0));
  for (int i = 1; i < n; ++i)
  {
    spline.Poles.push_back(pole(i));
  }
  spline.Poles.push_back(mix(pole(n - 1), 1.0 / 3, pole(n), 2.0 / 3, pole(n), 0));
  spline.Poles.push_back(seam);
  for (Point& point : spline.Poles)
  {
    point = { RoundedTo12Digits(point[0]), RoundedTo12Digits(point[1]) };
  }
  spline.Knots = { 0, 0, 0 };
  for (int i = 0; i <= n; ++i)
  {
    spline.Knots.push_back(i);
  }
  spline.Knots.insert(spline.Knots.end(), 3, n);
  return spline;
}

Real ClosedSpline::GetRegionMoment(int a, int b) const
{
  // Green: integral of p^(a+1) q^b / (a+1) dq, a polynomial of degree 3 (a + b + 1) + 2 <= 23 on a span.
  static const GaussRule rule = MakeGaussRule(12);
  return Integrate(*this, rule, 1,
    [a, b](const SplineSample& s)
    {
      Real f = s.Derivative[1] / (a + 1);
      for (int i = 0; i <= a; ++i)
      {
        f *= s.Position[0];
      }
      for (int i = 0; i < b; ++i)
      {
        f *= s.Position[1];
      }
      return f;
    });
}

Real ClosedSpline::GetLengthMoment(int a) const
{
  static const GaussRule rule = MakeGaussRule(30);
  return Integrate(*this, rule, 8,
    [a](const SplineSample& s)
    { return std::hypot(s.Derivative[0], s.Derivative[1]) * (a == 0 ? Real(1) : s.Position[0]); });
}

ClosedSpline Airfoil(int count)
{
  // The circle passes 0.06 from the critical point, which rounds the trailing edge.
  const std::complex<double> center(-0.1, 0.08);
  const double radius = std::abs(std::complex<double>(1.0, 0.0) - center) + 0.06;
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    const std::complex<double> z = center + std::polar(radius, 2.0 * static_cast<double>(Pi) * i / count);
    const std::complex<double> w = 25.0 * (z + 1.0 / z);
    points.push_back({ w.real(), w.imag() });
  }
  return InterpolateClosed(points);
}

ClosedSpline Gear(int teeth)
{
  const int pointsPerTooth = 12;
  std::vector<Point> points;
  for (int i = 0; i < teeth * pointsPerTooth; ++i)
  {
    const double angle = 2.0 * static_cast<double>(Pi) * i / (teeth * pointsPerTooth);
    const double radius = 50.0 + 4.0 * std::tanh(2.0 * std::sin(teeth * angle)) / std::tanh(2.0);
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return InterpolateClosed(points);
}

ClosedSpline RingSection()
{
  const int count = 24;
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    const double t = 2.0 * static_cast<double>(Pi) * i / count;
    points.push_back(
      { 30.0 + 8.0 * std::cos(t) + 2.0 * std::cos(3.0 * t), 6.0 * std::sin(t) + std::sin(2.0 * t) });
  }
  return InterpolateClosed(points);
}

ExactMoments Extruded(const ClosedSpline& s, Real h)
{
  const Real a = s.GetRegionMoment(0, 0);
  const Real x = s.GetRegionMoment(1, 0);
  const Real y = s.GetRegionMoment(0, 1);
  Matrix second{};
  second[0][0] = h * s.GetRegionMoment(2, 0);
  second[1][1] = h * s.GetRegionMoment(0, 2);
  second[2][2] = a * h * h * h / 3;
  second[0][1] = second[1][0] = h * s.GetRegionMoment(1, 1);
  second[0][2] = second[2][0] = x * h * h / 2;
  second[1][2] = second[2][1] = y * h * h / 2;
  return FromOrigin(a * h, 2 * a + h * s.GetLengthMoment(0), { x * h, y * h, a * h * h / 2 }, second);
}

ExactMoments Revolved(const ClosedSpline& s)
{
  Matrix second{};
  second[0][0] = second[1][1] = Pi * s.GetRegionMoment(3, 0);
  second[2][2] = 2 * Pi * s.GetRegionMoment(1, 2);
  return FromOrigin(2 * Pi * s.GetRegionMoment(1, 0), 2 * Pi * s.GetLengthMoment(1),
    { 0, 0, 2 * Pi * s.GetRegionMoment(1, 1) }, second);
}
}
