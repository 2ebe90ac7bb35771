#include "smIsolatedJob.h"

#include "smByteFields.h"
#include "smFormat.h"
#include "smIntegralNames.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <limits>
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

/// Head of a message in the pipe: its kind, and the number of bytes that follow.
constexpr std::size_t HeadSize = 1 + sizeof(std::uint64_t);

/// Visits what a message of the kind `result` holds.
void VisitResult(sm::Fields& fields, sm::FileResult& file, bool& isComplete)
{
  isComplete = fields.Has(isComplete);
  file.Visit(fields);
  if (fields.Has(file.Shapes.has_value()))
  {
    file.Shapes = file.Shapes.value_or(sm::ProductShapes());
    file.Shapes->Visit(fields);
  }
}

std::string EncodeMessage(const sm::JobMessage& message)
{
  sm::ByteWriter writer;
  if (message.Kind == sm::JobMessage::Result)
  {
    bool isComplete = message.IsComplete;
    // A writer changes nothing.
    VisitResult(writer, const_cast<sm::FileResult&>(*message.File), isComplete);
  }
  else
  {
    std::string text = message.Text;
    double fraction = message.Fraction;
    writer.sm::Fields::Text(nullptr, text);
    writer.Number(nullptr, fraction);
  }
  const std::uint64_t size = writer.Get().size();
  return std::string(1, message.Kind) + std::string(reinterpret_cast<const char*>(&size), sizeof(size)) +
    writer.Get();
}

void WriteMessage(int descriptor, const sm::JobMessage& message)
{
  const std::string bytes = EncodeMessage(message);
  size_t done = 0;
  while (done < bytes.size())
  {
    const ssize_t count = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR)
    {
      _exit(1); // the parent has closed the pipe
    }
    done += count > 0 ? static_cast<size_t>(count) : 0;
  }
}

/// Set to 1 when a child has no memory left; shared with the process that started it.
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
  constexpr size_t little = size_t(64) << 20;
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
  struct rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    for (const int number : { SIGSEGV, SIGBUS, SIGABRT })
    {
      std::signal(number, OnFatalSignal);
    }
  }
}

/// How many processes of this machine the system has ended for want of memory; -1 where it does not report
/// it.
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
  // The standard output is reserved for the results, so the output of libraries is sent to /dev/null.
  const int null = open("/dev/null", O_WRONLY);
  if (null >= 0)
  {
    dup2(null, STDOUT_FILENO);
    close(null);
  }
  if (options.Threads > 0)
  {
    vtkSMPTools::Initialize(options.Threads);
    // Mesa's software rasterizer has threads of its own.
    setenv("LP_NUM_THREADS", std::to_string(options.Threads).c_str(), 0);
  }
  sm::RunFileJob(options, [descriptor](const sm::JobMessage& message) { WriteMessage(descriptor, message); });
  // _exit() skips the destructors of static objects in third-party libraries, which might fail.
  _exit(0);
}

using Clock = std::chrono::steady_clock;

/// Returns the seconds after which a job is killed. Computations stop at the time limit by themselves; a
/// hanging reader or compiler does not.
double GetSecondsLeft(const sm::JobOptions& options)
{
  return options.MaximumSeconds > 0.0 ? options.MaximumSeconds + std::max(2.0, 0.25 * options.MaximumSeconds)
                                      : std::numeric_limits<double>::infinity();
}

/// No process does this to itself.
bool WasKilled(int status)
{
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
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

bool IsOverProcessorLimit(int status)
{
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
}

/// Returns a sentence about the process of a child and how it ended; empty if it ended normally.
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
      (number == SIGKILL && !isOutOfMemory ? ", from outside, as the system does when memory runs out)"
                                           : ")");
  }
  else if (WIFEXITED(status) && WEXITSTATUS(status) != 0)
  {
    end = "ended with exit status " + std::to_string(WEXITSTATUS(status));
  }
  return !end.empty() && isOutOfMemory ? "ran out of memory and " + end : end;
}

