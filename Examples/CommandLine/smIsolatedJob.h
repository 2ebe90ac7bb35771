/**
 * @file smIsolatedJob.h
 * @brief One file in a process of its own, so that a file that crashes a CAD kernel costs nothing but itself
 *
 * The child is forked while this process has neither threads nor an OpenGL context; results come back as lines of
 * JSON through a pipe. No signal handler is installed in the child.
 */
#ifndef smIsolatedJob_h
#define smIsolatedJob_h

#include "smFileJob.h"

namespace sm
{
struct JobOutcome
{
  Json File;                ///< entry of "files"; null when interrupted before there was one
  std::string TextureError; ///< why trim textures that were asked for are not all there
  std::string PictureError; ///< why the picture asked for is not there; empty: it is, or none was asked for
};

using ProgressListener = std::function<void(const std::string& stage, double fraction)>;

/// Runs the job in a child and waits for it. Call from a process with one thread.
JobOutcome RunIsolatedJob(const JobOptions& options, const ProgressListener& progress);

/// From now on Ctrl-C and SIGTERM end the job that runs and are remembered, instead of ending this process at once.
void CatchInterrupt();
bool IsInterrupted();
/// Ends this process by the signal that was caught, as a shell expects it.
[[noreturn]] void EndByInterrupt();
}

#endif
