/**
 * @file smOCCTAssemblies.h
 * @brief Keeps OpenCASCADE's transfer of assemblies linear in the number of instances
 */
#ifndef smOCCTAssemblies_h
#define smOCCTAssemblies_h

#include "smOCCTEntities.h"

#include <XSControl_WorkSession.hxx>

namespace sm
{
/**
 * For every instance the transfer searches two lists, whose lengths are the numbers of instances of the part
 * and of the assembly. This function, which must be called before the transfer, shortens both if they are
 * long, without a change of the result:
 *
 * - The entities that refer to the part's representation; each instance adds one, the relationship that
 * places it. In that list the transfer searches the definition of the shape and relationships without a
 * placement. If it finds no shape, it uses the last one of the others. All of these but the last are removed.
 * - The items of the assembly's representation, among which the transfer searches the placement, to detect
 * that origin and target are interchanged. Placements that are not interchanged in any relationship, and that
 * are not origin of one, are removed.
 */
void ShortenAssemblies(const Handle(XSControl_WorkSession) & session, const ModelEntities& entities);
}

#endif
