#include "smSafeFile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace sm
{
namespace
{
/// Symbolic links are followed so many times at most, so that a cycle of links ends.
constexpr int MaxChain = 40;
/// Age in seconds from which a temporary file that is not locked counts as left over by a process that was
/// killed.
constexpr std::time_t MinAgeOfLeft = 60;

/// Returns the path and the targets of its symbolic links, one after another. std::filesystem::canonical()
/// does not serve: the last target may not exist yet.
std::vector<fs::path> FollowLinks(const std::string& path)
{
  std::vector<fs::path> chain = { path };
  std::error_code error;
  for (int links = 0; links < MaxChain && fs::is_symlink(chain.back(), error); ++links)
  {
    chain.push_back(chain.back().parent_path() / fs::read_symlink(chain.back(), error));
  }
  return chain;
}

/// Removes a temporary file left over by a process that was killed. A process that still writes it holds a
/// lock on it from its creation on.
void RemoveLeft(const std::string& path)
{
  const int file = open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status = {};
  if (file >= 0)
  {
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
      std::time(nullptr) - status.st_mtime > MinAgeOfLeft && flock(file, LOCK_EX | LOCK_NB) == 0)
    {
      unlink(path.c_str());
    }
    close(file);
  }
}

std::string DescribeError(int number)
{
  return number != 0 ? std::string(" (") + std::strerror(number) + ")" : std::string();
}
}

SafeFile::SafeFile(const std::string& path)
  : Target(path)
{
  std::error_code error;
  this->Target = FollowLinks(path).back().string();
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
  const bool made = this->Make();
  if (made)
  {
    this->Stream.open(this->Temporary, std::ios::binary | std::ios::trunc);
  }
  if (!made || !this->Stream)
  {
    const std::string reason = DescribeError(errno);
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

bool SafeFile::Make()
{
  // Looks for a name that no file has, not even the temporary file of another process that writes the same
  // file.
  for (int attempt = 0; this->Lock < 0 && (attempt == 0 || errno == EEXIST); ++attempt)
  {
    this->Temporary = this->Target + ".saving" + std::to_string(attempt);
    RemoveLeft(this->Temporary);
    this->Lock = open(this->Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  }
  const int reason = errno;
  if (this->Lock >= 0)
  {
    flock(this->Lock, LOCK_EX | LOCK_NB);
  }
  errno = reason;
  return this->Lock >= 0;
}

SafeFile::~SafeFile()
{
  if (this->Lock >= 0)
  {
    close(this->Lock);
  }
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
    // libstdc++ closes the file and throws when its buffer cannot be written.
    return false;
  }
}

bool SafeFile::Keep()
{
  if (!this->Problem.empty())
  {
    return false;
  }
  // errno keeps the reason of an earlier failure of the stream.
  errno = this->Stream ? 0 : errno;
  this->Stream.flush();
  const bool whole = static_cast<bool>(this->Stream);
  int reason = errno;
  if (!this->Close() || !whole)
  {
    reason = reason != 0 ? reason : errno;
    this->DiskFull = reason == ENOSPC || reason == EFBIG || reason == EDQUOT;
    return this->Fail("not all of it could be written" + DescribeError(reason) +
      "; make room on the disk or choose another folder");
  }
  // Without this call the file could be empty after a power cut, because its new name may reach the disk
  // before its bytes. Some file systems do not support the call.
  errno = 0;
  if (fsync(this->Lock) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT))
  {
    this->DiskFull = errno != EIO;
    return this->Fail("not all of it could be written" + DescribeError(errno) +
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

bool IsStream(const std::string& path)
{
  std::error_code error;
  const std::vector<fs::path> chain = FollowLinks(path);
  const fs::file_status status = fs::status(chain.back(), error);
  // The links in /proc/self/fd name what is open already: a file that replaces it would not be the one that
  // is open.
  return (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) ||
    std::any_of(chain.begin(), chain.end(),
      [&error](const fs::path& name)
      {
        const fs::path folder = fs::weakly_canonical(name.parent_path(), error);
        return folder.filename() == "fd" && folder.string().rfind("/proc/", 0) == 0;
      });
}

std::string SaveFile(const std::string& path, const std::string& bytes)
{
  if (!IsStream(path))
  {
    SafeFile file(path);
    file.GetStream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.Keep();
    return file.GetProblem();
  }
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  return stream ? std::string() : "not all of it could be written" + DescribeError(errno);
}

std::string FindSaveProblem(const std::string& path)
{
  if (IsStream(path))
  {
    return access(path.c_str(), W_OK) == 0 ? std::string() : "it cannot be opened" + DescribeError(errno);
  }
  return SafeFile(path).GetProblem();
}
}
