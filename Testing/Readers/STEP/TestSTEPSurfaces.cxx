/**
 * @file TestSTEPSurfaces.cxx
 * @brief Every surface and curve type: our B-spline at mapped parameters against OpenCASCADE's own evaluation
 */
#include "Geometry/smGeometryConversion.h"
#include "Geometry/smPeriodicSurface.h"
#include "Geometry/smSurfaceConversion.h"
#include "Trims/smTrimConversion.h"
#include "smTesting.h"

#include "smOCCTGeometry.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
std::mt19937& GetRandom()
{
  static std::mt19937 random(7);
  return random;
}

double Uniform(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(GetRandom());
}

gp_Pnt RandomPoint()
{
  return gp_Pnt(Uniform(-5.0, 5.0), Uniform(-5.0, 5.0), Uniform(-5.0, 5.0));
}

/// A frame in general position; left-handed on request.
gp_Ax3 MakeFrame(bool direct)
{
  gp_Ax3 frame(gp_Pnt(3.0, -2.0, 7.0), gp_Dir(0.3, -0.5, 0.8), gp_Dir(1.0, 0.7, 0.2));
  if (!direct)
  {
    frame.YReverse();
  }
  return frame;
}

sm::AffineMap MakeMap(bool mirrored)
{
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 1.0, -0.4)), 0.83);
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0.5, 0.0, -1.0), gp_Dir(0.2, 0.9, 0.3)));
  const double origin[3] = { 1.5, -4.25, 2.0 };
  return sm::AffineMap::Make(mirrored ? turn * mirror : turn, 1.0 / 25.4, origin);
}

/// 13 digits: OpenCASCADE's own rounding in coordinates of about 10.
constexpr double SurfaceLimit = 1e-13;

double GetKernelDistance(const sm::Vector3& a, const gp_XYZ& b)
{
  return std::hypot(a[0] - b.X(), a[1] - b.Y(), a[2] - b.Z());
}

/// Values of derivatives are up to about 100, of second ones more.
constexpr double DerivativeLimit = 1e-12;

/// The native value has the points and derivatives that OpenCASCADE evaluates.
void CheckValue(const char* name, const Handle(Geom_Surface) & surface, const sm::NativeBox& box)
{
  const sm::SurfacePointer value = sm::MakeGeometry(surface);
  double worst[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; value && i < 100; ++i)
  {
    const double u = Uniform(box.Low[0], box.High[0]);
    const double v = Uniform(box.Low[1], box.High[1]);
    gp_Pnt p;
    gp_Vec d[5];
    surface->D2(u, v, p, d[0], d[1], d[2], d[3], d[4]);
    sm::GeometricSurface::Derivatives own;
    const int order = value->GetLargestOrder();
    value->Evaluate(u, v, order, own);
    worst[0] = std::max(worst[0], GetKernelDistance(own[0][0], p.XYZ()));
    const double slope = std::max({ 1.0, d[0].Magnitude(), d[1].Magnitude() });
    worst[1] = std::max({ worst[1], GetKernelDistance(own[1][0], d[0].XYZ()) / slope,
      GetKernelDistance(own[0][1], d[1].XYZ()) / slope });
    if (order == 2)
    {
      const double bend = std::max({ slope, d[2].Magnitude(), d[3].Magnitude(), d[4].Magnitude() });
      worst[2] = std::max({ worst[2], GetKernelDistance(own[2][0], d[2].XYZ()) / bend,
        GetKernelDistance(own[0][2], d[3].XYZ()) / bend, GetKernelDistance(own[1][1], d[4].XYZ()) / bend });
    }
  }
  smtest::CheckTrue(std::string(name) + " is a value", value != nullptr);
  smtest::CheckRange(std::string(name) + " point", 0.0, worst[0], DerivativeLimit, "rounding of both");
  smtest::CheckRange(std::string(name) + " slopes", 0.0, worst[1], DerivativeLimit, "rounding of both");
  // An offset has first derivatives only.
  smtest::CheckRange(
    std::string(name) + " second derivatives", 0.0, worst[2], DerivativeLimit, "rounding of both");
}

/// The same for a curve.
void CheckValue(const char* name, const Handle(Geom_Curve) & curve, double first, double last)
{
  const sm::CurvePointer<3> value = sm::MakeGeometry(curve);
  double worst[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int i = 0; value && i < 100; ++i)
  {
    const double t = Uniform(first, last);
    gp_Pnt p;
    gp_Vec d[3];
    curve->D3(t, p, d[0], d[1], d[2]);
    sm::GeometricCurve<3>::Derivatives own;
    const int order = value->GetLargestOrder();
    value->Evaluate(t, order, own);
    worst[0] = std::max(worst[0], GetKernelDistance(own[0], p.XYZ()));
    double size = 1.0;
    for (int k = 1; k <= order; ++k)
    {
      size = std::max(size, d[k - 1].Magnitude());
      worst[k] = std::max(worst[k], GetKernelDistance(own[k], d[k - 1].XYZ()) / size);
    }
  }
  smtest::CheckTrue(std::string("edge: ") + name + " is a value", value != nullptr);
  for (int k = 0; k < 4; ++k)
  {
    smtest::CheckRange(std::string("edge: ") + name + " derivative " + std::to_string(k), 0.0, worst[k],
      DerivativeLimit, "rounding of both");
  }
}

