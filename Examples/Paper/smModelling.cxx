#include "smModelling.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineSurface.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Lin.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <stdexcept>

namespace smpaper
{
const double Pi = std::acos(-1.0);

namespace
{
const double Tolerance = 1e-7;

TopoDS_Wire Polygon(const std::vector<gp_Pnt>& corners)
{
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners)
  {
    polygon.Add(corner);
  }
  polygon.Close();
  return polygon.Wire();
}

TopTools_IndexedMapOfShape EdgesWhere(const TopoDS_Shape& shape, const EdgeTest& isMeant)
{
  TopTools_IndexedMapOfShape all;
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, TopAbs_EDGE, all);
  for (int i = 1; i <= all.Extent(); ++i)
  {
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(all(i)), first, last);
    if (!curve.IsNull() && isMeant(curve->Value(0.37 * first + 0.63 * last)))
    {
      found.Add(all(i));
    }
  }
  if (found.IsEmpty())
  {
    throw std::runtime_error("no edge is where one is to be rounded");
  }
  return found;
}

TopTools_ListOfShape List(const std::vector<TopoDS_Shape>& shapes, std::size_t from)
{
  TopTools_ListOfShape list;
  for (std::size_t i = from; i < shapes.size(); ++i)
  {
    list.Append(shapes[i]);
  }
  return list;
}

TopoDS_Shape Combine(BRepAlgoAPI_BooleanOperation& operation, const TopTools_ListOfShape& bodies,
  const TopTools_ListOfShape& tools)
{
  operation.SetArguments(bodies);
  operation.SetTools(tools);
  operation.Build();
  if (operation.HasErrors())
  {
    throw std::runtime_error("a Boolean operation failed");
  }
  return operation.Shape();
}

Handle(Geom_BSplineCurve) Interpolate(const std::vector<gp_Pnt>& points, bool closed, bool uniform)
{
  const int count = static_cast<int>(points.size());
  Handle(TColgp_HArray1OfPnt) through = new TColgp_HArray1OfPnt(1, count);
  Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, closed ? count + 1 : count);
  for (int i = 0; i < count; ++i)
  {
    through->SetValue(i + 1, points[i]);
  }
  for (int i = parameters->Lower(); i <= parameters->Upper(); ++i)
  {
    parameters->SetValue(i, i - 1.0);
  }
  GeomAPI_Interpolate byChord(through, closed, Tolerance);
  GeomAPI_Interpolate byNumber(through, parameters, closed, Tolerance);
  GeomAPI_Interpolate& interpolation = uniform ? byNumber : byChord;
  interpolation.Perform();
  if (!interpolation.IsDone())
  {
    throw std::runtime_error("a spline cannot be laid through its points");
  }
  return interpolation.Curve();
}
}

TopoDS_Shape Box(const gp_Pnt& low, const gp_Pnt& high)
{
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

TopoDS_Shape Cylinder(const gp_Pnt& start, const gp_Dir& axis, double radius, double length)
{
  return BRepPrimAPI_MakeCylinder(gp_Ax2(start, axis), radius, length).Shape();
}

TopoDS_Shape Cone(const gp_Pnt& start, const gp_Dir& axis, double radius0, double radius1, double length)
{
  return BRepPrimAPI_MakeCone(gp_Ax2(start, axis), radius0, radius1, length).Shape();
}

TopoDS_Shape Prism(const std::vector<gp_Pnt>& corners, const gp_Vec& along)
{
  return Prism(Polygon(corners), along);
}

TopoDS_Shape Prism(const TopoDS_Wire& wire, const gp_Vec& along)
{
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire, true).Shape(), along).Shape();
}

TopoDS_Shape Revolution(const std::vector<gp_Pnt>& corners, const gp_Ax1& axis)
{
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(Polygon(corners), true).Shape(), axis).Shape();
}

TopoDS_Shape Moved(const TopoDS_Shape& shape, const gp_Vec& by)
{
  gp_Trsf motion;
  motion.SetTranslation(by);
  return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

TopoDS_Shape Rotated(const TopoDS_Shape& shape, const gp_Ax1& axis, double angle)
{
  gp_Trsf motion;
  motion.SetRotation(axis, angle);
  return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

TopoDS_Shape Cut(const TopoDS_Shape& body, const std::vector<TopoDS_Shape>& tools)
{
  BRepAlgoAPI_Cut cut;
  return Combine(cut, List({ body }, 0), List(tools, 0));
}

TopoDS_Shape Fuse(const std::vector<TopoDS_Shape>& shapes)
{
  BRepAlgoAPI_Fuse fuse;
  const TopoDS_Shape joined = Combine(fuse, List({ shapes.at(0) }, 0), List(shapes, 1));
  ShapeUpgrade_UnifySameDomain unify(joined, true, true, false);
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape Fillet(const TopoDS_Shape& body, double radius, const EdgeTest& isMeant)
{
  BRepFilletAPI_MakeFillet fillet(body);
  const TopTools_IndexedMapOfShape edges = EdgesWhere(body, isMeant);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    fillet.Add(radius, TopoDS::Edge(edges(i)));
  }
  fillet.Build();
  if (!fillet.IsDone())
  {
    throw std::runtime_error("a fillet of radius " + std::to_string(radius) + " failed");
  }
  return fillet.Shape();
}

TopoDS_Shape Chamfer(const TopoDS_Shape& body, double size, const EdgeTest& isMeant)
{
  BRepFilletAPI_MakeChamfer chamfer(body);
  const TopTools_IndexedMapOfShape edges = EdgesWhere(body, isMeant);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    chamfer.Add(size, TopoDS::Edge(edges(i)));
  }
  chamfer.Build();
  if (!chamfer.IsDone())
  {
    throw std::runtime_error("a chamfer of " + std::to_string(size) + " failed");
  }
  return chamfer.Shape();
}

EdgeTest OnCircle(const gp_Ax1& axis, double radius, double height)
{
  return [=](const gp_Pnt& point)
  {
    const double along = gp_Vec(axis.Location(), point).Dot(gp_Vec(axis.Direction()));
    return std::abs(gp_Lin(axis).Distance(point) - radius) < 1e-4 && std::abs(along - height) < 1e-4;
  };
}

Handle(Geom_BSplineCurve) SplineThrough(const std::vector<gp_Pnt>& points)
{
  return Interpolate(points, false, false);
}

TopoDS_Wire ClosedSpline(const std::vector<gp_Pnt>& points)
{
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(Interpolate(points, true, true))).Wire();
}

