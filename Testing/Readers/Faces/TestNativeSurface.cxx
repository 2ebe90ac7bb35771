// Elementary surfaces are found in the B-splines that the reader makes of them, wherever they are, and what
// an edit deformed is none. The definitions of ISO 10303-42 are the truth: both have the same points.
#include "Geometry/smGeometryConversion.h"
#include "Geometry/smNativeSurface.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace native
{
namespace
{
using sm::Vector3;
using Type = sm::ElementarySurface::Type;

constexpr double Pi = 3.14159265358979323846;

std::mt19937& GetRandom()
{
  static std::mt19937 random(44);
  return random;
}

double Uniform(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(GetRandom());
}

sm::GeometricFrame MakeFrame(double distance)
{
  sm::GeometricFrame frame;
  frame.Origin = { distance, -0.4 * distance, Uniform(-1.0, 1.0) };
  frame.Axes[2] = sm::Normalized<double>({ Uniform(-1.0, 1.0), Uniform(-1.0, 1.0), Uniform(0.1, 1.0) });
  frame.Axes[0] = sm::Normalized(sm::Cross(frame.Axes[2], Vector3{ 1.0, Uniform(-0.5, 0.5), 0.0 }));
  frame.Axes[1] = sm::Cross(frame.Axes[2], frame.Axes[0]);
  return frame;
}

/// A uniform scale, a rotation and perhaps a reflection, as units and placements are.
sm::AffineMap MakeMap(double scale, bool isMirrored)
{
  sm::AffineMap map;
  const double turn = Uniform(0.0, 6.0);
  const double rows[3][3] = { { std::cos(turn), -std::sin(turn), 0.0 },
    { std::sin(turn), std::cos(turn), 0.0 }, { 0.0, 0.0, isMirrored ? -1.0 : 1.0 } };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      map.Linear[i][j] = scale * rows[i][j];
    }
    map.Translation[i] = Uniform(-1.0, 1.0);
  }
  return map;
}

struct Sample
{
  const char* Name;
  sm::ElementarySurface Surface;
  sm::NativeBox Box;
};

std::vector<Sample> MakeSamples(double distance)
{
  std::vector<Sample> samples;
  const auto add = [&](const char* name, Type kind, double r0, double r1, double angle, sm::NativeBox box)
  {
    sm::ElementarySurface surface;
    surface.Kind = kind;
    surface.Frame = MakeFrame(distance);
    surface.Radii[0] = r0;
    surface.Radii[1] = r1;
    surface.Angle = angle;
    samples.push_back({ name, surface, box });
  };
  add("plane", Type::Plane, 0.0, 0.0, 0.0, { { -3.0, 2.0 }, { 4.0, 9.0 } });
  add("cylinder", Type::Cylinder, 2.0, 0.0, 0.0, { { 0.0, -1.0 }, { 2.0 * Pi, 5.0 } });
  // Domains of faces whose loops go around more than once, and axes that a small circle would turn by more
  // than rounding.
  add("cylinder of two turns", Type::Cylinder, 2.0, 0.0, 0.0, { { -4.0, -1.0 }, { 8.5, 5.0 } });
  add("cone of two turns", Type::Cone, 2.0, 0.0, 0.4, { { -4.0, -1.0 }, { 8.5, 5.0 } });
  add("thin cylinder", Type::Cylinder, 0.02, 0.0, 0.0, { { 0.0, -40.0 }, { 1.6, 40.0 } });
  add("short arc of a cylinder", Type::Cylinder, 9.0, 0.0, 0.0, { { 1.0, -1.0 }, { 1.02, 5.0 } });
  add("low arc of a cylinder", Type::Cylinder, 9.0, 0.0, 0.0, { { 1.0, 0.0 }, { 3.0, 0.01 } });
  add("flat cone", Type::Cone, 9.0, 0.0, 1.5707955, { { 0.0, -1.0 }, { 2.0 * Pi, 5.0 } });
  add("part of a cylinder", Type::Cylinder, 2.0, 0.0, 0.0, { { -1.0, -1.0 }, { 0.3, 5.0 } });
  add("widening cone", Type::Cone, 2.0, 0.0, 0.4, { { 0.5, -1.0 }, { 4.5, 5.0 } });
  add("cone with its apex", Type::Cone, 2.0, 0.0, 0.4, { { 0.0, -2.0 / std::sin(0.4) }, { 2.0 * Pi, 1.0 } });
  add("narrowing cone", Type::Cone, 9.0, 0.0, -0.4, { { 0.5, -1.0 }, { 4.5, 5.0 } });
  add("sphere", Type::Sphere, 3.0, 0.0, 0.0, { { 0.0, -0.5 * Pi }, { 2.0 * Pi, 0.5 * Pi } });
  add("zone of a sphere", Type::Sphere, 3.0, 0.0, 0.0, { { 1.0, -0.3 }, { 2.5, 1.1 } });
  add("torus", Type::Torus, 5.0, 1.5, 0.0, { { 0.0, 0.0 }, { 2.0 * Pi, 2.0 * Pi } });
  // Small arcs, whose control points determine an axis with few digits.
  add("small part of a cone", Type::Cone, 9.0, 0.0, 0.4, { { 1.0, -0.01 }, { 1.02, 0.02 } });
  add("short arc of a cone", Type::Cone, 9.0, 0.0, 0.4, { { 1.0, -2.0 }, { 1.01, 5.0 } });
  add("small part of a sphere", Type::Sphere, 9.0, 0.0, 0.0, { { 1.0, -0.01 }, { 1.02, 0.02 } });
  add("small part of a torus", Type::Torus, 9.0, 1.5, 0.0, { { 1.0, 0.4 }, { 1.01, 0.42 } });
  add("short arc of a torus", Type::Torus, 30.0, 1.5, 0.0, { { 1.0, 0.0 }, { 1.01, 2.0 } });
  add("torus that crosses its axis, outside", Type::Torus, 2.0, 5.0, 0.0, { { 0.2, -1.0 }, { 4.2, 1.5 } });
  add("torus that crosses its axis, inside", Type::Torus, 2.0, 5.0, 0.0, { { 0.2, 2.2 }, { 4.2, 3.9 } });
  add("fillet of a torus", Type::Torus, 5.0, 1.5, 0.0, { { 0.2, 2.0 }, { 1.2, 3.5 } });
  return samples;
}