void CheckSurface(const char* name, const Handle(Geom_Surface) & surface, double u0, double u1, double v0,
  double v1, double residual = 0.0)
{
  const sm::NativeBox box{ { u0, v0 }, { u1, v1 } };
  CheckValue(name, surface, box);
  for (const bool mirrored : { false, true })
  {
    const sm::AffineMap map = MakeMap(mirrored);
    const sm::SurfacePointer value = sm::MakeGeometry(surface);
    const sm::ConvertedSurface converted = sm::ConvertSurface(value, box, map);
    const sm::ConvertedSurface native = sm::ConvertGeometry(*value, box, map);
    double worst = 0.0;
    double worstNative = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      const double u = i % 20 == 0 ? u0 : i % 20 == 1 ? u1 : Uniform(u0, u1);
      const double v = i / 20 == 0 ? v0 : i / 20 == 1 ? v1 : Uniform(v0, v1);
      const sm::Vector3 expected = map.MapPoint(surface->Value(u, v).XYZ());
      double p[3];
      converted.Surface.Evaluate(converted.Map[0].Evaluate(u), converted.Map[1].Evaluate(v), p);
      worst = std::max(worst, std::hypot(p[0] - expected[0], p[1] - expected[1], p[2] - expected[2]));
      native.Surface.Evaluate(native.Map[0].Evaluate(u), native.Map[1].Evaluate(v), p);
      worstNative =
        std::max(worstNative, std::hypot(p[0] - expected[0], p[1] - expected[1], p[2] - expected[2]));
    }
    smtest::CheckRange(std::string(name) + (mirrored ? " mirrored" : ""), 0.0, worst, SurfaceLimit + residual,
      "rounding of coordinates of about 1");
    smtest::CheckRange(std::string(name) + (mirrored ? " mirrored" : "") + ", of the value alone", 0.0,
      worstNative, SurfaceLimit + native.Surface.Residual, "the same");
    smtest::CheckRange(std::string(name) + " stated residual", 0.0, converted.Surface.Residual, residual);
    smtest::CheckEqual(std::string(name) + " is consistent", "", converted.Surface.Check());
  }
}

Handle(Geom_BSplineCurve) MakeSpline(bool periodic, bool rational)
{
  TColStd_Array1OfReal knots(1, 5);
  TColStd_Array1OfInteger multiplicities(1, 5);
  const double values[] = { 0.0, 1.0, 2.5, 3.0, 4.5 };
  int poles = 0;
  for (int i = 1; i <= 5; ++i)
  {
    knots(i) = values[i - 1];
    multiplicities(i) = i == 1 || i == 5 ? (periodic ? 2 : 4) : (i == 3 ? 2 : 1);
    poles += i < 5 || !periodic ? multiplicities(i) : 0;
  }
  poles -= periodic ? 0 : 4;
  TColgp_Array1OfPnt points(1, poles);
  TColStd_Array1OfReal weights(1, poles);
  for (int i = 1; i <= poles; ++i)
  {
    points(i) = RandomPoint();
    weights(i) = rational ? Uniform(0.5, 2.0) : 1.0;
  }
  return new Geom_BSplineCurve(points, weights, knots, multiplicities, 3, periodic);
}

Handle(Geom_BSplineSurface) MakeSplineSurface(bool periodicU, bool periodicV, bool rational)
{
  const Handle(Geom_BSplineCurve) u = MakeSpline(periodicU, false);
  const Handle(Geom_BSplineCurve) v = MakeSpline(periodicV, false);
  TColgp_Array2OfPnt poles(1, u->NbPoles(), 1, v->NbPoles());
  TColStd_Array2OfReal weights(1, u->NbPoles(), 1, v->NbPoles());
  for (int i = 1; i <= u->NbPoles(); ++i)
  {
    for (int j = 1; j <= v->NbPoles(); ++j)
    {
      poles(i, j) = RandomPoint();
      weights(i, j) = rational ? Uniform(0.5, 2.0) : 1.0;
    }
  }
  return new Geom_BSplineSurface(poles, weights, u->Knots(), v->Knots(), u->Multiplicities(),
    v->Multiplicities(), 3, 3, periodicU, periodicV);
}

