#include "smExactSolids.h"

#include "smExactSpline.h"
#include "smRationalBlock.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Bnd_Box.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Pln.hxx>

namespace smtest
{
namespace
{
/// The solid inside a compound that a Boolean operation returns.
TopoDS_Shape FirstSolid(const TopoDS_Shape& shape)
{
  TopExp_Explorer explorer(shape, TopAbs_SOLID);
  return explorer.More() ? explorer.Current() : TopoDS_Shape();
}

ExactSolid MakeBlockWithHole()
{
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(40.0, 24.0, 16.0);
  const gp_Ax2 axis(gp_Pnt(12.0 - 0.75 * 8.0, 11.0, -8.0), gp_Dir(0.6, 0.0, 0.8));
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(axis, 5.0, 60.0);
  return MakeExactSolid(
    FirstSolid(BRepAlgoAPI_Cut(block, drill).Shape()), SlantedHole(40, 24, 16, 5, 12, 11, 0.75L), true);
}

ExactSolid MakeBicylinder()
{
  const TopoDS_Shape x = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-20, 0, 0), gp_Dir(1, 0, 0)), 10.0, 40.0);
  const TopoDS_Shape y = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, -20, 0), gp_Dir(0, 1, 0)), 10.0, 40.0);
  return MakeExactSolid(FirstSolid(BRepAlgoAPI_Common(x, y).Shape()), Bicylinder(10), true);
}

ExactSolid MakeHollowSphere()
{
  const TopoDS_Shape outer = BRepPrimAPI_MakeSphere(10.0);
  const TopoDS_Shape inner = BRepPrimAPI_MakeSphere(gp_Pnt(1.0, 2.0, -1.5), 6.0);
  Placement placement;
  placement.Translation = { 1, 2, -1.5L };
  return MakeExactSolid(FirstSolid(BRepAlgoAPI_Cut(outer, inner).Shape()),
    Combined(Sphere(10), Moved(Sphere(6), placement), -1), true);
}

ExactSolid MakeEllipsoid()
{
  gp_GTrsf scale;
  scale.SetValue(1, 1, 1.5);
  scale.SetValue(3, 3, 0.5);
  // GTransform turns the sphere into a rational B-spline and scales its control points.
  const TopoDS_Shape shape = BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(10.0).Shape(), scale, true);
  return MakeExactSolid(FirstSolid(shape), Ellipsoid(15, 10, 5), false);
}

/// The face inside a closed spline; `revolved` puts (p, q) at (x, z) instead of (x, y).
TopoDS_Shape MakeFace(const ClosedSpline& spline, bool revolved)
{
  const int poleCount = static_cast<int>(spline.Poles.size());
  TColgp_Array1OfPnt poles(1, poleCount);
  for (int i = 0; i < poleCount; ++i)
  {
    const double p = spline.Poles[i][0];
    const double q = spline.Poles[i][1];
    poles.SetValue(i + 1, revolved ? gp_Pnt(p, 0, q) : gp_Pnt(p, q, 0));
  }
  const int knotCount = static_cast<int>(spline.Knots.size()) - 6;
  TColStd_Array1OfReal knots(1, knotCount);
  TColStd_Array1OfInteger multiplicities(1, knotCount);
  for (int i = 0; i < knotCount; ++i)
  {
    knots.SetValue(i + 1, spline.Knots[i + 3]);
    multiplicities.SetValue(i + 1, i == 0 || i == knotCount - 1 ? 4 : 1);
  }
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve));
  const gp_Dir normal = revolved ? gp_Dir(0, -1, 0) : gp_Dir(0, 0, 1);
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), normal), wire);
}

ExactSolid MakeExtruded(const ClosedSpline& spline, double height)
{
  return MakeExactSolid(BRepPrimAPI_MakePrism(MakeFace(spline, false), gp_Vec(0, 0, height)).Shape(),
    Extruded(spline, height), true);
}

ExactSolid MakeRing()
{
  const ClosedSpline section = RingSection();
  return MakeExactSolid(
    BRepPrimAPI_MakeRevol(MakeFace(section, true), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape(),
    Revolved(section), true);
}

ExactSolid MakeWavyPlate()
{
  const double heights[4][4] = { { 0, 3, -2, 1 }, { 2, 9, -5, 0.5 }, { -4, 6, 8, -3 }, { 1, -2, 4, 2.5 } };
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      poles.SetValue(i + 1, j + 1, gp_Pnt(10.0 * i, 8.0 * j, heights[i][j]));
    }
  }
  TColStd_Array1OfReal knots(1, 2);
  knots.SetValue(1, 0.0);
  knots.SetValue(2, 1.0);
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(4);
  const Handle(Geom_BSplineSurface) surface =
    new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(surface, 1e-7);
  ExactMoments moments = ExtrudedGraph(30, 24, heights, 6);
  moments.Area = IntegrateBlock(
    MakeBlock({ 3, 3, 1 },
      [&](double u, double v, double w)
      {
        const double height = heights[std::lround(3 * u)][std::lround(3 * v)];
        return std::array<double, 3>{ 30 * u, 24 * v, height + 6 * w };
      })).Area;
  return MakeExactSolid(BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 6.0)).Shape(), moments, true);
}