/// Returns the sample of that name at the origin.
Sample GetSample(const std::string& name)
{
  const std::vector<Sample> samples = MakeSamples(0.0);
  return *std::find_if(
    samples.begin(), samples.end(), [&name](const Sample& sample) { return name == sample.Name; });
}

/// Returns the largest distance of the points of a found surface from those of the B-spline.
double GetDistanceOf(const sm::NativeSurface& native, const sm::NURBSSurface& spline)
{
  std::string problem;
  const sm::SurfacePointer surface = sm::GeometricSurface::Make(native.Surface, problem);
  smtest::CheckEqual("the surface is consistent", "", problem);
  double distance = 0.0;
  for (int i = 0; surface && i <= 20; ++i)
  {
    for (int k = 0; k <= 20; ++k)
    {
      double at[2];
      for (int d = 0; d < 2; ++d)
      {
        at[d] = spline.GetDomainStart(d) +
          (d == 0 ? i : k) / 20.0 * (spline.GetDomainEnd(d) - spline.GetDomainStart(d));
      }
      Vector3 p;
      spline.Evaluate(at[0], at[1], p.data());
      const auto q = native.Map(at[0], at[1]);
      distance = std::max(distance, sm::GetDistance(p, surface->Evaluate(q[0], q[1])));
    }
  }
  return distance;
}

void TestFound(double distance, double scale, bool isMirrored)
{
  for (const Sample& sample : MakeSamples(distance))
  {
    const std::string name = std::string(sample.Name) + " at " + std::to_string(distance) +
      (isMirrored ? ", mirrored" : "") + ", scale " + std::to_string(scale);
    std::string problem;
    const auto surface = sm::GeometricSurface::Make(sample.Surface, problem);
    const sm::NURBSSurface spline =
      sm::ConvertGeometry(*surface, sample.Box, MakeMap(scale, isMirrored)).Surface;
    const auto native = sm::FindNativeSurface(spline);
    smtest::CheckTrue(name + ": found", native.has_value());
    if (!native)
    {
      continue;
    }
    smtest::CheckEqual(
      name + ": kind", static_cast<int>(sample.Surface.Kind), static_cast<int>(native->Surface.Kind));
    smtest::Check(name + ": points", 0.0, GetDistanceOf(*native, spline), 1e-13 * scale * (10.0 + distance),
      "rounding of coordinates and angles");
    for (int d = 0; d < 2 && sample.Surface.Kind != Type::Plane; ++d)
    {
      // The radius of a cone is that of its wider end.
      const double expected = sample.Surface.Kind == Type::Cone && d == 0 ? native->Surface.Radii[d]
                                                                          : scale * sample.Surface.Radii[d];
      const double arc = std::min(1.0, 10.0 * (sample.Box.High[0] - sample.Box.Low[0]));
      smtest::Check(name + ": radius", expected, native->Surface.Radii[d],
        1e-13 * scale * (10.0 + distance) / (arc * arc),
        "rounding of coordinates over the square of the arc");
    }
    const std::array<Vector3, 3>& axes = native->Surface.Frame.Axes;
    smtest::Check(
      name + ": right-handed", 1.0, sm::Dot(sm::Cross(axes[0], axes[1]), axes[2]), 1e-14, "unit vectors");
    // An edit of one control point, by far more than rounding and by far less than can be seen.
    for (const std::size_t k : { std::size_t(0), spline.ControlPoints.size() / 2 })
    {
      sm::NURBSSurface edited = spline;
      edited.ControlPoints[k][2] += 1e-9 * scale * (10.0 + distance);
      smtest::CheckTrue(name + ": none after an edit", !sm::FindNativeSurface(edited));
    }
  }
}

