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
 * Text of the file from its header on, in which lists of coordinates, triangles and polylines of tessellated geometry have no
 * parameters: `#7=COORDINATES_LIST();`. They are annotations or copies of bodies for display, no body, structure, colour or property is
 * made of them, and a parser that does not know these types may take time quadratic in their length. All instances keep their
 * numbers and their types, so that references to them hold. Damaged instances stay as they are. Empty when there is nothing to remove.
 */
SMREADERSPART21_EXPORT std::string RemoveTessellations(const Part21File& file);

/// For each of the file's types whether the above takes its parameters away.
SMREADERSPART21_EXPORT std::vector<bool> FindTessellationTypes(const Part21File& file);
}

#endif
