/**
 * @file smModelling.h
 * @brief Short words for what the paper's parts are modelled with, over OpenCASCADE
 *
 * Lengths in mm, angles in radians. Every function throws std::runtime_error or Standard_Failure where
 * OpenCASCADE does not do what was asked; none returns a null shape.
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

#include <array>
#include <functional>
#include <vector>

namespace smpaper
{
extern const double Pi;

TopoDS_Shape Box(const gp_Pnt& low, const gp_Pnt& high);
TopoDS_Shape Cylinder(const gp_Pnt& start, const gp_Dir& axis, double radius, double length);
/// Around the axis through start; the radii are those at its start and its end.
TopoDS_Shape Cone(const gp_Pnt& start, const gp_Dir& axis, double radius0, double radius1, double length);

/// A planar polygon swept along a vector.
TopoDS_Shape Prism(const std::vector<gp_Pnt>& corners, const gp_Vec& along);
/// A planar wire swept along a vector.
TopoDS_Shape Prism(const TopoDS_Wire& wire, const gp_Vec& along);
/// A planar polygon turned once around the axis.
TopoDS_Shape Revolution(const std::vector<gp_Pnt>& corners, const gp_Ax1& axis);

TopoDS_Shape Moved(const TopoDS_Shape& shape, const gp_Vec& by);
TopoDS_Shape Rotated(const TopoDS_Shape& shape, const gp_Ax1& axis, double angle);

TopoDS_Shape Cut(const TopoDS_Shape& body, const std::vector<TopoDS_Shape>& tools);
/// Joined, with faces of the same surface made one.
TopoDS_Shape Fuse(const std::vector<TopoDS_Shape>& shapes);

/// Says of a point, taken at 0.63 of an edge's parameter, whether its edge is meant.
using EdgeTest = std::function<bool(const gp_Pnt&)>;
TopoDS_Shape Fillet(const TopoDS_Shape& body, double radius, const EdgeTest& isMeant);
TopoDS_Shape Chamfer(const TopoDS_Shape& body, double size, const EdgeTest& isMeant);
/// The circle's edges: points `radius` from the axis and `height` along it.
EdgeTest OnCircle(const gp_Ax1& axis, double radius, double height);

/// The cubic spline through points, its parameter along the chords.
Handle(Geom_BSplineCurve) SplineThrough(const std::vector<gp_Pnt>& points);
/// A wire of one spline, closed with two continuous derivatives; the first point is not repeated. Its knots are the
/// points' numbers, so that wires through as many points can be lofted without new knots.
TopoDS_Wire ClosedSpline(const std::vector<gp_Pnt>& points);

/// The tube of a radius round a closed spline: sections are skinned by a surface that is closed and smooth both ways.
/// It is cut into so many faces along the spline; one that is closed both ways is more than Boolean operations understand.
/// `reference` gives for every point a vector that is never along the curve, so that the tube closes without a twist.
TopoDS_Shape ClosedTube(const std::vector<gp_Pnt>& points, double radius, int pieces,
  const std::function<gp_Vec(const gp_Pnt&)>& reference);

/// A solid bounded by the faces, sewn where their borders coincide.
TopoDS_Shape SolidOfFaces(const std::vector<TopoDS_Shape>& faces);
/// The one solid in a shape; throws when there are more or none.
TopoDS_Shape OneSolid(const TopoDS_Shape& shape);
}

#endif
