/**
 * @file smSTEPSchema.h
 * @brief Entity types of AP203, AP214 and AP242 on which a solid, its place in an assembly and its units
 * depend
 */
#ifndef smSTEPSchema_h
#define smSTEPSchema_h

#include "smReadersPart21Module.h"

#include <cstdint>
#include <string_view>

namespace sm
{
/// Roles of an entity, as bits; an entity has all those of its records.
namespace STEPRole
{
enum Bit : std::uint64_t
{
  Solid = 1ull << 0,      ///< MANIFOLD_SOLID_BREP and its kinds
  OtherSolid = 1ull << 1, ///< CSG, swept solids, construction history: no boundary that could be integrated
  SurfaceModel = 1ull << 2,
  WireModel = 1ull << 3,
  GeometricSet = 1ull << 4,
  Tessellated = 1ull << 5, ///< triangles instead of exact faces
  Shell = 1ull << 6,
  Face = 1ull << 7,
  Bound = 1ull << 8,
  Loop = 1ull << 9,
  OrientedEdge = 1ull << 10,
  Edge = 1ull << 11,
  Vertex = 1ull << 12,
  Point = 1ull << 13,
  Direction = 1ull << 14,
  Vector = 1ull << 15,
  Placement = 1ull << 16,
  Curve = 1ull << 17,
  Surface = 1ull << 18,
  Pcurve = 1ull << 19,
  CurveSegment = 1ull << 20,
  Representation = 1ull << 21,
  MappedItem = 1ull << 22,
  RepresentationMap = 1ull << 23,
  Relationship = 1ull << 24,
  ShapeRelationship = 1ull << 25,
  Transformation = 1ull << 26,
  Context = 1ull << 27,
  ProductDefinition = 1ull << 28,
  Occurrence = 1ull << 29, ///< NEXT_ASSEMBLY_USAGE_OCCURRENCE
  ProductShape = 1ull << 30,
  ShapeDefinition = 1ull << 31,
  OccurrenceShape = 1ull << 32, ///< CONTEXT_DEPENDENT_SHAPE_REPRESENTATION
  DefinitionalRepresentation = 1ull << 33,
  Unit = 1ull << 34,
  Measure = 1ull << 35,
  SplineCurve = 1ull << 36,
  SplineSurface = 1ull << 37,
  OtherUsage = 1ull << 38, ///< a relationship of products that places no part by itself
  Document = 1ull << 39,   ///< DOCUMENT_FILE
  DocumentEquivalence = 1ull << 40,
  DocumentReference = 1ull << 41,
  FileIdentification = 1ull << 42, ///< the path of a document's file
};
}

/**
 * One type of record. `Simple` describes the parameters of a simple instance (inherited ones first), `Own`
 * those of its record in a complex instance; null: not checked. A character for each parameter:
 *
 *     .  anything              n  number           p  number above 0       z  number of at least 0
 *     i  integer               b  .T. or .F.       (…)  list of these      ?x  x, or $
 *     c  list of coordinates   other capital letter: a reference to an entity of that role (GetRoleOfLetter)
 */
struct STEPEntityType
{
  const char* Name;
  std::uint64_t Roles;
  const char* Simple;
  const char* Own;
};

/// Returns the description of a type; null for types on which no solid depends.
SMREADERSPART21_EXPORT const STEPEntityType* FindSTEPEntityType(std::string_view name);

/// Returns the roles of which the target of a reference with this letter must have one; 0 for letters that
/// are not references.
std::uint64_t GetRoleOfLetter(char letter);
}

#endif