void CheckSurfaces()
{
  const double pi = std::acos(-1.0);
  for (const bool direct : { true, false })
  {
    const gp_Ax3 frame = MakeFrame(direct);
    CheckSurface("plane", new Geom_Plane(frame), -3.0, 4.0, 1.0, 9.0);
    CheckSurface("cylinder", new Geom_CylindricalSurface(frame, 2.5), 0.0, 2.0 * pi, -3.0, 4.0);
    CheckSurface("narrow cylinder", new Geom_CylindricalSurface(frame, 2.5), 5.0, 5.3, -3.0, 4.0);
    CheckSurface("cone", new Geom_ConicalSurface(frame, 0.4, 2.0), 1.0, 6.5, -2.0 / std::sin(0.4), 3.0);
    CheckSurface("sphere", new Geom_SphericalSurface(frame, 3.0), 0.0, 2.0 * pi, -0.5 * pi, 0.5 * pi);
    CheckSurface("sphere cap", new Geom_SphericalSurface(frame, 3.0), -2.0, 1.0, 0.3, 0.5 * pi);
    CheckSurface("torus", new Geom_ToroidalSurface(frame, 4.0, 1.5), 0.0, 2.0 * pi, 0.0, 2.0 * pi);
    CheckSurface("lemon torus", new Geom_ToroidalSurface(frame, 1.0, 1.5), 0.2, 3.0, -2.0, 2.0);
  }
  const gp_Ax1 axis(gp_Pnt(1.0, 1.0, -2.0), gp_Dir(0.2, 0.1, 0.9));
  const gp_Dir along(0.6, -0.3, 0.7);
  const gp_Ax2 conic(gp_Pnt(2.0, 3.0, 1.0), gp_Dir(0.5, 0.1, 0.8), gp_Dir(0.3, 1.0, 0.0));
  const Handle(Geom_Curve) spline = MakeSpline(false, false);
  const Handle(Geom_Curve) rational = MakeSpline(false, true);
  const Handle(Geom_Curve) periodic = MakeSpline(true, true);
  TColgp_Array1OfPnt points(1, 4);
  for (int i = 1; i <= 4; ++i)
  {
    points(i) = RandomPoint();
  }
  const Handle(Geom_Curve) bezier = new Geom_BezierCurve(points);
  const Handle(Geom_Curve) circle = new Geom_Circle(conic, 2.0);
  struct Basis
  {
    const char* Name;
    Handle(Geom_Curve) Curve;
    double First;
    double Last;
    double Residual;
  };
  const Basis bases[] = { { "line", new Geom_Line(conic.Axis()), -3.0, 5.0, 0.0 },
    { "circle", circle, 1.0, 5.5, 0.0 }, { "ellipse", new Geom_Ellipse(conic, 3.0, 1.2), 0.0, 2.0 * pi, 0.0 },
    { "parabola", new Geom_Parabola(conic, 1.3), -2.0, 3.0, 0.0 },
    { "hyperbola", new Geom_Hyperbola(conic, 1.5, 0.8), -1.0, 1.6, 0.0 }, { "spline", spline, 0.0, 4.5, 0.0 },
    { "rational spline", rational, 0.5, 4.0, 0.0 }, { "periodic spline", periodic, 3.2, 9.7, 0.0 },
    { "Bezier", bezier, 0.0, 1.0, 0.0 },
    { "trimmed circle", new Geom_TrimmedCurve(circle, 1.0, 3.0), 1.0, 3.0, 0.0 },
    { "offset circle", new Geom_OffsetCurve(circle, 0.4, gp_Dir(0.5, 0.1, 0.8)), 1.0, 3.0, 1e-12 } };
  for (const Basis& basis : bases)
  {
    CheckSurface((std::string("extruded ") + basis.Name).c_str(),
      new Geom_SurfaceOfLinearExtrusion(basis.Curve, along), basis.First, basis.Last, -2.0, 5.0,
      basis.Residual);
    CheckSurface((std::string("revolved ") + basis.Name).c_str(),
      new Geom_SurfaceOfRevolution(basis.Curve, axis), 0.5, 5.0, basis.First, basis.Last, basis.Residual);
  }
  CheckSurface("B-spline", MakeSplineSurface(false, false, false), 0.0, 4.5, 0.0, 4.5);
  CheckSurface("rational B-spline", MakeSplineSurface(false, false, true), 0.0, 4.5, 0.0, 4.5);
  CheckSurface("periodic B-spline", MakeSplineSurface(true, false, true), 0.0, 4.5, 0.0, 4.5);
  CheckSurface("periodic B-spline, moved range", MakeSplineSurface(true, true, false), -6.2, -1.9, 2.7, 9.0);
  TColgp_Array2OfPnt net(1, 4, 1, 3);
  TColStd_Array2OfReal weights(1, 4, 1, 3);
  for (int i = 1; i <= 4; ++i)
  {
    for (int j = 1; j <= 3; ++j)
    {
      net(i, j) = gp_Pnt(i, j, Uniform(0.0, 0.5));
      weights(i, j) = Uniform(0.5, 2.0);
    }
  }
  const Handle(Geom_BezierSurface) patch = new Geom_BezierSurface(net, weights);
  CheckSurface("Bezier", patch, 0.0, 1.0, 0.0, 1.0);
  CheckSurface(
    "rectangular trim", new Geom_RectangularTrimmedSurface(patch, 0.2, 0.8, 0.1, 0.6), 0.2, 0.8, 0.1, 0.6);
  // The one surface that is fitted: 1e-10 of the size is what the reader promises, 2e-12 what it does.
  CheckSurface("offset Bezier", new Geom_OffsetSurface(patch, 0.15), 0.0, 1.0, 0.0, 1.0, 2e-12);
  CheckSurface("offset cylinder",
    new Geom_OffsetSurface(new Geom_CylindricalSurface(MakeFrame(true), 2.5), 0.5), 0.0, 2.0 * pi, -3.0, 4.0);
  CheckSurface("offset torus",
    new Geom_OffsetSurface(new Geom_ToroidalSurface(MakeFrame(true), 4.0, 1.5), -0.5), 0.0, 3.0, -1.0, 4.0);
}

/// A surface far away, whose poles are exact there, becomes the same as the one at home: the kernel's
/// evaluation, which loses digits far away, must not be mistaken for the surface.
void CheckFarSurfaces()
{
  TColgp_Array2OfPnt net(1, 10, 1, 8);
  for (int i = 1; i <= 10; ++i)
  {
    for (int j = 1; j <= 8; ++j)
    {
      net(i, j) = gp_Pnt(i, j, std::round(256.0 * Uniform(0.0, 0.5)) / 256.0);
    }
  }
  const Handle(Geom_BezierSurface) patch = new Geom_BezierSurface(net);
  sm::NativeBox box;
  box.High[0] = box.High[1] = 1.0;
  const double far[3] = { 8388608.0, -4194304.0, 2097152.0 };
  const double home[3] = { 0.0, 0.0, 0.0 };
  const Handle(Geom_Surface)
    surfaces[] = { Handle(Geom_Surface)(patch), new Geom_OffsetSurface(patch, 0.25) };
  for (const Handle(Geom_Surface) & surface : surfaces)
  {
    const auto moved = Handle(Geom_Surface)::DownCast(surface->Translated(gp_Vec(far[0], far[1], far[2])));
    const sm::NURBSSurface a =
      sm::ConvertSurface(sm::MakeGeometry(surface), box, sm::AffineMap::Make(gp_Trsf(), 1.0, home)).Surface;
    const sm::NURBSSurface b =
      sm::ConvertSurface(sm::MakeGeometry(moved), box, sm::AffineMap::Make(gp_Trsf(), 1.0, far)).Surface;
    const std::string name = std::string("far ") + surface->DynamicType()->Name();
    smtest::CheckEqual(name + ", control points", static_cast<long long>(a.ControlPoints.size()),
      static_cast<long long>(b.ControlPoints.size()));
    double worst = 0.0;
    for (std::size_t i = 0; i < std::min(a.ControlPoints.size(), b.ControlPoints.size()); ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        worst = std::max(worst, std::abs(a.ControlPoints[i][c] - b.ControlPoints[i][c]));
      }
    }
    smtest::Check(name + ", control points differ by", 0.0, worst, 0.0, "the same arithmetic");
  }
}

