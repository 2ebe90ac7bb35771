/**
 * @file smFileJob.h
 * @brief Reads one file, integrates and draws it, and sends the results as JSON
 */
#ifndef smFileJob_h
#define smFileJob_h

#include "smJson.h"
#include "smMaterials.h"

#include <array>
#include <chrono>
#include <functional>
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
  std::string PictureName;      ///< PNG file to draw; empty: none
  std::string MeshName;         ///< file of triangles to write, see WriteMesh(); empty: none
  double Deflection = 0.0;      ///< of the triangles, in Unit; 0: the reader's default
  std::string Unit = "mm";      ///< length unit of all results, or "file"
  std::string InputUnit = "mm"; ///< of files that state none, see vtkBREPReader::SetInputUnit
  std::string Repair =
    "needed"; ///< or "always": which shapes OpenCASCADE repairs, see vtkCADReader::SetRepair
  std::string Backend = "auto";
  double Tolerance = 1e-9; ///< relative, see vtkSurfaceIntegralGPU::SetRelativeTolerance
  /// Tolerances of single quantities, "volume=1e-6" or "center=0,1e-3": relative, absolute; see vtkMassPropertiesGPU.
  std::vector<std::string> QuantityTolerances;
  int MomentDegree = -1;              ///< volume moments up to this degree; negative: none
  std::vector<std::string> Integrals; ///< expressions, "NAME=EXPR"
  std::string Stability;              ///< direction of gravity, see ParseDirection(); empty: no stability
  /// Heights of waterlines along Up, in the unit of the results; Up is not 0.
  std::vector<double> Waterlines;
  std::array<double, 3> Up = { 0.0, 0.0, 1.0 };
  /// Planes of sections: a point, in the unit of the results, and a normal that is not 0.
  std::vector<std::array<double, 6>> Sections;
  int Threads = 0; ///< 0: one for each processor
  double MaximumEvaluations = 2e9;
  double MaximumSeconds = 0.0; ///< for the whole job; 0: no limit
  /// Time at which they have elapsed; RunFileJob() sets it.
  std::chrono::steady_clock::time_point Deadline = std::chrono::steady_clock::time_point::max();
  double GapLimit = 1e-3; ///< see vtkSurfaceIntegralBase::SetGapLimit
  /// "adaptive", or a scheme of the paper: "midpoint", "gauss2", "gauss3". The next four options are for these.
  std::string Scheme = "adaptive";
  int SubPatches = 2;
  int TrimTexture = 4;
  double ChordTolerance = 1e-8;
  std::string Deviation = "bounded";
  std::string TexturePrefix;     ///< "folder/stem": trim textures go to folder/stem-NAME.png; empty: none
  double Density = 0.0;          ///< kg/m^3; 0: the density in the file
  double DensityTolerance = 0.0; ///< relative, of densities without one of their own
  /// Materials by the names of solids, before Density; see vtkMassPropertiesBase::AddMaterial.
  std::vector<MaterialRule> Materials;
  /// Name patterns of products (MatchesPattern): only these are computed; none: all.
  std::vector<std::string> Only;
  std::vector<std::string> Selectors; ///< of these products, once the file is read
  bool PartsList = false;             ///< adds "parts" to the entry, see MakePartsList()
  int Depth = 0;                      ///< levels of the parts list; 0: all
  bool Box = false;                   ///< adds "bounding_box" to the quantities
  bool Validate = false;              ///< adds "validation" to the entry, see CompareValidation()
  double ValidationLimit = 1e-3;
  std::string ValidationTarget; ///< STEP file to write with validation properties; empty: none
  /// A comparison with the plain file ComparedName to draw, see DrawComparison(), and nothing else; null: none.
  Json Comparison;
  std::string ComparedName;
  bool Shapes = false;       ///< adds the shapes of the solids to the entry, see smProductShapes.h
  std::vector<double> About; ///< a frame of reference, see ParseFrame(); empty: none
};

/// Stages of a job, in their order: reading; mass properties; then the other results.
namespace stages
{
constexpr const char* Start = "start";
constexpr const char* Read = "read";
constexpr const char* Integrate = "integrate";
constexpr const char* Integrals = "integrals";
constexpr const char* Buoyancy = "buoyancy";
constexpr const char* Section = "section";
constexpr const char* Stability = "stability";
constexpr const char* Textures = "textures";
constexpr const char* Mesh = "mesh";
constexpr const char* Draw = "draw";
}

/// Receives the messages of a job, each one of
///   {"progress": [stage, fraction]}
/// {"result": the entry of "files" in the JSON document, "complete": true if nothing is missing}; it is sent several times, each time with
///     more in it, so that a crash in a later stage does not cost the results of those before
///   {"textures": an error message when a trim texture was not written, otherwise ""}
///   {"mesh": an error message when the triangles were not written, otherwise ""}
///   {"picture": an error message when the picture was not written, otherwise ""}
using JobListener = std::function<void(const Json&)>;

/// Runs the whole job in this process, which should be a child (smIsolatedJob.h). Never throws. Jobs that are given the same
/// `reader` one after the other read their file once.
void RunFileJob(const JobOptions& options, const JobListener& send, vtkCADReader* reader = nullptr);

/// Adds the reason why requested results are missing; the status becomes not-computed if it was ok.
void MarkIncomplete(Json& file, const std::string& reason);

/// Returns the exit status of the program for one file (ExitStatus in smOptions.h), from its entry in the JSON document.
int GetExitStatus(const Json& file);

/// Returns the entry of a file that could not be read: it has every key, including those of all requested results, and all values are null.
Json UnreadableFile(const JobOptions& options, const std::string& message);
}

#endif
