/**
 * @file smKernelProcess.h
 * @brief Requests to solidmoments-kernel (smKernelMessages.h)
 */
#ifndef smKernelProcess_h
#define smKernelProcess_h

#include "smBytes.h"
#include "smProgressCallback.h"

#include <functional>
#include <string>

namespace sm
{
struct KernelAnswer
{
  /// The message `Result`.
  Bytes Result;
  /// A sentence about the process why there is none: "its process ended by signal 11 (Segmentation fault)";
  /// empty if there is one, or if it was stopped.
  std::string Problem;
  bool IsStopped = false;
  /// True if the process ended by an error of its own.
  bool IsCrash = false;
};

/// Sends a request and waits for its answer. `progress` gets the fraction of the work that is done about ten
/// times a second, and returns false to stop. `take`, which may be empty, gets the bytes of `Content`, and
/// returns false to stop. Throws std::bad_alloc, also if the program has no memory left.
KernelAnswer AskKernel(char kind, const Bytes& request, const ProgressCallback& progress,
  const std::function<bool(const Bytes&)>& take = {});
}

#endif
