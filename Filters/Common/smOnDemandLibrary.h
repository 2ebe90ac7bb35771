/**
 * @file smOnDemandLibrary.h
 * @brief Libraries that are loaded when something is wanted of them; not installed
 */
#ifndef smOnDemandLibrary_h
#define smOnDemandLibrary_h

#include "smFiltersCommonModule.h"

#include <string>

namespace sm
{
/// What a library gives: its version, and a table of functions or an object. Both outlive the process.
struct LibraryEntry
{
  const char* Version;
  void* Content;
};
using LibraryEntryFunction = LibraryEntry (*)();

/**
 * Loads the library `fileName` from the folder of this module's library, calls its function `entryName`, a
 * LibraryEntryFunction, and returns its content. Returns null, with the reason as the predicate of a sentence
 * about the library, if the file is missing or cannot be loaded, or if its version is not `version`. A
 * library is never unloaded. Thread safe.
 */
SMFILTERSCOMMON_EXPORT void* LoadOnDemand(
  const std::string& fileName, const char* entryName, const std::string& version, std::string& reason);
}

#endif
