/**
 * @file smValidation.h
 * @brief Compares the validation properties of a STEP file with the results, and writes them
 */
#ifndef smValidation_h
#define smValidation_h

#include "smJson.h"

#include <string>

namespace sm
{
/**
 * Returns a list with an entry for every property that the file states: product (name), definition (entity number), quantity ("volume",
 * "area", "centroid"), stated, computed and bound in the length unit of the results, difference, limit, result ("pass", "fail",
 * "not-comparable") and reason. Volume and area may differ by `limit` of the stated value, the centroid by `limit` of the cube root of the
 * volume, and all by their bounds. `tree` is that of GetProductTree() with placements.
 */
Json CompareValidation(const std::string& fileName, const Json& tree, const Json& file, double limit);

/// Writes the text of the file with the validation properties and densities of the products that were computed. Existing statements are
/// kept. Returns an error message; empty if the file was written.
std::string WriteValidation(
  const std::string& fileName, const Json& tree, const Json& file, const std::string& target);
}

#endif
