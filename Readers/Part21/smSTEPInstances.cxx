// Numbers of instances and densities of the products and shapes of a census.
#include "smSTEPCensusTaker.h"
#include "smSTEPDensities.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <unordered_set>

namespace sm
{
namespace
{
/// Marks a density that has not been determined.
constexpr double Unknown = -1.0;

/// Joins the densities that an entity gets from two assemblies: the common value, or NaN if they differ.
void JoinDensity(double passed, double& density)
{
  density = density == Unknown || density == passed ? passed : std::numeric_limits<double>::quiet_NaN();
}
}

/// A product's own density takes precedence over those of the assemblies that contain it.
void STEPCensusTaker::PassDensity(Index from, Index to)
{
  // That of a product whose shape is mapped, too.
  const auto mapped = this->MappedOwners.find(to);
  const STEPDensity* own = mapped == this->MappedOwners.end() ? nullptr : this->FindDensity(mapped->second);
  own = own ? own : this->FindDensity(from);
  // std::max with NaN as its first argument returns NaN.
  const double passed = own ? own->Density : std::max(this->DensitiesOfEntities[from], 0.0);
  JoinDensity(passed, this->DensitiesOfEntities[to]);
}

/// Returns what the file states about the density of a product; null if it states nothing that counts.
const STEPDensity* STEPCensusTaker::FindDensity(Index product) const
{
  const std::vector<STEPDensity>& stated = this->Census.Densities;
  const auto own = std::lower_bound(stated.begin(), stated.end(), this->File.GetId(product),
    [](const STEPDensity& density, std::uint64_t id) { return density.Product < id; });
  const bool states = own != stated.end() && own->Product == this->File.GetId(product);
  return states && (own->Density > 0.0 || own->Contradicted) ? &*own : nullptr;
}

/**
 * Finds the products without occurrences of others whose shapes are mapped into those of other products: they
 * are parts of these, although no occurrence says so. Each shape gets at most two of the products whose
 * shapes it is mapped into, directly or through others.
 */
void STEPCensusTaker::FindMappedProducts()
{
  std::vector<Arc> mapped;
  std::unordered_set<Index> assemblies;
  for (const Arc& arc : this->Arcs)
  {
    if (this->Entities.Has(arc.By, STEPRole::MappedItem) && arc.From != arc.To)
    {
      mapped.push_back(arc);
    }
    if (this->IsOfAssembly(arc))
    {
      assemblies.insert(arc.From);
    }
  }
  this->IsMapped.assign(mapped.empty() ? 0 : this->File.GetNumberOfInstances(), false);
  if (mapped.empty())
  {
    return;
  }
  std::sort(mapped.begin(), mapped.end());
  std::unordered_map<Index, std::array<Index, 2>> wholes;
  std::vector<std::pair<Index, Index>> open;
  const auto pass = [&](Index shape, Index product)
  {
    for (auto arc = std::lower_bound(mapped.begin(), mapped.end(), Arc{ shape, 0, 0 });
         arc != mapped.end() && arc->From == shape; ++arc)
    {
      std::array<Index, 2>& found =
        wholes.try_emplace(arc->To, std::array<Index, 2>{ None, None }).first->second;
      Index& place = found[0] == None || found[0] == product ? found[0] : found[1];
      if (place == None)
      {
        place = product;
        open.emplace_back(arc->To, product);
      }
    }
  };
  for (const auto& [product, shape] : this->ShapesOfProducts)
  {
    pass(shape, product);
    while (!open.empty())
    {
      const auto [part, whole] = open.back();
      open.pop_back();
      pass(part, whole);
    }
  }
  for (const auto& [product, shape] : this->ShapesOfProducts)
  {
    const auto found = wholes.find(shape);
    const bool isPart = found != wholes.end() &&
      ((found->second[0] != None && found->second[0] != product) ||
        (found->second[1] != None && found->second[1] != product));
    if (isPart && assemblies.count(product) == 0)
    {
      this->IsMapped[product] = true;
      this->MappedOwners.emplace(shape, product);
    }
  }
}

/// Joins occurrences without a placement with the mapped items that place them: for each shape of the part,
/// one into a shape of the assembly. An item of several shapes, or of a shape that several products or other
/// shapes have, is not joined: it belongs to all of them.
void STEPCensusTaker::JoinMappedOccurrences()
{
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> mapped;
  std::unordered_map<Index, int> users;
  for (const auto& [product, shape] : this->ShapesOfProducts)
  {
    ++users[shape];
  }
  for (const Arc& arc : this->Arcs)
  {
    ++users[arc.By];
  }
  for (std::size_t k = 0; k < this->Arcs.size(); ++k)
  {
    const Arc& arc = this->Arcs[k];
    if (this->Entities.Has(arc.By, STEPRole::MappedItem) && users[arc.By] == 1 && users[arc.From] == 1)
    {
      mapped[{ this->Arcs[k].From, this->Arcs[k].To }].push_back(k);
    }
  }
  if (mapped.empty())
  {
    return;
  }
  const std::size_t none = this->Census.Occurrences.size();
  // The occurrence of each arc that is joined.
  std::vector<std::size_t> joined(this->Arcs.size(), none);
  const auto join = [&](std::size_t k, Index whole, Index part)
  {
    const auto found = mapped.find({ whole, part });
    const bool isFound = found != mapped.end() && !found->second.empty();
    if (isFound)
    {
      joined[found->second.back()] = k;
      found->second.pop_back();
    }
    return isFound;
  };
  for (std::size_t k = 0; k < none; ++k)
  {
    const CensusOccurrence& occurrence = this->Census.Occurrences[k];
    if (occurrence.Placement == 0 && occurrence.Parent != 0 && occurrence.Child != 0)
    {
      const std::vector<Index> wholes = this->GetShapes(this->File.Find(occurrence.Parent));
      for (const Index part : this->GetShapes(this->File.Find(occurrence.Child)))
      {
        for (const Index whole : wholes)
        {
          if (join(k, whole, part))
          {
            break;
          }
        }
      }
    }
  }
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    std::unordered_set<Index> contained;
    for (std::size_t k = 0; k < this->Arcs.size(); ++k)
    {
      if (joined[k] == none && this->Entities.Has(this->Arcs[k].From, STEPRole::Representation))
      {
        contained.insert(this->Arcs[k].To);
      }
    }
    for (std::size_t k = 0; k < this->Arcs.size(); ++k)
    {
      if (joined[k] != none && contained.count(this->Arcs[k].From) > 0)
      {
        joined[k] = none;
        isChanged = true;
      }
    }
  }
  std::vector<Arc> arcs;
  for (std::size_t k = 0; k < this->Arcs.size(); ++k)
  {
    if (joined[k] == none)
    {
      arcs.push_back(this->Arcs[k]);
    }
    else
    {
      this->JoinedItems.emplace_back(joined[k], this->Arcs[k]);
    }
  }
  this->Arcs = std::move(arcs);
}