TopoDS_Shape ClosedTube(const std::vector<gp_Pnt>& points, double radius, int pieces,
  const std::function<gp_Vec(const gp_Pnt&)>& reference)
{
  // The circle as a rational quadratic of four arcs: corners of a square, and the middles of its sides.
  const int circlePoles = 9;
  const std::array<double, circlePoles> across = { 1, 1, 0, -1, -1, -1, 0, 1, 1 };
  const std::array<double, circlePoles> up = { 0, 1, 1, 1, 0, -1, -1, -1, 0 };
  const Handle(Geom_BSplineCurve) spine = Interpolate(points, true, true);
  std::array<std::vector<gp_Pnt>, circlePoles> rails;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    gp_Pnt center;
    gp_Vec tangent;
    spine->D1(static_cast<double>(i), center, tangent);
    const gp_Dir binormal(tangent.Crossed(reference(center)));
    const gp_Dir normal = binormal.Crossed(gp_Dir(tangent));
    for (int j = 0; j < circlePoles; ++j)
    {
      rails[j].push_back(
        center.Translated(gp_Vec(normal) * (radius * across[j]) + gp_Vec(binormal) * (radius * up[j])));
    }
  }
  std::array<Handle(Geom_BSplineCurve), circlePoles> skins;
  for (int j = 0; j < circlePoles; ++j)
  {
    skins[j] = Interpolate(rails[j], true, true);
    skins[j]->SetNotPeriodic();
  }
  const Handle(Geom_BSplineCurve)& skin = skins[0];
  TColgp_Array2OfPnt poles(1, skin->NbPoles(), 1, circlePoles);
  TColStd_Array2OfReal weights(1, skin->NbPoles(), 1, circlePoles);
  for (int i = 1; i <= skin->NbPoles(); ++i)
  {
    for (int j = 0; j < circlePoles; ++j)
    {
      poles(i, j + 1) = skins[j]->Pole(i);
      weights(i, j + 1) = j % 2 == 0 ? 1.0 : std::sqrt(0.5);
    }
  }
  TColStd_Array1OfReal circleKnots(1, 5);
  TColStd_Array1OfInteger circleMultiplicities(1, 5);
  for (int j = 1; j <= 5; ++j)
  {
    circleKnots(j) = j - 1.0;
    circleMultiplicities(j) = j == 1 || j == 5 ? 3 : 2;
  }
  const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(poles, weights, skin->Knots(),
    circleKnots, skin->Multiplicities(), circleMultiplicities, skin->Degree(), 2);
  std::vector<TopoDS_Shape> faces;
  double first = 0.0;
  double last = 0.0;
  double circleFirst = 0.0;
  double circleLast = 0.0;
  surface->Bounds(first, last, circleFirst, circleLast);
  for (int i = 0; i < pieces; ++i)
  {
    const double start = first + (last - first) * i / pieces;
    const double end = first + (last - first) * (i + 1) / pieces;
    faces.push_back(BRepBuilderAPI_MakeFace(surface, start, end, circleFirst, circleLast, Tolerance).Shape());
  }
  return SolidOfFaces(faces);
}

TopoDS_Shape SolidOfFaces(const std::vector<TopoDS_Shape>& faces)
{
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const TopoDS_Shape& face : faces)
  {
    sewing.Add(face);
  }
  sewing.Perform();
  TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
  TopoDS_Shell shell;
  if (shells.More())
  {
    shell = TopoDS::Shell(shells.Current());
  }
  else
  {
    // Sewing returns a face when the only face closes on itself.
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, sewing.SewedShape());
    shell.Closed(true);
  }
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
  if (!BRepLib::OrientClosedSolid(solid))
  {
    throw std::runtime_error("faces do not bound a solid");
  }
  return solid;
}

TopoDS_Shape OneSolid(const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  if (solids.Extent() != 1)
  {
    throw std::runtime_error(std::to_string(solids.Extent()) + " solids came out where one was meant");
  }
  return solids(1);
}
}
