/**
 * @file smInputFile.h
 * @brief Input that is not a plain file: compressed files and the standard input
 */
#ifndef smInputFile_h
#define smInputFile_h

#include <string>
#include <vector>

namespace sm
{
/**
 * The content behind a name as a plain file: the file itself; for "-" a copy of the standard input; the content of a file that gzip has
 * compressed (.step.gz, .stpz); and the only STEP file in a ZIP archive, or its only BREP file where it has none (.stpz, .zip). The first bytes of a file tell its kind. Copies are in a
 * folder below TMPDIR (/tmp without it) that the destructor removes, under the stem of the name, and have no more than 4 GB.
 */
class InputFile
{
public:
  explicit InputFile(const std::string& name);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// The plain file; the name that was given where there is an error.
  const std::string& GetPath() const { return this->Path; }
  /// Why there is none; empty if there is.
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

/// The names, with the STEP and BREP files in it, by their extension and in the order of their names, in place of every folder that has some.
std::vector<std::string> ExpandFolders(const std::vector<std::string>& names);
}

#endif
