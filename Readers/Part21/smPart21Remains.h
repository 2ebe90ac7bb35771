/**
 * @file smPart21Remains.h
 * @brief The text of a damaged STEP file without what breaks the syntax
 */
#ifndef smPart21Remains_h
#define smPart21Remains_h

#include "smPart21File.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * A STEP file of the instances that keep the syntax, with their numbers, under a header of its own that names the file's schemas. A parser
 * that loses more than the damaged instance, or reads something else out of the damage, sees with it what Part21File sees. Numbers of lost
 * instances that others refer to are undefined references in it.
 *
 * Instances that are marked in `unparsable` (smPart21Unparsable.h) are left out, too.
 *
 * Empty when there is nothing to leave out, and when a part of the text may be missing (truncated, without data, beyond the end): what is lost
 * then is not known.
 */
SMREADERSPART21_EXPORT std::string GetRemains(
  const Part21File& file, const std::vector<bool>& unparsable = {});
}

#endif
