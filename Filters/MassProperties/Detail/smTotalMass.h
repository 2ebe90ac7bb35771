/**
 * @file smTotalMass.h
 * @brief Materials and masses of bodies, and of all bodies together
 */
#ifndef smTotalMass_h
#define smTotalMass_h

#include "smMassAnalysis.h"

namespace sm
{
/// Returns the material of a body: what it has of the mass of a product; else that of the first rule that its
/// name matches; else the density of the options; else what its file states.
Material ChooseMaterial(const BodyIntegrals& body, const MassAnalysisOptions& options);

/// Returns the share of a body in the mass of a product, or null.
const ProductShare* FindShare(const BodyIntegrals& body, const MassAnalysisOptions& options);

/// Returns the largest relative change of 1 / volume where the volume changes by at most `change`.
double GetReciprocalChange(double volume, double change);

/// Sets the properties of a row that is of one material: those of the volume times the density, or scaled to
/// the mass that the material states. `share` is FindShare() of the body, `unit` the length unit of the row.
void SetMass(MassRow& row, const Material& material, const ProductShare* share, const std::string& unit);

/// Sets the mass properties of the total, of bodies that all have the same unit, and adds a message about
/// those without a density. `parts` are the moments of the bodies with a volume, in their order, and `sum`
/// those of all of them; `spreads` are their GetSpreadMoments().
void SetTotalMass(const std::vector<BodyIntegrals>& bodies, const std::vector<Moments>& parts,
  const Moments& sum, const std::vector<Moments>& spreads, const MassAnalysisOptions& options,
  MassAnalysis& analysis);

/// Adds a message about each length unit that is not known, where it leaves bodies with a density without a
/// mass.
void NoteUnknownUnits(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis);

/// Adds a message about the masses that materials state, which override volume times density.
void NoteStatedMasses(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis);

/// Adds a message about each rule that no body matches.
void NoteUnusedRules(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis);
}

#endif
