/**
 * @file smMassAnalysis.h
 * @brief Mass properties of bodies from their integrals: signs, totals, plausibility, tolerances, statuses
 */
#ifndef smMassAnalysis_h
#define smMassAnalysis_h

#include "Detail/smMassTolerance.h"
#include "Detail/smReferenceFrame.h"
#include "smBodyIntegrals.h"
#include "smFiltersMassPropertiesModule.h"
#include "smIntegralEngine.h"
#include "smMassTable.h"
#include "smMaterials.h"
#include "smPartsList.h"
#include "smProducts.h"
#include "smStatus.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace sm
{
class SelfCrossingCheck;

/// What a solid has of the mass that materials state for a product.
struct ProductShare
{
  /// The density with which the solid has its share. A contradiction leaves it without a density.
  sm::Material Material;
  /// The part of the mass that is distributed, above 0 and at most 1; 0 after a contradiction.
  double Share = 0.0;
  /// Largest relative error of the density, and how far other closings of the gaps may change it.
  double Error = 0.0;
  double Spread = 0.0;
};

/// Options of AnalyzeMass().
struct MassAnalysisOptions
{
  MassTolerance Tolerance;
  /// Density of all bodies in kg/m^3; 0: the density that the file of each part states, if any.
  double Density = 0.0;
  /// Largest relative deviation of the densities of materials that state none.
  double DensityTolerance = 0.0;
  /// Materials by the names of the bodies. The first rule that a name matches comes before Density.
  std::vector<MaterialRule> Materials;
  /// Materials of bodies without one, by their ids, from their mirror images.
  std::map<std::string, Material> Twins;
  /// The products of the input, for rules that state masses of products; else empty.
  ProductTreeNode Products;
  /// Shares by the ids of solids, which come before their materials. AnalyzeMass() sets them.
  std::map<std::string, ProductShare> Shares;

  /// Takes the products of `input` if a rule states the mass of one.
  void TakeProducts(vtkDataObject* input);
  /// The frame of reference of InFrame in MassRow, which must be valid if Frame.IsGiven is true.
  ReferenceFrame Frame;
  /// False if the integrals have no bounds and belong to no closed chain (the paper's schemes). Then every
  /// bound, the closure correction and the closure residual are NaN, and the status of every body is at least
  /// tolerance-not-met.
  bool HasBounds = true;
  /// Largest closure residual at which a surface without open edges counts as closed. If there are bounds, a
  /// larger residual of a solid indicates a broken loop.
  double MaxClosureResidual = 1e-9;
  /// See vtkSurfaceIntegralBase::SetGapLimit().
  double GapLimit = 1e-3;
};

/// The results of all bodies of a run.
struct MassAnalysis
{
  /// Rows of the bodies, in their order, and the row of all bodies together.
  std::vector<MassRow> Rows;
  MassRow Total;
  /// Length unit of the total.
  std::string Unit = "mm";
  bool HasOneUnit = true;
  /// True if at least one body has a density.
  bool HasMass = false;
  /// Numbers of bodies that have a volume, and of those among them that have a density.
  int Weighable = 0;
  int Weighed = 0;
  int OpenEdges = 0;
  int FlippedShells = 0;
  /// Status of the total alone, whose bound is the sum of the bodies' bounds: Ok or ToleranceNotMet.
  sm::Status TotalStatus = sm::Status::Ok;
  /// Messages about the total.
  std::vector<std::string> Messages;
  /// The parts list; empty where bodies have different units.
  std::vector<PartsListEntry> Parts;
};

/// Reverses shells whose normals point inwards, sets the statuses of the bodies and computes all mass
/// properties. Bodies have the integrals of GetMassIntegrands() (SumFaces), or no Faces if nothing was
/// computed.
SMFILTERSMASSPROPERTIES_EXPORT MassAnalysis AnalyzeMass(
  std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options);

/// Returns the request of the integrals for mass properties: once for each part, about its origin, to
/// tolerances that depend on the part alone.
SMFILTERSMASSPROPERTIES_EXPORT IntegralRequest MakeMassRequest(const MassTolerance& tolerance);

/// Returns a callback that returns false when the run is stopped, or when the time is over that its report
/// leaves of its limits, from now on.
SMFILTERSMASSPROPERTIES_EXPORT std::function<bool()> MakeContinue(
  const IntegralLimits& limits, const RunReport& report);

/// Calls AnalyzeMass(), looks for bodies that cross themselves if the integrals have bounds, as long as the
/// limits of the run allow, and adds the status and the messages of the total to the report. `checkEdits` is
/// that of SelfCrossingCheck::Run().
SMFILTERSMASSPROPERTIES_EXPORT MassAnalysis AnalyzeRun(std::vector<BodyIntegrals>& bodies,
  const MassAnalysisOptions& options, bool checkEdits, const IntegralLimits& limits,
  SelfCrossingCheck& crossings, RunReport& report);
}

#endif
