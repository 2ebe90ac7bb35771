/**
 * @file smOCCTBuildGeometry.h
 * @brief NURBS surfaces, edge curves and trim curves as OpenCASCADE's B-splines: the same functions of the
 * same parameters
 *
 * Only the representation changes: homogeneous control points are divided by their weights, knots are
 * clamped, and polynomial pieces are raised to the highest degree among them, each with one or two roundings
 * of the coordinates. All functions throw std::runtime_error, with the reason, if OpenCASCADE has no such
 * spline, or Standard_Failure.
 */
#ifndef smOCCTBuildGeometry_h
#define smOCCTBuildGeometry_h

#include "Geometry/smParameterMap.h"
#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Handle.hxx>

namespace sm
{
/// Returns the same surface over the same domain, with knots clamped at both ends in both directions.
NURBSSurface ClampKnots(const NURBSSurface& surface);

/// Builds a surface. `map` transforms stored coordinates to those of OpenCASCADE.
Handle(Geom_BSplineSurface) BuildSurface(const NURBSSurface& surface, const AffineMap& map);

/// A B-spline of the highest degree of the pieces, at least 1, over the curve's own parameters.
Handle(Geom_BSplineCurve) BuildCurve(const EdgeCurve& curve, const AffineMap& map);
Handle(Geom2d_BSplineCurve) BuildTrim(const TrimCurve& curve);
}

#endif
