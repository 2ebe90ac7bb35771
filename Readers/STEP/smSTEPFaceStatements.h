/**
 * @file smSTEPFaceStatements.h
 * @brief Reads what a STEP file states about its faces in space: from entities alone
 */
#ifndef smSTEPFaceStatements_h
#define smSTEPFaceStatements_h

#include "smFaceStatement.h"
#include "smPart21File.h"
#include "smReadersSTEPModule.h"
#include "smSTEPCensus.h"

namespace sm
{
/**
 * Returns the statements of all faces of bodies that occur in the file. Curves: LINE, CIRCLE, ELLIPSE,
 * PARABOLA, HYPERBOLA, POLYLINE, B_SPLINE_CURVE of all kinds, TRIMMED_CURVE of these, also within
 * SURFACE_CURVE, SEAM_CURVE and INTERSECTION_CURVE; POLY_LOOP and VERTEX_LOOP. A face with any other is not
 * known. Linear in the file; throws only std::bad_alloc.
 */
SMREADERSSTEP_EXPORT FaceStatements ReadFaceStatements(const Part21File& file, const STEPCensus& census);
}

#endif
