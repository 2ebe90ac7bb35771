#include "smModelling.h"
#include "smPaperParts.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>

#include <cmath>

namespace smpaper
{
namespace
{
/// Makes a closed spline in a plane of constant x, wider at the side of the palm.
TopoDS_Wire Section(double x, double y, double z, double halfWidth, double halfHeight, double lean)
{
  const int count = 14;
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    const double side = halfWidth * std::cos(angle) * (1.0 + 0.15 * std::sin(angle));
    const double up = halfHeight * std::sin(angle);
    points.emplace_back(x + lean * up, y + side, z + up);
  }
  return ClosedSpline(points);
}

TopoDS_Shape Loft(const std::vector<TopoDS_Wire>& sections)
{
  BRepOffsetAPI_ThruSections loft(true, false, 1e-6);
  loft.CheckCompatibility(false);
  for (const TopoDS_Wire& section : sections)
  {
    loft.AddWire(section);
  }
  loft.Build();
  return loft.Shape();
}

/// Makes the solid above a wavy B-spline sheet over [x0,x1] x [y0,y1].
TopoDS_Shape AboveSheet(double x0, double x1, double y0, double y1, double level, double wave, double height)
{
  const int columns = 9;
  const int rows = 6;
  TColgp_Array2OfPnt points(1, columns, 1, rows);
  for (int i = 1; i <= columns; ++i)
  {
    for (int j = 1; j <= rows; ++j)
    {
      const double s = (i - 1.0) / (columns - 1.0);
      const double t = (j - 1.0) / (rows - 1.0);
      const double z = level + wave * (std::sin(2.0 * Pi * s) + 0.7 * std::cos(Pi * t + 2.0 * s));
      points(i, j) = gp_Pnt(x0 + (x1 - x0) * s, y0 + (y1 - y0) * t, z);
    }
  }
  GeomAPI_PointsToBSplineSurface sheet;
  sheet.Interpolate(points);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(sheet.Surface(), 1e-7).Shape(), gp_Vec(0, 0, height))
    .Shape();
}

TopoDS_Shape Common(const TopoDS_Shape& a, const TopoDS_Shape& b)
{
  return BRepAlgoAPI_Common(a, b).Shape();
}

/// Makes a ring-shaped spline tube, which is cut from the handle as the groove of a finger.
TopoDS_Shape Groove(double x, double y, double z, double across, double up, double radius)
{
  const int count = 16;
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    points.emplace_back(
      x + 2.5 * std::sin(2.0 * angle), y + across * std::cos(angle), z + up * std::sin(angle));
  }
  return ClosedTube(points, radius, 4, [](const gp_Pnt&) { return gp_Vec(1.0, 0.0, 0.0); });
}

/// Makes a free-form duct along y.
TopoDS_Shape Duct(double x, double z, double halfWidth, double halfHeight, double sway)
{
  std::vector<TopoDS_Wire> sections;
  for (int k = 0; k < 5; ++k)
  {
    const double s = k / 4.0;
    std::vector<gp_Pnt> points;
    const int count = 12;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * Pi * i / count;
      const double swell = 1.0 + 0.25 * std::cos(2.0 * Pi * s);
      points.emplace_back(x + sway * std::sin(Pi * s) + swell * halfWidth * std::cos(angle),
        -60.0 + 120.0 * s, z + swell * halfHeight * std::sin(angle) * (1.0 + 0.2 * std::cos(angle)));
    }
    sections.push_back(ClosedSpline(points));
  }
  return Loft(sections);
}
}

PaperPart MakeFreeForm()
{
  TopoDS_Shape body = Loft({ Section(-92, 2, 4, 13, 11, 0.10), Section(-70, 1, 5, 22, 20, 0.08),
    Section(-40, -2, 6, 25, 24, 0.00), Section(-5, -4, 8, 23, 22, -0.05), Section(30, 0, 12, 26, 25, 0.00),
    Section(62, 5, 17, 31, 27, 0.05), Section(88, 8, 21, 24, 20, 0.10) });
  // Free-form sheets replace the flat ends, the bottom and the back.
  const gp_Ax1 acrossY(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0));
  body = Common(body, Rotated(AboveSheet(-70, 80, -60, 60, -85, 2.0, 166), acrossY, Pi / 2.0));
  body = Common(body, AboveSheet(-130, 130, -60, 60, -9, 1.6, 100));
  body = Cut(body,
    { Groove(-55, 0, 4, 25, 24, 7.0), Groove(-32, -3, 5, 28, 27, 7.5), Groove(-8, -4, 6, 26, 25, 7.0) });
  body = Cut(body, { Duct(48, 15, 12, 8, 6), Duct(22, 11, 6, 5, -4) });
  PaperPart part;
  part.Name = "free_form";
  part.Components.push_back({ part.Name, OneSolid(body), { TopLoc_Location() } });
  return part;
}
}
