/**
 * @file smCensusText.h
 * @brief The census of a STEP file as text, for people and for comparison in tests
 */
#ifndef smCensusText_h
#define smCensusText_h

#include "smSTEPCensus.h"

#include <string>

namespace smtest
{
/// Kinds of problems with their number and, of each, the first places: "wrong type: 2 (#5 at parent #6)".
/// Empty for a sound file.
std::string DescribeProblems(const sm::Part21File& file, const sm::STEPCensus& census, std::size_t places);

/// Counts on one line: "solids 2, instances 3, faces 12, surface models 0, other solids 0, occurrences 2,
/// mapped 0".
std::string DescribeCounts(const sm::STEPCensus& census);

/// All bodies with their shells, the assembly, units and problems.
std::string DescribeCensus(const sm::Part21File& file, const sm::STEPCensus& census);
}

#endif