/// Adds the reason for missing results to those that a child sent before it failed; `isExplained` is true if
/// `end` is the whole reason.
void AddFailure(const sm::JobOptions& options, const std::string& stage, const std::string& end,
  bool isExplained, std::optional<sm::FileResult>& file)
{
  std::string reason = "the process that worked on this file " +
    (end.empty() ? "ended without a result" : end) + " in stage \"" + stage + "\"";
  if (!file)
  {
    const bool isReading = stage == sm::stages::Read;
    file = sm::UnreadableFile(options,
      reason + (isReading && !isExplained ? "; the file is malformed or the CAD kernel cannot read it" : ""));
    file->Status = isExplained ? names::StatusNotComputed : names::StatusUnreadable;
    return;
  }
  if (!isExplained)
  {
    reason += "; this is a defect of this program or of the OpenGL driver, and none of the file";
  }
  const bool isComputed = file->Status != names::StatusNotComputed;
  sm::MarkIncomplete(*file, reason + (isComputed ? "; what was computed before is kept" : ""));
}

/// Adds the reasons why requested pictures and meshes are missing. `end`: result of DescribeEnd().
void FindOutputErrors(
  const sm::JobOptions& options, const sm::JobMessages& said, const std::string& end, sm::JobOutcome& outcome)
{
  // The status already explains why an unreadable or empty file has no pictures.
  const std::string& status = outcome.File->Status;
  if (!options.TexturePrefix.empty() && status != "unreadable")
  {
    outcome.TextureError = said.Textures.value_or("the process ended before they were written");
  }
  const bool isRead = status != "unreadable" && status != "empty";
  const auto explain = [&end](const std::optional<std::string>& reason, const std::string& process)
  { return reason.value_or(process + " " + (end.empty() ? "ended without one" : end)); };
  if (!options.MeshName.empty() && isRead)
  {
    outcome.MeshError = explain(said.Mesh, "the process that made it");
  }
  if (!options.PictureName.empty() && isRead)
  {
    outcome.PictureError = explain(said.Picture, "the process that drew it");
  }
}
}

