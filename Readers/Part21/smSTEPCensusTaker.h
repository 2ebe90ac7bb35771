/**
 * @file smSTEPCensusTaker.h
 * @brief The steps by which a census is taken; not installed
 */
#ifndef smSTEPCensusTaker_h
#define smSTEPCensusTaker_h

#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"

#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sm
{
/// Takes a census step by step; each step uses the results of those before it.
class STEPCensusTaker
{
public:
  using Index = Part21File::Index;
  static constexpr Index None = Part21File::None;

  explicit STEPCensusTaker(const Part21File& file)
    : File(file)
    , Entities(file)
    , Groups(file.GetNumberOfInstances())
  {
  }
  STEPCensus Take();

private:
  /// An arc of the product structure, from a product or shape to another one that it contains.
  struct Arc
  {
    Index From;
    Index To;
    /// The occurrence, mapped item or relationship that states it.
    Index By;
    bool operator<(const Arc& other) const
    {
      return this->From != other.From ? this->From < other.From : this->To < other.To;
    }
  };
  /// An entry of the stack of WalkBodies(). Entities below a trim curve are two-dimensional.
  struct Step
  {
    Index Entity;
    bool Flat;
  };

  void Add(CensusDefect defect, Index entity, std::uint64_t other = 0, const char* place = "");
  /// Returns the entity to which an attribute refers, if it has one of the roles; else adds a problem and
  /// returns None.
  Index Follow(Index from, const STEPAttribute& attribute, std::uint64_t roles);
  Index Follow(Index from, const Part21Value& value, std::uint64_t roles, const char* place);
  void Use(Index i, unsigned char use) { this->Census.Uses[i] |= use; }

  // smSTEPStructure.cxx: products and shapes
  void SortEntities();
  void FindPlacements();
  void CheckPlacement(CensusOccurrence& occurrence, Index placement);
  bool IsShapeOf(Index representation, Index product) const;
  void JoinShapes();
  Index FindGroup(Index representation);
  void AddArcs();
  void AddOccurrence(Index i);
  void AddShapes(Index i);
  void AddItems(Index representation);
  void AddPlacedShapes();
  std::vector<Index> GetShapes(Index product) const;
  void MarkStructure();
  void CheckFrame(Index user, Index placement);
  void ReportDamagedStructure();

  // smSTEPInstances.cxx: numbers of instances of products and shapes
  void CountAll();
  void JoinMappedOccurrences();
  void FindMappedProducts();
  void PassDensity(Index from, Index to);
  const STEPDensity* FindDensity(Index product) const;
  /// Marks groups with a body of one of these kinds, and what they are part of; `intoAssemblies`: assemblies,
  /// too.
  std::vector<bool> FindAbove(const std::vector<CensusBodyKind>& kinds, bool intoAssemblies) const;
  void ReportCycles();
  std::vector<bool> FindRead() const;
  void SetInstances();
  void CheckTwicePlaced();
  void CheckPlacedProducts();
  void CheckJoinedProducts();

  // smSTEPComponents.cxx: what products declare besides their bodies
  bool IsOfAssembly(const Arc& arc) const;
  void FindAlternatives();
  bool IsElsewhere(Index group, Index tessellation) const;
  std::vector<std::uint32_t> FindExactBodies(Index group) const;
  void CheckAlternatives();
  void CheckVersions();
  void CheckSurfaces(Index product, const std::vector<std::uint32_t>& bodies);
  void FindShapelessProducts();
  std::unordered_map<Index, std::string> FindFilesOfProducts() const;
  std::string GetProductName(Index product) const;
  void ListProducts();
  void ReadQuantities();

  // smSTEPBodies.cxx: bodies, shells, faces
  void AddBodies();
  void AddItem(Index representation, Index item, std::vector<Index>& bodies);
  std::uint32_t AddBody(Index item);
  void AddShells(CensusBody& body, Index item);
  void AddShellUse(Index user, const Part21Value& value, bool isVoid, const char* place);
  std::uint32_t AddShell(Index shell);
  std::uint32_t AddFace(Index face);
  /// Returns the shell or face to which a chain of oriented ones refers.
  Index Unwrap(Index i, const STEPAttribute& element, const char* oriented);
  void FindUnused();
  void CheckBounds();

  // smSTEPDependence.cxx: the entities on which bodies depend, and their damage
  void WalkBodies();
  void Walk(std::vector<Step>& open, unsigned char use);
  void FindCycles();
  /// Adds a problem of geometry, also to Perils.
  void AddPeril(CensusDefect defect, Index entity, std::uint64_t other, const char* place);
  void Visit(Index i, bool flat);
  void CheckRecord(Index i, std::string_view parameters, const char* signature, bool flat);
  const char* CheckList(Index i, std::string_view text, const char* signature, bool flat);
  bool CheckValue(Index i, const Part21Value& value, char kind);
  void CheckCoordinates(Index i, const Part21Value& value, bool flat);
  void CheckLocation(Index placement);
  void CheckSplineCurve(Index i);
  void CheckSplineSurface(Index i);

  // smSTEPUnits.cxx
  int AddContext(Index representation);
  void ReadUnits(Index context, CensusContext& result);
  CensusUnit ReadLengthUnit(Index unit);
  void ReadUncertainty(Index context, CensusContext& result);
  void ReportUnits();

  const Part21File& File;
  STEPAttributes Entities;
  STEPCensus Census;

  std::vector<Index> Representations;
  std::vector<Index> Products;
  std::vector<Index> Relationships;
  std::vector<Index> ShapeDefinitions;
  std::vector<Index> OccurrenceShapes;
  std::vector<Index> OccurrenceEntities;

  /// Union-find over representations that are one shape.
  std::vector<Index> Groups;
  /// Arcs from products and shapes, sorted.
  std::vector<Arc> Arcs;
  /// (product, shape) pairs, sorted.
  std::vector<std::pair<Index, Index>> ShapesOfProducts;
  /// Number of instances of each product and, at its group's entity, of each shape.
  std::vector<CensusCount> Counts;
  /// Density of each product and shape: its own, else that of the assemblies that contain it; 0: none, NaN:
  /// these differ, -1: not known yet.
  std::vector<double> DensitiesOfEntities;
  /// Placement (OccurrenceShape) of each occurrence, and the relationships that belong to one.
  std::unordered_map<Index, Index> Placements;
  std::vector<bool> Placing;
  /// Bodies by shape: (group, body index), and occurrences' and mapped items' entities.
  std::vector<std::pair<Index, std::uint32_t>> BodiesOfGroups;
  std::vector<Index> BodyEntities;
  /// Shapes of which a representation has faceted solids only, and shapes with others.
  std::set<Index> FacetedGroups;
  std::set<Index> ExactGroups;
  std::vector<std::pair<Index, std::uint32_t>> MappedFrom;
  std::vector<bool> SolidsBelow;
  /// The first product that each representation is the shape of.
  std::map<Index, Index> ProductsOfRepresentations;
  /// Representations of bodies, by the bodies' indices, whose context was not found.
  std::map<std::uint32_t, Index> WithoutContext;
  /// Relationships between the shapes of an occurrence that are not its placement.
  std::vector<Arc> FurtherPlacements;
  /// Occurrences by their places in the census, and the arcs of the mapped items that place them.
  std::vector<std::pair<std::size_t, Arc>> JoinedItems;
  /// Products that are parts by mapped items alone, and the product of each of their shapes; empty if there
  /// are no mapped items.
  std::vector<bool> IsMapped;
  std::unordered_map<Index, Index> MappedOwners;

  std::unordered_map<Index, std::uint32_t> BodyIndices;
  std::unordered_map<Index, std::uint32_t> ShellIndices;
  std::unordered_map<Index, std::uint32_t> FaceIndices;
  std::vector<Index> FaceEntities;
  std::unordered_map<Index, int> ContextIndices;
  std::vector<unsigned char> Visited;
};
}

#endif
