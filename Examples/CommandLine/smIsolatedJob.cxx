#include "smIsolatedJob.h"

#include "smFormat.h"
#include "smIntegralNames.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace
{
namespace names = sm::names;

volatile std::sig_atomic_t Interrupted = 0; ///< the signal

void OnInterrupt(int number)
{
  Interrupted = number;
}

/// Writes one line of JSON. Names in files may be in any encoding; bytes that are not UTF-8 are replaced.
void WriteLine(int descriptor, const sm::Json& message)
{
  const std::string line = sm::Dump(message) + "\n";
  size_t done = 0;
  while (done < line.size())
  {
    const ssize_t count = write(descriptor, line.data() + done, line.size() - done);
    if (count < 0 && errno != EINTR)
    {
      _exit(1); // the parent has closed the pipe
    }
    done += count > 0 ? static_cast<size_t>(count) : 0;
  }
}

// --- out of memory -----------------------------------------------------------------------------

/// In memory that the child shares with this process: what it says when it has no memory for more.
struct Notes
{
  volatile std::sig_atomic_t OutOfMemory;
};
Notes* SharedNotes = nullptr;

void OnNoMemory()
{
  SharedNotes->OutOfMemory = 1;
  throw std::bad_alloc();
}

/// A driver that gets no memory ends the process or uses a null pointer. Then so little of the limit is left that this fails.
void OnFatalSignal(int number)
{
  constexpr size_t little = size_t(64) << 20;
  if (mmap(nullptr, little, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED)
  {
    SharedNotes->OutOfMemory = 1;
  }
  std::signal(number, SIG_DFL);
  raise(number);
}

/// Lets the child say that it has no memory for more. Signal handlers only where its memory is limited (ulimit -v).
void WatchMemory()
{
  if (!SharedNotes)
  {
    return;
  }
  std::set_new_handler(OnNoMemory);
  struct rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    for (const int number : { SIGSEGV, SIGBUS, SIGABRT })
    {
      std::signal(number, OnFatalSignal);
    }
  }
}

[[noreturn]] void RunChild(const sm::JobOptions& options, int descriptor, pid_t parent)
{
  for (const int number : { SIGINT, SIGTERM, SIGHUP })
  {
    std::signal(number, SIG_DFL);
  }
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent)
  {
    _exit(1); // the parent has ended already
  }
  WatchMemory();
  // The standard output is for the results only, so the output of libraries goes to /dev/null.
  const int null = open("/dev/null", O_WRONLY);
  if (null >= 0)
  {
    dup2(null, STDOUT_FILENO);
    close(null);
  }
  sm::RunFileJob(options, [descriptor](const sm::Json& message) { WriteLine(descriptor, message); });
  // Without the destructors of static objects in third-party libraries, which could only fail.
  _exit(0);
}

/// Collects the messages of the child.
struct Listener
{
  const sm::ProgressListener& Progress;
  sm::Json Result;
  bool IsComplete = false; ///< of the result
  sm::Json Textures;
  sm::Json Mesh;
  sm::Json Picture;
  std::string Stage = sm::stages::Start;
  std::string Pending;

  void Take(sm::Json& message)
  {
    if (message.contains("progress"))
    {
      this->Stage = message["progress"][0].get<std::string>();
      this->Progress(this->Stage, message["progress"][1].get<double>());
    }
    else if (message.contains("result"))
    {
      this->Result = std::move(message["result"]);
      this->IsComplete = message["complete"].get<bool>();
    }
    else if (message.contains("textures"))
    {
      this->Textures = message["textures"];
    }
    else if (message.contains("mesh"))
    {
      this->Mesh = message["mesh"];
    }
    else if (message.contains("picture"))
    {
      this->Picture = message["picture"];
    }
  }

  void Append(const char* bytes, size_t count)
  {
    this->Pending.append(bytes, count);
    size_t begin = 0;
    for (size_t end = this->Pending.find('\n'); end != std::string::npos;
         end = this->Pending.find('\n', begin))
    {
      sm::Json message = sm::Json::parse(this->Pending.begin() + static_cast<long>(begin),
        this->Pending.begin() + static_cast<long>(end), nullptr, false);
      if (message.is_object())
      {
        this->Take(message);
      }
      begin = end + 1;
    }
    this->Pending.erase(0, begin);
  }
};

