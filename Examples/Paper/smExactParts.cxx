#include "smModelling.h"
#include "smPaperParts.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pln.hxx>

#include <cmath>

namespace smpaper
{
namespace
{
TopoDS_Shape QuarterDisk(double radius, double y)
{
  const gp_Pnt center(0.0, y, 0.0);
  const gp_Pnt onX(radius, y, 0.0);
  const gp_Pnt onZ(0.0, y, radius);
  // The rational quarter arc that is also the border of the round face.
  TColgp_Array1OfPnt poles(1, 3);
  TColStd_Array1OfReal weights(1, 3);
  TColStd_Array1OfReal knots(1, 2);
  TColStd_Array1OfInteger multiplicities(1, 2);
  poles(1) = onX;
  poles(2) = gp_Pnt(radius, y, radius);
  poles(3) = onZ;
  weights.Init(1.0);
  weights(2) = std::sqrt(0.5);
  knots(1) = 0.0;
  knots(2) = 1.0;
  multiplicities.Init(3);
  const Handle(Geom_BSplineCurve) arc = new Geom_BSplineCurve(poles, weights, knots, multiplicities, 2);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(center, onX).Edge(),
    BRepBuilderAPI_MakeEdge(arc).Edge(), BRepBuilderAPI_MakeEdge(onZ, center).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Shape();
}

TopoDS_Shape Rectangle(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d)
{
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(a, b).Edge(), BRepBuilderAPI_MakeEdge(b, c).Edge(),
    BRepBuilderAPI_MakeEdge(c, d).Edge(), BRepBuilderAPI_MakeEdge(d, a).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Shape();
}

/// Makes the curved face of degree 2 x 1, with u along the quarter arc, v along the axis, and one knot
/// interval in each direction.
TopoDS_Shape QuarterRound(double radius, double length)
{
  const double across[] = { radius, radius, 0.0 };
  const double up[] = { 0.0, radius, radius };
  TColgp_Array2OfPnt poles(1, 3, 1, 2);
  TColStd_Array2OfReal weights(1, 3, 1, 2);
  for (int i = 1; i <= 3; ++i)
  {
    for (int end = 1; end <= 2; ++end)
    {
      poles(i, end) = gp_Pnt(across[i - 1], end == 1 ? 0.0 : length, up[i - 1]);
      weights(i, end) = i == 2 ? std::sqrt(0.5) : 1.0;
    }
  }
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0.0;
  knots(2) = 1.0;
  TColStd_Array1OfInteger round(1, 2);
  TColStd_Array1OfInteger straight(1, 2);
  round.Init(3);
  straight.Init(2);
  const Handle(Geom_BSplineSurface) surface =
    new Geom_BSplineSurface(poles, weights, knots, knots, round, straight, 2, 1);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
}
}

PaperPart MakeQuarterCylinder()
{
  const double radius = 10.0;
  const double length = 40.0;
  PaperPart part;
  part.Name = "quarter_cylinder";
  const gp_Pnt origin(0.0, 0.0, 0.0);
  const gp_Pnt end(0.0, length, 0.0);
  const TopoDS_Shape solid = SolidOfFaces({ QuarterRound(radius, length), QuarterDisk(radius, 0.0),
    QuarterDisk(radius, length), Rectangle(origin, gp_Pnt(radius, 0, 0), gp_Pnt(radius, length, 0), end),
    Rectangle(origin, gp_Pnt(0, 0, radius), gp_Pnt(0, length, radius), end) });
  part.Components.push_back({ part.Name, solid, { TopLoc_Location() } });
  ExactValues exact;
  exact.Volume = Pi * radius * radius * length / 4.0;
  exact.Area = Pi * radius * radius / 2.0 + Pi * radius * length / 2.0 + 2.0 * radius * length;
  exact.CenterOfMass[0] = exact.CenterOfMass[2] = 4.0 * radius / (3.0 * Pi);
  exact.CenterOfMass[1] = length / 2.0;
  part.Exact = exact;
  return part;
}

PaperPart MakeSlantedBlock()
{
  const double a = 100.0;
  const double b = 80.0;
  const double c = 60.0;
  const double radius = 15.0;
  const double slant = Pi / 6.0;
  const double heading = Pi / 9.0;
  // The point of the axis at half the height.
  const double x = 45.0;
  const double y = 38.0;
  PaperPart part;
  part.Name = "slanted_block";
  const gp_Dir axis(
    std::sin(slant) * std::cos(heading), std::sin(slant) * std::sin(heading), std::cos(slant));
  const gp_Pnt start = gp_Pnt(x, y, c / 2.0).Translated(gp_Vec(axis) * -c);
  const TopoDS_Shape solid =
    Cut(Box(gp_Pnt(0, 0, 0), gp_Pnt(a, b, c)), { Cylinder(start, axis, radius, 2.0 * c) });
  part.Components.push_back({ part.Name, OneSolid(solid), { TopLoc_Location() } });
  // The section of the hole at every level is the same ellipse, whose centre is on the axis.
  const double block = a * b * c;
  const double ellipse = Pi * radius * radius / std::cos(slant);
  const double hole = ellipse * c;
  ExactValues exact;
  exact.Volume = block - hole;
  exact.Area = 2.0 * (a * b + b * c + c * a - ellipse) + 2.0 * Pi * radius * c / std::cos(slant);
  exact.CenterOfMass[0] = (block * a / 2.0 - hole * x) / exact.Volume;
  exact.CenterOfMass[1] = (block * b / 2.0 - hole * y) / exact.Volume;
  exact.CenterOfMass[2] = c / 2.0;
  part.Exact = exact;
  return part;
}
}
