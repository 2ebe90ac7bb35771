/**
 * @file smOCCTAssemblies.h
 * @brief Keeps OpenCASCADE's transfer of assemblies linear in the number of instances
 */
#ifndef smOCCTAssemblies_h
#define smOCCTAssemblies_h

#include <XSControl_WorkSession.hxx>

namespace sm
{
/**
 * For every instance the transfer goes through two lists that are as long as there are instances of the part, or in the assembly. Call this
 * before the transfer; it shortens both where they are long, so that the result is the same:
 *
 * - The entities that refer to the part's representation, of which each instance adds one, the relationship that places it. In that list
 *   the transfer looks for the definition of the shape and for relationships without a placement; of the others it takes the last,
 *   where it finds no shape. Of those all but the last are taken out.
 * - The items of the assembly's representation, among which the transfer looks for the placement, so as to tell an origin from a target that
 *   are interchanged. Placements that are not interchanged in any relationship, and no origin of one, are taken out.
 */
void ShortenAssemblies(const Handle(XSControl_WorkSession) & session);
}

#endif
