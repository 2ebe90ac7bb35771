/**
 * @file smOCCTBuildGeometry.h
 * @brief NURBS surfaces, edge curves and trim curves as OpenCASCADE's B-splines: the same functions of the same parameters
 *
 * Only the form changes: homogeneous control points are divided by their weights, knots that are not clamped are,
 * and polynomial pieces are raised to the highest degree among them. Each costs a rounding or two of the coordinates.
 * All functions throw std::runtime_error with the reason where OpenCASCADE has no such spline, or Standard_Failure.
 */
#ifndef smOCCTBuildGeometry_h
#define smOCCTBuildGeometry_h

#include "smNURBSSurface.h"
#include "smOCCTParameterMap.h"
#include "smPolynomialCurve.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Handle.hxx>

namespace sm
{
/// The same surface over the same domain with knots that are clamped at both ends of both directions.
NURBSSurface ClampKnots(const NURBSSurface& surface);

/// `map` takes the stored coordinates to those of the kernel.
Handle(Geom_BSplineSurface) BuildSurface(const NURBSSurface& surface, const AffineMap& map);

/// A B-spline of the highest degree of the pieces, at least 1, over the curve's own parameters.
Handle(Geom_BSplineCurve) BuildCurve(const EdgeCurve& curve, const AffineMap& map);
Handle(Geom2d_BSplineCurve) BuildTrim(const TrimCurve& curve);
}

#endif
