#include "smOnDemandLibrary.h"

#include <dlfcn.h>
#include <filesystem>

namespace sm
{
namespace
{
/// Opens the file next to this module's library; if that is a link, else next to what it points at.
void* OpenInFolder(const std::string& fileName, std::string& reason)
{
  namespace fs = std::filesystem;
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&LoadOnDemand), &info) == 0 || !info.dli_fname)
  {
    reason = "was not found";
    return nullptr;
  }
  std::error_code error;
  fs::path file;
  for (const fs::path& own : { fs::absolute(info.dli_fname, error), fs::canonical(info.dli_fname, error) })
  {
    file = own.parent_path() / fileName;
    if (fs::exists(file, error))
    {
      // All symbols are bound at once: a missing one is a reason here, and would end the process later.
      void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
      const char* const problem = library ? nullptr : dlerror();
      reason = library ? "" : "cannot be loaded (" + std::string(problem ? problem : "unknown reason") + ")";
      return library;
    }
  }
  reason = "was not found in " + file.parent_path().string();
  return nullptr;
}
}

void* LoadOnDemand(
  const std::string& fileName, const char* entryName, const std::string& version, std::string& reason)
{
  void* const library = OpenInFolder(fileName, reason);
  if (!library)
  {
    return nullptr;
  }
  const auto getEntry = reinterpret_cast<LibraryEntryFunction>(dlsym(library, entryName));
  const LibraryEntry entry = getEntry ? getEntry() : LibraryEntry{ "an unknown version", nullptr };
  reason = entry.Version == version ? "" : std::string("is of ") + entry.Version + ", not of " + version;
  return reason.empty() ? entry.Content : nullptr;
}
}
