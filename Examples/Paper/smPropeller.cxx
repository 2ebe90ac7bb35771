#include "smModelling.h"
#include "smPaperParts.h"

#include <BRepOffsetAPI_ThruSections.hxx>

#include <cmath>

namespace smpaper
{
namespace
{
const gp_Ax1 PropellerAxis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));

/// Makes the section of a blade in the plane x = radius: thicker at the leading edge, cambered, pitched as a
/// screw, and swept.
TopoDS_Wire BladeSection(double radius, double chord, double thickness, double pitch, double sweep)
{
  const int count = 16;
  const double angle = std::atan2(pitch, 2.0 * Pi * radius);
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i)
  {
    const double turn = 2.0 * Pi * i / count;
    const double along = 0.5 * chord * std::cos(turn);
    const double camber = 0.06 * chord * (1.0 - std::pow(2.0 * along / chord, 2));
    const double up = 0.5 * thickness * std::sin(turn) * (1.0 + 0.35 * std::cos(turn)) + camber;
    points.emplace_back(radius, along * std::cos(angle) - up * std::sin(angle) - sweep,
      along * std::sin(angle) + up * std::cos(angle));
  }
  return ClosedSpline(points);
}

TopoDS_Shape Blade()
{
  BRepOffsetAPI_ThruSections loft(true, false, 1e-6);
  // Without this setting OpenCASCADE rotates sections against each other.
  loft.CheckCompatibility(false);
  const double radii[] = { 18, 38, 60, 84, 106, 122, 132 };
  const double chords[] = { 30, 42, 58, 70, 66, 48, 22 };
  const double thicknesses[] = { 10, 9, 7.5, 6, 4.6, 3.4, 2.2 };
  for (int k = 0; k < 7; ++k)
  {
    const double sweep = 14.0 * std::pow(radii[k] / 132.0, 3);
    loft.AddWire(BladeSection(radii[k], chords[k], thicknesses[k], 190.0, sweep));
  }
  loft.Build();
  return loft.Shape();
}
}

PaperPart MakePropeller()
{
  const int bladeCount = 5;
  const double hubRadius = 27.0;
  const double bore = 11.0;
  std::vector<TopoDS_Shape> shapes = { Revolution(
    { gp_Pnt(0, 0, -34), gp_Pnt(hubRadius, 0, -34), gp_Pnt(hubRadius, 0, 32), gp_Pnt(17, 0, 52),
      gp_Pnt(0, 0, 52) },
    PropellerAxis) };
  shapes[0] = Fillet(shapes[0], 8.0, OnCircle(PropellerAxis, hubRadius, 32.0));
  shapes[0] = Fillet(shapes[0], 4.0, OnCircle(PropellerAxis, 17.0, 52.0));
  const TopoDS_Shape blade = Blade();
  for (int i = 0; i < bladeCount; ++i)
  {
    shapes.push_back(Rotated(blade, PropellerAxis, 2.0 * Pi * i / bladeCount));
  }
  TopoDS_Shape body = Fuse(shapes);
  // The edges between blades and hub.
  body = Fillet(body, 3.0,
    [=](const gp_Pnt& p)
    { return std::abs(std::hypot(p.X(), p.Y()) - hubRadius) < 1e-3 && std::abs(p.Z()) < 25.0; });
  std::vector<TopoDS_Shape> tools = { Cylinder(gp_Pnt(0, 0, -40), gp_Dir(0, 0, 1), bore, 100.0),
    Cone(gp_Pnt(0, 0, -34.5), gp_Dir(0, 0, 1), bore + 2.5, bore - 0.5, 3.0),
    Box(gp_Pnt(0, -2.5, -40), gp_Pnt(bore + 3.0, 2.5, 60)) };
  for (int i = 0; i < 4; ++i)
  {
    // Slanted screw holes for a spinner in the cone of the nose.
    tools.push_back(Rotated(
      Cylinder(gp_Pnt(26, 0, 47), gp_Dir(-0.6, 0, -1), 2.1, 20.0), PropellerAxis, Pi / 4.0 + Pi * i / 2.0));
  }
  PaperPart part;
  part.Name = "propeller";
  part.Components.push_back({ part.Name, OneSolid(Cut(body, tools)), { TopLoc_Location() } });
  return part;
}
}
