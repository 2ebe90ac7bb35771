/**
 * @file smPart21Remains.h
 * @brief The text of a damaged STEP file as OpenCASCADE can read it
 */
#ifndef smPart21Remains_h
#define smPart21Remains_h

#include "smPart21File.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * A STEP file of the instances that keep the syntax, with their numbers, under a header of its own that names
 * the file's schemas, in one DATA section. A parser that loses more than the damaged instance, or reads
 * something else out of the damage, sees with it what Part21File sees, and so does one that does not know the
 * sections of later editions. Numbers of lost instances that others refer to are undefined references in it.
 *
 * Instances that are marked in `unparsable` (smPart21Unparsable.h) are left out, too.
 *
 * Empty when there is nothing to leave out and one plain DATA section, and when a part of the text may be
 * missing (truncated, without data, beyond the end): what is lost then is not known.
 */
SMREADERSPART21_EXPORT std::string GetRemains(
  const Part21File& file, const std::vector<bool>& unparsable = {});

/**
 * The text with one number in place of all that are referred to and that no instance has: the largest one of
 * 31 bits that is free. OpenCASCADE takes an undefined number for the position of an instance among its
 * records; a file has fewer records than that. Empty if there are no such references.
 */
SMREADERSPART21_EXPORT std::string ReplaceUndefinedReferences(const Part21File& file);
}

#endif
