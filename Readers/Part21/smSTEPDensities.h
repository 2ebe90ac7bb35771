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
 * Returns one entry for every product that states a density, sorted by the number of the product.
 *
 * A density is an item with a value and a unit in a representation of a property of the product
 * (PROPERTY_DEFINITION, PROPERTY_DEFINITION_REPRESENTATION) one of whose names contains "density"
 * ("PTC_MASS_DENSITY"), or whose unit is one of density. The "material property" of the recommended practice
 * takes precedence over user-defined properties; two different densities of equal rank contradict each other,
 * and none counts. The unit is a DERIVED_UNIT of any unit of mass and the third power of any unit of length;
 * many systems omit the minus sign of that power. OpenCASCADE writes g/cm^3 as the third power of a gram
 * times the square of a centimetre, which is read as g/cm^3.
 */
std::vector<STEPDensity> ReadSTEPDensities(const STEPAttributes& entities);
}

#endif
