#include "smOCCTMakeGeometry.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
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
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <stdexcept>

namespace sm
{
namespace
{
gp_Pnt ToPoint(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

gp_Dir ToDirection(const Vector3& v)
{
  return { v[0], v[1], v[2] };
}

gp_Pnt2d ToPoint(const std::array<double, 2>& p)
{
  return { p[0], p[1] };
}

gp_Dir2d ToDirection(const std::array<double, 2>& v)
{
  return { v[0], v[1] };
}

gp_Ax3 ToFrame(const GeometricFrame& frame)
{
  gp_Ax3 result(ToPoint(frame.Origin), ToDirection(frame.Axes[2]), ToDirection(frame.Axes[0]));
  if (Dot(Cross(frame.Axes[2], frame.Axes[0]), frame.Axes[1]) < 0.0)
  {
    result.YReverse();
  }
  return result;
}

/// The classes and frames of OpenCASCADE in space and in the plane.
struct SpaceMakers
{
  using Line = Geom_Line;
  using Circle = Geom_Circle;
  using Ellipse = Geom_Ellipse;
  using Parabola = Geom_Parabola;
  using Hyperbola = Geom_Hyperbola;
  using Spline = Geom_BSplineCurve;
  using Curve = Geom_Curve;
  using Points = TColgp_Array1OfPnt;

  static gp_Ax2 MakeFrame(const ConicCurve<3>& conic)
  {
    return { ToPoint(conic.Center), ToDirection(Cross(conic.X, conic.Y)), ToDirection(conic.X) };
  }
  static gp_Parab MakeParabola(const ConicCurve<3>& conic) { return { MakeFrame(conic), conic.Radii[0] }; }
  static Handle(Geom_Curve) MakeOffset(const OffsetCurve<3>& offset)
  {
    return new Geom_OffsetCurve(
      MakeKernelCurve(*offset.Basis), -offset.Distance, ToDirection(offset.Reference));
  }
};

struct PlaneMakers
{
  using Line = Geom2d_Line;
  using Circle = Geom2d_Circle;
  using Ellipse = Geom2d_Ellipse;
  using Parabola = Geom2d_Parabola;
  using Hyperbola = Geom2d_Hyperbola;
  using Spline = Geom2d_BSplineCurve;
  using Curve = Geom2d_Curve;
  using Points = TColgp_Array1OfPnt2d;

  static gp_Ax22d MakeFrame(const ConicCurve<2>& conic)
  {
    return { ToPoint(conic.Center), ToDirection(conic.X), ToDirection(conic.Y) };
  }
  static gp_Parab2d MakeParabola(const ConicCurve<2>& conic) { return { MakeFrame(conic), conic.Radii[0] }; }
  static Handle(Geom2d_Curve) MakeOffset(const OffsetCurve<2>& offset)
  {
    return new Geom2d_OffsetCurve(MakeKernelCurve(*offset.Basis), -offset.Distance);
  }
};

TColStd_Array1OfReal ToKnots(const SplineBasis& basis)
{
  TColStd_Array1OfReal knots(1, static_cast<int>(basis.Knots.size()));
  std::copy(basis.Knots.begin(), basis.Knots.end(), knots.begin());
  return knots;
}

TColStd_Array1OfInteger ToMultiplicities(const SplineBasis& basis)
{
  TColStd_Array1OfInteger multiplicities(1, static_cast<int>(basis.Multiplicities.size()));
  std::copy(basis.Multiplicities.begin(), basis.Multiplicities.end(), multiplicities.begin());
  return multiplicities;
}

template <class Makers, int Dimension>
Handle(typename Makers::Curve) MakeConic(const ConicCurve<Dimension>& conic)
{
  using Type = typename ConicCurve<Dimension>::Type;
  if (conic.Kind == Type::Parabola)
  {
    return new typename Makers::Parabola(Makers::MakeParabola(conic));
  }
  const auto frame = Makers::MakeFrame(conic);
  if (conic.Kind == Type::Hyperbola)
  {
    return new typename Makers::Hyperbola(frame, conic.Radii[0], conic.Radii[1]);
  }
  if (conic.Radii[0] == conic.Radii[1])
  {
    return new typename Makers::Circle(frame, conic.Radii[0]);
  }
  return new typename Makers::Ellipse(frame, conic.Radii[0], conic.Radii[1]);
}

template <class Makers, int Dimension>
Handle(typename Makers::Curve) MakeSpline(const SplineCurve<Dimension>& spline)
{
  const int count = static_cast<int>(spline.Poles.size());
  typename Makers::Points poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 0; i < count; ++i)
  {
    poles.SetValue(i + 1, ToPoint(spline.Poles[i]));
    weights.SetValue(i + 1, spline.Weights.empty() ? 1.0 : spline.Weights[i]);
  }
  const SplineBasis& basis = spline.Basis;
  return spline.Weights.empty() ? new
    typename Makers::Spline(poles, ToKnots(basis), ToMultiplicities(basis), basis.Degree, basis.Periodic)
                                : new typename Makers::Spline(poles, weights, ToKnots(basis),
                                    ToMultiplicities(basis), basis.Degree, basis.Periodic);
}

/// Makes a closed spline of space periodic, as a face on it needs it: its seam has two parameters otherwise.
void MakePeriodic(const Handle(Geom_BSplineCurve) & spline)
{
  const int last = spline->NbPoles();
  const bool isClamped = !spline->IsPeriodic() && spline->Degree() > 1 &&
    spline->Multiplicity(1) == spline->Degree() + 1 &&
    spline->Multiplicity(spline->NbKnots()) == spline->Degree() + 1;
  if (isClamped && last > 3 && spline->Pole(1).XYZ().IsEqual(spline->Pole(last).XYZ(), 0.0) &&
    spline->Weight(1) == spline->Weight(last))
  {
    spline->SetPeriodic();
  }
}

void MakePeriodic(const Handle(Geom2d_BSplineCurve) &) {}

template <class Makers, int Dimension>
Handle(typename Makers::Curve) MakeCurve(const GeometricCurve<Dimension>& curve)
{
  if (const auto* line = curve.template GetIf<LineCurve<Dimension>>())
  {
    return new typename Makers::Line(ToPoint(line->Origin), ToDirection(line->Direction));
  }
  if (const auto* conic = curve.template GetIf<ConicCurve<Dimension>>())
  {
    return MakeConic<Makers>(*conic);
  }
  if (const auto* spline = curve.template GetIf<SplineCurve<Dimension>>())
  {
    const auto result = Handle(typename Makers::Spline)::DownCast(MakeSpline<Makers>(*spline));
    MakePeriodic(result);
    return Handle(typename Makers::Curve)(result);
  }
  if (const auto* offset = curve.template GetIf<OffsetCurve<Dimension>>())
  {
    return Makers::MakeOffset(*offset);
  }
  throw std::runtime_error("it is a curve of several parts, or on a surface");
}

/// Returns the profile of a swept surface, trimmed to its range if that is a part.
Handle(Geom_Curve) MakeProfile(const GeometricCurve<3>& curve, const ParameterRange& range)
{
  const Handle(Geom_Curve) whole = MakeKernelCurve(curve);
  const ParameterRange& domain = curve.GetDomain();
  const bool isWhole = !(range.Low > domain.Low || range.High < domain.High || range.Low < domain.Low);
  if (isWhole || !std::isfinite(range.Low) || !std::isfinite(range.High))
  {
    return whole;
  }
  return new Geom_TrimmedCurve(whole, range.Low, range.High, true, false);
}

Handle(Geom_Surface) MakeElementary(const ElementarySurface& value)
{
  const gp_Ax3 frame = ToFrame(value.Frame);
  switch (value.Kind)
  {
    case ElementarySurface::Type::Plane:
      return new Geom_Plane(frame);
    case ElementarySurface::Type::Cylinder:
      return new Geom_CylindricalSurface(frame, value.Radii[0]);
    case ElementarySurface::Type::Cone:
      return new Geom_ConicalSurface(frame, value.Angle, value.Radii[0]);
    case ElementarySurface::Type::Sphere:
      return new Geom_SphericalSurface(frame, value.Radii[0]);
    default:
      break;
  }
  return new Geom_ToroidalSurface(frame, value.Radii[0], value.Radii[1]);
}

Handle(Geom_Surface) MakeSplineSurface(const SplineSurface& spline)
{
  const int rows = spline.Basis[0].GetCount();
  const int columns = spline.Basis[1].GetCount();
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int j = 0; j < columns; ++j)
  {
    for (int i = 0; i < rows; ++i)
    {
      const std::size_t k = static_cast<std::size_t>(j) * rows + i;
      poles.SetValue(i + 1, j + 1, ToPoint(spline.Poles[k]));
      weights.SetValue(i + 1, j + 1, spline.Weights.empty() ? 1.0 : spline.Weights[k]);
    }
  }
  const SplineBasis& u = spline.Basis[0];
  const SplineBasis& v = spline.Basis[1];
  return spline.Weights.empty()
    ? new Geom_BSplineSurface(poles, ToKnots(u), ToKnots(v), ToMultiplicities(u), ToMultiplicities(v),
        u.Degree, v.Degree, u.Periodic, v.Periodic)
    : new Geom_BSplineSurface(poles, weights, ToKnots(u), ToKnots(v), ToMultiplicities(u),
        ToMultiplicities(v), u.Degree, v.Degree, u.Periodic, v.Periodic);
}
}

