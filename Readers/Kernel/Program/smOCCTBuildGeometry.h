/**
 * @file smOCCTBuildGeometry.h
 * @brief NURBS surfaces, edge curves and trim curves as OpenCASCADE's geometry
 *
 * Planes, cylinders, cones, spheres and tori, lines and circles become such (smNativeSurface.h); everything
 * else B-splines, the same functions of the same parameters. Of these only the representation changes:
 * homogeneous control points are divided by their weights, knots are clamped, and polynomial pieces are
 * raised to the highest degree among them, each with one or two roundings of the coordinates. All functions
 * throw std::runtime_error, with the reason, if OpenCASCADE has no such spline, or Standard_Failure.
 */
#ifndef smOCCTBuildGeometry_h
#define smOCCTBuildGeometry_h

#include "Geometry/smNativeSurface.h"
#include "Geometry/smParameterMap.h"
#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"

#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Standard_Handle.hxx>

#include <optional>

namespace sm
{
/// Returns the same surface over the same domain, with knots clamped at both ends in both directions.
NURBSSurface ClampKnots(const NURBSSurface& surface);

/// Builds a surface. `map` transforms stored coordinates to those of OpenCASCADE.
Handle(Geom_BSplineSurface) BuildSurface(const NURBSSurface& surface, const AffineMap& map);

/// The surface of a face, and how its parameters follow from those of the model's surface.
struct BuiltSurface
{
  Handle(Geom_Surface) Surface;
  /// Nothing for a B-spline, which has the parameters of the model.
  std::optional<NativeSurface> Native;

  bool IsMirrored() const { return this->Native && this->Native->IsMirrored(); }
};

/// Builds an elementary surface; nothing if the surface is another one, before or after an edit.
std::optional<BuiltSurface> BuildElementarySurface(const NURBSSurface& surface, const AffineMap& map);

/// The curve of an edge. Its parameter is Factor * (t - Start) for the parameter t of the model's edge.
struct BuiltCurve
{
  Handle(Geom_Curve) Curve;
  double Start = 0.0;
  double Factor = 1.0;

  double Map(double t) const { return this->Factor * (t - this->Start); }
};

/// Builds a line or a circle from the parameter 0, or a B-spline of the highest degree of the pieces, at
/// least 1, over the parameters of the model's edge.
BuiltCurve BuildCurve(const EdgeCurve& curve, const AffineMap& map);

/// Builds a trim curve with the parameter of the built edge: a line, if it is one with speed 1, or a
/// B-spline.
Handle(Geom2d_Curve) BuildTrim(const TrimCurve& curve, const BuiltCurve& edge);
}

#endif
