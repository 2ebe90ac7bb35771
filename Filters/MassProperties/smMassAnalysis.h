/**
 * @file smMassAnalysis.h
 * @brief From the integrals of bodies to their mass properties: signs, totals, plausibility, tolerances, statuses
 */
#ifndef smMassAnalysis_h
#define smMassAnalysis_h

#include "smBodyIntegrals.h"
#include "smFiltersMassPropertiesModule.h"
#include "smMassTable.h"
#include "smMassTolerance.h"
#include "smStatus.h"

#include <string>
#include <vector>

namespace sm
{
struct MassAnalysisOptions
{
  MassTolerance Tolerance;
  /// Of all bodies, kg/m^3; 0: the density that each part's file states.
  double Density = 0.0;
  /// False: the integrals have no bounds and no closed chain (the paper's schemes); every bound, the closure correction and the
  /// closure residual are NaN, and no body is better than tolerance-not-met.
  bool HasBounds = true;
  /// The largest closure residual of a surface that counts as closed although it has no edges. Of a solid it is a sign of a broken
  /// loop, where there are bounds.
  double LargestClosureResidual = 1e-9;
};

/// The results of all bodies of a run.
struct MassAnalysis
{
  /// In the order of the bodies, and for all together.
  std::vector<MassRow> Rows;
  MassRow Total;
  /// Length unit of the total.
  std::string Unit = "mm";
  bool HasOneUnit = true;
  /// Some body has a density.
  bool HasMass = false;
  int OpenEdges = 0;
  int FlippedShells = 0;
  /// Of the total alone, whose bound is the sum of theirs: Ok or ToleranceNotMet.
  sm::Status TotalStatus = sm::Status::Ok;
  /// What is to be said of the total.
  std::vector<std::string> Messages;
};

/// Reverses shells that are inside out, flags the bodies, and computes all mass properties. Bodies have integrals of
/// MakeMassIntegrands() (SumFaces), or no Faces where nothing was computed.
SMFILTERSMASSPROPERTIES_EXPORT MassAnalysis AnalyzeMass(
  std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options);
}

#endif