/// A trim curve that is straight, or not, in native parameters.
void TestTrims()
{
  std::string problem;
  const auto torus = sm::GeometricSurface::Make(GetSample("torus").Surface, problem);
  const sm::NURBSSurface spline =
    sm::ConvertGeometry(*torus, GetSample("torus").Box, sm::AffineMap()).Surface;
  const auto native = sm::FindNativeSurface(spline);
  sm::TrimCurve curve;
  curve.Breaks.push_back(2.0);
  const sm::TrimCurve::Point first[3] = { { 0.1, 0.2 }, { 0.5, 0.9 }, { 1.0, 1.0 } };
  const sm::TrimCurve::Point second[2] = { { 1.0, 1.0 }, { 1.8, 1.0 } };
  curve.AppendPiece(2.5, first, 2);
  curve.AppendPiece(4.0, second, 1);
  const auto mapped = native ? sm::MapTrim(curve, *native) : std::nullopt;
  smtest::CheckTrue("a trim curve is mapped", mapped.has_value());
  for (int i = 0; mapped && i <= 50; ++i)
  {
    const double t = 2.0 + 2.0 * i / 50.0;
    const auto p = curve.Evaluate(t);
    const auto expected = native->Map(p[0], p[1]);
    const auto actual = mapped->Evaluate(t);
    for (int d = 0; d < 2; ++d)
    {
      smtest::Check("its point", expected[d], actual[d], 1e-12, "fits of 4e-14, between their samples");
    }
  }
}

/// A curve around a cylinder whose height is 0 up to rounding, in native parameters.
void TestTrimAtOrigin()
{
  const Sample sample = GetSample("cylinder");
  std::string problem;
  const auto cylinder = sm::GeometricSurface::Make(sample.Surface, problem);
  const auto native =
    sm::FindNativeSurface(sm::ConvertGeometry(*cylinder, sample.Box, sm::AffineMap()).Surface);
  sm::TrimCurve curve;
  curve.Breaks.push_back(0.0);
  const sm::TrimCurve::Point points[3] = { { 0.1, -1.0 }, { 0.5, -0.99999999999999978 }, { 1.0, -1.0 } };
  curve.AppendPiece(1.0, points, 2);
  const auto mapped = native ? sm::MapTrim(curve, *native) : std::nullopt;
  smtest::CheckTrue("a height of rounding is fitted", mapped && mapped->GetNumberOfPieces() <= 4);
}

void TestCurves()
{
  const auto make = [](const std::function<Vector3(double)>& f, double low, double high)
  {
    // Bernstein coefficients of degree 1 between 400 points of the curve are exact for lines only; a circle
    // is fitted below.
    sm::EdgeCurve curve;
    curve.Breaks.push_back(low);
    const Vector3 ends[2] = { f(low), f(high) };
    curve.AppendPiece(high, ends, 1);
    return curve;
  };
  const auto line = sm::FindNativeCurve(make(
    [](double t) {
      return Vector3{ 1.0 + 2.0 * t, 3.0, -t };
    },
    0.5, 2.5));
  smtest::CheckTrue("a line", line && std::holds_alternative<sm::LineCurve<3>>(line->Curve));
  smtest::Check("its speed", std::sqrt(5.0), line ? line->Factor : 0.0, 1e-15, "rounding");
  for (const double turn : { 0.2, 2.0, 2.0 * Pi })
  {
    sm::ConicCurve<3> circle;
    circle.Center = { 3.0, 4.0, 5.0 };
    circle.X = { 0.0, 1.0, 0.0 };
    circle.Y = { 0.0, 0.0, 1.0 };
    circle.Radii[0] = circle.Radii[1] = 2.5;
    std::string problem;
    const auto value = sm::GeometricCurve<3>::Make(circle, problem);
    const auto found = sm::FindNativeCurve(sm::ConvertCurve(*value, 0.7, 0.7 + turn, MakeMap(1.0, false)));
    const auto* conic = found ? std::get_if<sm::ConicCurve<3>>(&found->Curve) : nullptr;
    smtest::CheckTrue("a circle", conic);
    smtest::Check("its radius", 2.5, conic ? conic->Radii[0] : 0.0, turn < 1.0 ? 1e-11 : 1e-13,
      "rounding over the square of the angle");
    smtest::Check("its angle per parameter", 1.0, found ? found->Factor : 0.0, turn < 1.0 ? 1e-11 : 1e-13,
      "rounding over the square of the angle");
    circle.Radii[1] = 2.5 * (1.0 + 1e-9);
    const auto ellipse = sm::GeometricCurve<3>::Make(circle, problem);
    smtest::CheckTrue("an ellipse is none",
      turn < 1.0 || !sm::FindNativeCurve(sm::ConvertCurve(*ellipse, 0.7, 0.7 + turn, sm::AffineMap())));
  }
}

void TestAll()
{
  for (const bool isMirrored : { false, true })
  {
    TestFound(0.0, 1.0, isMirrored);
    TestFound(50.0, 0.001, isMirrored);
    TestFound(1000.0, 25.4, isMirrored);
  }
  TestTrims();
  TestTrimAtOrigin();
  TestCurves();
}
}
}

int TestNativeSurface(int, char*[])
{
  native::TestAll();
  return smtest::Finish();
}
