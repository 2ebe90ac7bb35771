#include "smModelling.h"
#include "smPaperParts.h"

#include <BRepAlgoAPI_Common.hxx>

#include <cmath>

namespace smpaper
{
namespace
{
// The shaft rotates about x. A throw is journal, web, pin, web.
const gp_Ax1 CrankAxis(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0));
const double JournalRadius = 17.0;
const double JournalLength = 20.0;
const double PinRadius = 14.0;
const double PinLength = 22.0;
const double WebThickness = 11.0;
const double Stroke = 24.0;
const double ThrowLength = JournalLength + PinLength + 2.0 * WebThickness;
const double FilletRadius = 1.8;

TopoDS_Shape Disk(double x, double y, double radius, double length)
{
  return Cylinder(gp_Pnt(x, y, 0), gp_Dir(1, 0, 0), radius, length);
}

/// Makes a web that starts at x, with its pin towards +y and its counterweight towards -y.
TopoDS_Shape Web(double x)
{
  const gp_Vec thickness(WebThickness, 0, 0);
  const TopoDS_Shape wedge =
    Prism({ gp_Pnt(x, 6, -14), gp_Pnt(x, -70, -52), gp_Pnt(x, -70, 52), gp_Pnt(x, 6, 14) }, thickness);
  const TopoDS_Shape counterweight = BRepAlgoAPI_Common(wedge, Disk(x, 0, 46.0, WebThickness)).Shape();
  const TopoDS_Shape cheek =
    Prism({ gp_Pnt(x, 0, -23), gp_Pnt(x, Stroke, -19), gp_Pnt(x, Stroke, 19), gp_Pnt(x, 0, 23) }, thickness);
  const TopoDS_Shape web =
    Fuse({ Disk(x, 0, 25.0, WebThickness), Disk(x, Stroke, 21.0, WebThickness), cheek, counterweight });
  return Fillet(web, 2.5, [](const gp_Pnt& p) { return std::abs(std::hypot(p.Y(), p.Z()) - 46.0) < 1e-4; });
}

/// Makes a throw that starts at x, with its pin rotated by an angle about the shaft.
TopoDS_Shape Throw(double x, double angle)
{
  const double firstWeb = x + JournalLength;
  const double pin = firstWeb + WebThickness;
  const double secondWeb = pin + PinLength;
  TopoDS_Shape body = Fuse({ Web(firstWeb), Disk(pin, Stroke, PinRadius, PinLength), Web(secondWeb) });
  const gp_Ax1 pinAxis(gp_Pnt(0, Stroke, 0), gp_Dir(1, 0, 0));
  for (const double end : { pin, secondWeb })
  {
    body = Fillet(body, FilletRadius, OnCircle(pinAxis, PinRadius, end));
  }
  // The pin has a bore, which its oil hole crosses.
  body = Cut(body,
    { Disk(firstWeb - 1.0, Stroke + 2.0, 5.0, ThrowLength),
      Cylinder(gp_Pnt(pin + PinLength / 2.0, Stroke, 0), gp_Dir(0.1, 1, 0.4), 2.2, 30.0) });
  return Rotated(body, CrankAxis, angle);
}

/// Makes an oil hole from the middle of a journal's surface through the web into the pin's bore.
TopoDS_Shape OilDrilling(double x, double angle)
{
  const gp_Pnt from(x + JournalLength / 2.0, -JournalRadius - 2.0, 0);
  const gp_Pnt to(x + JournalLength + WebThickness + PinLength / 2.0, Stroke, 0);
  const gp_Vec along(from, to);
  return Rotated(Cylinder(from, gp_Dir(along), 2.4, along.Magnitude()), CrankAxis, angle);
}
}

PaperPart MakeCrank()
{
  const int throwCount = 4;
  const double angles[throwCount] = { 0.0, Pi, Pi, 0.0 };
  const double end = throwCount * ThrowLength + JournalLength;
  std::vector<TopoDS_Shape> shapes;
  for (int i = 0; i < throwCount; ++i)
  {
    shapes.push_back(Disk(i * ThrowLength, 0, JournalRadius, JournalLength));
    shapes.push_back(Throw(i * ThrowLength, angles[i]));
  }
  shapes.push_back(Disk(end - JournalLength, 0, JournalRadius, JournalLength));
  shapes.push_back(Disk(end, 0, 38.0, 14.0));
  shapes.push_back(Disk(-34.0, 0, 13.0, 34.0));
  TopoDS_Shape body = Fuse(shapes);
  for (int i = 0; i <= throwCount; ++i)
  {
    if (i > 0)
    {
      body = Fillet(body, FilletRadius, OnCircle(CrankAxis, JournalRadius, i * ThrowLength));
    }
    body = Fillet(body, FilletRadius, OnCircle(CrankAxis, JournalRadius, i * ThrowLength + JournalLength));
  }
  body = Chamfer(body, 1.5, OnCircle(CrankAxis, 38.0, end + 14.0));
  body = Chamfer(body, 1.5, OnCircle(CrankAxis, 13.0, -34.0));

  std::vector<TopoDS_Shape> tools = { Disk(end + 6.0, 0, 15.0, 20.0),
    Box(gp_Pnt(-30, 9.0, -3), gp_Pnt(-8, 20, 3)), Cylinder(gp_Pnt(-8, 8.99, 0), gp_Dir(0, 1, 0), 3.0, 20.0),
    Cone(gp_Pnt(-34.5, 0, 0), gp_Dir(1, 0, 0), 6.5, 3.0, 3.5), Disk(-36.0, 0, 3.0, 26.0) };
  for (int i = 0; i < 6; ++i)
  {
    const double angle = 2.0 * Pi * i / 6.0 + 0.2;
    const gp_Pnt hole(end - 1.0, 28.0 * std::cos(angle), 28.0 * std::sin(angle));
    tools.push_back(Cylinder(hole, gp_Dir(1, 0, 0), 4.0, 20.0));
    tools.push_back(Cone(hole.Translated(gp_Vec(13.0, 0, 0)), gp_Dir(1, 0, 0), 3.5, 6.0, 2.5));
  }
  for (int i = 0; i < throwCount; ++i)
  {
    tools.push_back(OilDrilling(i * ThrowLength, angles[i]));
  }
  PaperPart part;
  part.Name = "crank";
  part.Components.push_back({ part.Name, OneSolid(Cut(body, tools)), { TopLoc_Location() } });
  return part;
}
}
