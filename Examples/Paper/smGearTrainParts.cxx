#include "smGearTrainParts.h"

#include "smModelling.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <cmath>

namespace smpaper
{
namespace
{
const gp_Dir Up(0, 0, 1);
const gp_Ax1 GearAxis(gp_Pnt(0, 0, 0), Up);
const double BoltRadius = 3.0;
const double ShaftRadius = 8.0;
const double SeatRadius = 15.0;

gp_Pnt Polar(double radius, double angle, double z = 0.0)
{
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/// Returns half the angle of a tooth at a radius.
double HalfTooth(int teeth, double radius)
{
  const double pressure = Pi / 9.0;
  const double base = 0.5 * GearModule * teeth * std::cos(pressure);
  const auto involute = [](double angle) { return std::tan(angle) - angle; };
  const double backlash = 0.01 * GearModule / radius;
  return Pi / (2.0 * teeth) + involute(pressure) - involute(std::acos(std::min(1.0, base / radius))) -
    backlash;
}

TopoDS_Edge Flank(int teeth, double root, double tip, double middle, double side)
{
  const int count = 7;
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i)
  {
    const double radius = root + (tip - root) * i / (count - 1);
    points.push_back(Polar(radius, middle + side * HalfTooth(teeth, radius)));
  }
  if (side > 0.0)
  {
    std::reverse(points.begin(), points.end());
  }
  return BRepBuilderAPI_MakeEdge(SplineThrough(points)).Edge();
}

TopoDS_Edge Arc(double radius, double from, double to)
{
  return BRepBuilderAPI_MakeEdge(
    GC_MakeArcOfCircle(Polar(radius, from), Polar(radius, 0.5 * (from + to)), Polar(radius, to)).Value())
    .Edge();
}

TopoDS_Wire ToothedWire(int teeth, double root, double tip)
{
  BRepBuilderAPI_MakeWire wire;
  const double pitch = 2.0 * Pi / teeth;
  const double atRoot = HalfTooth(teeth, root);
  const double atTip = HalfTooth(teeth, tip);
  for (int i = 0; i < teeth; ++i)
  {
    const double middle = i * pitch;
    wire.Add(Flank(teeth, root, tip, middle, -1.0));
    wire.Add(Arc(tip, middle - atTip, middle + atTip));
    wire.Add(Flank(teeth, root, tip, middle, 1.0));
    wire.Add(Arc(root, middle + atRoot, middle + pitch - atRoot));
  }
  return wire.Wire();
}

TopoDS_Wire Hexagon(double acrossFlats, double z)
{
  const double radius = acrossFlats / std::sqrt(3.0);
  BRepBuilderAPI_MakeWire wire;
  for (int i = 0; i < 6; ++i)
  {
    wire.Add(
      BRepBuilderAPI_MakeEdge(Polar(radius, Pi * i / 3.0, z), Polar(radius, Pi * (i + 1) / 3.0, z)).Edge());
  }
  return wire.Wire();
}

/// Removes the parts of a body between z = low and high that are outside cones of 30 degrees, which shorten
/// its ends by `rise` at radius `rim`. The seam of the cones is at an angle where the body has no edge,
/// because OpenCASCADE straightens short curves that end at a seam.
TopoDS_Shape ChamferRims(
  const TopoDS_Shape& body, double rim, double rise, double low, double high, double seam)
{
  const double run = rise / std::tan(Pi / 6.0);
  const TopoDS_Shape envelope = Revolution(
    { gp_Pnt(0, 0, low), gp_Pnt(rim - run, 0, low), gp_Pnt(rim + 1.0, 0, low + rise + std::tan(Pi / 6.0)),
      gp_Pnt(rim + 1.0, 0, high - rise - std::tan(Pi / 6.0)), gp_Pnt(rim - run, 0, high),
      gp_Pnt(0, 0, high) },
    GearAxis);
  return BRepAlgoAPI_Common(body, Rotated(envelope, GearAxis, seam)).Shape();
}
}

TopoDS_Shape MakeGear(int teeth, double width)
{
  const double pitchRadius = 0.5 * GearModule * teeth;
  const double root = pitchRadius - 1.25 * GearModule;
  const double tip = pitchRadius + GearModule;
  TopoDS_Shape body = Prism(ToothedWire(teeth, root, tip), gp_Vec(0, 0, width));
  body = ChamferRims(body, tip, 1.0, 0.0, width, Pi / teeth);
  std::vector<TopoDS_Shape> tools = { Cylinder(gp_Pnt(0, 0, -1), Up, ShaftRadius, width + 2.0),
    Box(gp_Pnt(0, -1.5, -1), gp_Pnt(ShaftRadius + 1.6, 1.5, width + 1.0)) };
  if (root > 30.0)
  {
    // Recesses on both sides leave a web with holes.
    const auto recess = [=](double z0, double z1)
    {
      return Cut(Cylinder(gp_Pnt(0, 0, z0), Up, root - 4.0, z1 - z0),
        { Cylinder(gp_Pnt(0, 0, z0 - 1.0), Up, 13.0, z1 - z0 + 2.0) });
    };
    tools.push_back(recess(-1.0, 3.0));
    tools.push_back(recess(width - 3.0, width + 1.0));
    for (int i = 0; i < 6; ++i)
    {
      tools.push_back(Cylinder(Polar(23.0, Pi * i / 3.0, -1.0), Up, 6.0, width + 2.0));
    }
  }
  body = Cut(body, tools);
  if (root > 30.0)
  {
    for (const double z : { 3.0, width - 3.0 })
    {
      body = Fillet(body, 1.2, OnCircle(GearAxis, root - 4.0, z));
      body = Fillet(body, 1.2, OnCircle(GearAxis, 13.0, z));
    }
  }
  return OneSolid(body);
}

TopoDS_Shape MakeShaft(double length)
{
  const double low = -PlateThickness - 4.0;
  const double high = length + PlateThickness + 14.0;
  TopoDS_Shape body = Revolution(
    { gp_Pnt(0, 0, low), gp_Pnt(7.0, 0, low), gp_Pnt(7.0, 0, 0), gp_Pnt(ShaftRadius, 0, 0),
      gp_Pnt(ShaftRadius, 0, length), gp_Pnt(7.0, 0, length), gp_Pnt(7.0, 0, high), gp_Pnt(0, 0, high) },
    GearAxis);
  for (const double z : { low, high })
  {
    body = Chamfer(body, 0.8, OnCircle(GearAxis, 7.0, z));
  }
  body = Fillet(body, 0.4, OnCircle(GearAxis, 7.0, 0.0));
  body = Fillet(body, 0.4, OnCircle(GearAxis, 7.0, length));
  // Keyways, one with round ends, and a cross hole.
  const TopoDS_Shape groove = Fuse({ Box(gp_Pnt(6.2, -1.5, 4), gp_Pnt(10, 1.5, length - 4.0)),
    Cylinder(gp_Pnt(6.2, 0, 4), gp_Dir(1, 0, 0), 1.5, 3.8),
    Cylinder(gp_Pnt(6.2, 0, length - 4.0), gp_Dir(1, 0, 0), 1.5, 3.8) });
  return OneSolid(Cut(body, { groove, Cylinder(gp_Pnt(-10, 0, high - 6.0), gp_Dir(1, 0, 0), 1.6, 20.0) }));
}

TopoDS_Shape MakeBearingRing(bool outer)
{
  const double inner = outer ? 12.9 : 7.0;
  const double rim = outer ? SeatRadius : 10.1;
  TopoDS_Shape body = Revolution({ gp_Pnt(inner, 0, 0), gp_Pnt(rim, 0, 0), gp_Pnt(rim, 0, PlateThickness),
                                   gp_Pnt(inner, 0, PlateThickness) },
    GearAxis);
  for (const double z : { 0.0, PlateThickness })
  {
    body = Fillet(body, 0.5, OnCircle(GearAxis, outer ? rim : inner, z));
  }
  const TopoDS_Shape race =
    BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, PlateThickness / 2.0), Up), BallCircle, 2.5).Shape();
  return OneSolid(Cut(body, { race }));
}

