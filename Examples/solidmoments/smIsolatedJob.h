/**
 * @file smIsolatedJob.h
 * @brief Runs the jobs of files in child processes, so that a crash of the CAD kernel affects only the job of
 * that file; small files share a child
 *
 * Children are forked (smHelperProcess.h) while this process has neither threads nor an OpenGL context;
 * results come back as smByteFields.h writes them.
 */
#ifndef smIsolatedJob_h
#define smIsolatedJob_h

#include "smFileJob.h"
#include "smHelperProcess.h"
#include "smResults.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
struct JobOutcome
{
  std::optional<FileResult> File; ///< none when interrupted before there was one
  /// Why requested outputs except the picture are missing, each with its name.
  std::vector<std::string> OutputErrors;
  std::string PictureError; ///< why the requested picture is missing; empty: it is not, or none was requested
};

using ProgressListener = std::function<void(const std::string& stage, double fraction)>;

/// The messages of a child.
struct JobMessages
{
  std::optional<FileResult> Result;
  bool IsComplete = false; ///< of the result
  /// Why an output was not written, empty if it was; none: not reported.
  std::optional<std::string> Textures, Mesh, Validation, Robot, Picture;
  /// The same of analyses, by their keys.
  std::map<std::string, std::string> Analyses;
  std::string Stage;

  /// Takes a message as WriteMessage() wrote it, without its head; one that is damaged is ignored.
  void Take(JobMessage::Kinds kind, Bytes bytes, const JobOptions& options, const ProgressListener& progress);
};

/// A job and the listener to its progress.
struct ListenedJob
{
  JobOptions Options;
  ProgressListener Progress;
};

/// A child process that works on the jobs of some files, one after the other, and ends early, before the next
/// one, after a file that is not `ok` or that another backend than the CPU worked on: what such a file may
/// have left behind does not reach another one. A child is killed if it takes longer than
/// 1.25 times MaximumSeconds, and at least 2 seconds longer.
class JobProcess
{
public:
  /// Starts the child. Call from a process with one thread. Jobs with MaximumSeconds have a process of their
  /// own.
  explicit JobProcess(std::vector<ListenedJob> jobs);
  JobProcess(const JobProcess&) = delete;
  JobProcess& operator=(const JobProcess&) = delete;

  bool IsRunning() const { return this->Helper.IsRunning(); }
  /// Waits at most one second until one of the processes, all of which must be running, sends a message or
  /// ends. Kills those whose time has elapsed, and all of them after an interrupt.
  static void Wait(const std::vector<JobProcess*>& processes);

private:
  friend class IsolatedJob;
  void Run(int descriptor);
  void Take(char kind, Bytes content);

  std::vector<ListenedJob> Jobs;
  std::vector<JobMessages> Said; ///< of each job
  std::size_t Current = 0;       ///< the job that the child works on
  std::string Error;             ///< why there is no child; empty: there is one
  HelperProcess Helper;
};

/// One job of a process.
class IsolatedJob
{
public:
  IsolatedJob(std::shared_ptr<JobProcess> process, std::size_t index)
    : Process(std::move(process))
    , Index(index)
  {
  }

  JobProcess& GetProcess() const { return *this->Process; }
  /// Returns true until the child has finished the job or ended.
  bool IsRunning() const { return this->Process->IsRunning() && this->Process->Current <= this->Index; }
  /// Returns true if the child has ended before it began with the job.
  bool IsLeftOver() const;
  /// Returns true if the child has ended within the job, after it had worked on others, of which it may have
  /// had the damage: the job is to be repeated in a process of its own.
  bool IsInDoubt() const;
  /// Returns the outcome of a job that has ended; call it once.
  JobOutcome GetOutcome();

private:
  /// How the child ended, as far as this job is concerned.
  ProcessEnd GetEnd() const;

  std::shared_ptr<JobProcess> Process;
  std::size_t Index;
};

/// Makes Ctrl-C, SIGTERM and, unless it is ignored (nohup), SIGHUP end the running job and set
/// IsInterrupted(), instead of ending this process at once.
void CatchInterrupt();
bool IsInterrupted();
/// Ends this process by the signal that was caught, so that the shell sees that signal.
[[noreturn]] void EndByInterrupt();
}

#endif
