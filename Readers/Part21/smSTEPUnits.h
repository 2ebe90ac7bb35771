/**
 * @file smSTEPUnits.h
 * @brief Sizes of the units of length, angle and mass of a STEP file
 */
#ifndef smSTEPUnits_h
#define smSTEPUnits_h

#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"

#include <vector>

namespace sm
{
enum class STEPUnitKind : unsigned char
{
  Length, ///< factor to millimetres
  Angle,  ///< to radians
  Mass    ///< to kilograms
};

/// Reads a SI_UNIT, or a CONVERSION_BASED_UNIT through the units that it converts to. `used` gets the entities that were read.
CensusUnit ReadSTEPUnit(const STEPAttributes& entities, Part21File::Index unit, STEPUnitKind kind,
  std::vector<Part21File::Index>& used);

/// Reads an entity with a number and a unit; returns false if either is missing or damaged.
bool ReadSTEPMeasure(
  const STEPAttributes& entities, Part21File::Index measure, double& value, Part21File::Index& unit);
}

#endif
