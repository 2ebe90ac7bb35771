/**
 * @file smFile.h
 * @brief Loads files, and checks the beginning and end of STEP files
 */
#ifndef smFile_h
#define smFile_h

#include "smReadersSTEPModule.h"

#include <functional>
#include <string>
#include <string_view>

namespace sm
{
/// Reads all bytes of a file. Sets `problem`, with a remedy, if it cannot be opened or is empty. Returns
/// false if `progress`, which is called repeatedly, returned false.
bool LoadFile(
  const std::string& name, const std::function<bool()>& progress, std::string& bytes, std::string& problem);

/// Result of the check of the first and last bytes of a STEP file.
struct FileCheck
{
  bool Readable = false;
  /// The reason why it is not readable, with a remedy; empty if it may be.
  std::string Problem;
  /// Bytes before "ISO-10303-21;" that are neither blanks nor comments.
  std::size_t JunkBytes = 0;
  /// True if the file does not end with END-ISO-10303-21.
  bool Truncated = false;
};
SMREADERSSTEP_EXPORT FileCheck CheckText(std::string_view text);

/// Returns the first 64 KiB of a file, or fewer if it is shorter, in which the header of its format is.
SMREADERSSTEP_EXPORT std::string LoadHead(const std::string& name);

/// Returns true if the file begins like a STEP file; reads only its beginning.
bool LooksLikeSTEP(const std::string& name);
}

#endif