/// Rotation of the quaternion w + xi + yj + zk.
Matrix MakeRotation(Real w, Real x, Real y, Real z)
{
  const Real n = w * w + x * x + y * y + z * z;
  return { { { (w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n },
    { 2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n },
    { 2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n } } };
}
}

ExactSolid MakeExactSolid(const TopoDS_Shape& shape, const ExactMoments& moments, bool convertsExactly)
{
  ExactSolid solid;
  solid.Shape = shape;
  solid.Moments = moments;
  solid.ConvertsExactly = convertsExactly;
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  solid.Size = std::sqrt(box.SquareExtent());
  return solid;
}

const std::vector<NamedSolid>& GetExactSolids()
{
  static const std::vector<NamedSolid> solids = {
    { "box",
      [] { return MakeExactSolid(BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape(), Box(30, 20, 10), true); } },
    { "cylinder",
      [] { return MakeExactSolid(BRepPrimAPI_MakeCylinder(8.0, 25.0).Shape(), Cylinder(8, 25), true); } },
    { "cone",
      [] {
        return MakeExactSolid(BRepPrimAPI_MakeCone(12.0, 5.0, 20.0).Shape(), ConeFrustum(12, 5, 20), true);
      } },
    { "sphere", [] { return MakeExactSolid(BRepPrimAPI_MakeSphere(10.0).Shape(), Sphere(10), true); } },
    { "torus", [] { return MakeExactSolid(BRepPrimAPI_MakeTorus(20.0, 6.0).Shape(), Torus(20, 6), true); } },
    { "slanted_hole", MakeBlockWithHole },
    { "bicylinder", MakeBicylinder },
    { "hollow_sphere", MakeHollowSphere },
    { "ellipsoid", MakeEllipsoid },
    { "airfoil", [] { return MakeExtruded(Airfoil(160), 40.0); } },
    { "gear",
      []
      {
        ExactSolid gear = MakeExtruded(Gear(40), 12.0);
        gear.Comparable = false;
        return gear;
      } },
    { "spline_ring", MakeRing },
    { "wavy_plate", MakeWavyPlate },
  };
  return solids;
}

std::vector<Variant> GetVariants(const ExactSolid& solid)
{
  // Room for all, so that references to earlier ones stay valid.
  std::vector<Variant> variants;
  variants.reserve(16);
  auto add = [&](const char* name) -> Variant&
  {
    variants.emplace_back();
    variants.back().Name = name;
    return variants.back();
  };
  add("plain");
  add("nopcurves").WithPcurves = false;
  if (solid.ConvertsExactly)
  {
    add("nurbs").AsNurbs = true;
  }
  // Entries of the rotation are multiples of 0.04, so the file holds it without error.
  const Matrix turn = MakeRotation(2, 4, 2, 1);
  Placement& moved = add("moved").Move;
  moved.Rotation = turn;
  moved.Translation = { 15.5L, -40.25L, 7 };
  Variant& turned = add("turned");
  turned.Move.Rotation = MakeRotation(1, -3, 0.5L, 2.25L);
  turned.Move.Translation = { 1000, 2000, -500 };
  turned.WithPcurves = false;
  Variant& digits = add("digits12");
  digits.Move = turned.Move;
  digits.AllDigits = false;
  add("scaled").Move.Scale = 0.05L;
  Placement& large = add("large").Move;
  large.Scale = 40;
  large.Rotation = turn;
  Placement& mirrored = add("mirrored").Move;
  mirrored.Rotation = turn;
  for (Vector& row : mirrored.Rotation)
  {
    row[0] = -row[0];
  }
  mirrored.Translation = { 0, 5, 3 };
  // The scales are doubles, as the transformation has them.
  add("tiny").Move.Scale = 1e-3 / solid.Size;
  add("huge").Move.Scale = 1e5 / solid.Size;
  add("reversed").Reversed = true;
  Placement& far = add("far").Move;
  far.Translation = { 1e5L, -1e5L, 0.5e5L };
  const double sizes = std::round(1e5 * solid.Size);
  add("distant").Move.Translation = { sizes, -sizes, 0.5L * sizes };
  add("inch").Unit = "INCH";
  return variants;
}

TopoDS_Shape MovedShape(const TopoDS_Shape& shape, const Placement& placement)
{
  gp_Trsf transform;
  const Matrix& r = placement.Rotation;
  const double s = static_cast<double>(placement.Scale);
  auto entry = [&](int i, int j) { return s * static_cast<double>(r[i][j]); };
  auto shift = [&](int i) { return static_cast<double>(placement.Translation[i]); };
  transform.SetValues(entry(0, 0), entry(0, 1), entry(0, 2), shift(0), entry(1, 0), entry(1, 1), entry(1, 2),
    shift(1), entry(2, 0), entry(2, 1), entry(2, 2), shift(2));
  return BRepBuilderAPI_Transform(shape, transform, true).Shape();
}
}
