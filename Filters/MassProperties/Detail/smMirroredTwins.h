/**
 * @file smMirroredTwins.h
 * @brief Materials of solids that no rule names, from their mirror images
 */
#ifndef smMirroredTwins_h
#define smMirroredTwins_h

#include "smMassAnalysis.h"

#include <functional>
#include <string>
#include <vector>

namespace sm
{
/**
 * Sets `options.Twins`: a solid that would have no material and no mass gets those of a solid that a rule
 * names and that is its mirror image, by exact integrals of the faces of both (AreMirrored(), relative limit
 * 1e-9). Solids that a rule names, and those with a density of the options or of the file, keep theirs. Only
 * solids that have the volume, the area and the number of faces of each other are compared, and the solids of
 * one model in placements of one hand are compared once. Returns messages: one names the solids of such a
 * group with their twin; where several twins have different materials, none is taken; the last one has the
 * number of solids that were not compared. The integrals have the time that the limits of the run leave.
 * `shouldContinue` is called before each pair; false ends the search.
 */
std::vector<std::string> FindMirroredTwins(const std::vector<BodyIntegrals>& bodies,
  const IntegralLimits& limits, const RunReport& report, const std::function<bool()>& shouldContinue,
  MassAnalysisOptions& options);
}

#endif
