/**
 * @file smOCCTOrientVoids.h
 * @brief Voids that are oriented like the outer shell of their solid
 */
#ifndef smOCCTOrientVoids_h
#define smOCCTOrientVoids_h

#include <TopoDS_Shell.hxx>

#include <string>
#include <vector>

namespace sm
{
/**
 * Reverses voids that are oriented like the outer shell of a solid, because programs that do not heal what
 * they read would add their volume. The shells are those of a solid with one outer shell, which a STEP file
 * names first. A solid that is inside out as a whole remains so.
 *
 * A void is reversed only if all of this is certain:
 * - the first shell is the outer one: its box contains those of all others;
 * - the signs of both volumes, which exceed the errors of their quadratures and of the tolerances of edges,
 * and agree with the orientations that OpenCASCADE finds by rays;
 * - the void is inside the outer shell, and in no other void.
 *
 * All other shells remain as they are. Returns a sentence about those that may be oriented wrongly; empty if
 * there are none.
 */
std::string OrientVoids(std::vector<TopoDS_Shell>& shells);
}

#endif
