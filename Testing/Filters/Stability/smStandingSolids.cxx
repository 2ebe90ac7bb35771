#include "smStandingSolids.h"

#include "smStepFile.h"

#include <vtkMath.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include <cmath>

namespace smtest
{
namespace
{
}

TopoDS_Shape MakeLeaningPrism(double a, double b, double height, double lean)
{
  BRepBuilderAPI_MakePolygon base(gp_Pnt(0, 0, 0), gp_Pnt(a, 0, 0), gp_Pnt(a, b, 0), gp_Pnt(0, b, 0), true);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(base.Wire(), true).Face(), gp_Vec(lean, 0, height))
    .Shape();
}

TopoDS_Shape MakeHemisphere(double radius, bool below)
{
  return below ? BRepPrimAPI_MakeSphere(radius, -vtkMath::Pi() / 2, 0.0).Shape()
               : BRepPrimAPI_MakeSphere(radius, 0.0, vtkMath::Pi() / 2).Shape();
}

TopoDS_Shape MakeLyingCylinder(double radius, double length)
{
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, 0, 1)), radius, length)
    .Shape();
}

TopoDS_Shape MakeLyingHalfCylinder(double radius, double length)
{
  // OpenCASCADE turns counter-clockwise about the axis: from y to -z about -x.
  return BRepPrimAPI_MakeCylinder(
    gp_Ax2(gp_Pnt(length, 0, 0), gp_Dir(-1, 0, 0), gp_Dir(0, 1, 0)), radius, length, vtkMath::Pi())
    .Shape();
}

TopoDS_Shape MakeTripod(double distance)
{
  TopoDS_Shape body = BRepPrimAPI_MakeCylinder(distance + 2.0, 2.0).Shape();
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / 3.0 + 0.3;
    const gp_Pnt foot(distance * std::cos(angle), distance * std::sin(angle), 0.0);
    body = BRepAlgoAPI_Fuse(body, BRepPrimAPI_MakeSphere(foot, 1.0).Shape()).Shape();
  }
  return body;
}

TopoDS_Shape MakeDumbbell(double radius, double length)
{
  // The profile above the x axis, revolved about it.
  const double bar = radius / 3.0;
  const double reach = std::sqrt(radius * radius - bar * bar);
  const gp_Pnt p[6] = { { -radius, 0, 0 }, { 0, radius, 0 }, { reach, bar, 0 }, { length - reach, bar, 0 },
    { length, radius, 0 }, { length + radius, 0, 0 } };
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p[0], p[1], p[2]).Value()).Edge(),
    BRepBuilderAPI_MakeEdge(p[2], p[3]).Edge(),
    BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p[3], p[4], p[5]).Value()).Edge(),
    BRepBuilderAPI_MakeEdge(p[5], p[0]).Edge());
  return BRepPrimAPI_MakeRevol(
    BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)))
    .Shape();
}

TopoDS_Shape MakeHalfRocker()
{
  // First moments in x of the quarter of the disc, r^3/3, and of the triangle, r a^2/6.
  const double r = 2.0;
  const double a = std::sqrt(2.0) * r;
  const gp_Pnt p[4] = { { 0, 0, 0 }, { a, 0, 0.2 * a }, { 0, 0, r }, { -r, 0, r } };
  const gp_Pnt middle(-r * std::sqrt(0.5), 0, r - r * std::sqrt(0.5));
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(p[0], p[1]).Edge(),
    BRepBuilderAPI_MakeEdge(p[1], p[2]).Edge(), BRepBuilderAPI_MakeEdge(p[2], p[3]).Edge(),
    BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p[3], middle, p[0]).Value()).Edge());
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Vec(0, 3, 0)).Shape();
}

TopoDS_Shape MakeHalfBall()
{
  // The half in y > 0 has the moment 2/3 pi r^3 * 3/8 r in y, the block -w d t^2 / 2 with width w, height d,
  // thickness t.
  const double r = 10.0;
  const double width = 10.0;
  const double height = 10.0;
  const double thickness = std::sqrt(0.5 * vtkMath::Pi() * r * r * r * r / (width * height));
  const TopoDS_Shape half = BRepPrimAPI_MakeSphere(r, vtkMath::Pi()).Shape();
  const gp_Pnt corner(-0.5 * width, -thickness, -8.0);
  return BRepAlgoAPI_Fuse(half, BRepPrimAPI_MakeBox(corner, width, thickness, height).Shape()).Shape();
}

TopoDS_Shape MakeObliqueCylinder(double radius, double height, double leanX, double leanY, bool half)
{
  BRepBuilderAPI_MakeWire wire;
  if (half)
  {
    const gp_Pnt from(0, -radius, 0);
    const gp_Pnt to(0, radius, 0);
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, gp_Pnt(radius, 0, 0), to).Value()).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(to, from).Edge());
  }
  else
  {
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(), radius)).Edge());
  }
  return BRepPrimAPI_MakePrism(
    BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Vec(leanX, leanY, height))
    .Shape();
}

TopoDS_Shape MakeTipCone(double radius, double height)
{
  return BRepPrimAPI_MakeCone(0.0, radius, height).Shape();
}

TopoDS_Shape Rotated(const TopoDS_Shape& shape, const double axis[3], double angle, const double shift[3])
{
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(axis[0], axis[1], axis[2])), angle);
  gp_Trsf move;
  move.SetTranslation(gp_Vec(shift[0], shift[1], shift[2]));
  return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

std::string WriteStanding(
  const std::string& folder, const std::string& name, const TopoDS_Shape& shape, const char* unit)
{
  StepOptions options;
  options.Unit = unit;
  const std::string path = folder + "/standing_" + name + ".step";
  WriteStep(shape, path, options);
  return path;
}
}
