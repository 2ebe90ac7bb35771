/**
 * @file smSpecialFiles.h
 * @brief Files for the error tests and for assemblies
 */
#ifndef smSpecialFiles_h
#define smSpecialFiles_h

#include "smExactMoments.h"

#include <string>
#include <vector>

namespace smtest
{
struct SpecialFile
{
  std::string Name;
  std::string File;
  /// Number of solids a reader finds; 0: Total means nothing.
  int Solids = 0;
  ExactMoments Total;
  double Size = 0;
};

/// Writes empty, truncated, not_step, no_geometry, points_only, open_shell, open_solid, assembly (500
/// instances of one part, each placed differently), two_solids, junk_header, cone_tip (radius 12, height 20)
/// and cone_tip_digits12, the same with 12 digits a number, which miss the apex by 1e-11.
std::vector<SpecialFile> WriteSpecialFiles(const std::string& folder);

/// Placement of instance i of the assembly.
Placement GetAssemblyPlacement(int i);
constexpr int AssemblyInstances = 500;
}

#endif
