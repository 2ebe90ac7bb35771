/**
 * @file smSTEPExplicit.h
 * @brief Writes out what a STEP file leaves to rules of the standard that OpenCASCADE does not follow
 */
#ifndef smSTEPExplicit_h
#define smSTEPExplicit_h

#include "smSTEPCensus.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// A contradiction to the standard that leaves the meaning of an entity open.
struct STEPDoubt
{
  std::uint64_t Id = 0;
  std::string Reason;
};

struct STEPExplicit
{
  /// The text with its changes; empty if there are none.
  std::string Text;
  std::vector<STEPDoubt> Doubts;
  /// All contexts that assign units.
  std::vector<CensusContext> Contexts;
};

/**
 * Returns a text with the same meaning by the standard, that OpenCASCADE reads with this meaning. Entities
 * keep their numbers, and new ones get numbers that the text does not have.
 *
 * - A unit that is converted to another converted one (a foot of 12 inches) is converted to the unit of SI,
 * and a unit that is not a complex entity becomes one. OpenCASCADE takes 1 mm for both.
 * - ITEM_DEFINED_TRANSFORMATION and MAPPED_ITEM move a representation so that its first placement lands on
 * the second one (ISO 10303-43), which is second * inverse(first). OpenCASCADE takes inverse(first) * second.
 * Where these differ, the first placement becomes the origin and the second one the product.
 * - An omitted reference direction of AXIS2_PLACEMENT_3D is the x axis, or for an axis that is parallel to x
 * the y axis (ISO 10303-42, first_proj_axis). OpenCASCADE takes another one.
 * - NEXT_ASSEMBLY_USAGE_OCCURRENCE as a complex instance of its own types becomes a simple one. OpenCASCADE
 * knows no other.
 * - Valid forms that OpenCASCADE does not read are replaced (smSTEPKnownForms.h).
 * - Omitted axes of CARTESIAN_TRANSFORMATION_OPERATOR_3D are those of ISO 10303-42, base_axis.
 *
 * Time and memory are linear in the file.
 */
SMREADERSPART21_EXPORT STEPExplicit MakeSTEPExplicit(const Part21File& file);
}

#endif
