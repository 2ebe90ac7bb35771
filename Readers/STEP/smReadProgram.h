/**
 * @file smReadProgram.h
 * @brief Reading in a separate process: the program solidmoments-read, and the messages that it sends
 */
#ifndef smReadProgram_h
#define smReadProgram_h

#include "smBytes.h"
#include "smProgressCallback.h"

#include <string>
#include <vector>

namespace sm
{
/// Kinds of the messages of solidmoments-read: the fraction of the work that is done, a double; the output; a
/// repair begins, or has ended.
constexpr char ReadProgress = 'p';
constexpr char ReadResult = 'r';
constexpr char RepairBegins = 'b';
constexpr char RepairEnds = 'e';

/// Returns the path of solidmoments-read, which is in the folder bin next to that of the library or next to a
/// folder above it; empty if it is not there.
std::string FindReadProgram();

/// How the program ended.
struct ReadProgramOutcome
{
  /// The output of the reader.
  Bytes Result;
  /// The reason why there is no result, a sentence about the process; empty if there is one, or if it was
  /// stopped.
  std::string Problem;
  bool IsStopped = false;
  /// True if the program has sent a message: a failure is then not that of starting it.
  bool IsStarted = false;
  /// True if it ended while OpenCASCADE repaired a body.
  bool IsRepairing = false;
};

/**
 * Runs the program, with `input`, where there is one, as its standard input, and waits until it ends.
 * `progress` gets the fractions that it sends, and the last one repeatedly as long as none arrives. If it
 * returns false, or an exception is thrown, the program is killed. Throws std::bad_alloc.
 */
ReadProgramOutcome RunReadProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::string* input, const ProgressCallback& progress);
}

#endif