TopoDS_Shape MakeBall()
{
  return BRepPrimAPI_MakeSphere(2.4).Shape();
}

std::vector<gp_Pnt> GetSpacerPlaces(int shafts, double distance)
{
  const double length = (shafts - 1) * distance;
  std::vector<gp_Pnt> places;
  for (const double y : { -48.0, 48.0 })
  {
    for (const double x : { -24.0, length / 2.0, length + 42.0 })
    {
      places.emplace_back(x, y, 0.0);
    }
  }
  return places;
}

TopoDS_Shape MakePlate(int shafts, double distance)
{
  const double length = (shafts - 1) * distance;
  const double left = -36.0;
  const double right = length + 54.0;
  TopoDS_Shape body = Box(gp_Pnt(left, -60, 0), gp_Pnt(right, 60, PlateThickness));
  body = Fillet(body, 12.0, [=](const gp_Pnt& p) { return p.Z() > 1.0 && p.Z() < PlateThickness - 1.0; });
  body = Fillet(body, 1.5, [](const gp_Pnt& p) { return p.Z() > PlateThickness - 1e-6; });
  std::vector<TopoDS_Shape> tools;
  for (int i = 0; i < shafts; ++i)
  {
    tools.push_back(Cylinder(gp_Pnt(i * distance, 0, -1), Up, SeatRadius, PlateThickness + 2.0));
    for (int k = 0; k < 6; ++k)
    {
      const double angle = Pi * k / 3.0 + Pi / 6.0;
      const gp_Pnt place = Polar(20.0, angle).Translated(gp_Vec(i * distance, 0, 0));
      tools.push_back(Cylinder(place.Translated(gp_Vec(0, 0, -1)), Up, 1.6, PlateThickness + 2.0));
      tools.push_back(Cone(place.Translated(gp_Vec(0, 0, PlateThickness - 1.5)), Up, 1.1, 3.6, 2.5));
    }
    // A slanted oil hole to the seat.
    tools.push_back(
      Cylinder(gp_Pnt(i * distance, 30, PlateThickness + 4.0), gp_Dir(0, -1, -0.45), 1.4, 26.0));
  }
  for (int i = 0; i + 1 < shafts; ++i)
  {
    for (const double y : { -38.0, 38.0 })
    {
      const double middle = (i + 0.5) * distance;
      TopoDS_Shape window = Prism({ gp_Pnt(middle - 17, y - 12, -1), gp_Pnt(middle + 17, y - 12, -1),
                                    gp_Pnt(middle + 11, y + 12, -1), gp_Pnt(middle - 11, y + 12, -1) },
        gp_Vec(0, 0, PlateThickness + 2.0));
      if (std::abs(middle - length / 2.0) > 1.0)
      {
        tools.push_back(
          Fillet(window, 4.0, [](const gp_Pnt& p) { return p.Z() > 0.0 && p.Z() < PlateThickness; }));
      }
    }
  }
  for (const gp_Pnt& place : GetSpacerPlaces(shafts, distance))
  {
    tools.push_back(Cylinder(place.Translated(gp_Vec(0, 0, -1)), Up, BoltRadius + 0.2, PlateThickness + 2.0));
  }
  return OneSolid(Cut(body, tools));
}

