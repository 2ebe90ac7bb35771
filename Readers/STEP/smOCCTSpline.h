/**
 * @file smOCCTSpline.h
 * @brief The flat knot vectors of OpenCASCADE's splines, and the basis of its trimmed curves
 */
#ifndef smOCCTSpline_h
#define smOCCTSpline_h

#include "Geometry/smFlatKnots.h"

#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <array>
#include <vector>

namespace sm
{
/// The same for OpenCASCADE's knots.
inline FlatKnots MakeFlatKnots(int degree, const TColStd_Array1OfReal& knots,
  const TColStd_Array1OfInteger& multiplicities, bool periodic, double low, double high)
{
  return MakeFlatKnots(degree, std::vector<double>(knots.begin(), knots.end()),
    std::vector<int>(multiplicities.begin(), multiplicities.end()), periodic, low, high);
}

/// Returns the basis curve of trimmed curves, which has the same parameter.
inline Handle(Geom2d_Curve) GetBasis(Handle(Geom2d_Curve) curve)
{
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

inline Handle(Geom_Curve) GetBasis(Handle(Geom_Curve) curve)
{
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

template <class Spline>
std::vector<double> GetSplineBreaks(const Handle(Spline) & spline, double first, double last)
{
  return MakeBreaks(first, last,
    MakeFlatKnots(
      spline->Degree(), spline->Knots(), spline->Multiplicities(), spline->IsPeriodic(), first, last)
      .Knots);
}

/// Gets the poles and knots of a polynomial spline or Bézier curve; returns false for any other curve.
template <int Dimension, class Spline, class Bezier, class Curve, class MapPole>
bool GetPolynomial(const Handle(Curve) & curve, double first, double last, FlatKnots& flat,
  std::vector<std::array<double, Dimension>>& poles, const MapPole& mapPole)
{
  if (const auto spline = Handle(Spline)::DownCast(curve))
  {
    if (spline->IsRational())
    {
      return false;
    }
    flat = MakeFlatKnots(
      spline->Degree(), spline->Knots(), spline->Multiplicities(), spline->IsPeriodic(), first, last);
    for (const int i : flat.Poles)
    {
      poles.push_back(mapPole(spline->Pole(i + 1)));
    }
    return true;
  }
  if (const auto bezier = Handle(Bezier)::DownCast(curve))
  {
    if (bezier->IsRational())
    {
      return false;
    }
    flat.Degree = bezier->Degree();
    flat.Knots.assign(flat.Degree + 1, 0.0);
    flat.Knots.insert(flat.Knots.end(), flat.Degree + 1, 1.0);
    for (int i = 1; i <= bezier->NbPoles(); ++i)
    {
      poles.push_back(mapPole(bezier->Pole(i)));
    }
    return true;
  }
  return false;
}
}

#endif
