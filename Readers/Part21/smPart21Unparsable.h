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
 * Marks the instances whose numbers are above LargestParsedNumber, those with lists in more than 100 levels, over which OpenCASCADE
 * recurses, and those with an empty list where OpenCASCADE 7.6 follows the null pointer that it makes of it, right after parsing: it would
 * crash even if nothing depends on the instance. Empty if there are none.
 */
SMREADERSPART21_EXPORT std::vector<bool> FindUnparsable(const Part21File& file);
}

#endif
