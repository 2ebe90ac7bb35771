/**
 * @file smIsolatedJob.h
 * @brief Runs the jobs of files in child processes, so that a crash of the CAD kernel affects only the job of
 * that file
 *
 * Children are forked while this process has neither threads nor an OpenGL context; results come back through
 * a pipe, as smByteFields.h writes them. Signal handlers are installed in the child only if its memory is
 * limited (ulimit -v), to report that it ran out.
 */
#ifndef smIsolatedJob_h
#define smIsolatedJob_h

#include "smFileJob.h"
#include "smResults.h"

#include <csignal>
#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace sm
{
struct JobOutcome
{
  std::optional<FileResult> File; ///< none when interrupted before there was one
  std::string TextureError;       ///< why a requested trim texture is missing; empty: none is
  std::string
    MeshError; ///< why the requested triangles are missing; empty: they are not, or none were requested
  std::string PictureError; ///< why the requested picture is missing; empty: it is not, or none was requested
};

using ProgressListener = std::function<void(const std::string& stage, double fraction)>;

/// The messages of a child.
struct JobMessages
{
  std::optional<FileResult> Result;
  bool IsComplete = false; ///< of the result
  /// Why an output was not written, empty if it was; none: not reported.
  std::optional<std::string> Textures, Mesh, Picture;
  std::string Stage;

  /// Takes a message as WriteMessage() wrote it, without its head; one that is damaged is ignored.
  void Take(
    JobMessage::Kinds kind, std::string bytes, const JobOptions& options, const ProgressListener& progress);
};

/// The job of one file in a child process. A child is killed if it takes longer than 1.25 times
/// MaximumSeconds, and at least 2 seconds longer.
class IsolatedJob
{
public:
  /// Starts the child. Call from a process with one thread.
  IsolatedJob(const JobOptions& options, ProgressListener progress);
  /// Kills the child if it still runs.
  ~IsolatedJob();
  IsolatedJob(const IsolatedJob&) = delete;
  IsolatedJob& operator=(const IsolatedJob&) = delete;

  bool IsRunning() const { return this->Pipe >= 0; }
  /// Waits at most one second until one of the jobs, all of which must be running, sends a message or ends.
  /// Kills those whose time has elapsed, and all of them after an interrupt.
  static void Wait(const std::vector<IsolatedJob*>& jobs);
  /// Returns the outcome of a job that has ended; call it once.
  JobOutcome GetOutcome();

private:
  void Append(const char* bytes, std::size_t count);
  void End();

  JobOptions Options;
  ProgressListener Progress;
  double
    SecondsLeft; ///< of waiting for the child; other time does not count, because a full pipe stops the child
  JobMessages Said;
  std::string Pending;
  std::string Error; ///< why there is no child; empty: there is one
  pid_t Process = -1;
  int Pipe = -1; ///< of its messages; -1: it has ended
  int ExitStatus = 0;
  bool IsKilled = false;
  bool IsTimeOver = false;
  volatile std::sig_atomic_t* OutOfMemory = nullptr; ///< shared with the child, which sets it
  long MemoryKills = 0;                              ///< of the system, before the child
};

/// Makes Ctrl-C, SIGTERM and, unless it is ignored (nohup), SIGHUP end the running job and set
/// IsInterrupted(), instead of ending this process at once.
void CatchInterrupt();
bool IsInterrupted();
/// Ends this process by the signal that was caught, so that the shell sees that signal.
[[noreturn]] void EndByInterrupt();
}

#endif
