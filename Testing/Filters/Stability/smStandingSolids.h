/**
 * @file smStandingSolids.h
 * @brief Solids that stand, lie and balance, as STEP files
 */
#ifndef smStandingSolids_h
#define smStandingSolids_h

#include <TopoDS_Shape.hxx>

#include <string>

namespace smtest
{
/// The rectangle [0,a] x [0,b] at z = 0, extruded along (lean, 0, height): its centre is over the edge x = a
/// when lean = a.
TopoDS_Shape MakeLeaningPrism(double a, double b, double height, double lean);
/// The half of the ball about the origin below z = 0, or the one above.
TopoDS_Shape MakeHemisphere(double radius, bool below);
/// A cylinder whose axis is the x axis from 0 to `length`, and the half of it in z < 0.
TopoDS_Shape MakeLyingCylinder(double radius, double length);
TopoDS_Shape MakeLyingHalfCylinder(double radius, double length);
/// A round plate from z = 0 to 2 with three spherical feet of radius 1 about points at this distance from the
/// axis, at z = 0.
TopoDS_Shape MakeTripod(double distance);
/// Balls of the radius about (0,0,0) and (length,0,0), and a thinner bar between them.
TopoDS_Shape MakeDumbbell(double radius, double length);
/// A body that touches the ground z = 0 along y, with its centre above: to the left a quarter of a cylinder
/// of radius 2 rises, to the right a plane.
TopoDS_Shape MakeHalfRocker();
/// Half a ball of radius 10 about the origin, y > 0, and a block for y < 0, above its pole at z = -10: the
/// centre of mass is at x = y = 0, below the middle of the ball.
TopoDS_Shape MakeHalfBall();
/// The disc about the origin at z = 0, or its half in x > 0, extruded along (leanX, leanY, height).
TopoDS_Shape MakeObliqueCylinder(double radius, double height, double leanX, double leanY, bool half);
/// A cone with its tip at the origin and its axis along z, upwards.
TopoDS_Shape MakeTipCone(double radius, double height);

/// Returns the shape rotated by `angle`, in radians, about the axis through the origin, then moved by
/// `shift`.
TopoDS_Shape Rotated(const TopoDS_Shape& shape, const double axis[3], double angle, const double shift[3]);

/// Writes the shape to FOLDER/standing_NAME.step and returns the path. Throws where OCCT refuses.
std::string WriteStanding(
  const std::string& folder, const std::string& name, const TopoDS_Shape& shape, const char* unit = "MM");
}

#endif