TopoDS_Shape MakeSpacer(double length)
{
  TopoDS_Shape body = Revolution({ gp_Pnt(BoltRadius + 0.2, 0, 0), gp_Pnt(8, 0, 0), gp_Pnt(8, 0, 6),
                                   gp_Pnt(6, 0, 9), gp_Pnt(6, 0, length - 9.0), gp_Pnt(8, 0, length - 6.0),
                                   gp_Pnt(8, 0, length), gp_Pnt(BoltRadius + 0.2, 0, length) },
    GearAxis);
  body = Fillet(body, 2.0, OnCircle(GearAxis, 6.0, 9.0));
  body = Fillet(body, 2.0, OnCircle(GearAxis, 6.0, length - 9.0));
  return OneSolid(Cut(body, { Cylinder(gp_Pnt(-12, 0.8, length / 2.0), gp_Dir(1, 0, 0.3), 1.8, 26.0) }));
}

TopoDS_Shape MakeBolt(double gap)
{
  const double end = gap + 2.0 * PlateThickness + 9.0;
  TopoDS_Shape body = Revolution({ gp_Pnt(0, 0, -6), gp_Pnt(5, 0, -6), gp_Pnt(5, 0, 0),
                                   gp_Pnt(BoltRadius, 0, 0), gp_Pnt(BoltRadius, 0, end), gp_Pnt(0, 0, end) },
    GearAxis);
  body = Fillet(body, 0.6, OnCircle(GearAxis, 5.0, -6.0));
  body = Fillet(body, 0.3, OnCircle(GearAxis, BoltRadius, 0.0));
  body = Chamfer(body, 0.6, OnCircle(GearAxis, BoltRadius, end));
  const TopoDS_Shape socket = Prism(Hexagon(5.0, -7.0), gp_Vec(0, 0, 4.0));
  const TopoDS_Shape drillEnd = Cone(gp_Pnt(0, 0, -3.0), Up, 2.4, 0.0, 1.4);
  const TopoDS_Shape mouth = Cone(gp_Pnt(0, 0, -6.2), Up, 3.1, 2.3, 0.8);
  return OneSolid(Cut(body, { socket, drillEnd, mouth }));
}

TopoDS_Shape MakeNut()
{
  const double height = 5.2;
  TopoDS_Shape body = ChamferRims(
    Prism(Hexagon(10.0, 0.0), gp_Vec(0, 0, height)), 10.0 / std::sqrt(3.0), 0.45, 0.0, height, Pi / 6.0);
  body = Cut(body,
    { Cylinder(gp_Pnt(0, 0, -1), Up, BoltRadius - 0.3, height + 2.0),
      Cone(gp_Pnt(0, 0, -0.5), Up, BoltRadius + 0.8, BoltRadius - 0.7, 1.5),
      Cone(gp_Pnt(0, 0, height - 1.0), Up, BoltRadius - 0.7, BoltRadius + 0.8, 1.5) });
  return OneSolid(body);
}
}
