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
  std::string Json;               ///< empty: none; "-": standard output
  std::string Csv;                ///< empty: none; "-": standard output
  std::string PartsCsv;           ///< parts lists of all files; empty: none
  std::vector<std::string> Robot; ///< format and file of a robot; empty: none
  std::string RobotName;          ///< the file; empty: none
  std::string Joints;             ///< file with joints of the robot; empty: none
  std::string Mesh;
  std::string Picture;
  std::string Density; ///< a number or the name of a common material; empty: what the files state
  std::string DensityTolerance = "0"; ///< see ParseShare()
  std::string Materials;              ///< file with materials by the names of solids; empty: none
  std::string About;                  ///< see ParseFrame(); empty: none
  bool Compare = false;               ///< the two files are an old and a new product
  double CompareLimit = 1e-9;         ///< see CompareProducts()
  bool ListMaterials = false;
  bool ProbeOpenGL = false;
  std::vector<std::string>
    Print; ///< columns of each file's total to print instead of the table; empty: the table
  std::vector<std::string> Fields; ///< columns of the CSV; empty: all
  /// Statuses of a file that make the exit status 3; unreadable files have another exit status.
  std::vector<std::string> FailOn = { "open", "tolerance-not-met", "suspect", "not-computed", "empty" };
  std::vector<std::string> Require; ///< "stable", "mass": without it the exit status is 3
  JobOptions Job;                   ///< the options that all files share
  int JobsAtOnce = 1;               ///< files that are processed at the same time
  bool Quiet = false;
};

/// Reads the arguments. Returns an exit status when there is nothing more to do: after help, version, or
/// wrong usage, which is explained on the standard error.
std::optional<int> ParseArguments(int argc, char** argv, Arguments& arguments);

/// Prints the message on the standard error; returns UsageOrOutput.
int Complain(const std::string& message);
}

#endif