void STEPCensusTaker::CountAll()
{
  const Index count = this->File.GetNumberOfInstances();
  std::vector<std::uint32_t> incoming(count, 0);
  for (const Arc& arc : this->Arcs)
  {
    ++incoming[arc.To];
  }
  this->Counts.assign(count, 0);
  this->Census.Densities = ReadSTEPDensities(this->Entities);
  this->DensitiesOfEntities.assign(count, Unknown);
  this->Census.WithoutProducts = this->ShapesOfProducts.empty();
  std::vector<Index> open;
  std::vector<std::uint32_t> levels(count, 1);
  for (Index i = 0; i < count; ++i)
  {
    const bool product = this->Entities.Has(i, STEPRole::ProductDefinition);
    const bool shape = this->Groups[i] == i && this->Entities.Has(i, STEPRole::Representation) &&
      !this->Entities.Has(i, STEPRole::DefinitionalRepresentation);
    if ((product || shape) && incoming[i] == 0)
    {
      const bool isMapped = product && !this->IsMapped.empty() && this->IsMapped[i];
      this->Counts[i] = (product && !isMapped) || this->Census.WithoutProducts ? 1 : 0;
      open.push_back(i);
    }
  }
  while (!open.empty())
  {
    const Index from = open.back();
    open.pop_back();
    if (levels[from] > this->Census.Assemblies.Levels)
    {
      this->Census.Assemblies = { levels[from], this->File.GetId(from) };
    }
    for (auto arc = std::lower_bound(this->Arcs.begin(), this->Arcs.end(), Arc{ from, 0, 0 });
         arc != this->Arcs.end() && arc->From == from; ++arc)
    {
      this->Counts[arc->To] = AddCounts(this->Counts[arc->To], this->Counts[from]);
      levels[arc->To] = std::max(levels[arc->To], levels[from] + 1);
      // A representation that no product uses is not an assembly without a density.
      if (this->Counts[from] > 0)
      {
        this->PassDensity(from, arc->To);
      }
      if (--incoming[arc->To] == 0)
      {
        open.push_back(arc->To);
      }
    }
  }
  this->ReportCycles();
}

