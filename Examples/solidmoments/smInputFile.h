/**
 * @file smInputFile.h
 * @brief Makes plain files of compressed files and of the standard input
 */
#ifndef smInputFile_h
#define smInputFile_h

#include <optional>
#include <string>
#include <vector>

namespace sm
{
/**
 * Provides the content that a name refers to as a plain file: the file itself; for "-" a copy of the standard
 * input; the content of a file that gzip has compressed (.step.gz, .stpz); and the only STEP file in a ZIP
 * archive, or its only BREP file where it has none (.stpz, .zip). The kind is determined by the first bytes.
 * Copies are in a folder below TMPDIR (/tmp without it) that the destructor removes, under the stem of the
 * name, and have no more than 4 GB.
 */
class InputFile
{
public:
  explicit InputFile(const std::string& name);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Returns the path of the plain file; the given name if there is an error.
  const std::string& GetPath() const { return this->Path; }
  /// Returns the reason why there is no plain file; empty if there is one.
  const std::string& GetError() const { return this->Error; }

private:
  bool MakeFolder(const std::string& name);
  void CopyStandardInput();
  void Inflate(const std::string& name);
  void Extract(const std::string& name);

  std::string Path;
  std::string Error;
  std::string Folder;
};

/// Returns the content of a table that a user wrote, without the mark of UTF-8 that spreadsheets put before
/// it; none for a folder or a file that cannot be read.
std::optional<std::string> ReadTextFile(const std::string& name);

/// Returns the names, where every folder is replaced by the STEP and BREP files in it (by extension, sorted
/// by name), if it has some.
std::vector<std::string> ExpandFolders(const std::vector<std::string>& names);
}

#endif
