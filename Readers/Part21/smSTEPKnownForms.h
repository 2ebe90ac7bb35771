/**
 * @file smSTEPKnownForms.h
 * @brief Writes valid statements of a STEP file in the forms that OpenCASCADE knows
 */
#ifndef smSTEPKnownForms_h
#define smSTEPKnownForms_h

#include "smPart21Changes.h"
#include "smSTEPAttributes.h"

namespace sm
{
/**
 * Replaces valid forms that OpenCASCADE 7.6 does not read, or reads otherwise, by others with the same
 * meaning:
 *
 * - A face without bounds on a sphere or a torus gets a VERTEX_LOOP: it is the whole surface.
 * - ORIENTED_FACE: its shell gets the face itself, with the other sense and reversed bounds if the
 * orientation is .F.; a copy if the face is used elsewhere, too.
 * - BREP_WITH_VOIDS as a complex instance, for example with FACETED_BREP, becomes a simple one.
 * - Several SHAPE_DEFINITION_REPRESENTATIONs of one product by representations that are one shape: the first
 * one is kept.
 * - A representation that is related to that of a product through others is related to it directly.
 * - Relations to a representation that has triangles only are left out.
 *
 * Time and memory are linear in the file.
 */
void UseKnownForms(const STEPAttributes& entities, Part21Changes& changes);

/// Returns true for a face with an empty list of bounds that is a whole sphere or a whole torus.
bool IsWholeSurface(const STEPAttributes& entities, Part21File::Index face);
}

#endif
