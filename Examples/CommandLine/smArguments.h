/**
 * @file smArguments.h
 * @brief The arguments of the command line, checked
 */
#ifndef smArguments_h
#define smArguments_h

#include "smFileJob.h"
#include "smOptions.h"

#include <optional>
#include <string>
#include <vector>

namespace sm
{
struct Arguments
{
  std::vector<std::string> Files;
  std::string Json; ///< empty: none; "-": standard output
  std::string Csv;  ///< empty: none; "-": standard output
  std::string Picture;
  std::string TextureFolder; ///< for trim textures; empty: none
  std::string Up = "0,0,1";  ///< upward normal of the waterlines
  JobOptions Job;            ///< the options that all files share
  bool Quiet = false;
};

/// Reads the arguments. Returns an exit status when there is nothing more to do: after help, version, or wrong usage, which is
/// explained on the standard error.
std::optional<int> ParseArguments(int argc, char** argv, Arguments& arguments);

/// Prints the message on the standard error; returns UsageOrOutput.
int Complain(const std::string& message);
}

#endif