using Clock = std::chrono::steady_clock;

/// The end of a job that does not end by itself. What computes ends at the limit; a reader or a compiler that hangs does not.
Clock::time_point GetDeadline(const sm::JobOptions& options)
{
  if (!(options.MaximumSeconds > 0.0) || options.MaximumSeconds > 1e8)
  {
    return Clock::time_point::max();
  }
  const double seconds = options.MaximumSeconds + std::max(2.0, 0.25 * options.MaximumSeconds);
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Listens until the child closes the pipe. Returns true when it took too long and was killed; what it had sent is taken all the same.
bool Listen(int descriptor, pid_t child, Clock::time_point deadline, Listener& listener)
{
  char buffer[65536];
  bool isKilled = false;
  bool isTimeOver = false;
  for (;;)
  {
    // A signal that comes just before poll() is seen a second later.
    struct pollfd waiting = { descriptor, POLLIN, 0 };
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    const int ready =
      poll(&waiting, 1, isKilled ? -1 : static_cast<int>(std::clamp<long long>(left, 0, 1000)));
    if (!isKilled && (Interrupted || Clock::now() >= deadline))
    {
      kill(child, SIGKILL);
      isKilled = true;
      isTimeOver = !Interrupted;
      continue;
    }
    if (ready > 0)
    {
      const ssize_t count = read(descriptor, buffer, sizeof(buffer));
      if (count == 0 || (count < 0 && errno != EINTR))
      {
        return isTimeOver;
      }
      listener.Append(buffer, count > 0 ? static_cast<size_t>(count) : 0);
    }
  }
}

bool IsOverProcessorLimit(int status)
{
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
}

/// How a child ended, with its process as the subject; empty if it ended normally.
std::string DescribeEnd(int status, bool isTimeOver, bool isOutOfMemory, const sm::JobOptions& options)
{
  if (isTimeOver)
  {
    return "took longer than the " + sm::FormatDigits(options.MaximumSeconds, 6) +
      " s of --max-seconds and was ended";
  }
  std::string end;
  if (IsOverProcessorLimit(status))
  {
    end = "used all the processor time that the system allows it (ulimit -t) and was ended";
  }
  else if (WIFSIGNALED(status))
  {
    const int number = WTERMSIG(status);
    end = "ended by signal " + std::to_string(number) + " (" + strsignal(number) +
      (number == SIGKILL ? ", as the system does when memory runs out)" : ")");
  }
  else if (WIFEXITED(status) && WEXITSTATUS(status) != 0)
  {
    end = "ended with exit status " + std::to_string(WEXITSTATUS(status));
  }
  return !end.empty() && isOutOfMemory ? "ran out of memory and " + end : end;
}

/// A child process and the pipe that its messages come through.
struct Child
{
  pid_t Process = -1;
  int Pipe = -1;
  std::string Error; ///< why there is no child; empty: there is one
};

Child StartChild(const sm::JobOptions& options)
{
  struct stat info = {};
  if (stat(options.FileName.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
  {
    // Reading a pipe or a device may never end.
    return { -1, -1, "Cannot read " + options.FileName + ": not a regular file." };
  }
  int ends[2];
  if (pipe(ends) != 0)
  {
    return { -1, -1, std::string("no pipe to a child process: ") + std::strerror(errno) };
  }
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0)
  {
    close(ends[0]);
    RunChild(options, ends[1], parent);
  }
  const int error = errno;
  close(ends[1]);
  if (process < 0)
  {
    close(ends[0]);
    return { -1, -1, std::string("no child process: ") + std::strerror(error) };
  }
  return { process, ends[0], {} };
}

/// Adds to the results that a child sent before it failed why there are no more; `isExplained` is true when `end` is the whole reason.
void AddFailure(const sm::JobOptions& options, const Listener& listener, const std::string& end,
  bool isExplained, sm::Json& file)
{
  std::string reason = "the process that worked on this file " +
    (end.empty() ? "ended without a result" : end) + " in stage \"" + listener.Stage + "\"";
  if (file.is_null())
  {
    const bool isReading = listener.Stage == sm::stages::Read;
    file = sm::UnreadableFile(options.FileName,
      reason + (isReading && !isExplained ? "; the file is malformed or the CAD kernel cannot read it" : ""));
    file["status"] = isExplained ? names::StatusNotComputed : names::StatusUnreadable;
    return;
  }
  if (!isExplained)
  {
    reason += "; this is a defect of this program or of the OpenGL driver, and none of the file";
  }
  const bool isComputed = file["status"] != names::StatusNotComputed;
  sm::MarkIncomplete(file, reason + (isComputed ? "; what was computed before is kept" : ""));
}

/// Makes the notes that a child shares, or clears those of the child before.
void ResetNotes()
{
  if (!SharedNotes)
  {
    void* shared = mmap(nullptr, sizeof(Notes), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    SharedNotes = shared != MAP_FAILED ? static_cast<Notes*>(shared) : nullptr;
  }
  if (SharedNotes)
  {
    SharedNotes->OutOfMemory = 0;
  }
}

/// Adds the reasons why pictures and meshes are missing that were asked for. `end` is that of DescribeEnd().
void FindOutputErrors(
  const sm::JobOptions& options, const Listener& listener, const std::string& end, sm::JobOutcome& outcome)
{
  // The status already tells why an unreadable or empty file has no pictures.
  const sm::Json& status = outcome.File["status"];
  if (!options.TexturePrefix.empty() && status != "unreadable")
  {
    outcome.TextureError = listener.Textures.is_string() ? listener.Textures.get<std::string>()
                                                         : "the process ended before they were written";
  }
  const bool isRead = status != "unreadable" && status != "empty";
  const auto explain = [&end](const sm::Json& said, const std::string& process)
  {
    return said.is_string() ? said.get<std::string>()
      : end.empty()         ? process + " ended without one"
                            : process + " " + end;
  };
  if (!options.MeshName.empty() && isRead)
  {
    outcome.MeshError = explain(listener.Mesh, "the process that made it");
  }
  if (!options.PictureName.empty() && isRead)
  {
    outcome.PictureError = explain(listener.Picture, "the process that drew it");
  }
}
}

namespace sm
{
JobOutcome RunIsolatedJob(const JobOptions& options, const ProgressListener& progress)
{
  const Clock::time_point deadline = GetDeadline(options);
  ResetNotes();
  const Child child = StartChild(options);
  if (!child.Error.empty())
  {
    return { UnreadableFile(options.FileName, child.Error), {}, {}, {} };
  }
  Listener listener{ progress, nullptr, false, nullptr, nullptr, nullptr, stages::Start, {} };
  const bool isTimeOver = Listen(child.Pipe, child.Process, deadline, listener);
  close(child.Pipe);
  int status = 0;
  while (waitpid(child.Process, &status, 0) < 0 && errno == EINTR)
  {
  }

  JobOutcome outcome;
  outcome.File = std::move(listener.Result);
  if (outcome.File.is_object())
  {
    // The pipe carries UTF-8 only; the table and the CSV show the name with its own bytes.
    outcome.File["file"] = options.FileName;
  }
  if (Interrupted)
  {
    // Results that are not complete are those of no finished file.
    return listener.IsComplete ? outcome : JobOutcome();
  }
  const bool isOutOfMemory = SharedNotes && SharedNotes->OutOfMemory;
  const std::string end = DescribeEnd(status, isTimeOver, isOutOfMemory, options);
  if (!listener.IsComplete)
  {
    AddFailure(
      options, listener, end, isTimeOver || isOutOfMemory || IsOverProcessorLimit(status), outcome.File);
  }
  else if (!end.empty() && !isTimeOver)
  {
    outcome.File["messages"].push_back("the process that worked on this file " + end + " in stage \"" +
      listener.Stage + "\", after it had sent the result");
  }
  FindOutputErrors(options, listener, end, outcome);
  return outcome;
}

void CatchInterrupt()
{
  struct sigaction action = {};
  action.sa_handler = OnInterrupt; // without SA_RESTART: a blocked read must return
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  // nohup ignores it for this program.
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
  {
    sigaction(SIGHUP, &action, nullptr);
  }
}

bool IsInterrupted()
{
  return Interrupted != 0;
}

void EndByInterrupt()
{
  const int number = Interrupted;
  std::signal(number, SIG_DFL);
  raise(number);
  _exit(128 + number);
}
}
