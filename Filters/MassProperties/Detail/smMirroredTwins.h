/**
 * @file smMirroredTwins.h
 * @brief Materials of solids that no rule names, from their mirror images
 */
#ifndef smMirroredTwins_h
#define smMirroredTwins_h

#include "smMassAnalysis.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * Sets `options.Twins`: a solid that would have no material and no mass gets those of a solid that a rule
 * names and that is its mirror image, by exact integrals of the faces of both (AreMirrored(), relative limit
 * 1e-9). Solids that a rule names, and those with a density of the options or of the file, keep theirs. Only
 * solids that have the volume, the area and the number of faces of each other are compared. Returns messages:
 * one names each solid with its twin; where several twins have different materials, none is taken.
 * The integrals have the time that the limits of the run leave.
 */
std::vector<std::string> FindMirroredTwins(const std::vector<BodyIntegrals>& bodies,
  const IntegralLimits& limits, const RunReport& report, MassAnalysisOptions& options);
}

#endif
