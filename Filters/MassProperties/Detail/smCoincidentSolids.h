/**
 * @file smCoincidentSolids.h
 * @brief Solids that lie in one place
 */
#ifndef smCoincidentSolids_h
#define smCoincidentSolids_h

#include "smMassAnalysis.h"

#include <vector>

namespace sm
{
/// Adds a message about pairs of solids that have one volume and one centre of mass: they overlap, and both
/// count.
void NoteCoincidences(const std::vector<BodyIntegrals>& bodies, MassAnalysis& analysis);
}

#endif
