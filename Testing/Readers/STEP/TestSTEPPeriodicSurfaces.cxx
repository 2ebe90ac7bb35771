/**
 * @file TestSTEPPeriodicSurfaces.cxx
 * @brief Closed splines, clamped or not, become periodic with the same points as OpenCASCADE's
 */
#include "Geometry/smGeometryConversion.h"
#include "Geometry/smPeriodicSurface.h"
#include "Geometry/smSurfaceConversion.h"
#include "Trims/smTrimConversion.h"
#include "smOCCTGeometry.h"
#include "smSurfaceTesting.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace smtest;

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
}

int TestSTEPPeriodicSurfaces(int, char*[])
{
  CheckFileSurfaces();
  CheckPeriodicSurfaces();
  CheckPeriodicCurves();
  return Finish();
}