/// Marks the products, and the shapes in them; in a file without products all shapes.
std::vector<bool> STEPCensusTaker::FindRead() const
{
  std::vector<bool> isRead(this->File.GetNumberOfInstances(), this->Census.WithoutProducts);
  std::vector<Index> open = this->Products;
  while (!open.empty())
  {
    const Index from = open.back();
    open.pop_back();
    if (isRead[from])
    {
      continue;
    }
    isRead[from] = true;
    for (auto arc = std::lower_bound(this->Arcs.begin(), this->Arcs.end(), Arc{ from, 0, 0 });
         arc != this->Arcs.end() && arc->From == from; ++arc)
    {
      open.push_back(arc->To);
    }
  }
  return isRead;
}

/// Reports the cycles of the product structure. Those of mapped items are perils.
void STEPCensusTaker::ReportCycles()
{
  std::vector<Arc> arcs = this->Arcs;
  // What is left without the entities that lead to no cycle, and of the reverse without those that no cycle
  // leads to.
  for (int turn = 0; turn < 2; ++turn)
  {
    for (Arc& arc : arcs)
    {
      std::swap(arc.From, arc.To);
    }
    std::sort(arcs.begin(), arcs.end());
    std::vector<std::uint32_t> incoming(this->File.GetNumberOfInstances(), 0);
    for (const Arc& arc : arcs)
    {
      ++incoming[arc.To];
    }
    std::vector<Index> ends;
    for (std::size_t k = 0; k < arcs.size(); ++k)
    {
      if (incoming[arcs[k].From] == 0 && (k == 0 || arcs[k - 1].From != arcs[k].From))
      {
        ends.push_back(arcs[k].From);
      }
    }
    while (!ends.empty())
    {
      const Index end = ends.back();
      ends.pop_back();
      for (auto arc = std::lower_bound(arcs.begin(), arcs.end(), Arc{ end, 0, 0 });
           arc != arcs.end() && arc->From == end; ++arc)
      {
        if (--incoming[arc->To] == 0)
        {
          ends.push_back(arc->To);
        }
      }
    }
    arcs.erase(std::remove_if(
                 arcs.begin(), arcs.end(), [&incoming](const Arc& arc) { return incoming[arc.From] == 0; }),
      arcs.end());
  }
  std::sort(arcs.begin(), arcs.end(),
    [](const Arc& a, const Arc& b) { return a.To != b.To ? a.To < b.To : a.From < b.From; });
  const std::vector<bool> isRead = arcs.empty() ? std::vector<bool>() : this->FindRead();
  for (const Arc& arc : arcs)
  {
    if (this->Entities.Has(arc.By, STEPRole::MappedItem) && isRead[arc.From])
    {
      this->AddPeril(CensusDefect::AssemblyCycle, arc.By, this->File.GetId(arc.To), "contains itself");
    }
    else if (arc.By != None)
    {
      this->Add(CensusDefect::AssemblyCycle, arc.By, this->File.GetId(arc.To), "contains itself");
    }
  }
}

