/**
 * @file smPartsReport.h
 * @brief The parts list of a file as JSON, table and CSV
 */
#ifndef smPartsReport_h
#define smPartsReport_h

#include "smJson.h"
#include "smPartsList.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * Returns the entries for the JSON:
 *   name, kind ("part" or "assembly"), count (in the product above), count_in_all (in the file), solids (of one), status (the worst of the
 *   solids), layer, material, density, each and in_all ({volume, area, mass, known_mass, solids_with_mass, bounds}), children.
 * Products more than `depth` levels down are left out of the list, but not out of the sums; 0 keeps all.
 */
Json MakePartsJson(const std::vector<PartsListEntry>& entries, int depth);

/// Returns a table of the entry "parts" of a file; empty without one.
std::string FormatPartsList(const Json& file);

/// Returns the parts lists of all files as CSV, a row per entry with its level.
std::string FormatPartsCsv(const Json& files);
}

#endif