/// The end of a range that is a pole except for the file's digits becomes the pole, a row of one point;
/// another end stays.
void CheckPoles()
{
  const double pi = std::acos(-1.0);
  const gp_Ax3 frame(gp_Pnt(0.3, -2.0, 1.0), gp_Dir(0.2, 0.5, 1.0), gp_Dir(1.0, 0.0, 0.3));
  const sm::AffineMap map = MakeMap(false);
  const Handle(Geom_ConicalSurface) cone = new Geom_ConicalSurface(frame, 0.4, 2.0);
  const Handle(Geom_SphericalSurface) sphere = new Geom_SphericalSurface(frame, 3.0);
  const double apex = -2.0 / std::sin(0.4);
  const auto getWidth = [&map](const Handle(Geom_Surface) & surface, double low, double high, bool last)
  {
    const sm::NativeBox box{ { 0.0, low }, { 2.0, high } };
    const sm::NURBSSurface s = sm::ConvertSurface(sm::MakeGeometry(surface), box, map).Surface;
    const std::size_t columns = s.NumberOfControlPoints[0];
    const std::size_t row = last ? s.ControlPoints.size() - columns : 0;
    double width = 0.0;
    for (std::size_t i = 0; i < columns; ++i)
    {
      const auto& a = s.ControlPoints[row];
      const auto& b = s.ControlPoints[row + i];
      width = std::max(
        width, std::hypot(a[0] / a[3] - b[0] / b[3], a[1] / a[3] - b[1] / b[3], a[2] / a[3] - b[2] / b[3]));
    }
    return width;
  };
  for (const double digits : { 0.0, 1e-11, -1e-11, 1e-8, -5e-9 })
  {
    const std::string name = " with an end off by " + std::to_string(digits * 1e11) + "e-11";
    smtest::CheckRange("cone" + name, 0.0, getWidth(cone, apex + digits, 3.0, false), 1e-15);
    smtest::CheckRange("cone upside down" + name, 0.0, getWidth(cone, -20.0, apex - digits, true), 1e-15);
    smtest::CheckRange("sphere" + name, 0.0, getWidth(sphere, -0.5 * pi + digits, 1.0, false), 1e-15);
    smtest::CheckRange(
      "sphere's other pole" + name, 0.0, getWidth(sphere, 0.0, 0.5 * pi - digits, true), 1e-15);
  }
  smtest::CheckRange("a cone cut above its apex", 1e-6, getWidth(cone, apex + 1e-4, 3.0, false), 1.0);
  smtest::CheckRange("both nappes", 1e-6, getWidth(cone, apex - 1e-4, 3.0, false), 1.0);
}

/// Largest distance of a surface from OpenCASCADE's `oracle` at 400 points of a box, of which parameters
/// beyond the oracle's domain come back by whole periods.
double GetSurfaceDistance(
  const sm::GeometricSurface& surface, const Handle(Geom_Surface) & oracle, const sm::NativeBox& box)
{
  double low[2];
  double high[2];
  oracle->Bounds(low[0], high[0], low[1], high[1]);
  double worst = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    double own[2];
    double theirs[2];
    for (int d = 0; d < 2; ++d)
    {
      own[d] = Uniform(box.Low[d], box.High[d]);
      const double period = surface.GetPeriod(d);
      theirs[d] = period > 0.0 ? own[d] - std::floor((own[d] - low[d]) / period) * period : own[d];
    }
    worst = std::max(
      worst, GetKernelDistance(surface.Evaluate(own[0], own[1]), oracle->Value(theirs[0], theirs[1]).XYZ()));
  }
  return worst;
}

/// A closed spline surface, degree 2 along its section and 1 across, whose last row is `gap` beyond its first
/// one; with weights whose last row differs by a part of `weightGap`; closed in v instead of u on request.
Handle(Geom_BSplineSurface) MakeClosedSurface(double gap, bool rational, double weightGap, bool swapped)
{
  const double corners[5][2] = { { 1.0, 0.0 }, { 1.0, 3.0 }, { -2.0, 3.0 }, { -2.0, -1.0 }, { 1.0, 0.0 } };
  TColgp_Array2OfPnt net(1, 5, 1, 2);
  TColStd_Array2OfReal weights(1, 5, 1, 2);
  for (int i = 0; i < 5; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      net(i + 1, j + 1) = gp_Pnt(corners[i][0], corners[i][1], 2.0 * j);
      weights(i + 1, j + 1) = rational ? 1.0 + 0.25 * (i % 4) + 0.5 * j : 1.0;
    }
  }
  net(5, 2).SetX(1.0 + gap);
  weights(5, 1) *= 1.0 + weightGap;
  TColStd_Array1OfReal u(1, 4);
  TColStd_Array1OfInteger multiplicities(1, 4);
  for (int i = 1; i <= 4; ++i)
  {
    u(i) = i - 1.0;
    multiplicities(i) = i == 1 || i == 4 ? 3 : 1;
  }
  TColStd_Array1OfReal v(1, 2);
  v(1) = 0.0;
  v(2) = 1.0;
  TColStd_Array1OfInteger twice(1, 2);
  twice.Init(2);
  const Handle(Geom_BSplineSurface) surface =
    new Geom_BSplineSurface(net, weights, u, v, multiplicities, twice, 2, 1);
  if (swapped)
  {
    surface->ExchangeUV();
  }
  return surface;
}