namespace sm
{
void JobMessages::Take(
  JobMessage::Kinds kind, std::string bytes, const JobOptions& options, const ProgressListener& progress)
{
  ByteReader reader(std::move(bytes));
  if (kind == JobMessage::Result)
  {
    FileResult file(options);
    bool isComplete = false;
    VisitResult(reader, file, isComplete);
    if (reader.IsWhole())
    {
      this->Result = std::move(file);
      this->IsComplete = isComplete;
    }
    return;
  }
  std::string text;
  double fraction = 0.0;
  reader.Fields::Text(nullptr, text);
  reader.Number(nullptr, fraction);
  if (!reader.IsWhole())
  {
    return;
  }
  if (kind == JobMessage::Progress)
  {
    this->Stage = text;
    progress(text, fraction);
  }
  else
  {
    (kind == JobMessage::Textures  ? this->Textures
        : kind == JobMessage::Mesh ? this->Mesh
                                   : this->Picture) = text;
  }
}

IsolatedJob::IsolatedJob(const JobOptions& options, ProgressListener progress)
  : Options(options)
  , Progress(std::move(progress))
  , SecondsLeft(GetSecondsLeft(options))
{
  this->Said.Stage = stages::Start;
  struct stat info = {};
  if (stat(options.FileName.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
  {
    // Reading a pipe or a device may never end.
    this->Error = "Cannot read " + options.FileName + ": not a regular file.";
    return;
  }
  void* shared =
    mmap(nullptr, sizeof(*this->OutOfMemory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  this->OutOfMemory = shared != MAP_FAILED ? static_cast<volatile std::sig_atomic_t*>(shared) : nullptr;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    this->Error = std::string("no pipe to a child process: ") + std::strerror(errno);
    return;
  }
  const pid_t parent = getpid();
  this->MemoryKills = CountMemoryKills();
  this->Process = fork();
  if (this->Process == 0)
  {
    close(ends[0]);
    ::OutOfMemory = this->OutOfMemory;
    RunChild(options, ends[1], parent);
  }
  const int error = errno;
  close(ends[1]);
  this->Pipe = ends[0];
  if (this->Process < 0)
  {
    this->Error = std::string("no child process: ") + std::strerror(error);
    close(this->Pipe);
    this->Pipe = -1;
  }
}

IsolatedJob::~IsolatedJob()
{
  if (this->IsRunning())
  {
    kill(this->Process, SIGKILL);
    this->End();
  }
  if (this->OutOfMemory)
  {
    munmap(const_cast<std::sig_atomic_t*>(this->OutOfMemory), sizeof(*this->OutOfMemory));
  }
}

void IsolatedJob::End()
{
  close(this->Pipe);
  this->Pipe = -1;
  rusage used{};
  while (wait4(this->Process, &this->ExitStatus, 0, &used) < 0 && errno == EINTR)
  {
  }
  if (WasKilled(this->ExitStatus) && HasUsedProcessorLimit(used))
  {
    this->ExitStatus = SIGXCPU;
  }
}

void IsolatedJob::Append(const char* bytes, std::size_t count)
{
  this->Pending.append(bytes, count);
  std::size_t begin = 0;
  while (this->Pending.size() - begin >= HeadSize)
  {
    std::uint64_t size = 0;
    std::memcpy(&size, this->Pending.data() + begin + 1, sizeof(size));
    if (size > this->Pending.size() - begin - HeadSize)
    {
      break;
    }
    this->Said.Take(static_cast<JobMessage::Kinds>(this->Pending[begin]),
      this->Pending.substr(begin + HeadSize, static_cast<std::size_t>(size)), this->Options, this->Progress);
    begin += HeadSize + static_cast<std::size_t>(size);
  }
  this->Pending.erase(0, begin);
}

void IsolatedJob::Wait(const std::vector<IsolatedJob*>& jobs)
{
  // A signal that arrives just before poll() is noticed a second later.
  double seconds = 1.0;
  std::vector<struct pollfd> waiting;
  for (IsolatedJob* job : jobs)
  {
    if (!job->IsKilled && (Interrupted || job->SecondsLeft <= 0.0))
    {
      kill(job->Process, SIGKILL);
      job->IsKilled = true;
      job->IsTimeOver = !Interrupted;
    }
    seconds = job->IsKilled ? seconds : std::min(job->SecondsLeft, seconds);
    waiting.push_back({ job->Pipe, POLLIN, 0 });
  }
  const auto start = Clock::now();
  const int ready = poll(waiting.data(), waiting.size(), static_cast<int>(std::ceil(1e3 * seconds)));
  const double waited = std::chrono::duration<double>(Clock::now() - start).count();
  for (IsolatedJob* job : jobs)
  {
    job->SecondsLeft -= waited;
  }
  if (ready <= 0)
  {
    return;
  }
  char buffer[65536];
  for (std::size_t i = 0; i < jobs.size(); ++i)
  {
    if (waiting[i].revents == 0)
    {
      continue;
    }
    const ssize_t count = read(jobs[i]->Pipe, buffer, sizeof(buffer));
    if (count > 0)
    {
      jobs[i]->Append(buffer, static_cast<std::size_t>(count));
    }
    else if (count == 0 || errno != EINTR)
    {
      jobs[i]->End();
    }
  }
}

JobOutcome IsolatedJob::GetOutcome()
{
  JobOutcome outcome;
  if (!this->Error.empty())
  {
    outcome.File = UnreadableFile(this->Options, this->Error);
    return outcome;
  }
  outcome.File = std::move(this->Said.Result);
  if (outcome.File)
  {
    // The pipe carries UTF-8 only; the table and the CSV show the name with its own bytes.
    outcome.File->File = this->Options.FileName;
  }
  if (Interrupted)
  {
    // After an interrupt only complete results count as those of a finished file.
    return this->Said.IsComplete ? outcome : JobOutcome();
  }
  const bool isOutOfMemory = (this->OutOfMemory && *this->OutOfMemory) ||
    (WasKilled(this->ExitStatus) && CountMemoryKills() > this->MemoryKills && !this->IsTimeOver);
  const std::string end = DescribeEnd(this->ExitStatus, this->IsTimeOver, isOutOfMemory, this->Options);
  if (!this->Said.IsComplete)
  {
    AddFailure(this->Options, this->Said.Stage, end,
      this->IsTimeOver || isOutOfMemory || WasKilled(this->ExitStatus) ||
        IsOverProcessorLimit(this->ExitStatus),
      outcome.File);
  }
  else if (!end.empty() && !this->IsTimeOver)
  {
    outcome.File->Messages.push_back("the process that worked on this file " + end + " in stage \"" +
      this->Said.Stage + "\", after it had sent the result");
  }
  FindOutputErrors(this->Options, this->Said, end, outcome);
  return outcome;
}

void CatchInterrupt()
{
  struct sigaction action = {};
  action.sa_handler = OnInterrupt; // without SA_RESTART: a blocked read must return
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  // If nohup has set SIGHUP to be ignored, it stays ignored.
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
