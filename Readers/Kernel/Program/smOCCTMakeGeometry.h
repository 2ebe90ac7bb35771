/**
 * @file smOCCTMakeGeometry.h
 * @brief Native curves and surfaces as those of OpenCASCADE: the same functions of the same parameters
 */
#ifndef smOCCTMakeGeometry_h
#define smOCCTMakeGeometry_h

#include "Geometry/smGeometricSurface.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace sm
{
/// Makes an OpenCASCADE object of a value: the inverse of MakeGeometry() (smOCCTGeometry.h), except for the
/// last bits of unit vectors, which OpenCASCADE divides by their length again. Throws std::runtime_error with
/// a short reason for a value of which OpenCASCADE has no kind, and what OpenCASCADE throws.
Handle(Geom_Surface) MakeKernelSurface(const GeometricSurface& surface);
Handle(Geom_Curve) MakeKernelCurve(const GeometricCurve<3>& curve);
Handle(Geom2d_Curve) MakeKernelCurve(const GeometricCurve<2>& curve);
}

#endif
