/**
 * @file smReadProgram.h
 * @brief Reading in a process of its own: the program solidmoments-read, and the messages that it sends
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
/// Path of solidmoments-read, which is in the folder bin beside the library or beside a folder above it; empty if it is not there.
std::string FindReadProgram();

/// How the program ended.
struct ReadProgramOutcome
{
  /// The bytes that it sent by SendResult().
  Bytes Result;
  /// Why there is no result, with the process as the subject; empty if there is one, or if it was stopped.
  std::string Problem;
  bool IsStopped = false;
  /// It has sent a message, or could not be given its input: what failed is not its start.
  bool IsStarted = false;
};

/**
 * Runs the program, with `input`, where there is one, as its standard input, and waits until it ends. It sends its messages to the file descriptor that is its standard output; its other output
 * is dropped. `progress` gets the fractions that it sends by SendProgress(), again and again while none comes; once it answers false,
 * the program is killed. So it is when an exception leaves. Throws std::bad_alloc.
 */
ReadProgramOutcome RunReadProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::string* input, const ProgressCallback& progress);

/// For the program: gives the standard output to messages alone, so that what libraries print is dropped, and ends the process with
/// the one that started it. Returns the file descriptor for the messages, -1 if there is none.
SMREADERSSTEP_EXPORT int OpenMessages();
/// Sends a message; false if nobody listens any more.
SMREADERSSTEP_EXPORT bool SendProgress(int descriptor, double fraction);
SMREADERSSTEP_EXPORT bool SendResult(int descriptor, const Bytes& result);
}

#endif
