/**
 * @file smSTEPDoubts.h
 * @brief Finds placements and operators of a STEP file whose meaning is open
 */
#ifndef smSTEPDoubts_h
#define smSTEPDoubts_h

#include "smSTEPAttributes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// A contradiction to the standard that leaves the meaning of an entity open.
struct STEPDoubt
{
  std::uint64_t Id = 0;
  std::string Reason;
};

/**
 * Returns the placements whose reference direction is parallel to their axis although their x axis is needed,
 * and the operators of which two axes, or an axis and the default of another one, are parallel. Geometry that
 * is round about its axis and not trimmed by parameters needs no x axis. By the numbers of the entities.
 */
SMREADERSPART21_EXPORT std::vector<STEPDoubt> FindSTEPDoubts(const STEPAttributes& entities);
}

#endif
