/**
 * @file smSTEPTessellations.h
 * @brief The text of a STEP file without the numbers of tessellated geometry
 */
#ifndef smSTEPTessellations_h
#define smSTEPTessellations_h

#include "smPart21File.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * Returns the text of the file from its header on, in which lists of coordinates, triangles and polylines of
 * tessellated geometry have no parameters: `#7=COORDINATES_LIST();`. They are annotations or copies of bodies
 * for display. The reader makes no body, structure, colour or property of them, and a parser that does not
 * know these types may take time quadratic in their length. All instances keep their numbers and their types,
 * so that references to them hold. Damaged instances are not changed. Returns an empty text if there is
 * nothing to remove.
 */
SMREADERSPART21_EXPORT std::string RemoveTessellations(const Part21File& file);

/// Returns, for each type in Part21File::GetTypeNames(), true if RemoveTessellations() removes its
/// parameters.
SMREADERSPART21_EXPORT std::vector<bool> FindTessellationTypes(const Part21File& file);
}

#endif
