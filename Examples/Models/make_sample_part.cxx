// Models the sample part that Examples/quickstart.sh measures, and writes it as STEP:
//   make_sample_part sample_part.step
// A hand lever in mm: a free-form arm lofted through closed splines, fused to a bored hub, with rolling-ball
// fillets, slanted and straight holes, a keyway and chamfers. The file has the same bytes on every run.
#include "smModelFile.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include <cmath>
#include <functional>

namespace
{
const double Pi = std::acos(-1.0);

/// Makes a closed C2 spline around the arm's path at x: a super-ellipse, higher at the back than at the
/// front.
TopoDS_Wire Section(double x, double y, double z, double halfWidth, double halfHeight, double yaw)
{
  const int n = 12;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, n);
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * Pi * i / n;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double side = halfWidth * std::copysign(std::pow(std::abs(c), 0.9), c);
    const double up = halfHeight * std::copysign(std::pow(std::abs(s), 0.9), s) * (1.0 + 0.12 * c);
    points->SetValue(i + 1, gp_Pnt(x - side * std::sin(yaw), y + side * std::cos(yaw), z + up));
  }
  GeomAPI_Interpolate curve(points, Standard_True, 1e-7);
  curve.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve())).Wire();
}

TopoDS_Shape Arm()
{
  BRepOffsetAPI_ThruSections loft(Standard_True, Standard_False, 1e-6);
  loft.AddWire(Section(0.0, 0.0, 13.0, 11.0, 7.5, 0.00));
  loft.AddWire(Section(24.0, 1.0, 14.0, 10.5, 7.0, 0.08));
  loft.AddWire(Section(48.0, 5.0, 18.5, 9.0, 5.8, 0.20));
  loft.AddWire(Section(72.0, 11.0, 23.5, 9.0, 5.8, 0.26));
  loft.AddWire(Section(96.0, 17.0, 26.0, 12.0, 7.0, 0.20));
  loft.AddWire(Section(118.0, 20.0, 26.0, 12.5, 7.6, 0.05));
  loft.AddWire(Section(134.0, 20.0, 25.0, 10.0, 6.4, -0.05));
  loft.Build();
  return loft.Shape();
}

TopoDS_Shape Cylinder(const gp_Pnt& start, const gp_Dir& axis, double radius, double length)
{
  return BRepPrimAPI_MakeCylinder(gp_Ax2(start, axis), radius, length).Shape();
}

/// Returns all edges whose middle point meets a condition.
TopTools_IndexedMapOfShape EdgesWhere(
  const TopoDS_Shape& shape, const std::function<bool(const gp_Pnt&)>& holds)
{
  TopTools_IndexedMapOfShape all;
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, TopAbs_EDGE, all);
  for (int i = 1; i <= all.Extent(); ++i)
  {
    const TopoDS_Edge edge = TopoDS::Edge(all(i));
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (!curve.IsNull() && holds(curve->Value(0.37 * first + 0.63 * last)))
    {
      found.Add(edge);
    }
  }
  return found;
}

TopoDS_Shape Fillet(const TopoDS_Shape& shape, double radius, const std::function<bool(const gp_Pnt&)>& holds)
{
  BRepFilletAPI_MakeFillet fillet(shape);
  const TopTools_IndexedMapOfShape edges = EdgesWhere(shape, holds);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    fillet.Add(radius, TopoDS::Edge(edges(i)));
  }
  fillet.Build();
  return fillet.Shape();
}

TopoDS_Shape Chamfer(const TopoDS_Shape& shape, double size, const std::function<bool(const gp_Pnt&)>& holds)
{
  BRepFilletAPI_MakeChamfer chamfer(shape);
  const TopTools_IndexedMapOfShape edges = EdgesWhere(shape, holds);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    chamfer.Add(size, TopoDS::Edge(edges(i)));
  }
  chamfer.Build();
  return chamfer.Shape();
}

TopoDS_Shape Cut(const TopoDS_Shape& body, const TopoDS_Shape& tool)
{
  return BRepAlgoAPI_Cut(body, tool).Shape();
}

bool IsAtRadius(const gp_Pnt& p, double radius)
{
  return std::abs(std::hypot(p.X(), p.Y()) - radius) < 1e-4;
}

TopoDS_Shape Lever()
{
  const double hubRadius = 17.0;
  const double hubHeight = 28.0;
  const double bore = 8.5;

  TopoDS_Shape body = Fillet(Arm(), 4.0, [](const gp_Pnt& p) { return p.X() > 126.0; });
  body = BRepAlgoAPI_Fuse(Cylinder(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), hubRadius, hubHeight), body).Shape();
  // The edges between arm and hub.
  body = Fillet(body, 3.5,
    [=](const gp_Pnt& p)
    { return IsAtRadius(p, hubRadius) && p.Z() > 1.0 && p.Z() < hubHeight - 1.0 && p.X() > 1.0; });
  body = Chamfer(body, 1.2,
    [=](const gp_Pnt& p) { return IsAtRadius(p, hubRadius) && (p.Z() < 1e-6 || p.Z() > hubHeight - 1e-6); });

  body = Cut(body, Cylinder(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1), bore, hubHeight + 2.0));
  body = Cut(body, BRepPrimAPI_MakeBox(gp_Pnt(-bore - 2.8, -2.5, -1), gp_Pnt(0, 2.5, hubHeight + 1)).Shape());
  body = Chamfer(body, 0.8,
    [=](const gp_Pnt& p) { return IsAtRadius(p, bore) && (p.Z() < 1e-6 || p.Z() > hubHeight - 1e-6); });
  // A slanted hole for a clamping screw through the wall of the hub.
  body = Cut(body, Cylinder(gp_Pnt(0, 0, 15), gp_Dir(-0.25, -1, 0.3), 2.6, 40.0));
  // Two holes through the grip, one of them slanted.
  body = Cut(body, Cylinder(gp_Pnt(118, 20, 0), gp_Dir(0, 0, 1), 5.0, 50.0));
  body = Cut(body, Cylinder(gp_Pnt(92, 16, 0), gp_Dir(0.12, 0.05, 1), 3.2, 60.0));
  // The edges around the end of the hole through the grip.
  body = Fillet(body, 1.0,
    [](const gp_Pnt& p) { return std::abs(std::hypot(p.X() - 118.0, p.Y() - 20.0) - 5.0) < 1e-4; });
  return body;
}
}

int main(int argc, char** argv)
{
  return smmodel::Run(
    argc, argv, { "sample_part", "SolidMoments sample part: a hand lever", "make_sample_part" }, Lever);
}
