/**
 * @file smFileJob.h
 * @brief One file: read it, integrate, draw it; what is found goes out as JSON
 */
#ifndef smFileJob_h
#define smFileJob_h

#include "smJson.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace sm
{
struct JobOptions
{
  std::string FileName;
  std::string PictureName; ///< PNG file to draw; empty: none
  std::string Unit = "mm"; ///< length unit of all results, or "file"
  std::string Backend = "auto";
  double Tolerance = 1e-9; ///< relative, see vtkSurfaceIntegralGPU::SetRelativeTolerance
  /// Of single quantities, "volume=1e-6" or "center=0,1e-3": relative, absolute; see vtkMassPropertiesGPU.
  std::vector<std::string> QuantityTolerances;
  /// Volume moments up to this degree; negative: none. And expressions, "NAME=EXPR".
  int MomentDegree = -1;
  std::vector<std::string> Integrals;
  /// Where things fall, see ParseDirection(); empty: stability is not asked for.
  std::string Stability;
  /// Heights of waterlines along Up, in the unit of the results; Up is not 0.
  std::vector<double> Waterlines;
  std::array<double, 3> Up = { 0.0, 0.0, 1.0 };
  double MaximumEvaluations = 2e9;
  double MaximumSeconds = 0.0;
  std::string Scheme =
    "adaptive"; ///< or "midpoint", "gauss2", "gauss3", the paper's; the next four are for the paper's schemes
  int SubPatches = 2;
  int TrimTexture = 4;
  double ChordTolerance = 1e-8;
  std::string Deviation = "bounded";
  std::string TexturePrefix; ///< "folder/stem": trim textures go to folder/stem-NAME.png; empty: none
  double Density = 0.0;      ///< kg/m^3; 0: what the file states
};

/// Takes what a job has to say, one of
///   {"progress": [stage, fraction]}
///   {"result": {the entry of "files" in DESIGN 6}}
///   {"textures": reason why a trim texture was not written, "" when all were}
///   {"picture": reason why there is none, "" when it was written}
using JobListener = std::function<void(const Json&)>;

/// Runs the whole job in this process: see smIsolatedJob.h for why that should be a child. Never throws.
void RunFileJob(const JobOptions& options, const JobListener& tell);

/// One of QuantityTolerances taken apart; false when it is not well formed.
bool ParseQuantityTolerance(
  const std::string& text, std::string& quantity, double& relative, double& absolute);

/// "x", "+y", "-z", or three numbers, "0,0.1,-1"; false when it is neither, or all three are 0.
bool ParseDirection(const std::string& text, std::array<double, 3>& direction);

/// The entry of a file that could not be read: every key is there, every value null.
Json UnreadableFile(const std::string& fileName, const std::string& message);
}

#endif
