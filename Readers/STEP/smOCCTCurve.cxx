#include "smOCCTCurve.h"

#include "smOCCTSpline.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>

#include <algorithm>

namespace sm
{
std::vector<double> GetCurveBreaks(const Handle(Geom_Curve) & source, double first, double last)
{
  Handle(Geom_Curve) curve = GetBasis(source);
  while (const auto offset = Handle(Geom_OffsetCurve)::DownCast(curve))
  {
    curve = GetBasis(offset->BasisCurve());
  }
  if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve))
  {
    return GetSplineBreaks(spline, first, last);
  }
  return { first, last };
}

EdgeCurve FitEdge(const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map)
{
  // OpenCASCADE rounds in its own coordinates, before a translation that may cancel most of them.
  const Vector3& t = map.Translation;
  return FitEdge([&](double x) { return map.MapPoint(curve->Value(x).XYZ()); },
    GetCurveBreaks(curve, first, last), std::max({ std::abs(t[0]), std::abs(t[1]), std::abs(t[2]) }));
}

EdgeCurve ConvertEdge(const Handle(Geom_Curve) & source, double first, double last, const AffineMap& map)
{
  const Handle(Geom_Curve) curve = GetBasis(source);
  EdgeCurve result;
  if (Handle(Geom_Line)::DownCast(curve))
  {
    const Vector3 ends[2] = { map.MapPoint(curve->Value(first).XYZ()),
      map.MapPoint(curve->Value(last).XYZ()) };
    result.Breaks.push_back(first);
    result.AppendPiece(last, ends, 1);
    return result;
  }
  FlatKnots flat;
  std::vector<Vector3> poles;
  if (GetPolynomial<3, Geom_BSplineCurve, Geom_BezierCurve>(
        curve, first, last, flat, poles, [&map](const gp_Pnt& p) { return map.MapPoint(p.XYZ()); }))
  {
    const std::vector<double> breaks = GetCurveBreaks(curve, first, last);
    result.Breaks.push_back(first);
    Vector3 piece[MaximumDegree + 1];
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      ExtractBezierPiece<3>(flat, poles, breaks[i], breaks[i + 1], piece);
      result.AppendPiece(breaks[i + 1], piece, flat.Degree);
    }
    return result;
  }
  return FitEdge(curve, first, last, map);
}
}
