/**
 * @file smPartsList.h
 * @brief The parts list (bill of materials) of a file: products with their counts, and the sums of their solids
 */
#ifndef smPartsList_h
#define smPartsList_h

#include "smJson.h"

#include <string>

namespace sm
{
/**
 * Entries of the products below the root of `tree` (smProductTree.h), sorted by name. An entry stands for all equal products in one place:
 *   name, kind ("part" or "assembly"), count (in the product above), count_in_all (in the file), solids (of one), material, density, each
 *   and in_all ({volume, area, mass, known_mass, solids_with_mass, bounds}), children.
 * Products are equal if they have the same name and consist of the same bodies and equal products. Values of `each` are those of the first,
 * values of `in_all` the sums over all. Products more than `depth` levels down are left out of the list, but not out of the sums; 0 keeps
 * all. Solids that `solids` lacks are left out.
 */
Json MakePartsList(const Json& tree, const Json& solids, int depth);

/// A table of the entry "parts" of a file; empty without one.
std::string FormatPartsList(const Json& file);

/// The parts lists of all files as CSV, a row per entry with its level.
std::string FormatPartsCsv(const Json& files);
}

#endif
