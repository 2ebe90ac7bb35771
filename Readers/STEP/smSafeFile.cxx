#include "smSafeFile.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace sm
{
SafeFile::SafeFile(const std::string& path)
  : Target(path)
{
  std::error_code error;
  if (fs::is_symlink(path, error))
  {
    const fs::path target = fs::canonical(path, error);
    this->Target = error ? path : target.string();
  }
  if (fs::is_directory(this->Target, error))
  {
    this->Fail("it is a folder; give the name of a file");
    return;
  }
  const bool exists = fs::exists(this->Target, error);
  // Replacing needs the folder's permission only; a file that is write-protected is not to be replaced.
  if (exists && !std::fstream(this->Target, std::ios::in | std::ios::out | std::ios::binary))
  {
    this->Fail("the file that is there is write-protected; choose another name");
    return;
  }
  int attempt = 0;
  do
  {
    this->Temporary = this->Target + ".saving" + std::to_string(attempt++);
  } while (fs::exists(this->Temporary, error));
  errno = 0;
  this->Stream.open(this->Temporary, std::ios::binary | std::ios::trunc);
  if (!this->Stream)
  {
    const std::string reason = errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : std::string();
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
