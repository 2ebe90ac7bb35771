/**
 * @file smOCCTGeometry.h
 * @brief OpenCASCADE's curves and surfaces as native values: the same functions of the same parameters
 */
#ifndef smOCCTGeometry_h
#define smOCCTGeometry_h

#include "Geometry/smGeometricSurface.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace sm
{
/// Makes a value of a curve or surface without its trims. Null for a kind that OpenCASCADE does not make of
/// STEP files. Throws std::runtime_error with a short reason if OpenCASCADE's data are not consistent.
SurfacePointer MakeGeometry(const Handle(Geom_Surface) & surface);
CurvePointer<3> MakeGeometry(const Handle(Geom_Curve) & curve);
CurvePointer<2> MakeGeometry(const Handle(Geom2d_Curve) & curve);
}

#endif
