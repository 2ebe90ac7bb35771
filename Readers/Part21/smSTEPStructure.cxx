// Finds the products, occurrences and shapes of a census, and their relations.
#include "smSTEPCensusTaker.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPStructureAttributes.h"

#include <algorithm>
#include <set>
#include <unordered_set>

namespace sm
{
namespace
{
constexpr STEPAttribute RelatingProduct = { "PRODUCT_DEFINITION_RELATIONSHIP", 3, 3, "relating product" };
constexpr STEPAttribute RelatedProduct = { "PRODUCT_DEFINITION_RELATIONSHIP", 4, 4, "related product" };
constexpr STEPAttribute ItemsOfTransformation[] = { { "ITEM_DEFINED_TRANSFORMATION", 2, 2, "first item" },
  { "ITEM_DEFINED_TRANSFORMATION", 3, 3, "second item" } };
constexpr STEPAttribute OccurrenceId = { "PRODUCT_DEFINITION_RELATIONSHIP", 0, 0, "id" };
constexpr STEPAttribute OccurrenceName = { "PRODUCT_DEFINITION_RELATIONSHIP", 1, 1, "name" };
constexpr STEPAttribute RepresentationOfShape = { "PROPERTY_DEFINITION_REPRESENTATION", 1, 1,
  "representation" };
constexpr STEPAttribute PlacingRelation = { "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", 0, 0, "relationship" };
constexpr STEPAttribute PlacedShape = { "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", 1, 1, "product shape" };

bool HasTransformation(const STEPAttributes& entities, Part21File::Index relationship)
{
  std::string_view parameters;
  return entities.FindRecord(relationship, OperatorOfRelationship.Record, parameters);
}
}

void STEPCensusTaker::SortEntities()
{
  for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
  {
    this->Groups[i] = i;
    const std::uint64_t roles = this->Entities.GetRoles(i);
    const std::pair<std::uint64_t, std::vector<Index>*> lists[] = {
      { STEPRole::ProductDefinition, &this->Products }, { STEPRole::Relationship, &this->Relationships },
      { STEPRole::ShapeDefinition, &this->ShapeDefinitions },
      { STEPRole::OccurrenceShape, &this->OccurrenceShapes },
      { STEPRole::Occurrence, &this->OccurrenceEntities }
    };
    for (const auto& [role, list] : lists)
    {
      if (roles & role)
      {
        list->push_back(i);
      }
    }
    if ((roles & STEPRole::Representation) && !(roles & STEPRole::DefinitionalRepresentation))
    {
      this->Representations.push_back(i);
    }
  }
}

void STEPCensusTaker::FindPlacements()
{
  this->Placing.assign(this->File.GetNumberOfInstances(), false);
  for (const Index i : this->OccurrenceShapes)
  {
    const Index relation = this->Follow(i, PlacingRelation, STEPRole::Relationship);
    const Index shape = this->Follow(i, PlacedShape, STEPRole::ProductShape);
    const Index used =
      shape == None ? None : this->Entities.Follow(this->Entities.Get(shape, DefinitionOfProperty));
    const bool isOther = this->Entities.Has(used, STEPRole::OtherUsage);
    const Index occurrence =
      shape == None || isOther ? None : this->Follow(shape, DefinitionOfProperty, STEPRole::Occurrence);
    if (relation != None)
    {
      this->Placing[relation] = true;
    }
    if (isOther && relation != None && HasTransformation(this->Entities, relation))
    {
      // A usage that is not an occurrence, or another place for one instance in a part of the assembly.
      this->Add(
        CensusDefect::PlacementMismatch, used, this->File.GetId(i), "a usage of a type that is not read");
    }
    if (occurrence != None && !this->Placements.emplace(occurrence, i).second)
    {
      this->Add(CensusDefect::PlacementMismatch, occurrence, this->File.GetId(i), "a second placement");
    }
  }
}

STEPCensusTaker::Index STEPCensusTaker::FindGroup(Index representation)
{
  Index i = representation;
  while (this->Groups[i] != i)
  {
    // Path halving keeps chains short.
    this->Groups[i] = this->Groups[this->Groups[i]];
    i = this->Groups[i];
  }
  return i;
}

void STEPCensusTaker::JoinShapes()
{
  for (const Index i : this->Relationships)
  {
    if (!this->Entities.Has(i, STEPRole::ShapeRelationship) || this->Placing[i] ||
      HasTransformation(this->Entities, i))
    {
      continue;
    }
    const Index first = this->Follow(i, FirstRepresentation, STEPRole::Representation);
    const Index second = this->Follow(i, SecondRepresentation, STEPRole::Representation);
    if (first != None && second != None)
    {
      this->Use(i, CensusUse::Structure);
      // The smaller index becomes the representative. Chains remain short, since files mostly relate
      // neighbouring entities.
      const std::pair<Index, Index> groups = std::minmax({ this->FindGroup(first), this->FindGroup(second) });
      this->Groups[groups.second] = groups.first;
    }
  }
}

void STEPCensusTaker::AddShapes(Index i)
{
  const Index shape = this->Follow(i, RepresentedProperty, STEPRole::ProductShape);
  const Index product =
    shape == None ? None : this->Entities.Follow(this->Entities.Get(shape, DefinitionOfProperty));
  if (shape == None || (product != None && !this->Entities.Has(product, STEPRole::ProductDefinition)))
  {
    // The shape of a feature or of an occurrence, not of a product.
    return;
  }
  const Index representation = this->Follow(i, RepresentationOfShape, STEPRole::Representation);
  if (product == None)
  {
    this->Follow(shape, DefinitionOfProperty, STEPRole::ProductDefinition);
    return;
  }
  this->Use(i, CensusUse::Structure);
  this->Use(shape, CensusUse::Structure);
  if (representation != None)
  {
    this->ShapesOfProducts.emplace_back(product, this->FindGroup(representation));
    this->ProductsOfRepresentations.emplace(representation, product);
  }
}

void STEPCensusTaker::AddOccurrence(Index i)
{
  const Index parent = this->Follow(i, RelatingProduct, STEPRole::ProductDefinition);
  const Index child = this->Follow(i, RelatedProduct, STEPRole::ProductDefinition);
  CensusOccurrence occurrence;
  occurrence.Id = this->File.GetId(i);
  const Part21Value name = this->Entities.Get(i, OccurrenceName);
  occurrence.Name = name.Text.empty() ? this->Entities.Get(i, OccurrenceId).Text : name.Text;
  occurrence.Parent = parent == None ? 0 : this->File.GetId(parent);
  occurrence.Child = child == None ? 0 : this->File.GetId(child);
  if (parent != None && child != None)
  {
    this->Arcs.push_back({ parent, child, i });
  }
  const auto placement = this->Placements.find(i);
  if (placement != this->Placements.end())
  {
    this->CheckPlacement(occurrence, placement->second);
  }
  this->Census.Occurrences.push_back(std::move(occurrence));
}

bool STEPCensusTaker::IsShapeOf(Index representation, Index product) const
{
  const auto first = std::lower_bound(
    this->ShapesOfProducts.begin(), this->ShapesOfProducts.end(), std::make_pair(product, Index{ 0 }));
  if (first == this->ShapesOfProducts.end() || first->first != product)
  {
    // A product without a shape is not a contradiction.
    return true;
  }
  return std::binary_search(
    first, this->ShapesOfProducts.end(), std::make_pair(product, this->Groups[representation]));
}

void STEPCensusTaker::CheckPlacement(CensusOccurrence& occurrence, Index placement)
{
  const Index i = this->File.Find(occurrence.Id);
  const Index relation = this->Entities.Follow(this->Entities.Get(placement, PlacingRelation));
  occurrence.Placement = this->File.GetId(placement);
  this->Use(placement, CensusUse::Structure);
  if (!this->Entities.Has(relation, STEPRole::Relationship))
  {
    return;
  }
  this->Use(relation, CensusUse::Structure);
  if (HasTransformation(this->Entities, relation))
  {
    const Index transformation = this->Follow(relation, OperatorOfRelationship, STEPRole::Transformation);
    occurrence.Transformation = transformation == None ? 0 : this->File.GetId(transformation);
  }
  else
  {
    this->Add(CensusDefect::MissingPlacement, i, occurrence.Placement, "no transformation");
  }
  const Index first = this->Follow(relation, FirstRepresentation, STEPRole::Representation);
  const Index second = this->Follow(relation, SecondRepresentation, STEPRole::Representation);
  const Index parent = this->File.Find(occurrence.Parent);
  const Index child = this->File.Find(occurrence.Child);
  if (first == None || second == None || occurrence.Parent == 0 || occurrence.Child == 0)
  {
    return;
  }
  const bool forward = this->IsShapeOf(first, child) && this->IsShapeOf(second, parent);
  const bool backward = this->IsShapeOf(first, parent) && this->IsShapeOf(second, child);
  occurrence.IsReversed = !forward && backward;
  if (forward || backward)
  {
    occurrence.ChildShape = this->File.GetId(occurrence.IsReversed ? second : first);
    occurrence.ParentShape = this->File.GetId(occurrence.IsReversed ? first : second);
  }
  else
  {
    this->Add(CensusDefect::PlacementMismatch, i, occurrence.Placement, "representations of other products");
  }
}

/// Returns the shapes of a product.
std::vector<STEPCensusTaker::Index> STEPCensusTaker::GetShapes(Index product) const
{
  std::vector<Index> shapes;
  for (auto found = std::lower_bound(
         this->ShapesOfProducts.begin(), this->ShapesOfProducts.end(), std::make_pair(product, Index{ 0 }));
       found != this->ShapesOfProducts.end() && found->first == product; ++found)
  {
    shapes.push_back(found->second);
  }
  return shapes;
}

void STEPCensusTaker::AddItems(Index representation)
{
  Part21Values items(this->Entities.Get(representation, ItemsOfRepresentation).Text);
  std::unordered_set<Index> mappedItems;
  for (Part21Value value; items.Next(value);)
  {
    const Index item = this->Entities.Follow(value);
    if (!this->Entities.Has(item, STEPRole::MappedItem))
    {
      continue;
    }
    if (!mappedItems.insert(item).second)
    {
      this->Add(
        CensusDefect::RepeatedItem, representation, this->File.GetId(item), ItemsOfRepresentation.Name);
      continue;
    }
    const Index map = this->Entities.Follow(this->Entities.Get(item, MappingSource));
    const Index mapped =
      map == None ? None : this->Entities.Follow(this->Entities.Get(map, MappedRepresentation));
    if (this->Entities.Has(map, STEPRole::RepresentationMap) &&
      this->Entities.Has(mapped, STEPRole::Representation))
    {
      this->Arcs.push_back({ this->FindGroup(representation), this->FindGroup(mapped), item });
      this->MappedFrom.emplace_back(
        representation, static_cast<std::uint32_t>(this->Census.MappedItems.size()));
      CensusMappedItem& result = this->Census.MappedItems.emplace_back();
      result.Id = this->File.GetId(item);
      result.Parent = this->File.GetId(representation);
      result.Child = this->File.GetId(mapped);
    }
  }
}

void STEPCensusTaker::AddArcs()
{
  for (const Index i : this->ShapeDefinitions)
  {
    this->AddShapes(i);
  }
  for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
  {
    this->Groups[i] = this->FindGroup(i);
  }
  std::sort(this->ShapesOfProducts.begin(), this->ShapesOfProducts.end());
  this->ShapesOfProducts.erase(
    std::unique(this->ShapesOfProducts.begin(), this->ShapesOfProducts.end()), this->ShapesOfProducts.end());
  for (const auto& [product, group] : this->ShapesOfProducts)
  {
    this->Arcs.push_back({ product, group, None });
  }
  for (const Index i : this->OccurrenceEntities)
  {
    this->AddOccurrence(i);
  }
  for (const Index i : this->Representations)
  {
    this->AddItems(i);
  }
  this->AddPlacedShapes();
  this->JoinMappedOccurrences();
  this->FindMappedProducts();
  std::sort(this->Arcs.begin(), this->Arcs.end());
}

/// Adds arcs for shapes that a relationship places in others, unless an occurrence of their products states
/// the same.
void STEPCensusTaker::AddPlacedShapes()
{
  const auto findShape = [this](Index product)
  {
    const auto found = std::lower_bound(
      this->ShapesOfProducts.begin(), this->ShapesOfProducts.end(), std::make_pair(product, Index{ 0 }));
    return found != this->ShapesOfProducts.end() && found->first == product ? found->second : None;
  };
  std::set<std::pair<Index, Index>> known;
  for (const Arc& arc : this->Arcs)
  {
    if (arc.By != None && this->Entities.Has(arc.By, STEPRole::Occurrence))
    {
      known.emplace(findShape(arc.From), findShape(arc.To));
    }
  }
  for (const Index i : this->Relationships)
  {
    if (this->Placing[i] || !HasTransformation(this->Entities, i) ||
      !this->Entities.Has(i, STEPRole::ShapeRelationship))
    {
      continue;
    }
    const Index part = this->Follow(i, FirstRepresentation, STEPRole::Representation);
    const Index whole = this->Follow(i, SecondRepresentation, STEPRole::Representation);
    if (part == None || whole == None)
    {
      continue;
    }
    const Arc arc = { this->FindGroup(whole), this->FindGroup(part), i };
    (known.count({ arc.From, arc.To }) > 0 ? this->FurtherPlacements : this->Arcs).push_back(arc);
  }
}

/// A placement that is not a frame in space places nothing: OpenCASCADE takes none for it.
void STEPCensusTaker::CheckFrame(Index user, Index placement)
{
  std::string_view record;
  if (this->Entities.Has(placement, STEPRole::Placement) &&
    !this->Entities.FindRecord(placement, "AXIS2_PLACEMENT_3D", record))
  {
    this->Add(CensusDefect::WrongType, user, this->File.GetId(placement));
  }
}

/// Marks the entities of the structure on which products with solids depend, and reports their damage.
/// Placements are added to the stack of WalkBodies().
void STEPCensusTaker::MarkStructure()
{
  std::vector<Step> placements;
  const auto addPlacement = [this, &placements](Index i)
  {
    if (i != None)
    {
      placements.push_back({ i, false });
    }
  };
  for (const Index i : this->Representations)
  {
    if (this->Counts[this->FindGroup(i)] == 0)
    {
      continue;
    }
    this->Use(i, CensusUse::Structure);
    const Part21Value list = this->Entities.Get(i, ItemsOfRepresentation);
    if (!list.IsList())
    {
      this->Add(CensusDefect::WrongParameter, i, 0, ItemsOfRepresentation.Name);
    }
    Part21Values items(list.Text);
    for (Part21Value value; items.Next(value);)
    {
      const Index item = this->Follow(i, value, ~std::uint64_t{ 0 }, ItemsOfRepresentation.Name);
      if (this->Entities.Has(item, STEPRole::MappedItem))
      {
        this->Use(item, CensusUse::Structure);
        const Index map = this->Follow(item, MappingSource, STEPRole::RepresentationMap);
        const Index target =
          this->Follow(item, MappingTarget, STEPRole::Placement | STEPRole::Transformation);
        addPlacement(target);
        this->CheckFrame(item, target);
        if (map != None)
        {
          this->Use(map, CensusUse::Structure);
          this->Follow(map, MappedRepresentation, STEPRole::Representation);
          const Index origin = this->Follow(map, MappingOrigin, STEPRole::Placement);
          addPlacement(origin);
          this->CheckFrame(map, origin);
        }
      }
    }
  }
  const auto addTransformation = [&](Index transformation)
  {
    addPlacement(transformation);
    for (const STEPAttribute& item : ItemsOfTransformation)
    {
      this->CheckFrame(transformation, this->Entities.Follow(this->Entities.Get(transformation, item)));
    }
  };
  for (const Arc& arc : this->Arcs)
  {
    if (this->Entities.Has(arc.By, STEPRole::Relationship) && this->Counts[arc.From] > 0)
    {
      this->Use(arc.By, CensusUse::Structure);
      addTransformation(this->Follow(arc.By, OperatorOfRelationship, STEPRole::Transformation));
    }
  }
  for (std::size_t k = 0; k < this->Census.Occurrences.size(); ++k)
  {
    const CensusOccurrence& occurrence = this->Census.Occurrences[k];
    this->Use(this->OccurrenceEntities[k], CensusUse::Structure);
    if (occurrence.Transformation != 0)
    {
      addTransformation(this->File.Find(occurrence.Transformation));
    }
  }
  for (const Index i : this->Products)
  {
    this->Use(i, CensusUse::Structure);
  }
  this->ReportDamagedStructure();
  this->Walk(placements, CensusUse::Structure);
}

/// Undefined references have been reported where they were followed; those of a product, by which its name is
/// found, are not.
void STEPCensusTaker::ReportDamagedStructure()
{
  for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
  {
    if (!(this->Census.Uses[i] & CensusUse::Structure) || !this->File.IsDamaged(i))
    {
      continue;
    }
    const Part21Range<Index> references = this->File.GetReferences(i);
    if (std::find(references.begin(), references.end(), None) == references.end())
    {
      this->Add(CensusDefect::DamagedEntity, i);
    }
    else if (this->Entities.Has(i, STEPRole::ProductDefinition))
    {
      this->Add(CensusDefect::UndefinedReference, i);
    }
  }
}
}
