/**
 * @file smCountedBodies.h
 * @brief Bodies that materials leave out or count once
 */
#ifndef smCountedBodies_h
#define smCountedBodies_h

#include "smFiltersMassPropertiesModule.h"
#include "smMaterials.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
struct BodyIntegrals;

/// Returns true if a rule may leave out bodies.
SMFILTERSMASSPROPERTIES_EXPORT bool LeavesOutBodies(const std::vector<MaterialRule>& rules);

/**
 * Removes the bodies that the rules leave out, in this order: those whose names are left out; of equal
 * products of `input` that are counted once (the same name, the same bodies among `bodies`, equal products
 * below, in any place) all but the first one in depth-first order; of bodies that are counted once in place
 * and coincide all but the first. Two bodies coincide if they have the same faces in the same order: control
 * points, as placed, within 1e-9 of the size of the body, knots, weights and trim curves within 1e-9.
 * Returns messages with the numbers and names, and with `noteUnused` one for each of these rules that left
 * out nothing.
 */
SMFILTERSMASSPROPERTIES_EXPORT std::vector<std::string> LeaveOutBodies(const std::vector<MaterialRule>& rules,
  vtkDataObject* input, bool noteUnused, std::vector<BodyIntegrals>& bodies);
}

#endif
