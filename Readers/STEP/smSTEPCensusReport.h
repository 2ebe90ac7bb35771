/**
 * @file smSTEPCensusReport.h
 * @brief What the census of a STEP file found, as messages and defects of the document
 */
#ifndef smSTEPCensusReport_h
#define smSTEPCensusReport_h

#include "smDocument.h"
#include "smSTEPCensus.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// Reports densities that are not used, quantities, products without a shape, and the problems of the census.
/// Contradictions are defects; a missing unit, and edges in the wrong direction, are messages.
void ReportCensus(const STEPCensus& census, Document& document);

/// Returns `#12 "name"`, or `#12` if the name is empty.
std::string NameEntity(std::uint64_t id, const std::string& name);
/// Returns the first ten numbers, and how many there are more: "#1, #2 and 3 more".
std::string ListEntities(const std::vector<std::uint64_t>& ids);
/// Returns "12 instances".
std::string CountInstances(CensusCount count);
}

#endif
