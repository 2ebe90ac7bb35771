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
/// Attributes of contexts, units and measures.
constexpr STEPAttribute UnitsOfContext = { "GLOBAL_UNIT_ASSIGNED_CONTEXT", 0, 2, "units" };
constexpr STEPAttribute Prefix = { "SI_UNIT", 0, 1, "prefix" };
constexpr STEPAttribute SIName = { "SI_UNIT", 1, 2, "name" };
constexpr STEPAttribute ConversionName = { "CONVERSION_BASED_UNIT", 0, 1, "name" };
constexpr STEPAttribute ConversionFactor = { "CONVERSION_BASED_UNIT", 1, 2, "conversion factor" };
constexpr STEPAttribute MeasureValue = { "MEASURE_WITH_UNIT", 0, 0, "value" };
constexpr STEPAttribute MeasureUnit = { "MEASURE_WITH_UNIT", 1, 1, "unit" };

enum class STEPUnitKind : unsigned char
{
  Length, ///< factor to millimetres
  Angle,  ///< to radians
  Mass    ///< to kilograms
};

/// Reads a SI_UNIT, or a CONVERSION_BASED_UNIT through the units that it converts to. `used` gets the
/// entities that were read.
CensusUnit ReadSTEPUnit(const STEPAttributes& entities, Part21File::Index unit, STEPUnitKind kind,
  std::vector<Part21File::Index>& used);

/// Reads the units of length and angle of a context, whose Id is set. `used` gets the entities that were
/// read.
SMREADERSPART21_EXPORT void ReadSTEPUnits(const STEPAttributes& entities, Part21File::Index context,
  CensusContext& result, std::vector<Part21File::Index>& used);

/// Reads an entity with a number and a unit; returns false if either is missing or damaged.
bool ReadSTEPMeasure(
  const STEPAttributes& entities, Part21File::Index measure, double& value, Part21File::Index& unit);
}

#endif
