/**
 * @file smSTEPDensities.h
 * @brief Densities that a STEP file states for its products
 */
#ifndef smSTEPDensities_h
#define smSTEPDensities_h

#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"

#include <vector>

namespace sm
{
/**
 * One for every product that states a density, by the product's number.
 *
 * A density is an item with a value and a unit in a representation of a property of the product (PROPERTY_DEFINITION,
 * PROPERTY_DEFINITION_REPRESENTATION) that any of their names calls one ("density", "PTC_MASS_DENSITY"), or whose unit is one. The
 * recommended practice's "material property" goes before users' own properties. The unit is a DERIVED_UNIT of one mass and the third
 * power of one length, whatever they are; many systems leave out the minus of that power. OpenCASCADE writes g/cm^3 as the third power of
 * a gram times the square of a centimetre, which is read as it was meant.
 */
std::vector<STEPDensity> ReadSTEPDensities(const STEPAttributes& entities);
}

#endif
