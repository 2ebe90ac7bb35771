/**
 * @file smReadProgram.h
 * @brief Reading in a separate process: the program solidmoments-read, and the messages that it sends
 */
#ifndef smReadProgram_h
#define smReadProgram_h

#include "smBytes.h"
#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"

#include <string>
#include <vector>

namespace sm
{
/// Returns the path of solidmoments-read, which is in the folder bin next to that of the library or next to a
/// folder above it; empty if it is not there.
std::string FindReadProgram();

/// How the program ended.
struct ReadProgramOutcome
{
  /// The bytes that it sent by SendResult().
  Bytes Result;
  /// The reason why there is no result, a sentence about the process; empty if there is one, or if it was
  /// stopped.
  std::string Problem;
  bool IsStopped = false;
  /// True if the program has sent a message, or if its input could not be written: a failure is then not that
  /// of starting it.
  bool IsStarted = false;
};

/**
 * Runs the program, with `input`, where there is one, as its standard input, and waits until it ends. It
 * sends its messages to the file descriptor that is its standard output; its other output is discarded.
 * `progress` gets the fractions that it sends by SendProgress(), and the last one repeatedly as long as none
 * arrives. If it returns false, or an exception is thrown, the program is killed. Throws std::bad_alloc.
 */
ReadProgramOutcome RunReadProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::string* input, const ProgressCallback& progress);

/// For the program: reserves the standard output for messages, so that output of libraries is discarded, and
/// lets the process end with the one that started it. Returns the file descriptor for the messages, -1 if
/// there is none.
SMREADERSSTEP_EXPORT int OpenMessages();
/// Sends a message; returns false if the other process has ended.
SMREADERSSTEP_EXPORT bool SendProgress(int descriptor, double fraction);
SMREADERSSTEP_EXPORT bool SendResult(int descriptor, const Bytes& result);
}

#endif
