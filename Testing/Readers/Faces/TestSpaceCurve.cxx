// Line integrals along curves of a file, against formulas.
#include "smSpaceCurve.h"
#include "smTesting.h"

#include <cmath>

namespace
{
constexpr double HalfTurn = 3.14159265358979323846;
constexpr double CurveLimit = 1e-10;

sm::SpaceCurve MakeEllipse(double a, double b)
{
  sm::SpaceCurve curve;
  curve.Kind = sm::SpaceCurve::Type::Ellipse;
  curve.Axes[0] = { 1.0, 0.0, 0.0 };
  curve.Axes[1] = { 0.0, 1.0, 0.0 };
  curve.Radii[0] = a;
  curve.Radii[1] = b;
  return curve;
}

/// The circle about z as a rational quadratic spline of four quarters from angle 0 on.
sm::SpaceCurve MakeSplineCircle(double radius)
{
  sm::SpaceCurve curve;
  curve.Kind = sm::SpaceCurve::Type::Spline;
  curve.Degree = 2;
  curve.Knots = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
  for (int i = 0; i < 9; ++i)
  {
    const double length = i % 2 == 0 ? radius : radius * std::sqrt(2.0);
    curve.Points.push_back(
      { length * std::cos(0.25 * HalfTurn * i), length * std::sin(0.25 * HalfTurn * i), 0.0 });
    curve.Weights.push_back(i % 2 == 0 ? 1.0 : std::sqrt(0.5));
  }
  return curve;
}

/// Closes a part of a curve by the straight line from its end to its start, and returns the vector area in z.
double GetArea(const sm::SpaceCurve& curve, const sm::Vector3& start, const sm::Vector3& end, bool isForward)
{
  sm::LineIntegrals sum;
  smtest::CheckTrue("the curve has the part", sm::IntegrateEdge(curve, start, end, isForward, sum));
  sum.AddSegment(sm::Subtract(end, start), { 0.0, 0.0, 0.0 });
  return sum.GetVectorArea()[2];
}

void TestConics()
{
  const sm::SpaceCurve circle = MakeEllipse(2.0, 2.0);
  const sm::Vector3 a{ 2.0, 0.0, 0.0 };
  const sm::Vector3 b{ 0.0, 2.0, 0.0 };
  const double segment = HalfTurn - 2.0;
  smtest::Check("whole circle", 4.0 * HalfTurn, GetArea(circle, a, a, true), CurveLimit);
  smtest::Check("whole circle backwards", -4.0 * HalfTurn, GetArea(circle, a, a, false), CurveLimit);
  smtest::Check("quarter", segment, GetArea(circle, a, b, true), CurveLimit);
  smtest::Check("quarter backwards", -segment, GetArea(circle, b, a, false), CurveLimit);
  smtest::Check(
    "the other three quarters", -(4.0 * HalfTurn - segment), GetArea(circle, a, b, false), CurveLimit);
  smtest::Check("whole ellipse", 6.0 * HalfTurn,
    GetArea(MakeEllipse(3.0, 2.0), { 3.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, true), CurveLimit);
  smtest::Check("vertex off the circle", 4.0 * HalfTurn,
    GetArea(circle, { 2.01, 0.0, 0.0 }, { 2.01, 0.0, 0.0 }, true), CurveLimit);

  sm::SpaceCurve parabola = MakeEllipse(0.25, 0.0);
  parabola.Kind = sm::SpaceCurve::Type::Parabola;
  // x = y^2 between y = -1 and 1, and the chord x = 1.
  smtest::Check(
    "parabola", -4.0 / 3.0, GetArea(parabola, { 1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.0 }, true), CurveLimit);
  sm::SpaceCurve hyperbola = MakeEllipse(1.0, 1.0);
  hyperbola.Kind = sm::SpaceCurve::Type::Hyperbola;
  const double t = 1.0;
  // Twice the triangle from the origin, less twice the sector t / 2.
  smtest::Check("hyperbola", -(std::cosh(t) * std::sinh(t) - t),
    GetArea(hyperbola, { std::cosh(t), -std::sinh(t), 0.0 }, { std::cosh(t), std::sinh(t), 0.0 }, true),
    CurveLimit);
}

void TestSplines()
{
  const sm::SpaceCurve circle = MakeSplineCircle(2.0);
  smtest::CheckTrue("the spline is consistent", circle.IsConsistent());
  const double segment = HalfTurn - 2.0;
  const sm::Vector3 a{ 2.0, 0.0, 0.0 };
  const sm::Vector3 b{ 0.0, 2.0, 0.0 };
  const sm::Vector3 c{ -2.0, 0.0, 0.0 };
  // Adaptive rules with a tolerance of 1e-9.
  const double limit = 1e-8;
  smtest::Check("whole spline", 4.0 * HalfTurn, GetArea(circle, a, a, true), limit);
  smtest::Check("whole spline from another vertex", 4.0 * HalfTurn, GetArea(circle, c, c, true), limit);
  smtest::Check("whole spline backwards", -4.0 * HalfTurn, GetArea(circle, a, a, false), limit);
  smtest::Check("first quarter", segment, GetArea(circle, a, b, true), limit);
  smtest::Check("inner quarter", segment, GetArea(circle, b, c, true), limit);
  smtest::Check("inner quarter backwards", -segment, GetArea(circle, c, b, false), limit);
  smtest::Check("across the seam", 4.0 * HalfTurn - segment, GetArea(circle, b, a, true), limit);
  smtest::Check("across the seam, two parts", 4.0 * HalfTurn - segment, GetArea(circle, c, b, true), limit);
  const double x = 2.0 * std::cos(0.3);
  const double y = 2.0 * std::sin(0.3);
  smtest::Check("from a point inside a span",
    2.0 * (0.5 * HalfTurn - 0.3) - 2.0 * std::sin(0.5 * HalfTurn - 0.3),
    GetArea(circle, { x, y, 0.0 }, b, true), limit);
  // A curve of degree 20, y = T_20(x) on [-1,1], above y = -1: its Bernstein coefficients by interpolation of
  // its monomials.
  sm::SpaceCurve wave;
  wave.Kind = sm::SpaceCurve::Type::Spline;
  wave.Degree = 20;
  wave.Knots.assign(21, 0.0);
  wave.Knots.insert(wave.Knots.end(), 21, 1.0);
  for (int i = 0; i <= 20; ++i)
  {
    // The coefficients of T_n(2 t - 1) are (-1)^(n-i) C(2n, 2i) / C(n, i).
    double value = i % 2 == 0 ? 1.0 : -1.0;
    for (int k = 0; k < 2 * i; ++k)
    {
      value *= (40.0 - k) / (k + 1.0);
    }
    for (int k = 0; k < i; ++k)
    {
      value /= (20.0 - k) / (k + 1.0);
    }
    wave.Points.push_back({ i / 10.0 - 1.0, value, 0.0 });
  }
  // The integral of T_20 is -2 / 399; the chord lies at y = 1, and the curve below it.
  smtest::Check("a curve of degree 20", 2.0 + 2.0 / 399.0, GetArea(wave, { -1, 1, 0 }, { 1, 1, 0 }, true),
    1e-7, "five points for a fortieth");
  // y = 1 / w(x) on [0,1] with w(x) = 1 + 3/2 (2 x - 1)^2, as a rational curve of degree 5 whose weights
  // differ by a factor of 3.6 only: ten points miss its integral by 9e-7.
  sm::SpaceCurve hill;
  hill.Kind = sm::SpaceCurve::Type::Spline;
  hill.Degree = 5;
  hill.Knots = { 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1 };
  hill.Weights = { 2.5, 1.3, 0.7, 0.7, 1.3, 2.5 };
  // Bernstein coefficients of x w(x).
  const double moments[6] = { 0.0, 0.5, 0.4, 0.3, 0.8, 2.5 };
  for (int i = 0; i <= 5; ++i)
  {
    hill.Points.push_back({ moments[i] / hill.Weights[i], 1.0 / hill.Weights[i], 0.0 });
  }
  smtest::Check("a rational curve of degree 5", 0.4 - std::atan(std::sqrt(1.5)) / std::sqrt(1.5),
    GetArea(hill, { 0.0, 0.4, 0.0 }, { 1.0, 0.4, 0.0 }, true), limit);
  sm::SpaceCurve broken = circle;
  broken.Knots.pop_back();
  smtest::CheckTrue("a spline with too few knots is none", !broken.IsConsistent());
}

/// The lateral face of a half cylinder: moments by Stokes against integrals over the face.
void TestMoments()
{
  const double r = 2.0;
  const double h = 3.0;
  const sm::SpaceCurve arc = MakeEllipse(r, r);
  const sm::Vector3 a{ r, 0.0, 0.0 };
  const sm::Vector3 b{ -r, 0.0, 0.0 };
  const auto integrate = [&](const sm::Vector3& origin)
  {
    sm::LineIntegrals edge;
    sm::IntegrateEdge(arc, a, b, true, edge);
    sm::LineIntegrals sum;
    sum.Add(edge, sm::Subtract(a, origin), 1.0);
    sum.Add(edge, sm::Subtract({ r, 0.0, h }, origin), -1.0);
    sum.AddSegment(sm::Subtract(b, origin), sm::Subtract({ -r, 0.0, h }, origin));
    sum.AddSegment(sm::Subtract({ r, 0.0, h }, origin), sm::Subtract(a, origin));
    return sum;
  };
  const sm::LineIntegrals sum = integrate({ 0.0, 0.0, 0.0 });
  // n = (cos, sin, 0), dA = r h dphi: the vector area is (0, 2 r h, 0).
  const sm::Vector3 area = sum.GetVectorArea();
  smtest::Check("vector area x", 0.0, area[0], CurveLimit);
  smtest::Check("vector area y", 2.0 * r * h, area[1], CurveLimit);
  smtest::Check("vector area z", 0.0, area[2], CurveLimit);
  // Integrals of n_i x_j: n_0 x_0 = n_1 x_1 = r^2 h pi / 2, n_1 x_2 = r h^2, others 0; without a third of the
  // trace.
  const double third = r * r * h * HalfTurn / 3.0;
  const double expected[3][3] = { { r * r * h * HalfTurn / 2.0 - third, 0.0, 0.0 },
    { 0.0, r * r * h * HalfTurn / 2.0 - third, r * h * h }, { 0.0, 0.0, -third } };
  const sm::Matrix3 moments = sum.GetMoments();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      smtest::Check("moment " + std::to_string(i) + std::to_string(j), expected[i][j], moments[i][j], 1e-9);
    }
  }
  // Another origin: moments change by the vector area times the shift.
  const sm::Matrix3 moved = integrate({ 1.0, 2.0, -5.0 }).GetMoments();
  smtest::Check("moved moment 12", expected[1][2] + 5.0 * area[1], moved[1][2], 1e-9);
  smtest::Check("moved moment 11", expected[1][1] - 2.0 * area[1] * 2.0 / 3.0, moved[1][1], 1e-9);
  // A rotation by a quarter about z, and a factor of 2.
  const sm::Matrix3 map{ sm::Vector3{ 0.0, -2.0, 0.0 }, sm::Vector3{ 2.0, 0.0, 0.0 },
    sm::Vector3{ 0.0, 0.0, 2.0 } };
  const sm::LineIntegrals mapped = sum.Map(map);
  smtest::Check("mapped vector area", -4.0 * area[1], mapped.GetVectorArea()[0], CurveLimit);
  smtest::Check("mapped moment 02", -8.0 * expected[1][2], mapped.GetMoments()[0][2], 1e-9);
  smtest::Check("mapped length", 2.0 * sum.Length, mapped.Length, CurveLimit);
}
}

int TestSpaceCurve(int, char*[])
{
  TestConics();
  TestSplines();
  TestMoments();
  return smtest::Finish();
}
