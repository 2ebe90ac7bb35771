// What the products of a census declare besides their bodies: triangles in place of faces, shapes in other
// files, quantities.
#include "smSTEPCensusTaker.h"
#include "smSTEPExtent.h"
#include "smSTEPPropertyAttributes.h"

#include <algorithm>
#include <unordered_set>

namespace sm
{
namespace
{
constexpr STEPAttribute FormationOfPart = { "PRODUCT_DEFINITION", 2, 2, "formation" };
constexpr STEPAttribute PartOfFormation = { "PRODUCT_DEFINITION_FORMATION", 2, 2, "product" };
constexpr STEPAttribute IdOfPart = { "PRODUCT", 0, 0, "id" };
constexpr STEPAttribute NameOfPart = { "PRODUCT", 1, 1, "name" };
constexpr STEPAttribute IdOfDocument = { "DOCUMENT", 0, 0, "id" };
constexpr STEPAttribute AssignedId = { "IDENTIFICATION_ASSIGNMENT", 0, 0, "assigned id" };
constexpr STEPAttribute LinkOfTessellation = { "TESSELLATED_SOLID", 1, 2, "geometric link" };
constexpr STEPAttribute UsingProduct = { "PRODUCT_DEFINITION_RELATIONSHIP", 3, 3, "relating product" };
constexpr STEPAttribute UsedProduct = { "PRODUCT_DEFINITION_RELATIONSHIP", 4, 4, "related product" };
constexpr STEPAttribute QuantityOfUsage = { "QUANTIFIED_ASSEMBLY_COMPONENT_USAGE", 0, 6, "quantity" };
}

/// Returns the exact bodies of a group, or of all products with this group if it has none.
std::vector<std::uint32_t> STEPCensusTaker::FindExactBodies(Index group) const
{
  std::vector<std::uint32_t> bodies;
  const auto add = [&](Index of)
  {
    for (auto it = std::lower_bound(
           this->BodiesOfGroups.begin(), this->BodiesOfGroups.end(), std::make_pair(of, std::uint32_t{ 0 }));
         it != this->BodiesOfGroups.end() && it->first == of; ++it)
    {
      const CensusBodyKind kind = this->Census.Bodies[it->second].Kind;
      if (kind == CensusBodyKind::Solid || kind == CensusBodyKind::SurfaceModel)
      {
        bodies.push_back(it->second);
      }
    }
  };
  add(group);
  for (const auto& [product, shape] : this->ShapesOfProducts)
  {
    if (bodies.empty() && shape == group)
    {
      const auto first = std::lower_bound(
        this->ShapesOfProducts.begin(), this->ShapesOfProducts.end(), std::make_pair(product, Index{ 0 }));
      for (auto other = first; other != this->ShapesOfProducts.end() && other->first == product; ++other)
      {
        add(other->second);
      }
    }
  }
  return bodies;
}

/// Returns true if triangles lie beyond the exact bodies next to them, and thus are none of these in other
/// words.
bool STEPCensusTaker::IsElsewhere(Index group, Index tessellation) const
{
  constexpr double slack = 0.1;
  STEPExtent exact;
  for (const std::uint32_t body : this->FindExactBodies(group))
  {
    AddExtent(this->Entities, this->BodyEntities[body], exact);
  }
  STEPExtent triangles;
  AddExtent(this->Entities, tessellation, triangles);
  if (exact.IsEmpty() || triangles.IsEmpty())
  {
    return false;
  }
  const double diagonal = exact.GetDiagonal();
  const double reach = exact.Reach + (exact.IsRevolved ? 2.0 * diagonal : slack * diagonal);
  bool isBeyond = false;
  for (std::size_t c = 0; c < 3; ++c)
  {
    isBeyond =
      isBeyond || triangles.Low[c] < exact.Low[c] - reach || triangles.High[c] > exact.High[c] + reach;
  }
  return isBeyond;
}

bool STEPCensusTaker::IsOfAssembly(const Arc& arc) const
{
  return this->Entities.Has(arc.By, STEPRole::Occurrence);
}

void STEPCensusTaker::FindAlternatives()
{
  const auto isTessellated = [](const CensusBody& body) { return body.Kind == CensusBodyKind::Tessellated; };
  if (std::none_of(this->Census.Bodies.begin(), this->Census.Bodies.end(), isTessellated))
  {
    return;
  }
  const std::vector<bool> exact =
    this->FindAbove({ CensusBodyKind::Solid, CensusBodyKind::SurfaceModel }, false);
  // From products, and shapes of none, without exact faces down to their groups.
  std::vector<bool> lacks(exact.size(), false);
  std::vector<bool> isPart(exact.size(), false);
  for (const Arc& arc : this->Arcs)
  {
    isPart[arc.To] = isPart[arc.To] || !this->IsOfAssembly(arc);
  }
  std::vector<Index> open;
  for (Index i = 0; i < exact.size(); ++i)
  {
    if (this->Counts[i] > 0 && !isPart[i] && !exact[i])
    {
      lacks[i] = true;
      open.push_back(i);
    }
  }
  while (!open.empty())
  {
    const Index from = open.back();
    open.pop_back();
    for (auto arc = std::lower_bound(this->Arcs.begin(), this->Arcs.end(), Arc{ from, 0, 0 });
         arc != this->Arcs.end() && arc->From == from; ++arc)
    {
      if (!this->IsOfAssembly(*arc) && !lacks[arc->To])
      {
        lacks[arc->To] = true;
        open.push_back(arc->To);
      }
    }
  }
  for (std::size_t k = 0; k < this->Census.Bodies.size(); ++k)
  {
    this->Census.Bodies[k].Alternative = isTessellated(this->Census.Bodies[k]);
  }
  for (const auto& [group, index] : this->BodiesOfGroups)
  {
    CensusBody& body = this->Census.Bodies[index];
    const Index link =
      this->Entities.Follow(this->Entities.Get(this->BodyEntities[index], LinkOfTessellation));
    const auto linked = link == None ? this->BodyIndices.end() : this->BodyIndices.find(link);
    const bool isLinked = linked != this->BodyIndices.end() &&
      this->Census.Bodies[linked->second].Kind == CensusBodyKind::Solid &&
      this->Census.Bodies[linked->second].Instances > 0;
    body.Alternative = body.Alternative &&
      (isLinked || (!lacks[group] && !this->IsElsewhere(group, this->BodyEntities[index])));
  }
}

/// Surfaces outside solids are left out, for most of them are none of a part. A product of nothing but closed
/// ones is a part.
void STEPCensusTaker::CheckSurfaces(Index product, const std::vector<std::uint32_t>& bodies)
{
  std::uint64_t closed = 0;
  for (const std::uint32_t index : bodies)
  {
    const CensusBody& body = this->Census.Bodies[index];
    if (body.Kind == CensusBodyKind::Solid || body.Kind == CensusBodyKind::OtherSolid)
    {
      return;
    }
    for (std::uint32_t s = body.FirstShell; s < body.FirstShell + body.NumberOfShells; ++s)
    {
      const CensusShell& shell = this->Census.Shells[this->Census.ShellUses[s].Shell];
      closed = shell.Kind == CensusShellKind::Closed ? shell.Id : closed;
    }
  }
  const auto isSolid = [](const CensusBody& body)
  { return body.Kind == CensusBodyKind::Solid && body.Instances > 0; };
  if (closed != 0 && std::any_of(this->Census.Bodies.begin(), this->Census.Bodies.end(), isSolid))
  {
    this->Add(CensusDefect::SurfaceProduct, product, closed, "closed shell");
  }
}

/// Several representations of one product are its shape in other words, or its parts: the same solid in two
/// of them is the former, as are exact and faceted solids.
void STEPCensusTaker::CheckAlternatives()
{
  const std::vector<std::pair<Index, Index>>& shapes = this->ShapesOfProducts;
  for (std::size_t first = 0, last = 0; first < shapes.size(); first = last)
  {
    const Index product = shapes[first].first;
    bool isExact = false;
    bool isFaceted = false;
    std::vector<std::uint32_t> bodies;
    for (last = first; last < shapes.size() && shapes[last].first == product; ++last)
    {
      const Index group = shapes[last].second;
      isExact = isExact || this->ExactGroups.count(group) > 0;
      isFaceted = isFaceted || this->FacetedGroups.count(group) > 0;
      const auto start = std::lower_bound(
        this->BodiesOfGroups.begin(), this->BodiesOfGroups.end(), std::make_pair(group, std::uint32_t{ 0 }));
      for (auto body = start; body != this->BodiesOfGroups.end() && body->first == group; ++body)
      {
        bodies.push_back(body->second);
      }
    }
    if (isExact && isFaceted && this->Counts[product] > 0)
    {
      this->Add(CensusDefect::AlternativeShape, product);
    }
    std::sort(bodies.begin(), bodies.end());
    if (this->Counts[product] > 0)
    {
      this->CheckSurfaces(product, bodies);
    }
    for (std::size_t k = 1; k < bodies.size(); ++k)
    {
      CensusBody& body = this->Census.Bodies[bodies[k]];
      if (bodies[k] == bodies[k - 1] && body.Kind == CensusBodyKind::Solid && body.Instances != CensusMaximum)
      {
        body.Instances -= this->Counts[product];
        this->Add(CensusDefect::RepeatedItem, product, body.Id, "two shapes of one product");
      }
    }
  }
}

void STEPCensusTaker::CheckVersions()
{
  std::vector<bool> isPart(this->Counts.size(), false);
  for (const Arc& arc : this->Arcs)
  {
    isPart[arc.To] = isPart[arc.To] || this->IsOfAssembly(arc);
  }
  std::unordered_map<Index, Index> roots;
  for (const Index definition : this->Products)
  {
    const Index formation = this->Entities.Follow(this->Entities.Get(definition, FormationOfPart));
    const Index product = this->Entities.Follow(this->Entities.Get(formation, PartOfFormation));
    if (isPart[definition] || !this->SolidsBelow[definition] || product == None)
    {
      continue;
    }
    const auto [root, isFirst] = roots.emplace(product, definition);
    if (!isFirst)
    {
      this->Add(CensusDefect::RepeatedProduct, definition, this->File.GetId(root->second), "of one product");
    }
  }
}

std::string STEPCensusTaker::GetProductName(Index product) const
{
  const Index formation = this->Entities.Follow(this->Entities.Get(product, FormationOfPart));
  const Index base = this->Entities.Follow(this->Entities.Get(formation, PartOfFormation));
  const std::string_view name = this->Entities.Get(base, NameOfPart).Text;
  return std::string(name.empty() ? this->Entities.Get(base, IdOfPart).Text : name);
}

/// Lists the shapes, and the products with theirs.
void STEPCensusTaker::ListProducts()
{
  std::unordered_map<Index, std::size_t> places;
  for (const Index i : this->Representations)
  {
    const Index group = this->Groups[i];
    const auto [place, isNew] = places.emplace(group, this->Census.Shapes.size());
    if (isNew)
    {
      this->Census.Shapes.emplace_back().Instances = this->Counts[group];
    }
    this->Census.Shapes[place->second].Representations.push_back(this->File.GetId(i));
  }
  for (const auto& [occurrence, arc] : this->JoinedItems)
  {
    this->Census.Occurrences[occurrence].MappedItems.push_back(
      { this->File.GetId(arc.By), places.at(arc.To) });
  }
  std::unordered_set<Index> parts;
  for (const Arc& arc : this->Arcs)
  {
    const auto shape = places.find(arc.To);
    if (shape != places.end())
    {
      this->Census.Shapes[shape->second].IsUsed = true;
      const auto whole = places.find(arc.From);
      if (this->Entities.Has(arc.By, STEPRole::Relationship) && whole != places.end())
      {
        this->Census.Shapes[whole->second].Placed.push_back({ this->File.GetId(arc.By), shape->second });
      }
    }
    if (this->IsOfAssembly(arc))
    {
      parts.insert(arc.To);
    }
  }
  for (const Index i : this->Products)
  {
    CensusProduct product;
    product.Id = this->File.GetId(i);
    product.Name = this->GetProductName(i);
    product.Instances = this->Counts[i];
    product.IsPart = parts.count(i) > 0 || (!this->IsMapped.empty() && this->IsMapped[i]);
    for (const Index shape : this->GetShapes(i))
    {
      product.Shapes.push_back(places.at(shape));
    }
    this->Census.Products.push_back(std::move(product));
  }
}

/// Returns the files that documents name for products, their formations, shapes and representations.
std::unordered_map<Part21File::Index, std::string> STEPCensusTaker::FindFilesOfProducts() const
{
  std::unordered_map<Index, std::string> documents;
  const Index count = this->File.GetNumberOfInstances();
  const auto addDocument = [this, &documents](Index i)
  { documents.emplace(i, this->Entities.Get(i, IdOfDocument).Text); };
  for (Index i = 0; i < count; ++i)
  {
    if (this->Entities.Has(i, STEPRole::FileIdentification))
    {
      const std::string_view path = this->Entities.Get(i, AssignedId).Text;
      for (const Index document : this->File.GetReferences(i))
      {
        if (this->Entities.Has(document, STEPRole::Document) && !path.empty())
        {
          documents[document] = path;
        }
      }
    }
    // A document that has a product of its own, whose versions are files.
    if (this->Entities.Has(i, STEPRole::DocumentEquivalence) && this->File.GetReferences(i).size() > 0 &&
      this->File.GetReferences(i)[0] != None)
    {
      addDocument(this->File.GetReferences(i)[0]);
    }
  }
  std::unordered_map<Index, std::string> files;
  for (Index i = 0; i < count; ++i)
  {
    const bool isReference = this->Entities.Has(i, STEPRole::DocumentReference);
    if (!isReference && !this->Entities.Has(i, STEPRole::ProductDefinition))
    {
      continue;
    }
    for (const Index document : this->File.GetReferences(i))
    {
      if (this->Entities.Has(document, STEPRole::Document))
      {
        addDocument(document);
      }
      const auto file = documents.find(document);
      if (file == documents.end())
      {
        continue;
      }
      if (!isReference)
      {
        files.emplace(i, file->second);
      }
      for (const Index item : this->File.GetReferences(i))
      {
        if (isReference && item != None && item != document)
        {
          files.emplace(item, file->second);
        }
      }
      break;
    }
  }
  return files;
}

void STEPCensusTaker::FindShapelessProducts()
{
  const std::vector<bool> hasBody =
    this->FindAbove({ CensusBodyKind::Solid, CensusBodyKind::OtherSolid, CensusBodyKind::SurfaceModel,
                      CensusBodyKind::GeometricSet, CensusBodyKind::Tessellated },
      true);
  std::vector<bool> isWhole(hasBody.size(), false);
  std::vector<Index> products;
  for (const Arc& arc : this->Arcs)
  {
    if (this->IsOfAssembly(arc))
    {
      isWhole[arc.From] = true;
      if (!hasBody[arc.To] && this->Counts[arc.To] > 0)
      {
        products.push_back(arc.To);
      }
    }
  }
  std::sort(products.begin(), products.end());
  products.erase(std::unique(products.begin(), products.end()), products.end());
  const std::unordered_map<Index, std::string> files =
    products.empty() ? std::unordered_map<Index, std::string>() : this->FindFilesOfProducts();
  for (const Index product : products)
  {
    if (isWhole[product])
    {
      continue;
    }
    CensusShapelessProduct shapeless{ this->File.GetId(product), this->GetProductName(product), {} };
    std::vector<Index> places = { product,
      this->Entities.Follow(this->Entities.Get(product, FormationOfPart)) };
    for (auto arc = std::lower_bound(this->Arcs.begin(), this->Arcs.end(), Arc{ product, 0, 0 });
         arc != this->Arcs.end() && arc->From == product; ++arc)
    {
      places.push_back(arc->To);
    }
    for (const Index place : places)
    {
      const auto file = files.find(place);
      shapeless.File = shapeless.File.empty() && file != files.end()
        ? (file->second.empty() ? "without a name" : file->second)
        : shapeless.File;
    }
    this->Census.ShapelessProducts.push_back(std::move(shapeless));
  }
}

void STEPCensusTaker::ReadQuantities()
{
  std::vector<std::pair<std::uint64_t, std::uint64_t>> placed;
  for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
  {
    std::string_view parameters;
    if (!this->Entities.Has(i, STEPRole::OtherUsage) ||
      !this->Entities.FindRecord(i, QuantityOfUsage.Record, parameters))
    {
      continue;
    }
    const Index parent = this->Entities.Follow(this->Entities.Get(i, UsingProduct));
    const Index child = this->Entities.Follow(this->Entities.Get(i, UsedProduct));
    const Index measure = this->Entities.Follow(this->Entities.Get(i, QuantityOfUsage));
    double number = 0.0;
    if (parent == None || child == None || this->Counts[parent] == 0 || !this->SolidsBelow[child] ||
      !this->Entities.FindRecord(measure, "MEASURE_WITH_UNIT", parameters) ||
      !GetPart21Value(GetPart21Value(parameters, 0).Text, 0).GetNumber(number))
    {
      continue;
    }
    if (placed.empty())
    {
      for (const CensusOccurrence& occurrence : this->Census.Occurrences)
      {
        placed.emplace_back(occurrence.Parent, occurrence.Child);
      }
      std::sort(placed.begin(), placed.end());
    }
    const auto range = std::equal_range(
      placed.begin(), placed.end(), std::make_pair(this->File.GetId(parent), this->File.GetId(child)));
    this->Census.Quantities.push_back(
      { this->File.GetId(i), this->File.GetId(parent), this->File.GetId(child), this->GetProductName(child),
        number, static_cast<std::size_t>(range.second - range.first) });
  }
}
}
