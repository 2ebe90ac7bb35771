/**
 * @file smPart21Unparsable.h
 * @brief Instances of a STEP file that keep the syntax, but that OpenCASCADE's parser cannot take
 */
#ifndef smPart21Unparsable_h
#define smPart21Unparsable_h

#include "smPart21File.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace sm
{
/// The largest number of an instance that OpenCASCADE's parser keeps.
constexpr std::uint64_t LargestParsedNumber = std::numeric_limits<std::int32_t>::max();

/**
 * Marks the instances that the parser does not accept: those whose numbers are above LargestParsedNumber,
 * those with lists in more than 100 levels, and those with an empty list as a parameter that the schemas
 * require to have members and the parser relies on. They are left out even if nothing depends on them. Empty
 * if there are none.
 */
SMREADERSPART21_EXPORT std::vector<bool> FindUnparsable(const Part21File& file);
}

#endif