/// A closed spline of the file becomes periodic as OpenCASCADE makes it, and is kept if that moves its
/// points. It covers a box that is moved by whole periods, but not one that crosses its seam.
void CheckFileSurfaces()
{
  struct Case
  {
    const char* Name;
    double Gap;
    bool Rational;
    double WeightGap;
    bool Closed;
  };
  const Case cases[] = { { "closed spline", 0.0, false, 0.0, true },
    { "closed spline with borders 1e-8 apart", 1e-8, false, 0.0, true },
    { "closed spline with borders 1e-12 apart", -1e-12, false, 0.0, true },
    { "closed rational spline", 0.0, true, 0.0, true },
    { "closed rational spline with borders 1e-8 apart", 1e-8, true, 0.0, true },
    { "closed rational spline with weights 1e-10 apart", 1e-8, true, 1e-10, true },
    { "spline with borders 2e-7 apart", 2e-7, false, 0.0, false },
    { "rational spline with weights 1e-6 apart", 0.0, true, 1e-6, false },
    { "open spline", 0.5, false, 0.0, false } };
  for (const Case& c : cases)
  {
    for (const bool swapped : { false, true })
    {
      const std::string name = std::string(c.Name) + (swapped ? " in v" : " in u");
      const int d = swapped ? 1 : 0;
      const Handle(Geom_BSplineSurface) oracle = MakeClosedSurface(c.Gap, c.Rational, c.WeightGap, swapped);
      const sm::SurfacePointer read = sm::MakeGeometry(Handle(Geom_Surface)(oracle));
      sm::FileSurface file;
      const sm::SurfacePointer periodic = sm::MakePeriodic(read, file);
      smtest::CheckTrue(name + ", is periodic or not", (periodic->GetPeriod(d) == 3.0) == c.Closed);
      smtest::CheckTrue(name + ", is not periodic across", periodic->GetPeriod(1 - d) == 0.0);
      const bool isMoved = c.Closed && (c.Gap != 0.0 || c.WeightGap != 0.0);
      smtest::CheckTrue(name + ", the file's surface is kept", (file.Surface == read) == isMoved);
      smtest::CheckTrue(name + ", a surface that is not closed stays", (periodic == read) != c.Closed);
      if (!c.Closed)
      {
        continue;
      }
      sm::NativeBox once{ { 0.0, 0.0 }, { 1.0, 1.0 } };
      once.High[d] = 3.0;
      const double moved = GetSurfaceDistance(*periodic, oracle, once);
      smtest::CheckRange(name + ", the periodic one from the file's", 0.0, moved, file.Distance + 1e-14,
        "the bound that is stated, and rounding");
      const double limit = std::abs(c.Gap) + 10.0 * c.WeightGap;
      smtest::CheckRange(
        name + ", the bound that is stated", 0.5 * std::abs(c.Gap), file.Distance, 1.0001 * limit);
      const auto theirs = Handle(Geom_BSplineSurface)::DownCast(oracle->Copy());
      swapped ? theirs->SetVPeriodic() : theirs->SetUPeriodic();
      sm::NativeBox turns = once;
      turns.Low[d] = -7.0;
      turns.High[d] = 11.0;
      smtest::CheckRange(name + ", from OpenCASCADE's periodic one", 0.0,
        GetSurfaceDistance(*periodic, theirs, turns), 1e-13, "rounding");
      sm::FileSurface again;
      smtest::CheckTrue(name + ", a periodic surface stays",
        sm::MakePeriodic(periodic, again) == periodic && !again.Surface && again.Distance == 0.0);
      for (const int turn : { -2, 0, 5 })
      {
        const double start = 3.0 * turn;
        sm::NativeBox box{ { 0.0, 0.0 }, { 1.0, 1.0 } };
        box.Low[d] = start - 1e-12;
        box.High[d] = start + 3.0;
        const std::string label = name + ", " + std::to_string(turn) + " turns";
        if (!isMoved)
        {
          continue;
        }
        const sm::SurfacePointer covering = sm::CoverBox(file, periodic, box);
        if (!smtest::CheckTrue(label + ", is covered", covering != nullptr))
        {
          continue;
        }
        for (const double x : { 0.0, 0.3, 1.7, 3.0 })
        {
          const sm::Vector3 point =
            swapped ? covering->Evaluate(1.0, start + x) : covering->Evaluate(start + x, 1.0);
          const gp_Pnt expected = swapped ? oracle->Value(1.0, x) : oracle->Value(x, 1.0);
          smtest::Check(label + ", distance from the file's", 0.0, GetKernelDistance(point, expected.XYZ()),
            1e-13, "rounding");
        }
        box.Low[d] = start + 1.0;
        box.High[d] = start + 3.5;
        smtest::CheckTrue(label + ", across its seam", sm::CoverBox(file, periodic, box) == nullptr);
      }
    }
  }
}

/// The knots of an unclamped closed spline of degree 3 with `spans` spans from 0 to its period, and the
/// number of control points after which they repeat. Its first and last control points are the same, as
/// Parasolid writes them.
struct UnclampedKnots
{
  std::vector<double> Knots;
  std::vector<int> Multiplicities;
  int Poles = 0;
  int Period = 0;

  /// `multiplicity` of all knots; that of the first and last one is `ends`.
  UnclampedKnots(const std::vector<double>& spans, int multiplicity, int ends)
  {
    const int count = static_cast<int>(spans.size());
    // The domain begins at the fourth flat knot and ends at the fourth last one.
    const int before = (3 - ends) / multiplicity + 1;
    int total = 0;
    for (int i = -before; i <= count + before; ++i)
    {
      double knot = 0.0;
      for (int k = std::min(i, 0); k < std::max(i, 0); ++k)
      {
        knot += (i < 0 ? -1.0 : 1.0) * spans[(k + count) % count];
      }
      this->Knots.push_back(knot);
      this->Multiplicities.push_back(i == -before || i == count + before ? ends : multiplicity);
      total += this->Multiplicities.back();
    }
    this->Poles = total - 4;
    this->Period = count * multiplicity;
  }
};

struct UnclampedCase
{
  const char* Name;
  std::vector<double> Spans;
  int Multiplicity;
  int Ends;
};

const std::vector<UnclampedCase>& GetUnclampedCases()
{
  static const std::vector<UnclampedCase> cases = { { "single knots", { 1.0, 1.0, 1.0, 1.0, 1.0 }, 1, 1 },
    { "double knots", { 1.0, 1.0, 1.0, 1.0 }, 2, 2 }, { "double knots, two spans", { 1.0, 1.0 }, 2, 2 },
    { "double knots with single ends", { 1.0, 1.0, 1.0, 1.0 }, 2, 1 },
    { "double knots of several lengths", { 0.5, 1.25, 0.75, 2.0, 0.3 }, 2, 2 },
    { "single knots of several lengths", { 0.5, 1.25, 0.75, 2.0, 0.3 }, 1, 1 } };
  return cases;
}

/// An unclamped closed spline surface, cubic in u or v; `gap` moves one of the control points that repeat.
Handle(Geom_BSplineSurface)
  MakeUnclampedSurface(const UnclampedCase& c, bool rational, bool swapped, double gap)
{
  const UnclampedKnots knots(c.Spans, c.Multiplicity, c.Ends);
  const int rows = knots.Poles;
  TColgp_Array2OfPnt net(1, rows, 1, 3);
  TColStd_Array2OfReal weights(1, rows, 1, 3);
  for (int j = 1; j <= 3; ++j)
  {
    for (int i = 1; i <= rows; ++i)
    {
      const bool isNew = i <= knots.Period;
      net(i, j) = isNew ? RandomPoint() : net(i - knots.Period, j);
      weights(i, j) = !isNew ? weights(i - knots.Period, j) : rational ? Uniform(0.5, 2.0) : 1.0;
    }
  }
  net(rows, 2).SetZ(net(rows, 2).Z() + gap);
  TColStd_Array1OfReal u(1, static_cast<int>(knots.Knots.size()));
  TColStd_Array1OfInteger multiplicities(1, static_cast<int>(knots.Knots.size()));
  std::copy(knots.Knots.begin(), knots.Knots.end(), u.begin());
  std::copy(knots.Multiplicities.begin(), knots.Multiplicities.end(), multiplicities.begin());
  TColStd_Array1OfReal v(1, 2);
  v(1) = -1.0;
  v(2) = 2.0;
  TColStd_Array1OfInteger thrice(1, 2);
  thrice.Init(3);
  const Handle(Geom_BSplineSurface) surface =
    new Geom_BSplineSurface(net, weights, u, v, multiplicities, thrice, 3, 2);
  if (swapped)
  {
    surface->ExchangeUV();
  }
  return surface;
}

