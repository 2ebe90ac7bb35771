/**
 * @file smSafeFile.h
 * @brief A file that is there whole or not at all
 */
#ifndef smSafeFile_h
#define smSafeFile_h

#include "smFiltersNURBSModule.h"

#include <fstream>
#include <string>

namespace sm
{
/**
 * Writes to a temporary file in the same folder, which replaces the file when Keep() is called: until then a file that was there
 * before stays. Without Keep() the temporary file is removed. A link is followed, also to a file that is not there yet; the permissions
 * of a file that is replaced are kept. The bytes are on the disk before the file is replaced. A temporary file that a process left which was
 * killed is removed by the next that saves the same file, a minute later. A folder, a device or a pipe is a problem.
 */
class SMFILTERSNURBS_EXPORT SafeFile
{
public:
  explicit SafeFile(const std::string& path);
  ~SafeFile();
  SafeFile(const SafeFile&) = delete;
  void operator=(const SafeFile&) = delete;

  /// Why the file cannot be written, and what to do about it; empty so far.
  const std::string& GetProblem() const { return this->Problem; }
  /// The problem is that the disk, or the user's share of it, is full.
  bool IsDiskFull() const { return this->DiskFull; }
  std::ostream& GetStream() { return this->Stream; }
  /// False when not everything could be written, and GetProblem() says why.
  bool Keep();

private:
  bool Fail(const std::string& problem);
  bool Make();
  bool Close();

  std::string Target;
  std::string Temporary;
  std::string Problem;
  bool DiskFull = false;
  /// Descriptor of the temporary file, which is locked as long as it is open; -1: none.
  int Lock = -1;
  std::ofstream Stream;
};

/**
 * Writes a file of these bytes: a regular file as SafeFile does, a device, a pipe or a name of an open file (/dev/stdout) directly.
 * Returns why it could not be written, and what to do about it; an empty text when all is there.
 */
SMFILTERSNURBS_EXPORT std::string SaveFile(const std::string& path, const std::string& bytes);

/// Why SaveFile() would fail: makes the temporary file and removes it. Empty when it would not.
SMFILTERSNURBS_EXPORT std::string FindSaveProblem(const std::string& path);

/// True for what SaveFile() writes directly. Such a file takes no second version of a document.
SMFILTERSNURBS_EXPORT bool IsStream(const std::string& path);
}

#endif
