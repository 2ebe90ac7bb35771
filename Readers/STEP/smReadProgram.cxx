#include "smReadProgram.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace sm
{
namespace
{
constexpr char ProgressKind = 'p';
constexpr char ResultKind = 'r';
/// Time in milliseconds after which the progress callback is called again if no message has arrived.
constexpr int Patience = 100;
/// Number of folders above that of the library that are searched; the library may be in lib/TRIPLET/ParaView.
constexpr int Levels = 4;

bool Send(int descriptor, const void* from, std::size_t size)
{
  const char* bytes = static_cast<const char*>(from);
  while (size > 0)
  {
    const ssize_t count = write(descriptor, bytes, size);
    if (count < 0 && errno != EINTR)
    {
      return false;
    }
    bytes += std::max<ssize_t>(count, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
  return true;
}

bool SendMessage(int descriptor, char kind, const void* from, std::uint64_t size)
{
  return Send(descriptor, &kind, 1) && Send(descriptor, &size, sizeof(size)) && Send(descriptor, from, size);
}

std::string DescribeEnd(int status)
{
  if (WIFSIGNALED(status))
  {
    const int number = WTERMSIG(status);
    const bool isCrash =
      number == SIGSEGV || number == SIGBUS || number == SIGABRT || number == SIGFPE || number == SIGILL;
    return "ended by signal " + std::to_string(number) + " (" + strsignal(number) + ")" +
      (number == SIGKILL ? ", as the system does when memory runs out"
          : isCrash      ? "; the file is malformed or OpenCASCADE cannot read it"
                         : "");
  }
  return "ended with exit status " + std::to_string(WEXITSTATUS(status)) + " and without a result";
}

/// The running program. The destructor kills it unless it has ended.
class Process
{
public:
  /// `input` is the file that the program reads as its standard input; -1: none.
  Process(const std::string& program, const std::vector<std::string>& arguments, int input);
  ~Process();
  Process(const Process&) = delete;
  void operator=(const Process&) = delete;

  /// Returns the errno for which the program could not be started; 0 if it was.
  int GetError() const { return this->Error; }
  /// Appends the bytes that the program has sent. Waits up to `milliseconds` if there are none. Returns false
  /// at the end of its output.
  bool Receive(int milliseconds, Bytes& received);
  /// Waits for the end of the program, and returns the status of waitpid().
  int Wait();

private:
  pid_t Id = -1;
  int Pipe = -1;
  int Error = 0;
};

/// Makes a nameless file in memory with these bytes, positioned at its start, which no other program
/// inherits. Returns -1, with errno, if that fails.
int MakeInput(const std::string& bytes)
{
#ifdef __linux__
  const int file = memfd_create("solidmoments", MFD_CLOEXEC);
#else
  const char* const given = std::getenv("TMPDIR");
  std::string name = std::string(given && *given ? given : "/tmp") + "/solidmoments-XXXXXX";
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0)
  {
    unlink(name.c_str());
  }
#endif
  if (file >= 0 && (!Send(file, bytes.data(), bytes.size()) || lseek(file, 0, SEEK_SET) != 0))
  {
    const int error = errno;
    close(file);
    errno = error;
    return -1;
  }
  return file;
}

Process::Process(const std::string& program, const std::vector<std::string>& arguments, int input)
{
  std::vector<char*> words{ const_cast<char*>(program.c_str()) };
  for (const std::string& argument : arguments)
  {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    this->Error = errno;
    return;
  }
  this->Pipe = ends[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (input >= 0)
  {
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  }
  else
  {
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  }
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  this->Error = posix_spawn(&this->Id, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  this->Id = this->Error == 0 ? this->Id : -1;
}

Process::~Process()
{
  if (this->Id > 0)
  {
    kill(this->Id, SIGKILL);
    this->Wait();
  }
  if (this->Pipe >= 0)
  {
    close(this->Pipe);
  }
}

bool Process::Receive(int milliseconds, Bytes& received)
{
  struct pollfd waiting = { this->Pipe, POLLIN, 0 };
  if (poll(&waiting, 1, milliseconds) <= 0)
  {
    return true;
  }
  std::array<char, 65536> buffer;
  const ssize_t count = read(this->Pipe, buffer.data(), buffer.size());
  if (count > 0)
  {
    received.insert(received.end(), buffer.begin(), buffer.begin() + count);
  }
  return count > 0 || (count < 0 && errno == EINTR);
}

int Process::Wait()
{
  int status = 0;
  while (waitpid(this->Id, &status, 0) < 0 && errno == EINTR)
  {
  }
  this->Id = -1;
  return status;
}

/// Processes the complete messages in `received` and removes them.
void TakeMessages(Bytes& received, double& fraction, ReadProgramOutcome& outcome, bool& isComplete)
{
  constexpr std::size_t HeadSize = 1 + sizeof(std::uint64_t);
  std::size_t at = 0;
  std::uint64_t size = 0;
  for (; received.size() - at >= HeadSize; at += HeadSize + size)
  {
    std::memcpy(&size, received.data() + at + 1, sizeof(size));
    if (received.size() - at - HeadSize < size)
    {
      break;
    }
    const char* content = received.data() + at + HeadSize;
    if (received[at] == ProgressKind && size == sizeof(fraction))
    {
      std::memcpy(&fraction, content, sizeof(fraction));
    }
    else if (received[at] == ResultKind)
    {
      // The result is the last message and is moved, not copied.
      received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(at + HeadSize));
      outcome.Result.swap(received);
      outcome.Result.resize(size);
      received.clear();
      isComplete = true;
      return;
    }
  }
  received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(at));
}
}

std::string FindReadProgram()
{
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&FindReadProgram), &info) == 0 || !info.dli_fname)
  {
    return {};
  }
  std::string folder = vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::GetRealPath(info.dli_fname));
  for (int i = 0; i < Levels && !folder.empty(); ++i)
  {
    const std::string program = folder + "/bin/solidmoments-read";
    if (access(program.c_str(), X_OK) == 0)
    {
      return program;
    }
    folder = vtksys::SystemTools::GetFilenamePath(folder);
  }
  return {};
}

