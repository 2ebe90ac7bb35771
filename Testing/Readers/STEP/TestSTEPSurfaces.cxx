/**
 * @file TestSTEPSurfaces.cxx
 * @brief Every surface and curve type: our B-spline at mapped parameters against OpenCASCADE's own evaluation
 */
#include "Geometry/smGeometryConversion.h"
#include "Geometry/smPeriodicSurface.h"
#include "Geometry/smSurfaceConversion.h"
#include "Trims/smTrimConversion.h"
#include "smOCCTGeometry.h"
#include "smSurfaceTesting.h"

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
using namespace smtest;

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
    const int order = value->GetMaxOrder();
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
    const int order = value->GetMaxOrder();
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
  smtest::CheckRange(name, 0.0, worst, 2.0 * result.GetMaxResidual() + 2e-14, "stated residual");
  smtest::CheckRange(std::string(name) + " from its own evaluation", 0.0, worstOwn,
    2.0 * result.GetMaxResidual() + 2e-14, "stated residual");
  smtest::CheckRange(std::string(name) + " residual", 0.0, result.GetMaxResidual(), exact ? 0.0 : 4e-13);
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
  smtest::CheckRange(std::string("edge: ") + name, 0.0, worst, 2.0 * result.GetMaxResidual() + 2e-14,
    "stated residual and rounding");
  smtest::CheckRange(
    std::string("edge: ") + name + " residual", 0.0, result.GetMaxResidual(), exact ? 0.0 : 5e-14);
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
  CheckPoles();
  CheckTrims();
  CheckEdges();
  return smtest::Finish();
}
