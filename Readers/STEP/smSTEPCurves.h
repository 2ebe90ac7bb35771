/**
 * @file smSTEPCurves.h
 * @brief Reads curves of a STEP file from their entities
 */
#ifndef smSTEPCurves_h
#define smSTEPCurves_h

#include "smSTEPAttributes.h"
#include "smSpaceCurve.h"

namespace sm
{
/// Reads a point in the unit of the file; returns false if it has not three coordinates.
bool ReadSTEPPoint(const STEPAttributes& entities, Part21File::Index point, Vector3& position);

/**
 * Reads a curve in the unit of the file: LINE, CIRCLE, ELLIPSE, PARABOLA, HYPERBOLA, POLYLINE, B_SPLINE_CURVE
 * of all kinds, and these as the basis of a TRIMMED_CURVE or as the curve in space of a SURFACE_CURVE,
 * SEAM_CURVE or INTERSECTION_CURVE. `isReversed` is set to true if the curve runs against the one that is
 * returned (TRIMMED_CURVE). Returns false for other and for damaged curves.
 */
bool ReadSTEPCurve(
  const STEPAttributes& entities, Part21File::Index entity, SpaceCurve& curve, bool& isReversed);
}

#endif
