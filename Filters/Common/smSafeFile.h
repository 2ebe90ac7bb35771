/**
 * @file smSafeFile.h
 * @brief Saves a file completely or not at all
 */
#ifndef smSafeFile_h
#define smSafeFile_h

#include "smFiltersCommonModule.h"

#include <fstream>
#include <string>

namespace sm
{
/**
 * Writes to a temporary file in the same folder, which replaces the file when Keep() is called: until then an
 * existing file stays unchanged. Without Keep() the temporary file is removed. A link is followed, also to a
 * file that is not there yet; the permissions of a file that is replaced are kept. The bytes are on the disk
 * before the file is replaced. A temporary file of a process that was killed is removed when the same file is
 * saved again, a minute later or more. A path of a folder, a device or a pipe is refused, see GetProblem().
 */
class SMFILTERSCOMMON_EXPORT SafeFile
{
public:
  explicit SafeFile(const std::string& path);
  ~SafeFile();
  SafeFile(const SafeFile&) = delete;
  void operator=(const SafeFile&) = delete;

  /// The reason why the file cannot be written, and a remedy; empty as long as nothing failed.
  const std::string& GetProblem() const { return this->Problem; }
  /// Returns true if the problem is a full disk or an exceeded quota.
  bool IsDiskFull() const { return this->DiskFull; }
  std::ostream& GetStream() { return this->Stream; }
  /// Replaces the file by the temporary one. Returns false, with GetProblem(), when not everything could be
  /// written; an existing file stays then.
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
 * Writes a file of these bytes: a regular file as SafeFile does, a device, a pipe or a name of an open file
 * (/dev/stdout) directly. Returns why it could not be written, and what to do about it; an empty text when
 * all is there.
 */
SMFILTERSCOMMON_EXPORT std::string SaveFile(const std::string& path, const std::string& bytes);

/// Returns the reason for which SaveFile() would fail, or an empty text; makes a temporary file and removes
/// it.
SMFILTERSCOMMON_EXPORT std::string FindSaveProblem(const std::string& path);

/// Returns true for paths that SaveFile() writes directly. A document written there cannot be replaced by a
/// later version.
SMFILTERSCOMMON_EXPORT bool IsStream(const std::string& path);
}

#endif
