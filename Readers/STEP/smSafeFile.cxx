#include "smSafeFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace sm
{
namespace
{
/// Links that lead to each other; a ring of them ends there.
constexpr int LongestChain = 40;
}

SafeFile::SafeFile(const std::string& path)
  : Target(path)
{
  std::error_code error;
  // By hand: a link may lead to a file that is not there yet.
  fs::path target = path;
  for (int links = 0; links < LongestChain && fs::is_symlink(target, error); ++links)
  {
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  this->Target = target.string();
  if (fs::is_directory(this->Target, error))
  {
    this->Fail("it is a folder; give the name of a file");
    return;
  }
  const bool exists = fs::exists(this->Target, error);
  if (exists && !fs::is_regular_file(this->Target, error))
  {
    this->Fail("what is there is no file but a device or a pipe; choose another name");
    return;
  }
  // Replacing needs the folder's permission only; a file that is write-protected is not to be replaced.
  if (exists && !std::fstream(this->Target, std::ios::in | std::ios::out | std::ios::binary))
  {
    this->Fail("the file that is there is write-protected; choose another name");
    return;
  }
  // A name that nobody has, also not another process that writes the same file.
  std::FILE* made = nullptr;
  for (int attempt = 0; !made && (attempt == 0 || errno == EEXIST); ++attempt)
  {
    this->Temporary = this->Target + ".saving" + std::to_string(attempt);
    errno = 0;
    made = std::fopen(this->Temporary.c_str(), "wbx");
  }
  if (made)
  {
    std::fclose(made);
    this->Stream.open(this->Temporary, std::ios::binary | std::ios::trunc);
  }
  if (!made || !this->Stream)
  {
    const std::string reason = errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : std::string();
    if (made)
    {
      fs::remove(this->Temporary, error);
    }
    this->Temporary.clear();
    this->Fail(
      "no file can be made in its folder" + reason + "; check that the folder exists and may be written");
    return;
  }
  if (exists)
  {
    fs::permissions(this->Temporary, fs::status(this->Target, error).permissions(), error);
  }
}

SafeFile::~SafeFile()
{
  if (!this->Temporary.empty())
  {
    this->Close();
    std::error_code error;
    fs::remove(this->Temporary, error);
  }
}

bool SafeFile::Fail(const std::string& problem)
{
  this->Problem = problem;
  return false;
}

bool SafeFile::Close()
{
  try
  {
    this->Stream.close();
    return static_cast<bool>(this->Stream);
  }
  catch (const std::exception&)
  {
    // libstdc++ closes the file and throws, when what it still holds cannot be written.
    return false;
  }
}

bool SafeFile::Keep()
{
  // A stream that failed before keeps the reason of then.
  errno = this->Stream ? 0 : errno;
  this->Stream.flush();
  const bool whole = static_cast<bool>(this->Stream);
  int reason = errno;
  if (!this->Close() || !whole)
  {
    reason = reason != 0 ? reason : errno;
    this->DiskFull = reason == ENOSPC || reason == EFBIG || reason == EDQUOT;
    return this->Fail(std::string("not all of it could be written") +
      (reason != 0 ? std::string(" (") + std::strerror(reason) + ")" : std::string()) +
      "; make room on the disk or choose another folder");
  }
  std::error_code error;
  fs::rename(this->Temporary, this->Target, error);
  if (error)
  {
    return this->Fail("the file that is there cannot be replaced (" + error.message() + ")");
  }
  this->Temporary.clear();
  return true;
}
}
