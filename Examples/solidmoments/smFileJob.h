/**
 * @file smFileJob.h
 * @brief Reads one file, integrates and draws it, and sends the results
 */
#ifndef smFileJob_h
#define smFileJob_h

#include "smAnalysis.h"
#include "smComparison.h"
#include "smMaterials.h"
#include "smRobot.h"
#include "smScheme.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkCADReader;

namespace sm
{
struct JobOptions
{
  std::string FileName;
  std::string
    SourceName; ///< plain file with the content of FileName (InputFile); empty: FileName itself is one
  std::string PictureName;                ///< PNG file to draw; empty: none
  std::string MeshName;                   ///< file of triangles to write, see smMeshFile.h; empty: none
  double Deflection = 0.0;                ///< of the triangles, in Unit; 0: the reader's default
  std::string Unit = "mm";                ///< length unit of all results, or "file"
  std::string InputUnit = "mm";           ///< of files that state none, see vtkBREPReader::SetInputUnit
  std::vector<std::string> SearchFolders; ///< see vtkSTEPReader::SetSearchFolders
  std::string Hidden = "count";           ///< or "skip", "only": see vtkSTEPReader::SetHidden
  std::string Repair =
    "needed"; ///< or "always", "never": which shapes OpenCASCADE repairs, see vtkCADReader::SetRepair
  std::string Backend = "auto";
  double Tolerance = 1e-9; ///< relative, see vtkSurfaceIntegralGPU::SetRelativeTolerance
  /// Tolerances of single quantities, "volume=1e-6" or "center=0,1e-3": relative, absolute; see
  /// vtkMassPropertiesGPU.
  std::vector<std::string> QuantityTolerances;
  AnalysisList Analyses = MakeAnalyses(); ///< what else is computed, with the options of each
  int Threads = 0;                        ///< 0: one for each processor
  double MaximumEvaluations = 2e9;
  double MaximumSeconds = 0.0; ///< for the whole job; 0: no limit
  /// Time at which they have elapsed; RunFileJob() sets it.
  std::chrono::steady_clock::time_point Deadline = std::chrono::steady_clock::time_point::max();
  double GapLimit = 1e-3; ///< see vtkSurfaceIntegralBase::SetGapLimit
  sm::Scheme Scheme;
  std::string TexturePrefix;     ///< "folder/stem": trim textures go to folder/stem-NAME.png; empty: none
  double Density = 0.0;          ///< kg/m^3; 0: the density in the file
  double DensityTolerance = 0.0; ///< relative, of densities without one of their own
  /// Materials by the names of solids, before Density; see vtkMassPropertiesBase::AddMaterial.
  std::vector<MaterialRule> Materials;
  /// Returns whether materials may leave solids out.
  bool LeavesOut() const;
  /// Name patterns of products (MatchesPattern): only these are computed; none: all.
  std::vector<std::string> Only;
  std::vector<std::string> Selectors; ///< of these products, once the file is read
  bool PartsList = false;             ///< adds "parts" to the entry
  int Depth = 0;                      ///< levels of the parts list; 0: all
  bool Validate = false;              ///< adds "validation" to the entry, see CompareValidation()
  double ValidationLimit = 1e-3;
  std::string RobotName; ///< file of a robot to write; empty: none
  /// Of the whole run: files that its meshes must not replace, and all robots.
  std::vector<std::string> TakenNames, AllRobots;
  sm::RobotFormat RobotFormat = sm::RobotFormat::Urdf;
  std::vector<std::string> Fused; ///< see MakeRobot()
  std::vector<RobotJoint> Joints;
  std::string Collision = "none"; ///< or "hull"
  std::string ValidationTarget;   ///< STEP file to write with validation properties; empty: none
  /// A comparison with the plain file ComparedName to draw, see DrawComparison(), and nothing else.
  std::optional<ProductDifference> Comparison;
  std::string ComparedName;
  bool Shapes = false;       ///< adds the shapes of the solids to the entry, see smProductShapes.h
  std::vector<double> About; ///< a frame of reference, see ParseFrame(); empty: none

  /// Returns the seconds to Deadline, above 0; 0 without MaximumSeconds.
  double GetSecondsLeft() const;
  /// Returns the name of the plain file to read.
  const std::string& GetSource() const
  {
    return this->SourceName.empty() ? this->FileName : this->SourceName;
  }
};

/// Stages of a job, in their order: reading; mass properties; then, behind those of the analyses, the
/// outputs.
namespace stages
{
constexpr const char* Start = "start";
constexpr const char* Read = "read";
constexpr const char* Integrate = "integrate";
constexpr const char* Textures = "textures";
constexpr const char* Mesh = "mesh";
constexpr const char* Validation = "validation";
constexpr const char* Robot = "robot";
constexpr const char* Draw = "draw";
}

/// A message of a job: progress; the results, several times, each time with more in them, so that a crash in
/// a later stage does not cost the results of those before; and for each output whether it was written.
struct JobMessage
{
  enum Kinds : char
  {
    Progress,
    Result,
    Textures,
    Mesh,
    Validation,
    Robot,
    Picture,
    Analysis,
    Next ///< the job is finished, and its process begins with the next one
  };
  Kinds Kind = Progress;
  std::string Text; ///< the stage; of an output why it was not written, empty if it was, with the key before
                    ///< it of an analysis
  double Fraction = 0.0;
  const FileResult* File = nullptr; ///< of Result
  bool IsComplete = false;          ///< of Result: nothing is missing

  static JobMessage OfProgress(const char* stage, double fraction = 0.0)
  {
    return { Progress, stage, fraction, nullptr, false };
  }
  static JobMessage OfResult(const FileResult& file, bool isComplete)
  {
    return { Result, {}, 0.0, &file, isComplete };
  }
  static JobMessage OfOutput(Kinds kind, std::string problem)
  {
    return { kind, std::move(problem), 0.0, nullptr, false };
  }
  /// The output of the analysis with that key.
  static JobMessage OfAnalysis(const std::string& key, const std::string& problem)
  {
    return OfOutput(Analysis, key + "\n" + problem);
  }
};

using JobListener = std::function<void(const JobMessage&)>;

/// Runs the whole job in this process, which should be a child (smIsolatedJob.h). Never throws. Jobs that are
/// given the same `reader` one after the other read their file once.
void RunFileJob(const JobOptions& options, const JobListener& send, vtkCADReader* reader = nullptr);

/// Adds the reason why requested results are missing; the status becomes not-computed if it was ok.
void MarkIncomplete(FileResult& file, const std::string& reason);

/// Returns the exit status of the program for one file (ExitStatus in smOptions.h).
int GetExitStatus(const FileResult& file);

/// Returns the results of a file that could not be read: all values are unknown.
FileResult UnreadableFile(const JobOptions& options, const std::string& message);
}

#endif
