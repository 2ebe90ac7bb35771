/**
 * @file smArguments.h
 * @brief The arguments of the command line, checked
 */
#ifndef smArguments_h
#define smArguments_h

#include "smFileJob.h"

#include <optional>
#include <string>
#include <vector>

namespace sm
{
/// 1, 2, 3: the first that applies.
enum ExitStatus
{
  AllOk = 0,
  UsageOrOutput = 1,
  Unreadable = 2,
  Flagged = 3
};

struct Arguments
{
  std::vector<std::string> Files;
  std::string Json; ///< empty: none; "-": standard output
  std::string Csv;  ///< likewise
  std::string Picture;
  std::string TextureFolder; ///< for trim textures; empty: none
  std::string Up = "0,0,1";  ///< direction out of the water
  JobOptions Job;            ///< what all files share
  bool Quiet = false;
};

/// Reads the arguments. Returns an exit status when there is nothing more to do: help, version, wrong usage (explained
/// on the standard error).
std::optional<int> ParseArguments(int argc, char** argv, Arguments& arguments);

/// Says `what` on the standard error; returns UsageOrOutput.
int Complain(const std::string& what);

/// Letters beyond ASCII stay as they are.
std::string LowerCase(std::string text);

/// "bracket" from "parts/bracket.step".
std::string Stem(const std::string& path);
}

#endif
