/**
 * @file smOutputFiles.h
 * @brief The files that a run will write: named, and checked before anything is read
 */
#ifndef smOutputFiles_h
#define smOutputFiles_h

#include "smArguments.h"

namespace sm
{
/// The picture of every file: "out.png" for a single one; of several "out-bracket.png", and "out-bracket-2.png" for a
/// second bracket. No two are the same.
std::vector<std::string> PictureNames(const Arguments& arguments);

/// Why an output cannot be written or must not be: it is an input, another output, or a STEP file that is there. An
/// empty string when all is well. Asked before the work and not an hour later.
std::string CheckOutputs(const Arguments& arguments);
}

#endif