ReadProgramOutcome RunReadProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::string* input, const ProgressCallback& progress)
{
  ReadProgramOutcome outcome;
  const int file = input ? MakeInput(*input) : -1;
  if (input && file < 0)
  {
    outcome.Problem = std::string("could not be given the content: ") + std::strerror(errno);
    outcome.IsStarted = true;
    return outcome;
  }
  Process process(program, arguments, file);
  if (file >= 0)
  {
    close(file);
  }
  if (process.GetError() != 0)
  {
    outcome.Problem = std::string("could not be started: ") + std::strerror(process.GetError());
    return outcome;
  }
  Bytes received;
  double fraction = -1.0;
  bool isComplete = false;
  for (std::size_t before = 0; process.Receive(Patience, received); before = received.size())
  {
    // Progress is not reported for each part of a long result.
    const bool isAmidst = received.size() > before && before > 0;
    TakeMessages(received, fraction, outcome, isComplete);
    outcome.IsStarted = outcome.IsStarted || fraction >= 0.0;
    if (!isAmidst && !progress(std::max(fraction, 0.0)))
    {
      outcome.IsStopped = true;
      return outcome;
    }
  }
  const int status = process.Wait();
  if (!isComplete)
  {
    outcome.Problem = DescribeEnd(status);
  }
  return outcome;
}

int OpenMessages()
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  const int messages = dup(STDOUT_FILENO);
  const int null = open("/dev/null", O_WRONLY);
  if (messages >= 0 && null >= 0)
  {
    dup2(null, STDOUT_FILENO);
    close(null);
  }
  return messages;
}

bool SendProgress(int descriptor, double fraction)
{
  return SendMessage(descriptor, ProgressKind, &fraction, sizeof(fraction));
}

bool SendResult(int descriptor, const Bytes& result)
{
  return SendMessage(descriptor, ResultKind, result.data(), result.size());
}
}
