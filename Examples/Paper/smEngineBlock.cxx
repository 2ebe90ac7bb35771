#include "smModelling.h"
#include "smPaperParts.h"

#include <cmath>

namespace smpaper
{
namespace
{
// The crank rotates about x; the banks lean 45 degrees to both sides of z.
const double Length = 312.0;
const double BoreSpacing = 72.0;
const double FirstBore = 48.0;
const int BoresInBank = 4;
const double DeckHeight = 112.0;
const double SkirtSide = 56.0;
const double SkirtBottom = -42.0;

/// Returns a point of a bank, side +1 or -1: `up` along the bores, `out` across them, away from the valley.
gp_Pnt InBank(double side, double x, double up, double out)
{
  const double r = std::sqrt(0.5);
  return { x, side * r * (up + out), r * (up - out) };
}

gp_Dir BankUp(double side)
{
  return { 0, side, 1 };
}

double BoreCenter(double side, int i)
{
  return FirstBore + i * BoreSpacing + 2.0 * side;
}

TopoDS_Shape Casting()
{
  std::vector<gp_Pnt> corners;
  const std::vector<gp_Pnt> right = { gp_Pnt(0, SkirtSide, SkirtBottom), gp_Pnt(0, SkirtSide, -2.0),
    InBank(1.0, 0, DeckHeight, 40.0), InBank(1.0, 0, DeckHeight, -39.0), gp_Pnt(0, 16, 68) };
  corners = right;
  for (auto corner = right.rbegin(); corner != right.rend(); ++corner)
  {
    corners.emplace_back(0, -corner->Y(), corner->Z());
  }
  TopoDS_Shape body = Prism(corners, gp_Vec(Length, 0, 0));
  // Edges along x: the foot of the valley and the kink of both flanks.
  body = Fillet(
    body, 8.0, [](const gp_Pnt& p) { return std::abs(std::abs(p.Y()) - 16.0) < 1e-4 && p.Z() > 60.0; });
  return Fillet(body, 12.0,
    [](const gp_Pnt& p)
    { return std::abs(std::abs(p.Y()) - SkirtSide) < 1e-4 && std::abs(p.Z() + 2.0) < 1e-4; });
}

/// Adds the rails of the sump, ribs on both skirts, and bosses for mounts and starter.
TopoDS_Shape WithRibs(const TopoDS_Shape& casting)
{
  std::vector<TopoDS_Shape> shapes = { casting };
  for (const double side : { 1.0, -1.0 })
  {
    const double inner = side > 0.0 ? SkirtSide - 2.0 : -SkirtSide - 14.0;
    shapes.push_back(Box(gp_Pnt(0, inner, SkirtBottom), gp_Pnt(Length, inner + 16.0, SkirtBottom + 9.0)));
    for (int i = 0; i < 9; ++i)
    {
      const double x = 14.0 + 35.0 * i;
      const double foot = SkirtBottom + 5.0;
      shapes.push_back(
        Prism({ gp_Pnt(x, side * (SkirtSide - 2.0), foot), gp_Pnt(x, side * (SkirtSide + 11.0), foot),
                gp_Pnt(x, side * (SkirtSide + 5.0), -12.0), gp_Pnt(x, side * (SkirtSide - 2.0), -12.0) },
          gp_Vec(5.0, 0, 0)));
    }
  }
  TopoDS_Shape body = Fuse(shapes);
  // The upper and outer edges of the ribs.
  body = Fillet(body, 1.5,
    [](const gp_Pnt& p)
    {
      const double out = std::abs(p.Y()) - SkirtSide;
      const double place = std::fmod(p.X() - 14.0 + 35.0, 35.0);
      const bool onRim =
        std::abs(place) < 1e-4 || std::abs(place - 5.0) < 1e-4 || std::abs(place - 35.0) < 1e-4;
      return onRim && out > 4.0 && p.Z() > SkirtBottom + 9.5 && p.Z() < -10.0 && p.X() > 1.0 &&
        p.X() < Length - 1.0;
    });
  // Vertical edges at the ends of the rails.
  return Fillet(body, 6.0,
    [](const gp_Pnt& p)
    {
      const bool atEnd = p.X() < 1e-4 || p.X() > Length - 1e-4;
      return atEnd && std::abs(std::abs(p.Y()) - SkirtSide - 14.0) < 1e-4 && p.Z() > SkirtBottom + 1.0 &&
        p.Z() < SkirtBottom + 8.0;
    });
}

/// Cuts the bays between the bulkheads and the tunnels of crank and camshaft.
std::vector<TopoDS_Shape> Crankcase()
{
  const gp_Dir x(1, 0, 0);
  std::vector<TopoDS_Shape> tools = { Cylinder(gp_Pnt(-1, 0, 0), x, 24.0, Length + 2.0),
    Cylinder(gp_Pnt(-1, 0, 52.5), x, 6.5, Length + 2.0) };
  for (int i = 0; i < BoresInBank; ++i)
  {
    const double start = FirstBore + i * BoreSpacing - 30.0;
    const TopoDS_Shape below =
      Fillet(Box(gp_Pnt(start, -41, SkirtBottom - 5.0), gp_Pnt(start + 60.0, 41, -5)), 6.0,
        [](const gp_Pnt& p) { return p.Z() > SkirtBottom - 4.0 && p.Z() < -6.0; });
    tools.push_back(Fuse({ Cylinder(gp_Pnt(start, 0, 0), x, 43.0, 60.0), below }));
  }
  // Space for the bearing caps, open below.
  tools.push_back(Box(gp_Pnt(-1, -32, SkirtBottom - 5.0), gp_Pnt(Length + 1.0, 32, -14)));
  return tools;
}

void AddScrewHole(
  std::vector<TopoDS_Shape>& tools, const gp_Pnt& mouth, const gp_Dir& inwards, double radius, double depth)
{
  const gp_Vec in(inwards);
  tools.push_back(Cylinder(mouth.Translated(in * -1.0), inwards, radius, depth + 1.0));
  tools.push_back(Cone(mouth.Translated(in * depth), inwards, radius, 0.0, radius * 0.6));
  tools.push_back(Cone(mouth.Translated(in * -0.5), inwards, radius + 1.5, radius - 0.5, 2.0));
}

/// Cuts the bores with their chamfers, the screw holes of the heads, and the water and oil passages between
/// them.
std::vector<TopoDS_Shape> Bank(double side)
{
  const gp_Dir down = BankUp(side).Reversed();
  std::vector<TopoDS_Shape> tools;
  for (int i = 0; i < BoresInBank; ++i)
  {
    const double x = BoreCenter(side, i);
    tools.push_back(Cylinder(InBank(side, x, 25.0, 0), BankUp(side), 27.0, DeckHeight));
    tools.push_back(Cone(InBank(side, x, DeckHeight + 0.5, 0), down, 28.5, 26.5, 2.0));
    for (const double out : { -1.0, 1.0 })
    {
      // A slanted water passage on both sides of the bore.
      const gp_Dir slanted(gp_Vec(down) + gp_Vec(0.25, 0, 0));
      tools.push_back(Cylinder(InBank(side, x - 6.0, DeckHeight + 2.0, 33.5 * out), slanted, 2.4, 26.0));
    }
  }
  for (int i = 0; i <= BoresInBank; ++i)
  {
    for (const double out : { -1.0, 1.0 })
    {
      const double x = FirstBore + (i - 0.5) * BoreSpacing + 2.0 * side;
      AddScrewHole(tools, InBank(side, x, DeckHeight, 27.0 * out), down, 4.2, 34.0);
    }
  }
  return tools;
}

std::vector<TopoDS_Shape> Screws()
{
  std::vector<TopoDS_Shape> tools;
  const gp_Dir up(0, 0, 1);
  for (const double side : { 1.0, -1.0 })
  {
    for (int i = 0; i < 8; ++i)
    {
      // Screw holes between the ribs, through the rails.
      tools.push_back(
        Cylinder(gp_Pnt(31.5 + 35.0 * i, side * (SkirtSide + 7.0), SkirtBottom - 1.0), up, 2.8, 12.0));
    }
    for (int i = 0; i <= BoresInBank; ++i)
    {
      AddScrewHole(tools, gp_Pnt(FirstBore + (i - 0.5) * BoreSpacing, 28.5 * side, -14.0), up, 2.6, 24.0);
    }
  }
  for (int i = 0; i < 10; ++i)
  {
    const double angle = -0.3 + (Pi + 0.6) * i / 9.0;
    const gp_Pnt front(0, 36.0 * std::cos(angle), 8.0 + 34.0 * std::sin(angle));
    AddScrewHole(tools, front, gp_Dir(1, 0, 0), 2.2, 9.0);
    AddScrewHole(tools, gp_Pnt(Length, front.Y(), front.Z()), gp_Dir(-1, 0, 0), 2.2, 9.0);
  }
  return tools;
}
}

PaperPart MakeEngineBlock()
{
  TopoDS_Shape body = Cut(WithRibs(Casting()), Crankcase());
  for (const double side : { 1.0, -1.0 })
  {
    body = Cut(body, Bank(side));
  }
  body = Cut(body, Screws());
  PaperPart part;
  part.Name = "engine_block";
  part.Components.push_back({ part.Name, OneSolid(body), { TopLoc_Location() } });
  return part;
}
}