std::vector<bool> STEPCensusTaker::FindAbove(
  const std::vector<CensusBodyKind>& kinds, bool intoAssemblies) const
{
  std::vector<Arc> back;
  for (const Arc& arc : this->Arcs)
  {
    if (intoAssemblies || !this->IsOfAssembly(arc))
    {
      back.push_back({ arc.To, arc.From, arc.By });
    }
  }
  std::sort(back.begin(), back.end());
  std::vector<bool> above(this->File.GetNumberOfInstances(), false);
  std::vector<Index> open;
  for (const auto& [group, body] : this->BodiesOfGroups)
  {
    const CensusBodyKind kind = this->Census.Bodies[body].Kind;
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end() && !above[group])
    {
      above[group] = true;
      open.push_back(group);
    }
  }
  while (!open.empty())
  {
    const Index end = open.back();
    open.pop_back();
    for (auto arc = std::lower_bound(back.begin(), back.end(), Arc{ end, 0, 0 });
         arc != back.end() && arc->From == end; ++arc)
    {
      if (!above[arc->To])
      {
        above[arc->To] = true;
        open.push_back(arc->To);
      }
    }
  }
  return above;
}

void STEPCensusTaker::SetInstances()
{
  std::vector<double> densities(this->Census.Bodies.size(), Unknown);
  for (const auto& [group, body] : this->BodiesOfGroups)
  {
    CensusCount& instances = this->Census.Bodies[body].Instances;
    instances = AddCounts(instances, this->Counts[group]);
    // A body may also be an item of a representation that no product uses, for example of one that describes
    // an aspect of the shape.
    if (this->Counts[group] > 0)
    {
      JoinDensity(std::max(this->DensitiesOfEntities[group], 0.0), densities[body]);
    }
  }
  for (std::size_t k = 0; k < this->Census.Bodies.size(); ++k)
  {
    CensusBody& body = this->Census.Bodies[k];
    body.Density = densities[k] > 0.0 ? densities[k] : 0.0;
    body.DensitiesDiffer = std::isnan(densities[k]);
    if (body.Instances == 0 && body.Kind == CensusBodyKind::Solid &&
      body.Constructions < body.Representations)
    {
      this->Add(CensusDefect::UnreachedBody, this->BodyEntities[k]);
    }
  }
  for (std::size_t k = 0; k < this->Census.Occurrences.size(); ++k)
  {
    CensusOccurrence& occurrence = this->Census.Occurrences[k];
    const Index i = this->OccurrenceEntities[k];
    if (occurrence.Parent != 0 && occurrence.Child != 0)
    {
      occurrence.Instances = this->Counts[this->File.Find(occurrence.Parent)];
      occurrence.HasSolids = this->SolidsBelow[this->File.Find(occurrence.Child)];
    }
    if (occurrence.HasSolids && occurrence.Placement == 0 && occurrence.MappedItems.empty())
    {
      this->Add(CensusDefect::MissingPlacement, i, 0, "no placement");
    }
  }
  for (const auto& [from, item] : this->MappedFrom)
  {
    CensusMappedItem& mapped = this->Census.MappedItems[item];
    mapped.Instances = this->Counts[this->FindGroup(from)];
    mapped.HasSolids = this->SolidsBelow[this->FindGroup(this->File.Find(mapped.Child))];
  }
}
/// Reports occurrences of a product whose shape is mapped into that of the assembly, too: usually both are
/// the same instance.
void STEPCensusTaker::CheckTwicePlaced()
{
  for (const auto& [from, item] : this->MappedFrom)
  {
    const CensusMappedItem& mapped = this->Census.MappedItems[item];
    const Index shape = this->File.Find(mapped.Child);
    for (std::size_t k = 0; k < this->Census.Occurrences.size() && mapped.HasSolids; ++k)
    {
      const CensusOccurrence& occurrence = this->Census.Occurrences[k];
      const Index parent = this->File.Find(occurrence.Parent);
      const Index child = this->File.Find(occurrence.Child);
      if (occurrence.HasSolids && occurrence.Placement != 0 && occurrence.Instances > 0 &&
        this->IsShapeOf(from, parent) && this->IsShapeOf(shape, child))
      {
        this->Add(CensusDefect::PlacedTwice, this->OccurrenceEntities[k], mapped.Id, "mapped item");
        break;
      }
    }
  }
}

