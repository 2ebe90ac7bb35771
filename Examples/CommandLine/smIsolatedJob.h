/**
 * @file smIsolatedJob.h
 * @brief Runs the job of one file in a child process, so that a crash of the CAD kernel ends that file's job only
 *
 * The child is forked while this process has neither threads nor an OpenGL context; results come back as lines of
 * JSON through a pipe. Signal handlers are installed in the child only where its memory is limited (ulimit -v), to say that it ran out.
 */
#ifndef smIsolatedJob_h
#define smIsolatedJob_h

#include "smFileJob.h"

namespace sm
{
struct JobOutcome
{
  Json File;                ///< entry of "files"; null when interrupted before there was one
  std::string TextureError; ///< why a requested trim texture is missing; empty: none is
  std::string
    MeshError; ///< why the requested triangles are missing; empty: they are not, or none were requested
  std::string PictureError; ///< why the requested picture is missing; empty: it is not, or none was requested
};

using ProgressListener = std::function<void(const std::string& stage, double fraction)>;

/// Runs the job in a child and waits for it; a child that takes longer than MaximumSeconds and a quarter, at least 2 seconds, more is
/// killed. Call from a process with one thread.
JobOutcome RunIsolatedJob(const JobOptions& options, const ProgressListener& progress);

/// Makes Ctrl-C, SIGTERM and, unless it is ignored (nohup), SIGHUP end the running job and set IsInterrupted(), instead of ending this process at once.
void CatchInterrupt();
bool IsInterrupted();
/// Ends this process by the signal that was caught, so that the shell sees that signal.
[[noreturn]] void EndByInterrupt();
}

#endif
