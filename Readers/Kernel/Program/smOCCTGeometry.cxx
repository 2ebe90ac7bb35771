#include "smOCCTGeometry.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
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

#include <stdexcept>

namespace sm
{
namespace
{
/// Returns the basis curve of trimmed curves, which has the same parameter.
Handle(Geom2d_Curve) GetBasis(Handle(Geom2d_Curve) curve)
{
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

Handle(Geom_Curve) GetBasis(Handle(Geom_Curve) curve)
{
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

template <class Value>
Vector3 ToPoint3(const Value& p)
{
  return { p.X(), p.Y(), p.Z() };
}

template <class Value>
std::array<double, 2> ToPoint2(const Value& p)
{
  return { p.X(), p.Y() };
}

/// The classes of OpenCASCADE in space and in the plane.
struct SpaceKinds
{
  static constexpr int Dimension = 3;
  using Line = Geom_Line;
  using Circle = Geom_Circle;
  using Ellipse = Geom_Ellipse;
  using Parabola = Geom_Parabola;
  using Hyperbola = Geom_Hyperbola;
  using Spline = Geom_BSplineCurve;
  using Bezier = Geom_BezierCurve;
  using Offset = Geom_OffsetCurve;
  using Curve = Geom_Curve;

  template <class Value>
  static Vector3 ToPoint(const Value& p)
  {
    return ToPoint3(p);
  }
  static ConicCurve<3> MakeConic(const Handle(Geom_Conic) & conic)
  {
    ConicCurve<3> value;
    const gp_Ax2& frame = conic->Position();
    value.Center = ToPoint3(frame.Location());
    value.X = ToPoint3(frame.XDirection());
    value.Y = ToPoint3(frame.YDirection());
    return value;
  }
  static Vector3 GetLineOrigin(const Handle(Geom_Line) & line) { return ToPoint3(line->Lin().Location()); }
  static Vector3 GetLineDirection(const Handle(Geom_Line) & line)
  {
    return ToPoint3(line->Lin().Direction());
  }
  static Vector3 GetReference(const Handle(Geom_OffsetCurve) & offset)
  {
    return ToPoint3(offset->Direction());
  }
  /// OpenCASCADE's offset is along T x V.
  static double GetDistance(const Handle(Geom_OffsetCurve) & offset) { return -offset->Offset(); }
};

struct PlaneKinds
{
  static constexpr int Dimension = 2;
  using Line = Geom2d_Line;
  using Circle = Geom2d_Circle;
  using Ellipse = Geom2d_Ellipse;
  using Parabola = Geom2d_Parabola;
  using Hyperbola = Geom2d_Hyperbola;
  using Spline = Geom2d_BSplineCurve;
  using Bezier = Geom2d_BezierCurve;
  using Offset = Geom2d_OffsetCurve;
  using Curve = Geom2d_Curve;

  template <class Value>
  static std::array<double, 2> ToPoint(const Value& p)
  {
    return ToPoint2(p);
  }
  static ConicCurve<2> MakeConic(const Handle(Geom2d_Conic) & conic)
  {
    ConicCurve<2> value;
    const gp_Ax22d& frame = conic->Position();
    value.Center = ToPoint2(frame.Location());
    value.X = ToPoint2(frame.XDirection());
    value.Y = ToPoint2(frame.YDirection());
    return value;
  }
  static std::array<double, 2> GetLineOrigin(const Handle(Geom2d_Line) & line)
  {
    return ToPoint2(line->Location());
  }
  static std::array<double, 2> GetLineDirection(const Handle(Geom2d_Line) & line)
  {
    return ToPoint2(line->Direction());
  }
  static std::array<double, 2> GetReference(const Handle(Geom2d_OffsetCurve) &) { return {}; }
  /// OpenCASCADE's offset is to the right of the curve.
  static double GetDistance(const Handle(Geom2d_OffsetCurve) & offset) { return -offset->Offset(); }
};

SplineBasis MakeBasis(
  int degree, const TColStd_Array1OfReal& knots, const TColStd_Array1OfInteger& multiplicities, bool periodic)
{
  SplineBasis basis;
  basis.Degree = degree;
  basis.Knots.assign(knots.begin(), knots.end());
  basis.Multiplicities.assign(multiplicities.begin(), multiplicities.end());
  basis.Periodic = periodic;
  return basis;
}

SplineBasis MakeBezierBasis(int degree)
{
  SplineBasis basis;
  basis.Degree = degree;
  basis.Knots = { 0.0, 1.0 };
  basis.Multiplicities = { degree + 1, degree + 1 };
  return basis;
}

template <class Kinds, class Spline>
SplineCurve<Kinds::Dimension> MakeSpline(const Handle(Spline) & source, SplineBasis basis)
{
  SplineCurve<Kinds::Dimension> spline;
  spline.Basis = std::move(basis);
  for (int i = 1; i <= source->NbPoles(); ++i)
  {
    spline.Poles.push_back(Kinds::ToPoint(source->Pole(i)));
    if (source->IsRational())
    {
      spline.Weights.push_back(source->Weight(i));
    }
  }
  return spline;
}

template <class Kinds>
CurvePointer<Kinds::Dimension> MakeCurve(const Handle(typename Kinds::Curve) & source);

template <class Kinds>
bool MakeCurveValue(
  const Handle(typename Kinds::Curve) & curve, typename GeometricCurve<Kinds::Dimension>::Variant& value)
{
  constexpr int Dimension = Kinds::Dimension;
  using Type = typename ConicCurve<Dimension>::Type;
  const auto setConic = [&value](ConicCurve<Dimension> conic, Type kind, double first, double second)
  {
    conic.Kind = kind;
    conic.Radii[0] = first;
    conic.Radii[1] = second;
    value = conic;
    return true;
  };
  if (const auto line = Handle(typename Kinds::Line)::DownCast(curve))
  {
    value = LineCurve<Dimension>{ Kinds::GetLineOrigin(line), Kinds::GetLineDirection(line) };
    return true;
  }
  if (const auto circle = Handle(typename Kinds::Circle)::DownCast(curve))
  {
    return setConic(Kinds::MakeConic(circle), Type::Ellipse, circle->Radius(), circle->Radius());
  }
  if (const auto ellipse = Handle(typename Kinds::Ellipse)::DownCast(curve))
  {
    return setConic(Kinds::MakeConic(ellipse), Type::Ellipse, ellipse->MajorRadius(), ellipse->MinorRadius());
  }
  if (const auto hyperbola = Handle(typename Kinds::Hyperbola)::DownCast(curve))
  {
    return setConic(
      Kinds::MakeConic(hyperbola), Type::Hyperbola, hyperbola->MajorRadius(), hyperbola->MinorRadius());
  }
  if (const auto parabola = Handle(typename Kinds::Parabola)::DownCast(curve))
  {
    return setConic(Kinds::MakeConic(parabola), Type::Parabola, parabola->Focal(), parabola->Focal());
  }
  if (const auto spline = Handle(typename Kinds::Spline)::DownCast(curve))
  {
    value = MakeSpline<Kinds>(
      spline, MakeBasis(spline->Degree(), spline->Knots(), spline->Multiplicities(), spline->IsPeriodic()));
    return true;
  }
  if (const auto bezier = Handle(typename Kinds::Bezier)::DownCast(curve))
  {
    value = MakeSpline<Kinds>(bezier, MakeBezierBasis(bezier->Degree()));
    return true;
  }
  const auto offset = Handle(typename Kinds::Offset)::DownCast(curve);
  if (!offset.IsNull())
  {
    value = OffsetCurve<Dimension>{ MakeCurve<Kinds>(offset->BasisCurve()), Kinds::GetDistance(offset),
      Kinds::GetReference(offset) };
  }
  return !offset.IsNull();
}

template <class Value>
auto Require(Value value, const std::string& problem)
{
  if (!problem.empty())
  {
    throw std::runtime_error("it is not usable: " + problem);
  }
  return value;
}

template <class Kinds>
CurvePointer<Kinds::Dimension> MakeCurve(const Handle(typename Kinds::Curve) & source)
{
  typename GeometricCurve<Kinds::Dimension>::Variant value;
  if (!MakeCurveValue<Kinds>(GetBasis(source), value))
  {
    return nullptr;
  }
  std::string problem;
  const auto curve = GeometricCurve<Kinds::Dimension>::Make(std::move(value), problem);
  return Require(curve, problem);
}

ParameterRange GetTrim(const Handle(Geom_Curve) & curve)
{
  const bool isTrimmed = curve->IsKind(STANDARD_TYPE(Geom_TrimmedCurve));
  return isTrimmed ? ParameterRange{ curve->FirstParameter(), curve->LastParameter() } : ParameterRange();
}

bool MakeElementary(const Handle(Geom_Surface) & surface, ElementarySurface& value)
{
  const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface);
  if (elementary.IsNull())
  {
    return false;
  }
  using Type = ElementarySurface::Type;
  const gp_Ax3& frame = elementary->Position();
  value.Frame.Origin = ToPoint3(frame.Location());
  value.Frame.Axes = { ToPoint3(frame.XDirection()), ToPoint3(frame.YDirection()),
    ToPoint3(frame.Direction()) };
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface))
  {
    value.Kind = Type::Cylinder;
    value.Radii[0] = cylinder->Radius();
  }
  else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
  {
    value.Kind = Type::Cone;
    value.Radii[0] = cone->RefRadius();
    value.Angle = cone->SemiAngle();
  }
  else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface))
  {
    value.Kind = Type::Sphere;
    value.Radii[0] = sphere->Radius();
  }
  else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface))
  {
    value.Kind = Type::Torus;
    value.Radii[0] = torus->MajorRadius();
    value.Radii[1] = torus->MinorRadius();
  }
  return true;
}

