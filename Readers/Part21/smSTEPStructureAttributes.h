/**
 * @file smSTEPStructureAttributes.h
 * @brief Attributes by which a representation is placed in another one
 */
#ifndef smSTEPStructureAttributes_h
#define smSTEPStructureAttributes_h

#include "smSTEPAttributes.h"

namespace sm
{
constexpr STEPAttribute FirstRepresentation = { "REPRESENTATION_RELATIONSHIP", 2, 2, "first representation" };
constexpr STEPAttribute SecondRepresentation = { "REPRESENTATION_RELATIONSHIP", 3, 3,
  "second representation" };
constexpr STEPAttribute OperatorOfRelationship = { "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION", 0, 4,
  "transformation" };
constexpr STEPAttribute MappingSource = { "MAPPED_ITEM", 0, 1, "mapping source" };
constexpr STEPAttribute MappingTarget = { "MAPPED_ITEM", 1, 2, "mapping target" };
constexpr STEPAttribute MappingOrigin = { "REPRESENTATION_MAP", 0, 0, "mapping origin" };
constexpr STEPAttribute MappedRepresentation = { "REPRESENTATION_MAP", 1, 1, "mapped representation" };
}

#endif