/// An unclamped closed spline surface, whose first and last control points repeat, becomes periodic with the
/// same points, also beyond its seam.
void CheckPeriodicSurfaces()
{
  for (const UnclampedCase& c : GetUnclampedCases())
  {
    for (const int mode : { 0, 1, 2, 3 })
    {
      const bool rational = mode % 2 == 1;
      const bool swapped = mode / 2 == 1;
      const int d = swapped ? 1 : 0;
      const std::string name = std::string("unclamped spline in ") + (swapped ? "v, " : "u, ") + c.Name +
        (rational ? ", rational" : "");
      const Handle(Geom_BSplineSurface) oracle = MakeUnclampedSurface(c, rational, swapped, 0.0);
      double ends[4];
      oracle->Bounds(ends[0], ends[1], ends[2], ends[3]);
      const double period = ends[2 * d + 1] - ends[2 * d];
      sm::FileSurface file;
      const sm::SurfacePointer read = sm::MakeGeometry(Handle(Geom_Surface)(oracle));
      const sm::SurfacePointer periodic = sm::MakePeriodic(read, file);
      smtest::Check(name + ", period", period, periodic->GetPeriod(d), 1e-15, "its domain");
      smtest::CheckTrue(name + ", is not periodic across", periodic->GetPeriod(1 - d) == 0.0);
      smtest::CheckTrue(name + ", has the points of the file", !file.Surface && file.Distance == 0.0);
      sm::NativeBox box{ { ends[0], ends[2] }, { ends[1], ends[3] } };
      smtest::CheckRange(name + ", from OpenCASCADE's", 0.0, GetSurfaceDistance(*periodic, oracle, box),
        SurfaceLimit, "rounding");
      box.Low[d] -= 2.3 * period;
      box.High[d] += 3.1 * period;
      smtest::CheckRange(name + ", beyond its seam", 0.0, GetSurfaceDistance(*periodic, oracle, box),
        SurfaceLimit, "rounding, also of the parameter");
      // A face across the seam.
      sm::NativeBox across{ { ends[0], ends[2] }, { ends[1], ends[3] } };
      across.Low[d] += 0.4 * period;
      across.High[d] += 0.35 * period;
      const sm::ConvertedSurface converted = sm::ConvertSurface(periodic, across, sm::AffineMap());
      double worst = 0.0;
      for (int i = 0; i < 200; ++i)
      {
        double at[2] = { Uniform(across.Low[0], across.High[0]), Uniform(across.Low[1], across.High[1]) };
        double p[3];
        converted.Surface.Evaluate(converted.Map[0].Evaluate(at[0]), converted.Map[1].Evaluate(at[1]), p);
        at[d] -= at[d] > ends[2 * d + 1] ? period : 0.0;
        worst = std::max(worst, GetKernelDistance({ p[0], p[1], p[2] }, oracle->Value(at[0], at[1]).XYZ()));
      }
      smtest::CheckRange(name + ", converted across its seam", 0.0, worst, SurfaceLimit, "rounding");

      const Handle(Geom_Surface) gaping = MakeUnclampedSurface(c, rational, swapped, 1e-3);
      const sm::SurfacePointer open = sm::MakeGeometry(gaping);
      smtest::CheckTrue(
        name + " with another last control point stays", sm::MakePeriodic(open, file) == open);
      const Handle(Geom_Surface) near = MakeUnclampedSurface(c, rational, swapped, 1e-8);
      const sm::SurfacePointer moved = sm::MakePeriodic(sm::MakeGeometry(near), file);
      smtest::CheckTrue(name + " 1e-8 apart is kept", moved->GetPeriod(d) > 0.0 && file.Surface);
      smtest::CheckRange(name + " 1e-8 apart, its bound", 0.0,
        GetSurfaceDistance(*moved, near, { { ends[0], ends[2] }, { ends[1], ends[3] } }),
        file.Distance + 1e-13);
    }
  }
}

/// The same curve of OpenCASCADE's.
Handle(Geom_BSplineCurve) MakeUnclampedCurve(const UnclampedCase& c, bool rational, double gap)
{
  const Handle(Geom_BSplineSurface) surface = MakeUnclampedSurface(c, rational, false, 0.0);
  TColgp_Array1OfPnt poles(1, surface->NbUPoles());
  TColStd_Array1OfReal weights(1, surface->NbUPoles());
  for (int i = 1; i <= surface->NbUPoles(); ++i)
  {
    poles(i) = surface->Pole(i, 1);
    weights(i) = surface->Weight(i, 1);
  }
  poles(surface->NbUPoles()).SetX(poles(surface->NbUPoles()).X() + gap);
  return new Geom_BSplineCurve(poles, weights, surface->UKnots(), surface->UMultiplicities(), 3);
}

/// Largest distance of a curve from OpenCASCADE's at parameters from `periods` before its domain to as many
/// behind.
double GetCurveDistance(const sm::GeometricCurve<3>& curve, const Handle(Geom_Curve) & oracle, double periods)
{
  const double low = oracle->FirstParameter();
  const double period = oracle->LastParameter() - low;
  double worst = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    const double t = Uniform(low - periods * period, low + (1.0 + periods) * period);
    const double theirs = t - std::floor((t - low) / period) * period;
    worst = std::max(worst, GetKernelDistance(curve.Evaluate(t), oracle->Value(theirs).XYZ()));
  }
  return worst;
}