/// Reports shapes of products that a mapped item or a relationship places without an occurrence: a shape has
/// no parts, those of the product are placed by occurrences, and the product itself may be counted elsewhere.
void STEPCensusTaker::CheckPlacedProducts()
{
  std::unordered_map<Index, Index> products;
  std::unordered_map<Index, Index> assemblies;
  // Shapes of the assemblies and parts of occurrences that have a placement.
  std::set<std::pair<Index, Index>> placed;
  for (const auto& [product, shape] : this->ShapesOfProducts)
  {
    products.emplace(shape, product);
  }
  for (const CensusOccurrence& occurrence : this->Census.Occurrences)
  {
    if (!occurrence.HasSolids || occurrence.Parent == 0)
    {
      continue;
    }
    const Index assembly = this->File.Find(occurrence.Parent);
    for (const Index shape : this->GetShapes(assembly))
    {
      assemblies.emplace(shape, assembly);
      for (const Index part : this->GetShapes(this->File.Find(occurrence.Child)))
      {
        if (occurrence.Placement != 0 || !occurrence.MappedItems.empty())
        {
          placed.emplace(shape, part);
        }
      }
    }
  }
  for (const Arc& arc : this->Arcs)
  {
    const bool isRelationship = this->Entities.Has(arc.By, STEPRole::Relationship);
    if (this->Counts[arc.From] == 0 || (!isRelationship && !this->Entities.Has(arc.By, STEPRole::MappedItem)))
    {
      continue;
    }
    const auto assembly = assemblies.find(arc.To);
    const auto product = products.find(arc.To);
    if (assembly != assemblies.end())
    {
      this->Add(CensusDefect::PlacedAssembly, arc.By, this->File.GetId(assembly->second), "product");
    }
    else if (isRelationship && product != products.end() && this->SolidsBelow[arc.To])
    {
      this->Add(CensusDefect::PlacedProduct, arc.By, this->File.GetId(product->second), "product");
    }
  }
  for (const Arc& arc : this->FurtherPlacements)
  {
    const bool isCounted =
      this->Counts[arc.To] > 0 && (this->SolidsBelow[arc.To] || assemblies.count(arc.To) > 0);
    // One without a placement is reported as such.
    if (isCounted && placed.count({ arc.From, arc.To }) > 0)
    {
      this->Add(CensusDefect::PlacedAgain, arc.By, 0, "relationship");
    }
  }
}

/// Reports products whose shapes are different representations that relationships make one.
void STEPCensusTaker::CheckJoinedProducts()
{
  std::unordered_map<Index, Index> first;
  for (const auto& [representation, product] : this->ProductsOfRepresentations)
  {
    const Index group = this->Groups[representation];
    const Index other = first.emplace(group, product).first->second;
    if (other != product && this->Counts[group] > 0 && this->SolidsBelow[group])
    {
      this->Add(CensusDefect::JoinedProducts, product, this->File.GetId(other), "product");
    }
  }
}
}
