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

/// The start of the names of every file's trim textures: "folder/bracket", and "folder/bracket-2" for a second bracket; empty
/// without a folder.
std::vector<std::string> TexturePrefixes(const Arguments& arguments);

/// Whether there is a file of this name that is a STEP file by its name or its first line.
bool IsStepFile(const std::string& name);

/// Makes the folder of the trim textures, if one was asked for and is not there; why it cannot be written, else empty.
std::string MakeTextureFolder(const Arguments& arguments);

/// Why an output cannot be written or must not be: it is an input, another output, or a STEP file that is there. An
/// empty string when all is well. Asked before the work and not an hour later.
std::string CheckOutputs(const Arguments& arguments);
}

#endif