/// Closed splines of space, clamped or not, become periodic with the same points; other curves do not, and a
/// surface swept along one is periodic, too.
void CheckPeriodicCurves()
{
  const auto check = [](const std::string& name, const Handle(Geom_BSplineCurve) & oracle)
  {
    const sm::CurvePointer<3> periodic = sm::MakePeriodic(sm::MakeGeometry(Handle(Geom_Curve)(oracle)), 0.0);
    const double length = oracle->LastParameter() - oracle->FirstParameter();
    if (!smtest::CheckTrue(name + " becomes periodic", periodic != nullptr))
    {
      return;
    }
    smtest::Check(name + ", period", length, periodic->GetPeriod(), 1e-15, "its domain");
    smtest::CheckRange(
      name + ", from OpenCASCADE's", 0.0, GetCurveDistance(*periodic, oracle, 0.0), SurfaceLimit, "rounding");
    smtest::CheckRange(name + ", beyond its seam", 0.0, GetCurveDistance(*periodic, oracle, 2.7),
      SurfaceLimit, "rounding, also of the parameter");
    const Handle(Geom_Surface) swept[] = { new Geom_SurfaceOfLinearExtrusion(oracle, gp_Dir(0.6, -0.3, 0.7)),
      new Geom_SurfaceOfRevolution(oracle, gp_Ax1(gp_Pnt(1.0, 1.0, -2.0), gp_Dir(0.2, 0.1, 0.9))) };
    for (int d = 0; d < 2; ++d)
    {
      sm::FileSurface file;
      const sm::SurfacePointer surface = sm::MakePeriodic(sm::MakeGeometry(swept[d]), file);
      const std::string label = name + (d == 0 ? ", extruded" : ", revolved");
      smtest::Check(label + ", period", length, surface->GetPeriod(d), 1e-15, "that of the curve");
      smtest::CheckTrue(label + ", has the points of the file", !file.Surface);
      double worst = 0.0;
      for (int i = 0; i < 400; ++i)
      {
        double at[2] = { Uniform(0.0, 5.0), Uniform(0.0, 5.0) };
        at[d] = Uniform(oracle->FirstParameter() - length, oracle->LastParameter() + length);
        const sm::Vector3 own = surface->Evaluate(at[0], at[1]);
        at[d] -= std::floor((at[d] - oracle->FirstParameter()) / length) * length;
        worst = std::max(worst, GetKernelDistance(own, swept[d]->Value(at[0], at[1]).XYZ()));
      }
      smtest::CheckRange(label + ", beyond its seam", 0.0, worst, SurfaceLimit, "rounding");
    }
  };
  for (const bool rational : { false, true })
  {
    const std::string kind = rational ? "rational " : "";
    const Handle(Geom_BSplineCurve) closed = MakeSpline(false, rational);
    const int last = closed->NbPoles();
    closed->SetPole(last, closed->Pole(1));
    closed->SetWeight(last, closed->Weight(1));
    check(kind + "closed spline", closed);
    for (const UnclampedCase& c : GetUnclampedCases())
    {
      const std::string name = kind + "unclamped curve, " + c.Name;
      check(name, MakeUnclampedCurve(c, rational, 0.0));
      const Handle(Geom_Curve) gaping = MakeUnclampedCurve(c, rational, 1e-3);
      smtest::CheckTrue(
        name + " with another last control point", !sm::MakePeriodic(sm::MakeGeometry(gaping), 1e-7));
    }
    const gp_Pnt first = closed->Pole(1);
    for (const double gap : { 1e-9, 1e-3 })
    {
      closed->SetPole(last, gp_Pnt(first.X() + gap, first.Y(), first.Z()));
      const sm::CurvePointer<3> value = sm::MakeGeometry(Handle(Geom_Curve)(closed));
      const std::string name = kind + "spline " + std::to_string(gap * 1e9) + "e-9 apart";
      smtest::CheckTrue(name + " stays without a tolerance", !sm::MakePeriodic(value, 0.0));
      const sm::CurvePointer<3> periodic = sm::MakePeriodic(value, 1e-7);
      smtest::CheckTrue(name + " within 1e-7 or not", (periodic != nullptr) == (gap < 1e-7));
      if (periodic)
      {
        smtest::CheckRange(
          name + ", from the open one", 0.1 * gap, GetCurveDistance(*periodic, closed, 0.0), gap);
      }
    }
  }
  const gp_Ax2 conic(gp_Pnt(2.0, 3.0, 1.0), gp_Dir(0.5, 0.1, 0.8), gp_Dir(0.3, 1.0, 0.0));
  const Handle(Geom_Curve) others[] = { new Geom_Line(conic.Axis()), new Geom_Circle(conic, 2.0),
    MakeSpline(false, false), MakeSpline(true, false) };
  for (const Handle(Geom_Curve) & other : others)
  {
    smtest::CheckTrue(std::string("not made periodic: ") + other->DynamicType()->Name(),
      !sm::MakePeriodic(sm::MakeGeometry(other), 1e-7));
  }
}

/// Trim curves under two angle maps, one, or none; the residual limit is 1e-13 of an arc and the floor of
/// double precision.
void CheckTrim(const char* name, const Handle(Geom2d_Curve) & curve, double first, double last,
  const sm::ParameterMap& mapU, const sm::ParameterMap& mapV, bool exact)
{
  sm::NativeTrim trim;
  trim.Curve = sm::MakeGeometry(curve);
  trim.First = first;
  trim.Last = last;
  const sm::ParameterMap maps[2] = { mapU, mapV };
  const double width[2] = { 4.0, 4.0 };
  // The edge runs from 10 to 13: another range than the pcurve's.
  const sm::TrimCurve result = sm::ConvertTrim(trim, 10.0, 13.0, maps, width);
  double worst = 0.0;
  double worstOwn = 0.0;
  bool increasing = true;
  for (std::size_t i = 1; i < result.Breaks.size(); ++i)
  {
    increasing = increasing && result.Breaks[i] > result.Breaks[i - 1];
  }
  for (int i = 0; i <= 1000; ++i)
  {
    const double x = i / 1000.0;
    const auto c = result.Evaluate(10.0 + 3.0 * x);
    const double t = (1.0 - x) * first + x * last;
    const gp_Pnt2d native = curve->Value(t);
    const auto own = trim.Evaluate(t);
    for (int d = 0; d < 2; ++d)
    {
      worst = std::max(worst, std::abs(c[d] - maps[d].Evaluate(native.Coord(d + 1))));
      worstOwn = std::max(worstOwn, std::abs(c[d] - maps[d].Evaluate(own[d])));
    }
  }
  smtest::CheckTrue(std::string(name) + ": breaks increase from 10 to 13",
    increasing && result.GetStart() == 10.0 && result.GetEnd() == 13.0);
  smtest::CheckRange(name, 0.0, worst, 2.0 * result.GetLargestResidual() + 2e-14, "stated residual");
  smtest::CheckRange(std::string(name) + " from its own evaluation", 0.0, worstOwn,
    2.0 * result.GetLargestResidual() + 2e-14, "stated residual");
  smtest::CheckRange(std::string(name) + " residual", 0.0, result.GetLargestResidual(), exact ? 0.0 : 4e-13);
}

