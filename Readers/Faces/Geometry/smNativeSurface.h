/**
 * @file smNativeSurface.h
 * @brief The plane, cylinder, cone, sphere or torus that a rational B-spline is: the inverse of
 * ConvertGeometry()
 */
#ifndef smNativeSurface_h
#define smNativeSurface_h

#include "smGeometricCurve.h"
#include "smGeometricSurface.h"
#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"

#include <array>
#include <optional>

namespace sm
{
/// A parameter of a B-spline, before it is combined linearly: itself, or the angle on equal arcs, from 0 at
/// the start of the domain (ParameterMap).
struct SMREADERSFACES_EXPORT NativeParameter
{
  bool IsCircular = false;
  /// Angle of an arc, of which the parameter k to k + 1 is number k.
  double Width = 0.0;
  int Count = 0;

  double Evaluate(double parameter) const;
};

/// An elementary surface, and its parameters: native = Start + Linear * (Evaluate(u), Evaluate(v)).
struct SMREADERSFACES_EXPORT NativeSurface
{
  ElementarySurface Surface;
  NativeParameter Parameters[2];
  double Start[2] = { 0.0, 0.0 };
  double Linear[2][2] = { { 1.0, 0.0 }, { 0.0, 1.0 } };

  std::array<double, 2> Map(double u, double v) const;
  /// Returns true if S_u x S_v of the elementary surface and of the B-spline have opposite directions.
  bool IsMirrored() const { return this->Linear[0][0] * this->Linear[1][1] < 0.0; }
};

/**
 * Returns the elementary surface, or nothing if the control points are not those of one: of a plane two by
 * two points of equal weight that are a parallelogram, of the others those that ConvertGeometry() makes, of
 * any number of turns about the axis, moved and scaled or not. Every control point must be that of the
 * surface within 64 roundings of the largest coordinate and the rounding that the surface states, so that the
 * result has no other error, and nothing is returned for what an edit deformed. Small arcs of cones, spheres
 * and tori, whose points determine an axis with few digits, get the frame that fits their points best
 * (FitNative()). The frame is right-handed, the angle of a cone above 0, and a torus may cross its axis.
 * Nothing is returned for a torus whose radii differ by at most 1e-4 of the minor one, nor, as measured, for
 * faces that hardly determine their cone: less than 5e-5 rad about its axis, or with a tip whose half angle
 * is below 3e-5.
 */
SMREADERSFACES_EXPORT std::optional<NativeSurface> FindNativeSurface(const NURBSSurface& surface);

/// The line or circle that an edge is: its parameter is Factor * (t - Start), from 0.
struct NativeCurve
{
  GeometricCurve<3>::Variant Curve;
  double Start = 0.0;
  double Factor = 1.0;
};

/// Returns the line, or the circle of at most one turn, on which an edge runs with constant speed, within
/// 1e-13 of its size and 32 roundings of its coordinates at all samples; nothing for another edge.
SMREADERSFACES_EXPORT std::optional<NativeCurve> FindNativeCurve(const EdgeCurve& curve);

/**
 * Returns the image of a trim curve in native parameters, over its own range: a straight line where it is
 * one, otherwise polynomial pieces that are fitted to 4e-14 of 1 (angles) and of the surface's extent
 * (lengths). Returns nothing if that fails.
 */
SMREADERSFACES_EXPORT std::optional<TrimCurve> MapTrim(const TrimCurve& trim, const NativeSurface& native);
}

#endif
