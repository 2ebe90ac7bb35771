/**
 * @file smOutputFiles.h
 * @brief Names of the files that a run will write, and checks that are made before anything is read
 */
#ifndef smOutputFiles_h
#define smOutputFiles_h

#include "smArguments.h"

namespace sm
{
/// Returns the name of an output for every input file: "out.png" for a single file; for several files
/// "out-bracket.png", and "out-bracket-2.png" for a second bracket. All names are different. If `name` is
/// empty, so are they.
std::vector<std::string> OutputNames(const std::vector<std::string>& files, const std::string& name);

/// Returns the prefix of the names of every file's trim textures: "folder/bracket", and "folder/bracket-2"
/// for a second bracket; empty without a folder.
std::vector<std::string> TexturePrefixes(const Arguments& arguments);

/// Returns true if a file of this name exists and is a STEP or BREP file by its extension or its first line.
bool IsModelFile(const std::string& name);

/// Returns true if two names are those of one file, which need not exist.
bool IsSameFile(const std::string& a, const std::string& b);

/// Returns every input and every output of a run except the meshes of robots and the trim textures.
std::vector<std::string> ListFiles(const Arguments& arguments);

/// Makes the folder of the trim textures, if one is given. Returns an error message when it cannot be
/// written, otherwise an empty text.
std::string MakeTextureFolder(const Arguments& arguments);

/// Returns an error message if an output cannot be written, or is an input, another output or an existing
/// STEP file; empty otherwise. Called before the computation, which may take long.
std::string CheckOutputs(const Arguments& arguments);
}

#endif