void CheckTrims()
{
  const double pi = std::acos(-1.0);
  const sm::ParameterMap none;
  const sm::ParameterMap turn = sm::ParameterMap::MakeCircular(0.0, 2.0 * pi);
  const sm::ParameterMap half = sm::ParameterMap::MakeCircular(-0.5 * pi, 0.5 * pi);
  const Handle(Geom2d_Line) diagonal = new Geom2d_Line(gp_Pnt2d(0.1, -1.0), gp_Dir2d(1.0, 0.3));
  CheckTrim("line, no angle", diagonal, 0.0, 4.0, none, none, true);
  CheckTrim("helix", diagonal, 0.0, 6.0, turn, none, false);
  CheckTrim(
    "loxodrome", new Geom2d_Line(gp_Pnt2d(0.1, -1.0), gp_Dir2d(2.0, 0.5)), 0.0, 6.0, turn, half, false);
  CheckTrim("circle in angles", new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(3.0, 0.2), gp_Dir2d(1.0, 0.0)), 0.9), 0.0,
    2.0 * pi, turn, half, false);
  CheckTrim("circle, no angle", new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(3.0, 0.2), gp_Dir2d(1.0, 0.0)), 0.9), 0.3,
    4.0, none, none, false);
  TColgp_Array1OfPnt2d poles(1, 6);
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger multiplicities(1, 4);
  for (int i = 1; i <= 6; ++i)
  {
    poles(i) = gp_Pnt2d(0.9 * i, Uniform(-1.0, 1.0));
  }
  for (int i = 1; i <= 4; ++i)
  {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == 4 ? 4 : 1;
  }
  const Handle(Geom2d_BSplineCurve) spline = new Geom2d_BSplineCurve(poles, knots, multiplicities, 3);
  CheckTrim("spline, no angle", spline, 1.3, 3.8, none, none, true);
  CheckTrim("spline in angles", spline, 1.0, 4.0, turn, half, false);

  // Constant parameters stay constant, and an arc border is its knot.
  sm::NativeTrim line;
  const Handle(Geom2d_Line) ruling = new Geom2d_Line(gp_Pnt2d(1.5 * pi, 0.0), gp_Dir2d(-1.8e-16, 1.0));
  line.Curve = sm::MakeGeometry(ruling);
  line.First = -2.0;
  line.Last = 40.0;
  const sm::ParameterMap maps[2] = { turn, none };
  const double width[2] = { 6.0, 42.0 };
  const sm::TrimCurve result = sm::ConvertTrim(line, 0.0, 1.0, maps, width);
  smtest::CheckEqual("a ruling has one piece", 1, result.GetNumberOfPieces());
  smtest::CheckTrue("its angle is one number", result.Coefficients[0][0] == result.Coefficients[1][0]);
  smtest::Check("the border of the third arc", 3.0, result.Coefficients[0][0], 1e-14,
    "the file's direction is off by 1.8e-16");
}

void CheckEdge(const char* name, const Handle(Geom_Curve) & curve, double first, double last, bool exact)
{
  const sm::AffineMap map = MakeMap(false);
  const sm::EdgeCurve result = sm::ConvertCurve(*sm::MakeGeometry(curve), first, last, map);
  CheckValue(name, curve, first, last);
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i)
  {
    const double t = first + (last - first) * i / 1000.0;
    const sm::Vector3 expected = map.MapPoint(curve->Value(t).XYZ());
    worst = std::max(worst, sm::Norm(sm::Subtract(result.Evaluate(t), expected)));
  }
  smtest::CheckRange(std::string("edge: ") + name, 0.0, worst, 2.0 * result.GetLargestResidual() + 2e-14,
    "stated residual and rounding");
  smtest::CheckRange(
    std::string("edge: ") + name + " residual", 0.0, result.GetLargestResidual(), exact ? 0.0 : 5e-14);
  smtest::CheckRange(std::string("edge: ") + name + " pieces", 1, result.GetNumberOfPieces(), 32);
}

void CheckEdges()
{
  const double pi = std::acos(-1.0);
  const gp_Ax2 conic(gp_Pnt(2.0, 3.0, 1.0), gp_Dir(0.5, 0.1, 0.8), gp_Dir(0.3, 1.0, 0.0));
  const Handle(Geom_Circle) circle = new Geom_Circle(conic, 2.0);
  CheckEdge("line", new Geom_Line(conic.Axis()), -3.0, 5.0, true);
  CheckEdge("circle", circle, 0.0, 2.0 * pi, false);
  CheckEdge("ellipse", new Geom_Ellipse(conic, 3.0, 1.2), 1.0, 4.0, false);
  CheckEdge("hyperbola", new Geom_Hyperbola(conic, 1.5, 0.8), -1.0, 1.6, false);
  CheckEdge("spline", MakeSpline(false, false), 0.4, 4.1, true);
  CheckEdge("rational spline", MakeSpline(false, true), 0.0, 4.5, false);
  CheckEdge("periodic spline", MakeSpline(true, false), 3.1, 8.6, true);
  CheckEdge("offset circle", new Geom_OffsetCurve(circle, 0.4, gp_Dir(0.5, 0.1, 0.8)), 1.0, 3.0, false);
}
}

int TestSTEPSurfaces(int, char*[])
{
  CheckSurfaces();
  CheckFarSurfaces();
  CheckFileSurfaces();
  CheckPeriodicSurfaces();
  CheckPeriodicCurves();
  CheckPoles();
  CheckTrims();
  CheckEdges();
  return smtest::Finish();
}
