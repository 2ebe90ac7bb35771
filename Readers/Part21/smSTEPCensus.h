/**
 * @file smSTEPCensus.h
 * @brief Declarations of a STEP file: its solids with shells and faces, how often each occurs, its units, and
 * damage that matters
 */
#ifndef smSTEPCensus_h
#define smSTEPCensus_h

#include "smPart21File.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace sm
{
/// Kinds of contradictions to the schema or within the file, at entities on which a solid, its placement or
/// its unit depends.
enum class CensusDefect : unsigned char
{
  DamagedEntity,      ///< syntax error, or a number used twice
  UndefinedReference, ///< a reference to nothing
  WrongType,          ///< a reference to an entity of a type that the schema does not allow there
  WrongParameter,     ///< too few or too many parameters, or one of the wrong kind
  ValueOutOfRange,    ///< a radius or weight that is not positive, a direction without length, a number above
                      ///< 1e100
  InconsistentSpline, ///< multiplicities, knots, poles and degree do not fit together
  CyclicReference,    ///< an oriented shell, face or edge, a boundary or a curve that is part of itself
  SharedBound,        ///< a bound of two faces, or twice of one
  ReversedEdge,     ///< a curved edge of a loop that runs against its neighbours: its other part may be meant
  VertexOffSurface, ///< the vertex of a loop without edges is not on the sphere or torus
  CurveOffVertex,   ///< a line, circle or ellipse that does not pass through the vertices of its edge
  ReversedLine,     ///< a straight edge against its loop, or a line or an open spline against its edge: the
                    ///< points are the same
  RepeatedFace,     ///< a face twice in one shell
  RepeatedItem,     ///< a solid twice in one representation; it is counted once
  AlternativeShape, ///< one product has exact and faceted solids in different representations: both are
                    ///< counted
  RepeatedProduct,  ///< several definitions of one product that are parts of nothing: versions, of which each
                    ///< is counted
  SurfaceProduct, ///< a product of closed surfaces without a solid, in a file with solids: its volume is not
                  ///< counted
  UnusedEntity,   ///< a face, bound, loop, shell or solid that nothing uses
  EmptyShell,     ///< a shell without a face
  AssemblyCycle,  ///< a product, or a representation, that contains itself
  MissingPlacement, ///< an occurrence in an assembly without a transformation
  PlacedTwice,      ///< an occurrence that its assembly has as a mapped item, too: both are counted
  PlacedAssembly, ///< a mapped item or relationship that places the shape of an assembly, whose parts are in
                  ///< occurrences: they are not counted there
  PlacedProduct,  ///< a relationship that places the shape of a product in another one, without an
                  ///< occurrence: it is counted there, and where the product occurs
  PlacedAgain,    ///< a relationship of the shapes of an occurrence, which has another placement: it is not
                  ///< counted
  JoinedProducts, ///< representations of two products that a relationship without a transformation makes one
                  ///< shape: both products have the solids of both
  PlacementMismatch, ///< the placement of an occurrence relates representations of other products
  UnreachedBody,     ///< a solid in a representation that no product uses
  MissingUnit,       ///< no length unit, or no angle unit
  WrongUnit,         ///< a unit that is damaged, not positive, or not what its name means
  AbsurdUnit,        ///< a length unit below a nanometre or above a kilometre
  Count
};

struct CensusProblem
{
  CensusDefect Defect = CensusDefect::DamagedEntity;
  /// Number of the entity that has the defect.
  std::uint64_t Id = 0;
  /// Number of the other entity involved: the one referred to, or the second of two; 0: none.
  std::uint64_t Other = 0;
  /// Short description of the parameter or attribute that has the defect; may be empty.
  const char* Place = "";
};

/// A number of instances. Sums and products saturate at the largest value, which stands for "at least so
/// many".
using CensusCount = std::uint64_t;
constexpr CensusCount CensusMaximum = std::numeric_limits<CensusCount>::max();

struct CensusFace
{
  /// Entity number of the face itself, not of an ORIENTED_FACE.
  std::uint64_t Id = 0;
  /// Range of its bounds in STEPCensus::Bounds.
  std::uint32_t FirstBound = 0;
  std::uint32_t NumberOfBounds = 0;
};

enum class CensusShellKind : unsigned char
{
  Closed,
  Open,
  FaceSet
};

struct CensusShell
{
  /// Entity number of the shell itself, not of an ORIENTED_CLOSED_SHELL.
  std::uint64_t Id = 0;
  CensusShellKind Kind = CensusShellKind::Closed;
  /// Range of its faces in STEPCensus::FaceUses, each once.
  std::uint32_t FirstFace = 0;
  std::uint32_t NumberOfFaces = 0;
};

/// A shell as part of a body.
struct CensusShellUse
{
  /// Index into STEPCensus::Shells.
  std::uint32_t Shell = 0;
  /// Entity number of the ORIENTED_CLOSED_SHELL, or of the shell.
  std::uint64_t Id = 0;
  bool Void = false;
};

enum class CensusBodyKind : unsigned char
{
  Solid,        ///< MANIFOLD_SOLID_BREP, BREP_WITH_VOIDS, FACETED_BREP
  OtherSolid,   ///< CSG, swept solids, construction history: declared, but there are no faces to integrate
  SurfaceModel, ///< SHELL_BASED_SURFACE_MODEL, FACE_BASED_SURFACE_MODEL, a shell or a face as an item of its
                ///< own
  GeometricSet, ///< GEOMETRIC_SET, GEOMETRIC_CURVE_SET, wireframes
  Tessellated   ///< triangles
};

struct CensusBody
{
  CensusBodyKind Kind = CensusBodyKind::Solid;
  std::uint64_t Id = 0;
  /// Name as in the file, with '' and \X2\.
  std::string Name;
  std::string Type;
  /// Range of its shells in STEPCensus::ShellUses, the outer one first.
  std::uint32_t FirstShell = 0;
  std::uint32_t NumberOfShells = 0;
  /// Number of faces of all its shells.
  std::uint64_t Faces = 0;
  /// Number of its instances in all products of the file together; 0: no product uses it.
  CensusCount Instances = 0;
  /// Number of representations of which it is an item.
  std::uint32_t Representations = 0;
  /// Number of these that are geometry of construction, which is not a shape of a product.
  std::uint32_t Constructions = 0;
  /// Index into STEPCensus::Contexts of one of these, -1 for none.
  int Context = -1;
  /// kg/m^3, of its product or else of the assemblies that it occurs in; 0: none is stated, or they differ.
  double Density = 0.0;
  bool DensitiesDiffer = false;
  /// True for triangles whose products all have exact faces, too, or that name the solid which they
  /// approximate.
  bool Alternative = false;
};

/// A shape that a mapped item, or a relationship with a transformation, places in another one.
struct CensusPlacedShape
{
  /// Number of the entity that places it.
  std::uint64_t Id = 0;
  /// Index into STEPCensus::Shapes.
  std::size_t Shape = 0;
};

/// Representations that are one shape, by their numbers, in the order of the file.
struct CensusShape
{
  std::vector<std::uint64_t> Representations;
  /// The shapes that relationships place in it, without those that an occurrence places.
  std::vector<CensusPlacedShape> Placed;
  CensusCount Instances = 0;
  /// True if a product has it, or another shape contains it.
  bool IsUsed = false;
};

/// A PRODUCT_DEFINITION.
struct CensusProduct
{
  std::uint64_t Id = 0;
  /// Name of its PRODUCT, or its id if the name is empty, as in the file.
  std::string Name;
  /// Indices into STEPCensus::Shapes.
  std::vector<std::size_t> Shapes;
  CensusCount Instances = 0;
  /// True for a part of another product, by an occurrence or a mapped item.
  bool IsPart = false;
};

/// An occurrence of a product in an assembly: NEXT_ASSEMBLY_USAGE_OCCURRENCE.
struct CensusOccurrence
{
  std::uint64_t Id = 0;
  std::string Name;
  /// Numbers of the PRODUCT_DEFINITIONs; 0 where there is none.
  std::uint64_t Parent = 0;
  std::uint64_t Child = 0;
  /// Entity numbers of the CONTEXT_DEPENDENT_SHAPE_REPRESENTATION and its transformation; 0: none.
  std::uint64_t Placement = 0;
  std::uint64_t Transformation = 0;
  /// The representations of the child and of the parent that the placement relates; 0 if it names others.
  std::uint64_t ChildShape = 0;
  std::uint64_t ParentShape = 0;
  /// True if the placement names that of the parent first.
  bool IsReversed = false;
  /// If it has no placement: the mapped items of shapes of the child into those of the parent, which place
  /// it, one for each shape.
  std::vector<CensusPlacedShape> MappedItems;
  /// Number of instances, that of its parent.
  CensusCount Instances = 0;
  /// True if the product or one below it has a solid.
  bool HasSolids = false;
};

/// A product that occurs in an assembly and has neither a body nor parts.
struct CensusShapelessProduct
{
  /// Number of the PRODUCT_DEFINITION.
  std::uint64_t Id = 0;
  std::string Name;
  /// The file that has its shape, as the file names it; empty for none.
  std::string File;
};

/// QUANTIFIED_ASSEMBLY_COMPONENT_USAGE of a product with solids: how many of it an assembly has, without
/// their positions.
struct CensusQuantity
{
  std::uint64_t Id = 0;
  /// Numbers of the PRODUCT_DEFINITIONs.
  std::uint64_t Parent = 0;
  std::uint64_t Child = 0;
  std::string ChildName;
  double Quantity = 0.0;
  /// Number of occurrences of the child in the parent.
  std::size_t Placed = 0;
};

/// MAPPED_ITEM in a representation that a product uses.
struct CensusMappedItem
{
  std::uint64_t Id = 0;
  /// Numbers of the representations.
  std::uint64_t Parent = 0;
  std::uint64_t Child = 0;
  CensusCount Instances = 0;
  bool HasSolids = false;
};

/// A unit that a context states.
struct CensusUnit
{
  enum class State : unsigned char
  {
    Missing,
    Stated,
    Wrong,
    Absurd
  };
  State Status = State::Missing;
  std::uint64_t Id = 0;
  /// Name of the unit: "MILLI METRE", "INCH".
  std::string Name;
  /// Size of the unit in millimetres or radians; NaN if it is missing or damaged.
  double Factor = std::numeric_limits<double>::quiet_NaN();
};

struct CensusContext
{
  std::uint64_t Id = 0;
  CensusUnit Length;
  CensusUnit Angle;
  /// The largest stated length uncertainty in millimetres, NaN for none, and its entity.
  double Uncertainty = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t UncertaintyId = 0;
  /// True if a solid that a product uses has this context.
  bool Used = false;
};

/// A density that the file states for a product (smSTEPDensities.h).
struct STEPDensity
{
  /// Number of the PRODUCT_DEFINITION that has it.
  std::uint64_t Product = 0;
  /// Number of the item with the value.
  std::uint64_t Id = 0;
  /// kg/m^3; 0 when the statement cannot be used.
  double Density = 0.0;
  /// The reason why it cannot be used; empty otherwise.
  std::string Problem;
  /// Other statements that are not used, as a sentence each; empty if there are none.
  std::string Others;
  /// True if statements of equal rank differ, so that there is no density, not even that of an assembly.
  bool Contradicted = false;
};

/// The deepest chain of entities of which each contains the next one.
struct CensusDepth
{
  std::size_t Levels = 0;
  /// Number of an entity at its end: the innermost product or representation, or the outermost geometric
  /// entity.
  std::uint64_t Id = 0;
};

/// Uses of an entity, as bits.
namespace CensusUse
{
enum Bit : unsigned char
{
  /// Geometry or topology of a body that a product uses.
  Geometry = 1,
  /// Geometry of a body that none uses.
  UnusedGeometry = 2,
  /// Products, occurrences, placements, representations.
  Structure = 4,
  Units = 8
};
}

/**
 * The census of a file, made from its entities alone. It lists everything for which a reader has to account:
 *
 * - Bodies: items of representations. A product uses a representation by SHAPE_DEFINITION_REPRESENTATION of a
 * PRODUCT_DEFINITION; representations that a SHAPE_REPRESENTATION_RELATIONSHIP without transformation relates
 * are one shape. A NEXT_ASSEMBLY_USAGE_OCCURRENCE places a product in another one; a MAPPED_ITEM, and a
 * relationship with a transformation that belongs to no occurrence, place a representation in another one.
 * Products that no occurrence has as its child, and whose shapes are not mapped into those of other products,
 * are roots and occur once; a product occurs as often as all its parents together. An occurrence without a
 * placement and a mapped item of its shape are one. In a file without a SHAPE_DEFINITION_REPRESENTATION
 * representations that no other uses are the roots.
 * - Problems, only at entities that bodies, structure or units depend on: damage elsewhere, for example in
 * text annotations, is not reported. The parameters of all geometric entities below a face are checked
 * against ISO 10303-42: number, kind, type of what they refer to, ranges, and for splines that knots,
 * multiplicities, poles and degree agree. Not checked are the positions of curves and of points relative to
 * each other, which readers check as they make them and add (AddProblem), and validation rules of the schemas
 * beyond those named.
 *
 * Time and memory are linear in the file (a file of 2^17 leaves in 17 levels takes no more than its 34
 * occurrences), and there is no recursion over the depth of the file. Only std::bad_alloc is thrown.
 */
struct SMREADERSPART21_EXPORT STEPCensus
{
  /// Largest number of problems of each kind that are listed; all are counted.
  static constexpr std::size_t ProblemLimit = 100;

  std::vector<CensusBody> Bodies;
  std::vector<CensusShellUse> ShellUses;
  std::vector<CensusShell> Shells;
  /// Indices into Faces, and whether the shell uses the face against its sense, by ORIENTED_FACE.
  std::vector<std::uint32_t> FaceUses;
  std::vector<bool> IsReversedUse;
  std::vector<CensusFace> Faces;
  std::vector<std::uint64_t> Bounds;
  std::vector<CensusShape> Shapes;
  /// In the order of the file.
  std::vector<CensusProduct> Products;
  std::vector<CensusOccurrence> Occurrences;
  std::vector<CensusMappedItem> MappedItems;
  std::vector<CensusShapelessProduct> ShapelessProducts;
  std::vector<CensusQuantity> Quantities;
  std::vector<CensusContext> Contexts;
  /// At most one for each product, by the product's number.
  std::vector<STEPDensity> Densities;
  std::vector<CensusProblem> Problems;
  /// All problems of geometry that may crash or hang a reader that relies on the schema: an entity that is
  /// part of itself, a trim curve of a wrong type, a placement with too few parameters, a number above 1e100,
  /// a radius of 0.
  std::vector<CensusProblem> Perils;
  std::array<std::size_t, static_cast<std::size_t>(CensusDefect::Count)> Counts{};
  /// Bits of CensusUse for every instance of the file.
  std::vector<unsigned char> Uses;
  /// Products and representations in one another, and entities of bodies that refer to one another: readers
  /// that recurse over them need a stack for so many levels.
  CensusDepth Assemblies;
  CensusDepth Geometry;
  /// True if the file has no product with a shape, so that the roots are representations.
  bool WithoutProducts = false;

  /// Counts a problem, and lists it if it is among the first of its kind.
  void AddProblem(CensusDefect defect, std::uint64_t id, std::uint64_t other, const char* place);
  std::size_t GetNumberOfProblems(CensusDefect defect) const
  {
    return this->Counts[static_cast<std::size_t>(defect)];
  }
  /// Returns the number of bodies of a kind that occur at least once.
  std::size_t CountBodies(CensusBodyKind kind) const;
  /// Returns the number of instances of bodies of a kind.
  CensusCount CountInstances(CensusBodyKind kind) const;
  /// Returns the number of nodes of the expanded product tree: instances of bodies with faces, and of the
  /// products and representations above them.
  CensusCount CountNodes() const;
  /// Returns the number of faces in the shells of bodies of a kind that occur; a face of two shells counts
  /// twice.
  std::uint64_t CountFaces(CensusBodyKind kind) const;
};

SMREADERSPART21_EXPORT STEPCensus TakeSTEPCensus(const Part21File& file);

/// Returns a short description of a kind: "undefined reference".
SMREADERSPART21_EXPORT const char* GetName(CensusDefect defect);

/// Returns a + b, or the largest value if the sum exceeds it.
inline CensusCount AddCounts(CensusCount a, CensusCount b)
{
  return a > CensusMaximum - b ? CensusMaximum : a + b;
}
}

#endif