template <class Spline>
SplineSurface MakeSplineValue(const Handle(Spline) & source, SplineBasis u, SplineBasis v)
{
  SplineSurface spline;
  spline.Basis[0] = std::move(u);
  spline.Basis[1] = std::move(v);
  const bool rational = source->IsURational() || source->IsVRational();
  for (int j = 1; j <= source->NbVPoles(); ++j)
  {
    for (int i = 1; i <= source->NbUPoles(); ++i)
    {
      spline.Poles.push_back(ToPoint3(source->Pole(i, j)));
      if (rational)
      {
        spline.Weights.push_back(source->Weight(i, j));
      }
    }
  }
  return spline;
}

bool MakeSurfaceValue(const Handle(Geom_Surface) & surface, GeometricSurface::Variant& value)
{
  ElementarySurface elementary;
  if (MakeElementary(surface, elementary))
  {
    value = elementary;
    return true;
  }
  if (const auto extruded = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface))
  {
    value = ExtrudedSurface{ MakeGeometry(extruded->BasisCurve()), GetTrim(extruded->BasisCurve()),
      ToPoint3(extruded->Direction()) };
    return true;
  }
  if (const auto revolved = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
  {
    value = RevolvedSurface{ MakeGeometry(revolved->BasisCurve()), GetTrim(revolved->BasisCurve()),
      ToPoint3(revolved->Axis().Location()), ToPoint3(revolved->Axis().Direction()) };
    return true;
  }
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
  {
    value = MakeSplineValue(spline,
      MakeBasis(spline->UDegree(), spline->UKnots(), spline->UMultiplicities(), spline->IsUPeriodic()),
      MakeBasis(spline->VDegree(), spline->VKnots(), spline->VMultiplicities(), spline->IsVPeriodic()));
    return true;
  }
  if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface))
  {
    value = MakeSplineValue(bezier, MakeBezierBasis(bezier->UDegree()), MakeBezierBasis(bezier->VDegree()));
    return true;
  }
  const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
  if (!offset.IsNull())
  {
    value = OffsetSurface{ MakeGeometry(offset->BasisSurface()), offset->Offset() };
  }
  return !offset.IsNull();
}
}

SurfacePointer MakeGeometry(const Handle(Geom_Surface) & source)
{
  Handle(Geom_Surface) basis = source;
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(basis))
  {
    basis = trimmed->BasisSurface();
  }
  GeometricSurface::Variant value;
  if (!MakeSurfaceValue(basis, value))
  {
    return nullptr;
  }
  std::string problem;
  const SurfacePointer surface = GeometricSurface::Make(std::move(value), problem);
  return Require(surface, problem);
}

CurvePointer<3> MakeGeometry(const Handle(Geom_Curve) & curve)
{
  return MakeCurve<SpaceKinds>(curve);
}

CurvePointer<2> MakeGeometry(const Handle(Geom2d_Curve) & curve)
{
  return MakeCurve<PlaneKinds>(curve);
}
}
