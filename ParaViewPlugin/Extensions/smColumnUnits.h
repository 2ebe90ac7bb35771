/**
 * @file smColumnUnits.h
 * @brief Units of the arrays and columns in the outputs, for labels
 */
#ifndef smColumnUnits_h
#define smColumnUnits_h

#include <string>

namespace sm
{
/**
 * Returns the unit of a quantity by the name of its column or array, also of a component (`CenterOfMass_0`)
 * or a bound (`VolumeBound`), for example "mm^3" or "kg mm^2"; empty for a number without unit and a name
 * that is not known.
 */
std::string GetColumnUnit(const std::string& column, const std::string& lengthUnit);
}

#endif
