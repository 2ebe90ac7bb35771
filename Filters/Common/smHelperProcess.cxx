#include "smHelperProcess.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <new>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace sm
{
namespace
{
using Clock = std::chrono::steady_clock;

/// Returns the limit of the stack of a process in kB, if that may be the cause of a crash; else 0.
rlim_t GetScarceStack()
{
  constexpr rlim_t ample = 1024;
  rlimit limit = {};
  const bool isKnown = getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return isKnown && limit.rlim_cur / 1024 < ample ? limit.rlim_cur / 1024 : 0;
}

/// Head of a message in the pipe: its kind, and the number of bytes that follow.
constexpr std::size_t HeadSize = 1 + sizeof(std::uint64_t);

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

/// Starts the program and returns errno; 0 if it runs.
int Spawn(
  const std::string& program, const std::vector<std::string>& arguments, int input, int output, pid_t& id)
{
  std::vector<char*> words{ const_cast<char*>(program.c_str()) };
  for (const std::string& argument : arguments)
  {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int error = posix_spawn(&id, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

/// Set to 1 when a child of Fork() has no memory left; shared with the process that started it.
volatile std::sig_atomic_t* OutOfMemory = nullptr;

void OnNoMemory()
{
  *OutOfMemory = 1;
  throw std::bad_alloc();
}

/// Handles a fatal signal: a driver without memory aborts or uses a null pointer. The cause is taken to be
/// memory if an allocation fails here.
void OnFatalSignal(int number)
{
  constexpr std::size_t little = std::size_t(64) << 20;
  if (mmap(nullptr, little, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED)
  {
    *OutOfMemory = 1;
  }
  std::signal(number, SIG_DFL);
  raise(number);
}

/// Lets the child report that it has run out of memory. Signal handlers are installed only if its memory is
/// limited (ulimit -v).
void WatchMemory()
{
  if (!OutOfMemory)
  {
    return;
  }
  std::set_new_handler(OnNoMemory);
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    for (const int number : { SIGSEGV, SIGBUS, SIGABRT })
    {
      std::signal(number, OnFatalSignal);
    }
  }
}

/// Returns how many processes of this machine the system has ended for want of memory; -1 if it does not
/// report that.
long CountMemoryKills()
{
  std::ifstream counters("/proc/vmstat");
  std::string name;
  for (long value = 0; counters >> name >> value;)
  {
    if (name == "oom_kill")
    {
      return value;
    }
  }
  return -1;
}

/// Returns true if a child may have crashed because its address space is limited (ulimit -v), and with it its
/// stack: it used at least a quarter of the limit.
bool MayHaveMetLimit(int signal, const rusage& used)
{
  rlimit limit{};
  return (signal == SIGSEGV || signal == SIGBUS) && getrlimit(RLIMIT_AS, &limit) == 0 &&
    limit.rlim_cur != RLIM_INFINITY && static_cast<rlim_t>(used.ru_maxrss) * 4096 > limit.rlim_cur;
}

/// Returns true if a process with these resources may have reached its hard limit of processor time, at which
/// the system sends SIGKILL: the shell's ulimit -t sets the hard limit, too.
bool HasUsedProcessorLimit(const rusage& used)
{
  rlimit limit{};
  const double seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
    1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  return getrlimit(RLIMIT_CPU, &limit) == 0 && limit.rlim_max != RLIM_INFINITY &&
    seconds > static_cast<double>(limit.rlim_max) - 0.5;
}
}

int ProcessEnd::GetSignal() const
{
  return WIFSIGNALED(this->Status) ? WTERMSIG(this->Status) : 0;
}

bool ProcessEnd::IsForced() const
{
  return this->IsTimeOver || this->IsOutOfMemory || this->GetSignal() == SIGKILL ||
    this->GetSignal() == SIGXCPU || (this->GetSignal() == SIGSEGV && GetScarceStack() > 0);
}

std::string ProcessEnd::Describe() const
{
  const int number = this->GetSignal();
  std::string end;
  if (number == SIGXCPU)
  {
    end = "used all the processor time that the system allows it (ulimit -t) and was ended";
  }
  else if (number != 0)
  {
    end = "ended by signal " + std::to_string(number) + " (" + strsignal(number) +
      (number == SIGKILL && !this->IsOutOfMemory ? ", from outside, as the system does when memory runs out)"
                                                 : ")");
    if (number == SIGSEGV && GetScarceStack() > 0)
    {
      end += "; the system allows it a stack of " + std::to_string(GetScarceStack()) +
        " kB (ulimit -s), which is too little: allow 8192";
    }
  }
  else if (WEXITSTATUS(this->Status) != 0)
  {
    end = "ended with exit status " + std::to_string(WEXITSTATUS(this->Status));
  }
  return !end.empty() && this->IsOutOfMemory ? "ran out of memory and " + end : end;
}

HelperProcess::HelperProcess(Listener take)
  : Take(std::move(take))
{
}

HelperProcess::~HelperProcess()
{
  if (this->IsRunning() && this->Parent == getpid())
  {
    kill(this->Id, SIGKILL);
    this->TakeEnd();
  }
  for (const int descriptor : { this->Pipe, this->Requests })
  {
    if (descriptor >= 0)
    {
      close(descriptor);
    }
  }
  if (this->OutOfMemory)
  {
    munmap(const_cast<std::sig_atomic_t*>(this->OutOfMemory), sizeof(*this->OutOfMemory));
  }
}

std::string HelperProcess::Start(const std::string& program, const std::vector<std::string>& arguments)
{
  // A socket, because a write to a pipe whose reader has ended raises a signal.
  int requests[2];
  int messages[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, requests) != 0)
  {
    return std::string("could not be started: ") + std::strerror(errno);
  }
  this->Requests = requests[0];
  int error = pipe2(messages, O_CLOEXEC) != 0 ? errno : 0;
  if (error == 0)
  {
    this->MemoryKills = CountMemoryKills();
    this->Parent = getpid();
    error = Spawn(program, arguments, requests[1], messages[1], this->Id);
    close(messages[1]);
    this->Pipe = error == 0 ? messages[0] : (close(messages[0]), -1);
  }
  close(requests[1]);
  return error == 0 ? "" : std::string("could not be started: ") + std::strerror(error);
}

bool HelperProcess::Send(char kind, const Bytes& content, const std::function<bool()>& watch)
{
  constexpr int patience = 100; // milliseconds
  Bytes head(HeadSize);
  const std::uint64_t length = content.size();
  head[0] = kind;
  std::memcpy(&head[1], &length, sizeof(length));
  for (const Bytes* part : { static_cast<const Bytes*>(&head), &content })
  {
    for (std::size_t at = 0; at < part->size();)
    {
      const ssize_t count =
        send(this->Requests, part->data() + at, part->size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
      at += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
      if (count >= 0 || errno == EINTR)
      {
        continue;
      }
      if (errno != EAGAIN && errno != EWOULDBLOCK)
      {
        return false;
      }
      struct pollfd waiting = { this->Requests, POLLOUT, 0 };
      const auto start = Clock::now();
      poll(&waiting, 1, patience);
      this->SecondsLeft -= std::chrono::duration<double>(Clock::now() - start).count();
      if (this->SecondsLeft <= 0.0 || !watch())
      {
        this->End.IsTimeOver = this->SecondsLeft <= 0.0;
        this->Kill();
        return false;
      }
    }
  }
  return true;
}

std::string HelperProcess::Fork(const std::function<void(int descriptor)>& work)
{
  void* shared =
    mmap(nullptr, sizeof(*this->OutOfMemory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  this->OutOfMemory = shared != MAP_FAILED ? static_cast<volatile std::sig_atomic_t*>(shared) : nullptr;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    return std::string("no pipe to a child process: ") + std::strerror(errno);
  }
  this->Parent = getpid();
  this->MemoryKills = CountMemoryKills();
  this->Id = fork();
  if (this->Id == 0)
  {
    for (const int number : { SIGINT, SIGTERM, SIGHUP })
    {
      std::signal(number, SIG_DFL);
    }
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int messages = OpenMessages();
    if (messages < 0 || getppid() != this->Parent)
    {
      _exit(1); // the parent has ended already
    }
    sm::OutOfMemory = this->OutOfMemory;
    WatchMemory();
    work(messages);
    // _exit() skips the destructors of static objects in third-party libraries, which might fail.
    _exit(0);
  }
  const int error = errno;
  close(ends[1]);
  this->Pipe = this->Id > 0 ? ends[0] : (close(ends[0]), -1);
  return this->Id > 0 ? "" : std::string("no child process: ") + std::strerror(error);
}

void HelperProcess::Kill()
{
  if (!this->IsKilled)
  {
    kill(this->Id, SIGKILL);
    this->IsKilled = true;
  }
}

void HelperProcess::TakeEnd()
{
  close(std::exchange(this->Pipe, -1));
  rusage used{};
  while (wait4(this->Id, &this->End.Status, 0, &used) < 0 && errno == EINTR)
  {
  }
  const bool wasKilled = this->End.GetSignal() == SIGKILL;
  this->End.PeakMegabytes = static_cast<double>(used.ru_maxrss) / 1024.0;
  this->End.IsOutOfMemory = (this->OutOfMemory && *this->OutOfMemory) ||
    (wasKilled && !this->IsKilled && CountMemoryKills() > this->MemoryKills) ||
    MayHaveMetLimit(this->End.GetSignal(), used);
  if (wasKilled && HasUsedProcessorLimit(used))
  {
    this->End.Status = SIGXCPU;
  }
}

void HelperProcess::TakeMessages()
{
  std::size_t at = 0;
  std::uint64_t size = 0;
  for (; this->Pending.size() - at >= HeadSize; at += HeadSize + size)
  {
    std::memcpy(&size, this->Pending.data() + at + 1, sizeof(size));
    if (size > this->Pending.size() - at - HeadSize)
    {
      break;
    }
    const char kind = this->Pending[at];
    const auto first = this->Pending.begin() + static_cast<std::ptrdiff_t>(at + HeadSize);
    if (size == this->Pending.size() - at - HeadSize)
    {
      // The last message, which may be large, is moved.
      this->Pending.erase(this->Pending.begin(), first);
      this->Take(kind, std::exchange(this->Pending, {}));
      return;
    }
    this->Take(kind, Bytes(first, first + static_cast<std::ptrdiff_t>(size)));
  }
  this->Pending.erase(this->Pending.begin(), this->Pending.begin() + static_cast<std::ptrdiff_t>(at));
}

void HelperProcess::Receive()
{
  std::array<char, 65536> buffer;
  const ssize_t count = read(this->Pipe, buffer.data(), buffer.size());
  if (count > 0)
  {
    this->Pending.insert(this->Pending.end(), buffer.begin(), buffer.begin() + count);
    this->TakeMessages();
  }
  else if (count == 0 || errno != EINTR)
  {
    this->TakeEnd();
  }
}

void HelperProcess::Wait(const std::vector<HelperProcess*>& helpers, double seconds)
{
  std::vector<struct pollfd> waiting;
  for (HelperProcess* helper : helpers)
  {
    if (!helper->IsKilled && helper->SecondsLeft <= 0.0)
    {
      helper->Kill();
      helper->End.IsTimeOver = true;
    }
    seconds = helper->IsKilled ? seconds : std::min(helper->SecondsLeft, seconds);
    waiting.push_back({ helper->Pipe, POLLIN, 0 });
  }
  const auto start = Clock::now();
  const int ready = poll(waiting.data(), waiting.size(), static_cast<int>(std::ceil(1e3 * seconds)));
  const double waited = std::chrono::duration<double>(Clock::now() - start).count();
  for (HelperProcess* helper : helpers)
  {
    helper->SecondsLeft -= waited;
  }
  for (std::size_t i = 0; ready > 0 && i < helpers.size(); ++i)
  {
    if (waiting[i].revents != 0)
    {
      helpers[i]->Receive();
    }
  }
}

std::string FindProgram(const std::string& name)
{
  // The library may be in lib/TRIPLET/ParaView.
  constexpr int levels = 4;
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&FindProgram), &info) == 0 || !info.dli_fname)
  {
    return {};
  }
  std::error_code error;
  std::filesystem::path folder = std::filesystem::canonical(info.dli_fname, error).parent_path();
  for (int i = 0; i < levels && !error && folder.has_relative_path(); ++i)
  {
    const std::string program = folder / "bin" / name;
    if (access(program.c_str(), X_OK) == 0)
    {
      return program;
    }
    folder = folder.parent_path();
  }
  return {};
}

void EndWithInput()
{
  std::thread(
    []()
    {
      struct pollfd input = { STDIN_FILENO, POLLRDHUP, 0 };
      while ((input.revents & (POLLRDHUP | POLLHUP | POLLERR | POLLNVAL)) == 0)
      {
        poll(&input, 1, -1);
      }
      _exit(1);
    })
    .detach();
}

int OpenMessages()
{
  // Not inherited: a program that this process starts would keep the other one waiting for its end.
  const int messages = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  const int null = open("/dev/null", O_WRONLY);
  if (messages >= 0 && null >= 0)
  {
    dup2(null, STDOUT_FILENO);
    close(null);
  }
  return messages;
}

bool ReceiveMessage(int descriptor, char& kind, Bytes& content)
{
  const auto take = [descriptor](void* to, std::size_t size)
  {
    char* bytes = static_cast<char*>(to);
    while (size > 0)
    {
      const ssize_t count = read(descriptor, bytes, size);
      if (count == 0 || (count < 0 && errno != EINTR))
      {
        return false;
      }
      bytes += std::max<ssize_t>(count, 0);
      size -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    return true;
  };
  std::uint64_t length = 0;
  if (!take(&kind, 1) || !take(&length, sizeof(length)))
  {
    return false;
  }
  content.resize(length);
  return take(content.data(), content.size());
}

bool SendMessage(int descriptor, char kind, const void* bytes, std::size_t size)
{
  const std::uint64_t length = size;
  return Send(descriptor, &kind, 1) && Send(descriptor, &length, sizeof(length)) &&
    Send(descriptor, bytes, size);
}
}
