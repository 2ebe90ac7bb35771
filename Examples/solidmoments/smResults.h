/**
 * @file smResults.h
 * @brief The results of a file: an entry of "files" in the JSON document
 */
#ifndef smResults_h
#define smResults_h

#include "smAnalysis.h"
#include "smPartsList.h"
#include "smProductResults.h"
#include "smProductShapes.h"
#include "smValidation.h"

#include <optional>
#include <string>
#include <vector>

class vtkFieldData;
class vtkTable;

namespace sm
{
/// The quantities of a solid, or of all together, with the results of the analyses of bodies.
struct BodyResult : Quantities
{
  /// Results of the paper's schemes.
  double PaperErrorEstimate = Unknown, PaperErrorEstimateWithBoundary = Unknown;
  long long SubPatches = -1;
  /// The bounding box: lowest and highest corner.
  VectorQuantity LowCorner, HighCorner;
  AnalysisResults Analyses;
};

/// An edge between faces with a gap.
struct EdgeResult
{
  long long Id = -1;
  std::string Name;
  long long Uses = -1;
  std::optional<bool> IsOpen;
  double MaxGap = Unknown, GapArea = Unknown, GapSquared = Unknown, Spread = Unknown;
};

struct SolidResult : BodyResult
{
  /// The path has the names of the assemblies above, with which instances of one name differ.
  std::string Name, Id, Path, Status;
  std::vector<EdgeResult> WorstEdges;
};

struct TotalResult : BodyResult
{
  ScalarQuantity KnownMass;
  long long SolidsWithMass = -1, SolidsWithVolume = -1;
};

/// The scheme of the paper that was used.
struct SchemeResult
{
  long long SubPatchFactor = -1, TextureFactor = -1;
  double ChordTolerance = Unknown;
  std::string Deviation;
};

/// NaN: that stage was not reached.
struct StageSeconds
{
  double Start = Unknown, Read = Unknown, Parse = Unknown, Transfer = Unknown, Trims = Unknown;
  double Prepare = Unknown, Mesh = Unknown, Convert = Unknown, Cut = Unknown, Plan = Unknown;
  double Upload = Unknown, Integrate = Unknown, Analyse = Unknown;
};

struct FileResult
{
  /// The results of a file before it is read: all values are unknown, those of all requested analyses, too.
  explicit FileResult(const JobOptions& options);

  std::string File, Status;
  std::optional<std::string> LengthUnit, Scheme, Backend, Renderer, BackendReason;
  std::vector<std::string> Messages;
  std::optional<SchemeResult> SchemeOptions;
  long long EstimatedEvaluations = -1;
  double EstimatedCPUSeconds = Unknown, EstimatedOpenGLSeconds = Unknown;
  std::vector<double> Frame; ///< origin, z axis, x axis; empty: none
  TotalResult Total;
  std::vector<SolidResult> Solids;
  long long Faces = -1, FreeFaces = -1, Evaluations = -1, Dispatches = -1;
  double Diagonal = Unknown;
  StageSeconds Seconds;
  std::optional<std::vector<PartsListEntry>> Parts;
  std::optional<std::vector<ValidationEntry>> Validation;
  AnalysisResults Analyses;
  /// For a comparison; no part of the document.
  std::optional<ProductShapes> Shapes;

  /// Visits the members of the document.
  void Visit(Fields& fields);
  /// Visits a solid, or the total.
  void VisitBody(Fields& fields, BodyResult& body, const std::function<void()>& inBounds = {});
  /// Returns the results by which products are compared.
  ProductResults GetProduct() const;
  /// Returns a solid with results of all requested analyses, of which nothing is known.
  SolidResult MakeSolid() const;
  /// Returns "mm^3" for the unit "mm" and the power 3.
  std::string FormatUnit(int power) const;
  /// Returns the rows of the table of all analyses: those of bodies first.
  std::string FormatAnalyses() const;
  /// Adds the columns of all analyses of the file (its total), or of a solid.
  void AddColumns(const AnalysisResults& results, Columns& columns) const;

private:
  /// Visits the results of the analyses of bodies, of files, or of both, which a solid has.
  void VisitAnalyses(Fields& fields, AnalysisResults& results, bool ofBodies, bool ofFiles);
  void VisitSolid(Fields& fields, SolidResult& solid);
  void VisitRun(Fields& fields);

  AnalysisList Known;
};

/// Returns true if all densities are known and not all equal.
bool HasMixedDensities(const Quantities& total);

/// Adds the quantities of all solids together, from the field data of port 0.
void ReadTotal(vtkFieldData* fields, TotalResult& total);
/// Adds a solid for every row of port 1; `edges` is port 4.
void ReadSolids(vtkTable* table, vtkTable* edges, FileResult& file);
}

#endif