Handle(Geom_Curve) MakeKernelCurve(const GeometricCurve<3>& curve)
{
  return MakeCurve<SpaceMakers>(curve);
}

Handle(Geom2d_Curve) MakeKernelCurve(const GeometricCurve<2>& curve)
{
  return MakeCurve<PlaneMakers>(curve);
}

Handle(Geom_Surface) MakeKernelSurface(const GeometricSurface& surface)
{
  if (const auto* elementary = surface.GetIf<ElementarySurface>())
  {
    return MakeElementary(*elementary);
  }
  if (const auto* extruded = surface.GetIf<ExtrudedSurface>())
  {
    return new Geom_SurfaceOfLinearExtrusion(
      MakeProfile(*extruded->Profile, extruded->Range), ToDirection(extruded->Direction));
  }
  if (const auto* revolved = surface.GetIf<RevolvedSurface>())
  {
    return new Geom_SurfaceOfRevolution(MakeProfile(*revolved->Profile, revolved->Range),
      gp_Ax1(ToPoint(revolved->Origin), ToDirection(revolved->Axis)));
  }
  if (const auto* spline = surface.GetIf<SplineSurface>())
  {
    return MakeSplineSurface(*spline);
  }
  const auto& offset = std::get<OffsetSurface>(surface.GetValue());
  return new Geom_OffsetSurface(MakeKernelSurface(*offset.Basis), offset.Distance);
}
}
