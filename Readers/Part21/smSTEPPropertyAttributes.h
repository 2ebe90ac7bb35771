/**
 * @file smSTEPPropertyAttributes.h
 * @brief Attributes of properties, of their representations, and of measures with units
 */
#ifndef smSTEPPropertyAttributes_h
#define smSTEPPropertyAttributes_h

#include "smSTEPAttributes.h"

namespace sm
{
constexpr STEPAttribute NameOfProperty = { "PROPERTY_DEFINITION", 0, 0, "name" };
constexpr STEPAttribute DescriptionOfProperty = { "PROPERTY_DEFINITION", 1, 1, "description" };
constexpr STEPAttribute DefinitionOfProperty = { "PROPERTY_DEFINITION", 2, 2, "definition" };
constexpr STEPAttribute RepresentedProperty = { "PROPERTY_DEFINITION_REPRESENTATION", 0, 0, "definition" };
constexpr STEPAttribute UsedRepresentation = { "PROPERTY_DEFINITION_REPRESENTATION", 1, 1,
  "used representation" };
constexpr STEPAttribute NameOfRepresentation = { "REPRESENTATION", 0, 0, "name" };
constexpr STEPAttribute ItemsOfRepresentation = { "REPRESENTATION", 1, 1, "items" };
constexpr STEPAttribute ContextOfRepresentation = { "REPRESENTATION", 2, 2, "context" };
constexpr STEPAttribute NameOfItem = { "REPRESENTATION_ITEM", 0, 0, "name" };
constexpr STEPAttribute ValueOfItem = { "MEASURE_WITH_UNIT", 0, 1, "value" };
constexpr STEPAttribute UnitOfItem = { "MEASURE_WITH_UNIT", 1, 2, "unit" };
constexpr STEPAttribute ElementsOfUnit = { "DERIVED_UNIT", 0, 0, "elements" };
constexpr STEPAttribute UnitOfElement = { "DERIVED_UNIT_ELEMENT", 0, 0, "unit" };
constexpr STEPAttribute ExponentOfElement = { "DERIVED_UNIT_ELEMENT", 1, 1, "exponent" };
constexpr STEPAttribute CoordinatesOfPoint = { "CARTESIAN_POINT", 0, 1, "coordinates" };
}

#endif
