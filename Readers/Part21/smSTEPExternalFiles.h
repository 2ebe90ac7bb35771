/**
 * @file smSTEPExternalFiles.h
 * @brief Assemblies in several STEP files: finds the files of products without a shape, and joins the texts
 */
#ifndef smSTEPExternalFiles_h
#define smSTEPExternalFiles_h

#include "smReadersPart21Module.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * A product of an assembly may have its shape in another file, which a DOCUMENT_FILE names. Such files are
 * looked for in the folder of the file that names them, then in `folders`: under the name as it is written,
 * then under its last part. No absolute name and no name with ".." is followed, only its last part; links
 * that lead out of these folders are not followed either. Files that name others are completed likewise, and
 * a file that several products name is read once.
 *
 * Returns the text of the file at `path` with the entities of the others, each of which becomes a part of the
 * product that named it, at its origin; empty if nothing was found. Numbers of the entities of another file
 * are larger by a round number, which a message says. A file that is not found, cannot be read, or contains
 * the one that names it, is left out with a message: the census reports its product as missing.
 *
 * Throws only std::bad_alloc.
 */
SMREADERSPART21_EXPORT std::string JoinSTEPFiles(const std::string& content, const std::string& path,
  const std::vector<std::string>& folders, std::vector<std::string>& messages);
}

#endif
