// Native curves and surfaces: definitions of ISO 10303-42 by formulas, derivatives by differences.
// TestSTEPSurfaces compares them with OpenCASCADE.
#include "Geometry/smCurveFoot.h"
#include "Geometry/smGeometryConversion.h"
#include "smNativeShapes.h"

#include <cmath>
#include <random>

namespace
{
using sm::Vector3;
using namespace smtest;

constexpr double AngleOfHalfTurn = 3.14159265358979323846;
/// Error of central differences with a step of 1e-5: its square times third derivatives, and rounding over
/// the step.
constexpr double DifferenceLimit = 2e-8;

/// Compares derivatives with central differences of those that are one order lower.
template <int Dimension>
void CheckDerivatives(const char* name, const sm::GeometricCurve<Dimension>& curve, double first, double last)
{
  double worst = 0.0;
  const double step = 1e-5;
  for (int i = 0; i < 40; ++i)
  {
    const double t = Uniform(first + step, last - step);
    typename sm::GeometricCurve<Dimension>::Derivatives d[3];
    const int order = curve.GetMaxOrder();
    for (int k = 0; k < 3; ++k)
    {
      curve.Evaluate(t + (k - 1) * step, order, d[k]);
    }
    for (int r = 0; r < order; ++r)
    {
      std::array<double, Dimension> slope;
      double size = 1.0;
      for (int c = 0; c < Dimension; ++c)
      {
        slope[c] = (d[2][r][c] - d[0][r][c]) / (2.0 * step);
        size = std::max({ size, std::abs(d[1][r][c]), std::abs(d[1][r + 1][c]), 100.0 * (r > 1) });
      }
      // A knot between the points spoils the highest derivatives.
      const bool isSmooth = curve.GetBreaks(t - step, t + step).size() == 2;
      worst = std::max(worst, isSmooth ? GetGap<Dimension>(slope, d[1][r + 1]) / size : 0.0);
    }
  }
  smtest::CheckRange(std::string(name) + ": derivatives", 0.0, worst, DifferenceLimit, "differences");
}

void CheckSlopes(const char* name, const sm::GeometricSurface& surface, const sm::NativeBox& box)
{
  double worst = 0.0;
  const double step = 1e-5;
  for (int i = 0; i < 40; ++i)
  {
    const double at[2] = { Uniform(box.Low[0] + step, box.High[0] - step),
      Uniform(box.Low[1] + step, box.High[1] - step) };
    sm::GeometricSurface::Derivatives here;
    const int order = surface.GetMaxOrder();
    surface.Evaluate(at[0], at[1], order, here);
    for (int d = 0; d < 2; ++d)
    {
      sm::GeometricSurface::Derivatives ends[2];
      for (int k = 0; k < 2; ++k)
      {
        const double move = k == 0 ? -step : step;
        surface.Evaluate(at[0] + (d == 0 ? move : 0.0), at[1] + (d == 1 ? move : 0.0), order, ends[k]);
      }
      for (int a = 0; a < order; ++a)
      {
        for (int b = 0; a + b < order; ++b)
        {
          Vector3 slope;
          const Vector3& exact = here[a + 1 - d][b + d];
          for (int c = 0; c < 3; ++c)
          {
            slope[c] = (ends[1][a][b][c] - ends[0][a][b][c]) / (2.0 * step);
          }
          worst = std::max(worst, GetGap<3>(slope, exact) / std::max(10.0, sm::Norm(exact)));
        }
      }
    }
  }
  smtest::CheckRange(std::string(name) + ": derivatives", 0.0, worst, DifferenceLimit, "differences");
}

template <int Dimension>
void TestCurves()
{
  using Shape = typename sm::ConicCurve<Dimension>::Type;
  const auto ellipse = MakeCurve<Dimension>(MakeConic<Dimension>(Shape::Ellipse, 2.0, 3.0));
  const auto parabola = MakeCurve<Dimension>(MakeConic<Dimension>(Shape::Parabola, 1.5, 1.5));
  const auto hyperbola = MakeCurve<Dimension>(MakeConic<Dimension>(Shape::Hyperbola, 1.5, 0.5));
  const auto spline = MakeCurve<Dimension>(MakeSpline<Dimension>(false));
  const auto rational = MakeCurve<Dimension>(MakeSpline<Dimension>(true));
  CheckDerivatives("ellipse", *ellipse, -3.0, 8.0);
  CheckDerivatives("parabola", *parabola, -3.0, 3.0);
  CheckDerivatives("hyperbola", *hyperbola, -2.0, 2.0);
  CheckDerivatives("spline", *spline, 0.0, 4.0);
  CheckDerivatives("rational spline", *rational, 0.0, 4.0);
  smtest::Check("period of an ellipse", 2.0 * AngleOfHalfTurn, ellipse->GetPeriod(), 0.0);
  smtest::Check("end of the spline's domain", 4.0, spline->GetDomain().High, 0.0);
  // Every point of the parabola is as far from the focus as from the directrix x = -f.
  double worst = 0.0;
  const auto conic = MakeConic<Dimension>(Shape::Parabola, 1.5, 1.5);
  for (const double t : { -3.0, -0.5, 0.0, 1.0, 4.0 })
  {
    const auto p = parabola->Evaluate(t);
    double x = 0.0;
    double y = 0.0;
    for (int c = 0; c < Dimension; ++c)
    {
      x += (p[c] - conic.Center[c]) * conic.X[c];
      y += (p[c] - conic.Center[c]) * conic.Y[c];
    }
    worst = std::max(worst, std::abs(std::hypot(x - 1.5, y) - (x + 1.5)));
  }
  smtest::CheckRange("focus and directrix", 0.0, worst, Limit, "rounding");
  // A foot is found from a point of the curve itself.
  for (const auto& curve : { ellipse, parabola, hyperbola, spline, rational })
  {
    constexpr double t = 0.7;
    smtest::Check("parameter of a point", t, sm::FindCurveParameter<Dimension>(*curve, curve->Evaluate(t)),
      1e-9, "the square root of rounding where the speed is small");
  }
  // A closed curve has its first and its last part near its end.
  sm::SplineCurve<Dimension> round;
  round.Basis.Degree = 2;
  round.Basis.Knots = { -1.0, 0.0, 1.0, 2.0, 3.0, 4.0 };
  round.Basis.Multiplicities = { 1, 2, 2, 2, 2, 1 };
  round.Weights = { 1.0, 0.5, 1.0, 0.5, 1.0, 0.5, 1.0 };
  const double height = 0.5 * std::sqrt(3.0);
  for (const auto& [x, y] : { std::make_pair(1.0, 0.0), { 1.0, 2.0 * height }, { -0.5, height },
         { -2.0, 0.0 }, { -0.5, -height }, { 1.0, -2.0 * height }, { 1.0, 0.0 } })
  {
    round.Poles.push_back({ x, y });
  }
  const auto circle = MakeCurve<Dimension>(round);
  for (const double angle : { -1.2, -0.3, -0.01, 0.01, 0.3 })
  {
    std::array<double, Dimension> p{};
    p[0] = std::cos(angle);
    p[1] = std::sin(angle);
    const double t = sm::FindCurveParameter<Dimension>(*circle, p);
    smtest::Check("foot on a closed curve", 0.0, GetGap<Dimension>(circle->Evaluate(t), p), 1e-9);
  }
  // Offsets keep their distance along the normal.
  sm::OffsetCurve<Dimension> offset{ rational, 0.3, {} };
  offset.Reference[Dimension - 1] = 1.0;
  const auto moved = MakeCurve<Dimension>(offset);
  CheckDerivatives("offset", *moved, 0.0, 4.0);
  typename sm::GeometricCurve<Dimension>::Derivatives d;
  rational->Evaluate(1.3, 1, d);
  const auto q = moved->Evaluate(1.3);
  double along = 0.0;
  for (int c = 0; c < Dimension; ++c)
  {
    along += (q[c] - d[0][c]) * d[1][c];
  }
  smtest::Check("distance of the offset", 0.3, GetGap<Dimension>(q, d[0]), Limit);
  smtest::Check("its direction is normal to the tangent", 0.0, along, 1e-12);
  // A composite of an arc against its sense, and a spline.
  sm::CompositeCurve<Dimension> composite;
  composite.Segments.push_back({ ellipse, 2.0, 1.0, 1.0 });
  composite.Segments.push_back({ spline, 0.0, 4.0, 2.0 });
  const auto whole = MakeCurve<Dimension>(composite);
  smtest::Check("length of the composite", 3.0, whole->GetDomain().High, 0.0);
  smtest::Check(
    "its first segment", 0.0, GetGap<Dimension>(whole->Evaluate(0.25), ellipse->Evaluate(1.75)), 0.0);
  smtest::Check(
    "its second segment", 0.0, GetGap<Dimension>(whole->Evaluate(2.0), spline->Evaluate(2.0)), 0.0);
  smtest::CheckEqual(
    "breaks at segments and knots", 5, static_cast<long long>(whole->GetBreaks(0.0, 3.0).size()));
  CheckDerivatives("composite, first segment", *whole, 0.0, 1.0);
  CheckDerivatives("composite, second segment", *whole, 1.0, 3.0);
}

/// In the plane a positive offset is to the left; in space it is along V x T.
void TestOffsetSides()
{
  const auto line = MakeCurve<2>(sm::LineCurve<2>{ { 0.0, 0.0 }, { 1.0, 0.0 } });
  smtest::Check("an offset in the plane is to the left", 0.0,
    GetGap<2>(MakeCurve<2>(sm::OffsetCurve<2>{ line, 0.5, {} })->Evaluate(2.0), { 2.0, 0.5 }), 0.0);
  const auto space = MakeCurve<3>(sm::LineCurve<3>{ {}, { 1.0, 0.0, 0.0 } });
  const auto offset = MakeCurve<3>(sm::OffsetCurve<3>{ space, 0.5, { 0.0, 0.0, 1.0 } });
  smtest::Check(
    "an offset in space is along V x T", 0.0, GetGap<3>(offset->Evaluate(2.0), { 2.0, 0.5, 0.0 }), 0.0);
}

/// The equation of the surface in its frame, 0 on it; lengths.
double GetEquation(const sm::ElementarySurface& s, const Vector3& point)
{
  using Shape = sm::ElementarySurface::Type;
  const Vector3 away = sm::Subtract(point, s.Frame.Origin);
  const double z = sm::Dot(away, s.Frame.Axes[2]);
  const double r = std::hypot(sm::Dot(away, s.Frame.Axes[0]), sm::Dot(away, s.Frame.Axes[1]));
  switch (s.Kind)
  {
    case Shape::Plane:
      return z;
    case Shape::Cylinder:
      return r - s.Radii[0];
    case Shape::Cone:
      return r - std::abs(s.Radii[0] + z * std::tan(s.Angle));
    case Shape::Sphere:
      return std::hypot(r, z) - s.Radii[0];
    default:
      return std::min(std::abs(std::hypot(r - s.Radii[0], z) - s.Radii[1]),
        std::abs(std::hypot(r + s.Radii[0], z) - s.Radii[1]));
  }
}

void TestElementary()
{
  using Shape = sm::ElementarySurface::Type;
  for (const Shape kind : { Shape::Plane, Shape::Cylinder, Shape::Cone, Shape::Sphere, Shape::Torus })
  {
    const sm::ElementarySurface value = MakeElementary(kind, 2.0, 0.5);
    const auto surface = MakeSurface(value);
    double worst = 0.0;
    for (int i = 0; i < 100; ++i)
    {
      worst = std::max(
        worst, std::abs(GetEquation(value, surface->Evaluate(Uniform(-4.0, 9.0), Uniform(-1.5, 1.5)))));
    }
    const std::string name = "elementary surface " + std::to_string(static_cast<int>(kind));
    smtest::CheckRange(name + ": equation", 0.0, worst, Limit, "rounding");
    CheckSlopes(name.c_str(), *surface, { { -1.0, -1.4 }, { 5.0, 1.4 } });
    sm::ConvertedSurface converted = sm::ConvertGeometry(*surface, { { 0.0, -1.2 }, { 6.0, 1.3 } }, {});
    double p[3];
    converted.Surface.Evaluate(converted.Map[0].Evaluate(4.4), converted.Map[1].Evaluate(0.3), p);
    smtest::Check(
      name + ": converted", 0.0, GetGap<3>({ p[0], p[1], p[2] }, surface->Evaluate(4.4, 0.3)), Limit);
  }
  // A lemon: the outer part and the inner part meet on the axis, and together are the whole circle.
  sm::ElementarySurface lemon = MakeElementary(Shape::Torus, 1.0, 2.0);
  lemon.Selected = sm::ElementarySurface::Part::Outer;
  const auto outer = MakeSurface(lemon);
  lemon.Selected = sm::ElementarySurface::Part::Inner;
  const auto inner = MakeSurface(lemon);
  smtest::Check(
    "the outer part ends on the axis", 2.0 * AngleOfHalfTurn / 3.0, outer->GetDomain(1).High, Limit);
  smtest::Check("where the inner part begins", outer->GetDomain(1).High, inner->GetDomain(1).Low, 0.0);
  smtest::Check("and closes the circle", 2.0 * AngleOfHalfTurn,
    inner->GetDomain(1).High - outer->GetDomain(1).Low, Limit);
  smtest::Check("neither is periodic", 0.0, outer->GetPeriod(1) + inner->GetPeriod(1), 0.0);
}

void TestSwept()
{
  using Shape = sm::ConicCurve<3>::Type;
  const auto ellipse = MakeCurve<3>(MakeConic<3>(Shape::Ellipse, 2.0, 3.0));
  const auto rational = MakeCurve<3>(MakeSpline<3>(true));
  sm::RevolvedSurface revolved{ rational, {}, { 1.0, 2.0, 0.0 }, sm::Normalized<double>({ 0.2, 0.1, 0.9 }) };
  const auto rotated = MakeSurface(revolved);
  CheckSlopes("revolved spline", *rotated, { { 0.0, 0.1 }, { 6.0, 0.9 } });
  const Vector3 p = rotated->Evaluate(1.1, 0.6);
  const Vector3 q = rational->Evaluate(0.6);
  const auto getHeight = [&](const Vector3& x)
  { return sm::Dot(sm::Subtract(x, revolved.Origin), revolved.Axis); };
  smtest::Check("a revolved point keeps its height", getHeight(q), getHeight(p), Limit);
  smtest::Check("and its distance", sm::Norm(sm::Subtract(q, revolved.Origin)),
    sm::Norm(sm::Subtract(p, revolved.Origin)), Limit);
  // The right-hand rule: about z from x to y.
  const auto line = MakeCurve<3>(sm::LineCurve<3>{ { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } });
  const auto drum = MakeSurface(sm::RevolvedSurface{ line, {}, {}, { 0.0, 0.0, 1.0 } });
  smtest::Check(
    "a quarter turn", 0.0, GetGap<3>(drum->Evaluate(0.5 * AngleOfHalfTurn, 1.0), { 0.0, 2.0, 1.0 }), Limit);
  sm::ExtrudedSurface extruded{ ellipse, { 1.0, 1.0 + 2.0 * AngleOfHalfTurn },
    sm::Normalized<double>({ 1.0, 2.0, 2.0 }) };
  const auto tube = MakeSurface(extruded);
  CheckSlopes("extruded ellipse", *tube, { { 0.0, -1.0 }, { 6.0, 1.0 } });
  smtest::Check(
    "a profile trimmed to a whole turn is periodic", 2.0 * AngleOfHalfTurn, tube->GetPeriod(0), 0.0);
  extruded.Range.High = 3.0;
  smtest::Check("a shorter one is not", 0.0, MakeSurface(extruded)->GetPeriod(0), 0.0);
  const auto thick = MakeSurface(sm::OffsetSurface{ tube, 0.25 });
  CheckSlopes("offset", *thick, { { 0.0, -1.0 }, { 6.0, 1.0 } });
  sm::GeometricSurface::Derivatives d;
  tube->Evaluate(2.0, 0.5, 1, d);
  const Vector3 normal = sm::Cross(d[1][0], d[0][1]);
  const Vector3 gap = sm::Subtract(thick->Evaluate(2.0, 0.5), d[0][0]);
  smtest::Check("the offset is along the normal", 0.25 * sm::Norm(normal), sm::Dot(gap, normal), 1e-12);
  const sm::ConvertedSurface fit = sm::ConvertGeometry(*thick, { { 0.5, 0.0 }, { 2.0, 1.0 } }, {});
  double r[3];
  fit.Surface.Evaluate(1.3, 0.4, r);
  smtest::CheckRange("a fitted offset", 0.0, GetGap<3>({ r[0], r[1], r[2] }, thick->Evaluate(1.3, 0.4)),
    fit.Surface.Residual + Limit, "its stated residual");
  // A curve on a surface, and a composite profile, which is fitted.
  const auto circle = MakeCurve<2>(MakeConic<2>(sm::ConicCurve<2>::Type::Ellipse, 0.3, 0.3));
  const auto onTube = MakeCurve<3>(sm::CurveOnSurface{ tube, circle });
  CheckDerivatives("curve on a surface", *onTube, 0.0, 6.0);
  std::string problem;
  smtest::CheckTrue("no curve on a surface in the plane",
    !sm::GeometricCurve<2>::Make(sm::CurveOnSurface{ tube, circle }, problem) && !problem.empty());
  sm::CompositeCurve<3> composite;
  composite.Segments.push_back({ ellipse, 2.0, 1.0, 1.0 });
  composite.Segments.push_back({ rational, 0.0, 4.0, 2.0 });
  const auto wall = MakeSurface(sm::ExtrudedSurface{ MakeCurve<3>(composite), {}, { 0.0, 0.0, 1.0 } });
  const sm::ConvertedSurface fitted = sm::ConvertGeometry(*wall, { { 0.0, 0.0 }, { 0.9, 1.0 } }, {});
  fitted.Surface.Evaluate(0.7, 0.5, r);
  smtest::CheckRange("an extruded composite", 0.0, GetGap<3>({ r[0], r[1], r[2] }, wall->Evaluate(0.7, 0.5)),
    fitted.Surface.Residual + Limit, "its stated residual");
}

/// A closed uniform cubic spline as a periodic one, against itself with all control points.
void TestPeriodicSpline()
{
  sm::SplineCurve<3> periodic;
  periodic.Basis.Degree = 3;
  periodic.Basis.Periodic = true;
  periodic.Basis.Knots = { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0 };
  periodic.Basis.Multiplicities.assign(6, 1);
  for (int i = 0; i < 5; ++i)
  {
    periodic.Poles.push_back({ Uniform(-2.0, 2.0), Uniform(-2.0, 2.0), Uniform(-2.0, 2.0) });
  }
  sm::SplineCurve<3> open = periodic;
  std::vector<double> flat;
  for (int k = -3; k <= 8; ++k)
  {
    flat.push_back(k);
  }
  open.Basis = sm::SplineBasis::MakeFromFlat(3, flat);
  // The first control point belongs to the first span.
  open.Poles.insert(open.Poles.end(), periodic.Poles.begin(), periodic.Poles.begin() + 3);
  const auto a = MakeCurve<3>(periodic);
  const auto b = MakeCurve<3>(open);
  smtest::Check("period", 5.0, a->GetPeriod(), 0.0);
  double worst = 0.0;
  for (const double t : { 0.0, 0.3, 1.7, 2.0, 4.9 })
  {
    worst = std::max({ worst, GetGap<3>(a->Evaluate(t), b->Evaluate(t)),
      GetGap<3>(a->Evaluate(t + 10.0), b->Evaluate(t)), GetGap<3>(a->Evaluate(t - 5.0), b->Evaluate(t)) });
  }
  smtest::CheckRange("a periodic spline in several turns", 0.0, worst, Limit, "rounding");
}

/// The parameter of a hyperbola against asinh to 17 digits, and where C libraries differ, to the bit.
void TestHyperbolaParameter()
{
  const double known[][2] = { { 0.0, 0.0 }, { 1e-9, 1e-9 }, { 0.09375, 0.093613211221128861 },
    { 1.0, 0.88137358701954303 }, { 3.0, 1.8184464592320668 }, { -0.5, -0.48121182505960345 },
    { 1e10, 23.718998110500402 } };
  for (const auto& [y, expected] : known)
  {
    // Two roundings, and those of the logarithm.
    smtest::Check(
      "asinh " + std::to_string(y), expected, sm::GetHyperbolaParameter(y), 3e-16 * std::abs(expected));
  }
  smtest::CheckTrue(
    "the same bits on every system", sm::GetHyperbolaParameter(0.09375) == 0x1.7f70910ab14f7p-4);
}
}

int TestGeometry(int, char*[])
{
  TestCurves<2>();
  TestCurves<3>();
  TestOffsetSides();
  TestElementary();
  TestSwept();
  TestPeriodicSpline();
  TestHyperbolaParameter();
  return smtest::Finish();
}
