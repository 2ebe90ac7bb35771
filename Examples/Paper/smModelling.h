/**
 * @file smModelling.h
 * @brief The modelling operations of the paper's parts, on top of OpenCASCADE
 *
 * Lengths are in mm, angles in radians. Every function throws std::runtime_error or Standard_Failure when
 * OpenCASCADE fails; none returns a null shape.
 */
#ifndef smModelling_h
#define smModelling_h

#include <Geom_BSplineCurve.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <functional>
#include <vector>

namespace smpaper
{
extern const double Pi;

TopoDS_Shape Box(const gp_Pnt& low, const gp_Pnt& high);
TopoDS_Shape Cylinder(const gp_Pnt& start, const gp_Dir& axis, double radius, double length);
/// A cone or cylinder about an axis, with the radii at its start and its end.
TopoDS_Shape Cone(const gp_Pnt& start, const gp_Dir& axis, double radius0, double radius1, double length);

/// A planar polygon swept along a vector.
TopoDS_Shape Prism(const std::vector<gp_Pnt>& corners, const gp_Vec& along);
/// A planar wire swept along a vector.
TopoDS_Shape Prism(const TopoDS_Wire& wire, const gp_Vec& along);
/// A planar polygon revolved about the axis.
TopoDS_Shape Revolution(const std::vector<gp_Pnt>& corners, const gp_Ax1& axis);

TopoDS_Shape Moved(const TopoDS_Shape& shape, const gp_Vec& by);
TopoDS_Shape Rotated(const TopoDS_Shape& shape, const gp_Ax1& axis, double angle);

TopoDS_Shape Cut(const TopoDS_Shape& body, const std::vector<TopoDS_Shape>& tools);
/// The union, with adjacent faces of the same surface merged.
TopoDS_Shape Fuse(const std::vector<TopoDS_Shape>& shapes);

/// Selects edges by a point of theirs, at 0.63 of the parameter range.
using EdgeTest = std::function<bool(const gp_Pnt&)>;
TopoDS_Shape Fillet(const TopoDS_Shape& body, double radius, const EdgeTest& isMeant);
TopoDS_Shape Chamfer(const TopoDS_Shape& body, double size, const EdgeTest& isMeant);
/// Selects the edges on a circle: points at `radius` from the axis and `height` along it.
EdgeTest OnCircle(const gp_Ax1& axis, double radius, double height);

/// The cubic spline through points, parametrised by chord length.
Handle(Geom_BSplineCurve) SplineThrough(const std::vector<gp_Pnt>& points);
/// A wire of one spline, closed with two continuous derivatives; the first point is not repeated. Its knots
/// are the points' numbers, so that wires through as many points can be lofted without new knots.
TopoDS_Wire ClosedSpline(const std::vector<gp_Pnt>& points);

/// The tube of a radius round a closed spline: a surface through its sections that is closed and smooth in
/// both directions. It is cut into a number of faces along the spline, because Boolean operations fail on a
/// face that is closed in both directions. `reference` gives for every point a vector that is never tangent
/// to the curve, so that the tube closes without a twist.
TopoDS_Shape ClosedTube(const std::vector<gp_Pnt>& points, double radius, int pieces,
  const std::function<gp_Vec(const gp_Pnt&)>& reference);

/// The solid that the faces bound; their coincident borders are sewn.
TopoDS_Shape SolidOfFaces(const std::vector<TopoDS_Shape>& faces);
/// The only solid in a shape; throws when there are several or none.
TopoDS_Shape OneSolid(const TopoDS_Shape& shape);
}

#endif
