#include "smPaperSolid.h"

#include "smSolidBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smfigure
{
using namespace sm;
namespace
{
const double Pi = std::acos(-1.0);
const double HalfSqrt2 = std::sqrt(0.5);
/// Number of polynomial pieces for a quarter of a circle; the error of the fit is of the size of rounding.
constexpr int PiecesPerQuarter = 8;

/// (cos, sin) on the unit circle as rational quarter arcs, u in [0,4], a quarter for each unit of u.
Point2 EvaluateCircle(double u)
{
  const int quarter = std::min(static_cast<int>(u), 3);
  const double s = u - quarter;
  const double b[3] = { (1.0 - s) * (1.0 - s), 2.0 * s * (1.0 - s) * HalfSqrt2, s * s };
  const double w = b[0] + b[1] + b[2];
  const double c = (b[0] + b[1]) / w;
  const double d = (b[1] + b[2]) / w;
  const Point2 rotated[4] = { { c, d }, { -d, c }, { -c, -d }, { d, -c } };
  return rotated[quarter];
}

/// Homogeneous control points of EvaluateCircle's quarters: (cos, sin, weight).
std::vector<Point3> MakeCirclePoints(int quarters)
{
  const double corner[8][2] = { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { -1, -1 }, { 0, -1 },
    { 1, -1 } };
  std::vector<Point3> points;
  for (int i = 0; i <= 2 * quarters; ++i)
  {
    const double weight = i % 2 ? HalfSqrt2 : 1.0;
    points.push_back({ weight * corner[i % 8][0], weight * corner[i % 8][1], weight });
  }
  return points;
}

/// The circle `center` + radius (cos a + sin b), u in [0, quarters], swept along `axis`, v in [v0, v1].
NURBSSurface MakeSweptCircle(int quarters, double radius, const Point3& center, const Point3& a,
  const Point3& b, const Point3& axis, double v0, double v1)
{
  NURBSSurface surface;
  surface.Degree[0] = 2;
  surface.Rational = true;
  for (int q = 0; q <= quarters; ++q)
  {
    surface.Knots[0].insert(surface.Knots[0].end(), q == 0 || q == quarters ? 3 : 2, q);
  }
  surface.Knots[1] = { v0, v0, v1, v1 };
  surface.NumberOfControlPoints[0] = 2 * quarters + 1;
  surface.NumberOfControlPoints[1] = 2;
  for (const double v : { v0, v1 })
  {
    for (const Point3& p : MakeCirclePoints(quarters))
    {
      std::array<double, 4> point{ 0.0, 0.0, 0.0, p[2] };
      for (int d = 0; d < 3; ++d)
      {
        point[d] = p[2] * (center[d] + v * axis[d]) + radius * (p[0] * a[d] + p[1] * b[d]);
      }
      surface.ControlPoints.push_back(point);
    }
  }
  return surface;
}

/// A block with the half sizes A, B, C and a hole of radius R. The axis of the hole is (Sine, 0, Cosine) v,
/// its circle R (cos e1 + sin e2) with e1 = (Cosine, 0, -Sine) and e2 = y.
struct SlantedHole
{
  double A = 30.0;
  double B = 20.0;
  double C = 15.0;
  double R = 9.0;
  double Cosine = std::cos(25.0 * Pi / 180.0);
  double Sine = std::sin(25.0 * Pi / 180.0);

  /// v of the rim at the bottom (end 0) or the top (end 1).
  double GetHeight(int end, double u) const
  {
    return ((end ? this->C : -this->C) + this->R * this->Sine * EvaluateCircle(u)[0]) / this->Cosine;
  }
  Point3 GetRim(int end, double u) const
  {
    const Point2 q = EvaluateCircle(u);
    const double v = this->GetHeight(end, u);
    return { v * this->Sine + this->R * q[0] * this->Cosine, this->R * q[1], end ? this->C : -this->C };
  }
  /// Returns the rim in the parameters of its plane; those of the bottom are along x and -y.
  Point2 GetRimOnPlane(int end, double u) const
  {
    const Point3 q = this->GetRim(end, u);
    return { (q[0] + this->A) / (2.0 * this->A), ((end ? q[1] : -q[1]) + this->B) / (2.0 * this->B) };
  }
};

void AddHoleFace(SolidBuilder& builder, const SlantedHole& hole, const SolidBuilder::EdgePointer (&rims)[2])
{
  const auto trim = [&](int end)
  {
    return FitCurve<2>(
      [&, end](double u) {
        return Point2{ u, hole.GetHeight(end, u) };
      },
      0.0, 4.0, 4 * PiecesPerQuarter);
  };
  const Point3 low = rims[0]->StartVertex;
  const Point3 high = rims[1]->StartVertex;
  Loop around;
  around.Coedges = { SolidBuilder::MakeCoedge(rims[0], false, trim(0)),
    builder.MakeStraightCoedge(low, high, { 4, hole.GetHeight(0, 4) }, { 4, hole.GetHeight(1, 4) }),
    SolidBuilder::MakeCoedge(rims[1], true, trim(1)),
    builder.MakeStraightCoedge(high, low, { 0, hole.GetHeight(1, 0) }, { 0, hole.GetHeight(0, 0) }) };
  const double reach = (hole.C + hole.R * hole.Sine) / hole.Cosine;
  builder.AddFace(MakeSweptCircle(4, hole.R, { 0, 0, 0 }, { hole.Cosine, 0, -hole.Sine }, { 0, 1, 0 },
                    { hole.Sine, 0, hole.Cosine }, -reach, reach),
    { around }, true);
}
}

PaperSolid MakeQuarterCylinder()
{
  const double r = 10.0;
  const double h = 25.0;
  SolidBuilder builder;
  const Point3 axis[2] = { { 0, 0, 0 }, { h, 0, 0 } };
  const Point3 side[2] = { { 0, r, 0 }, { h, r, 0 } };
  const Point3 top[2] = { { 0, 0, r }, { h, 0, r } };
  SolidBuilder::EdgePointer arcs[2];
  for (int end = 0; end < 2; ++end)
  {
    const double x = axis[end][0];
    arcs[end] = builder.AddEdge(FitCurve<3>(
      [&](double u)
      {
        const Point2 p = EvaluateCircle(u);
        return Point3{ x, r * p[0], r * p[1] };
      },
      0.0, 1.0, PiecesPerQuarter));
  }
  // u along the arc from y to z, v along x: Su x Sv points outward.
  Loop around;
  around.Coedges = { SolidBuilder::MakeCoedge(arcs[0], false, MakeLine<2>({ 0, 0 }, { 1, 0 })),
    builder.MakeStraightCoedge(top[0], top[1], { 1, 0 }, { 1, h }),
    SolidBuilder::MakeCoedge(arcs[1], true, MakeLine<2>({ 0, h }, { 1, h })),
    builder.MakeStraightCoedge(side[1], side[0], { 0, h }, { 0, 0 }) };
  builder.AddFace(
    MakeSweptCircle(1, r, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, 0.0, h), { around });
  builder.AddPlane({ axis[0], side[0], side[1], axis[1] });
  builder.AddPlane({ axis[1], top[1], top[0], axis[0] });
  const TrimCurve arc2 = FitCurve<2>(EvaluateCircle, 0.0, 1.0, PiecesPerQuarter);
  for (int end = 0; end < 2; ++end)
  {
    // (u,v) = (y,z) / r: its normal is +x, outward at the far end.
    const Point3 square[4] = { axis[end], side[end], { axis[end][0], r, r }, top[end] };
    Loop sector;
    sector.Coedges = { builder.MakeStraightCoedge(axis[end], side[end], { 0, 0 }, { 1, 0 }),
      SolidBuilder::MakeCoedge(arcs[end], false, arc2),
      builder.MakeStraightCoedge(top[end], axis[end], { 0, 1 }, { 0, 0 }) };
    builder.AddFace(MakePlaneSurface(square), { sector }, end == 0);
  }
  const double bounds[6] = { 0, h, 0, r, 0, r };
  return { builder.Make("quarter cylinder", true, bounds), Pi * r * r * h / 4.0 };
}

PaperSolid MakeSlantedBlock()
{
  const SlantedHole hole;
  const double a = hole.A;
  const double b = hole.B;
  const double c = hole.C;
  SolidBuilder builder;
  Point3 p[8]; // bit d of the index: the high side in direction d
  for (int i = 0; i < 8; ++i)
  {
    p[i] = { i & 1 ? a : -a, i & 2 ? b : -b, i & 4 ? c : -c };
  }
  SolidBuilder::EdgePointer rims[2];
  for (int end = 0; end < 2; ++end)
  {
    rims[end] = builder.AddEdge(
      FitCurve<3>([&](double u) { return hole.GetRim(end, u); }, 0.0, 4.0, 4 * PiecesPerQuarter));
    // The outer loop is counter-clockwise, the hole clockwise.
    Loop loop;
    loop.Coedges = { SolidBuilder::MakeCoedge(rims[end], end == 1,
      FitCurve<2>([&](double u) { return hole.GetRimOnPlane(end, u); }, 0.0, 4.0, 4 * PiecesPerQuarter)) };
    if (end)
    {
      builder.AddPlane({ p[4], p[5], p[7], p[6] }, { loop });
    }
    else
    {
      builder.AddPlane({ p[2], p[3], p[1], p[0] }, { loop });
    }
  }
  builder.AddPlane({ p[0], p[1], p[5], p[4] });
  builder.AddPlane({ p[3], p[2], p[6], p[7] });
  builder.AddPlane({ p[1], p[3], p[7], p[5] });
  builder.AddPlane({ p[2], p[0], p[4], p[6] });
  AddHoleFace(builder, hole, rims);
  const double bounds[6] = { -a, a, -b, b, -c, c };
  return { builder.Make("block with slanted hole", true, bounds),
    8.0 * a * b * c - Pi * hole.R * hole.R * 2.0 * c / hole.Cosine };
}

PaperSolid MakeTrimmedPatch()
{
  NURBSSurface surface;
  surface.Degree[0] = surface.Degree[1] = 3;
  surface.Knots[0] = { 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4 };
  surface.Knots[1] = { 0, 0, 0, 0, 1, 2, 3, 3, 3, 3 };
  surface.NumberOfControlPoints[0] = 7;
  surface.NumberOfControlPoints[1] = 6;
  for (int j = 0; j < 6; ++j)
  {
    for (int i = 0; i < 7; ++i)
    {
      surface.ControlPoints.push_back(
        { 10.0 * i, 10.0 * j, 8.0 * std::sin(0.9 * i) * std::cos(0.7 * j), 1.0 });
    }
  }
  SolidBuilder builder;
  const auto add = [&](const TrimCurve& curve)
  {
    return SolidBuilder::MakeCoedge(builder.AddEdge(FitCurve<3>(
                                      [&](double t)
                                      {
                                        const Point2 at = curve.Evaluate(t);
                                        Point3 point;
                                        surface.Evaluate(at[0], at[1], point.data());
                                        return point;
                                      },
                                      curve.GetStart(), curve.GetEnd(), 4 * PiecesPerQuarter)),
      false, curve);
  };
  const auto wave = [](double t) { return Point2{ 4.0 - t, 2.6 - 0.3 * std::cos(1.25 * Pi * t) }; };
  Loop outer;
  outer.Coedges = { add(MakeLine<2>({ 0, 0 }, { 4, 0 })), add(MakeLine<2>({ 4, 0 }, wave(0.0))),
    add(FitCurve<2>(wave, 0.0, 4.0, 4 * PiecesPerQuarter)), add(MakeLine<2>(wave(4.0), { 0, 0 })) };
  Loop hole;
  hole.Coedges = { add(FitCurve<2>(
    [](double u)
    {
      const Point2 p = EvaluateCircle(4.0 - u);
      return Point2{ 1.6 + 0.8 * p[0], 1.15 + 0.62 * p[1] };
    },
    0.0, 4.0, 4 * PiecesPerQuarter)) };
  builder.AddFace(surface, { outer, hole });
  const double bounds[6] = { 0, 60, 0, 50, -8, 8 };
  return { builder.Make("trimmed patch", false, bounds), std::numeric_limits<double>::quiet_NaN() };
}
}
