#include "smSTEPProductTree.h"

#include "smFirstOfSeveral.h"
#include "smRepeatedBodies.h"
#include "smSTEPAppearance.h"
#include "smSTEPMotions.h"
#include "smSTEPProducts.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPStructureAttributes.h"
#include "smShapeAdder.h"
#include "smTextEncoding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
namespace
{
using Index = Part21File::Index;

/// Names that OpenCASCADE gives shapes without a name, and writes.
bool IsMadeName(const std::string& name)
{
  static const std::set<std::string> made{ "COMPOUND", "COMPSOLID", "SOLID", "SHELL", "FACE", "NONE",
    "ASSEMBLY" };
  return made.count(name) > 0 || name.compare(0, 2, "=>") == 0;
}

std::string GetOwnName(std::string_view text)
{
  const std::string name = DecodePart21Text(text);
  return IsMadeName(name) ? std::string() : name;
}

class ProductTree
{
public:
  ProductTree(const STEPAttributes& entities, const STEPCensus& census, CensusBodyKind kind,
    const STEPBodies& bodies, const std::unordered_map<std::uint64_t, Vector3>& colors,
    const std::unordered_set<std::uint64_t>& hidden, HiddenMode mode, Document& document)
    : Entities(entities)
    , Census(census)
    , Kind(kind)
    , Bodies(bodies)
    , Colors(colors)
    , Hidden(hidden)
    , Mode(mode)
    , Result(document)
    , Adder(document)
    , Motions(entities, document.Defects)
  {
  }

  void Build()
  {
    for (const STEPProduct& product : ReadSTEPProducts(this->Entities.File, this->Census))
    {
      this->Stated.emplace(product.Definition, product.Stated);
    }
    this->Materials = ReadSTEPMaterials(this->Entities);
    this->Layers = ReadSTEPLayers(this->Entities);
    for (const CensusProduct& product : this->Census.Products)
    {
      this->Products.emplace(product.Id, &product);
    }
    for (const CensusOccurrence& occurrence : this->Census.Occurrences)
    {
      this->Occurrences[occurrence.Parent].push_back(&occurrence);
    }
    for (std::size_t k = 0; k < this->Census.Shapes.size(); ++k)
    {
      for (const std::uint64_t representation : this->Census.Shapes[k].Representations)
      {
        this->ShapesOfRepresentations.emplace(representation, k);
      }
    }
    for (const CensusBody& body : this->Census.Bodies)
    {
      if (body.Kind == CensusBodyKind::SurfaceModel && this->Kind == CensusBodyKind::Solid)
      {
        this->FreeFaces.emplace(body.Id, body.Faces);
      }
    }
    for (const CensusMappedItem& item : this->Census.MappedItems)
    {
      this->MappedItems.emplace(item.Id, &item);
    }
    for (const CensusOccurrence& occurrence : this->Census.Occurrences)
    {
      for (const CensusPlacedShape& item : occurrence.MappedItems)
      {
        this->Joined.insert(this->Entities.File.Find(item.Id));
      }
    }
    for (const auto& [index, body] : this->Bodies)
    {
      this->Adder.Announce(body.Shapes);
      this->BodyIndices.emplace(this->Census.Bodies[index].Id, index);
    }
    std::vector<ProductNode>& roots = this->Result.Root.Children;
    for (const CensusProduct& product : this->Census.Products)
    {
      if (!product.IsPart && product.Instances > 0)
      {
        roots.push_back(this->Visit(product, nullptr, {}, Inherited()));
      }
    }
    for (std::size_t k = 0; k < this->Census.Shapes.size() && this->Census.WithoutProducts; ++k)
    {
      if (!this->Census.Shapes[k].IsUsed)
      {
        ProductNode node;
        std::set<std::uint32_t> added;
        this->AddShapeOf(k, PartBody(), Placement(), Inherited(), added, node);
        roots.push_back(std::move(node));
      }
    }
    this->RepeatedSolids.Report(this->Result.Defects);
    this->ClosedShells.Report(this->Result.Defects);
  }

private:
  static constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();

  /// Attributes that an occurrence inherits from the assemblies above it.
  struct Inherited
  {
    Vector3 Color{ -1.0, -1.0, -1.0 };
    double Volume = Nothing;
    double Area = Nothing;
    std::string Material;
    bool IsHidden = false;
  };

  /// Where an occurrence is: its parts, and those of its shapes that mapped items place.
  struct Places
  {
    Placement Product;
    std::unordered_map<std::size_t, Placement> Shapes;
  };

  /// Counts as hidden what is visited while it exists, if `isHidden`.
  class HiddenScope
  {
  public:
    HiddenScope(int& depth, bool isHidden)
      : Depth(depth)
      , Step(isHidden ? 1 : 0)
    {
      this->Depth += this->Step;
    }
    ~HiddenScope() { this->Depth -= this->Step; }
    HiddenScope(const HiddenScope&) = delete;
    HiddenScope& operator=(const HiddenScope&) = delete;

  private:
    int& Depth;
    int Step;
  };

  /// Returns the number of solids of a product and of the products in it.
  std::size_t CountSolids(const CensusProduct& product)
  {
    const auto [found, isNew] = this->SolidCounts.try_emplace(product.Id, 0);
    if (isNew)
    {
      std::size_t count = 0;
      std::set<std::uint32_t> counted;
      for (const std::size_t shape : product.Shapes)
      {
        this->VisitItems(shape, counted, Placement(),
          [&](std::uint32_t body, const Placement&)
          { count += this->Adder.CountSolids(this->Bodies.at(body).Shapes); });
      }
      for (const CensusOccurrence* occurrence : this->Occurrences[product.Id])
      {
        const auto child = this->Products.find(occurrence->Child);
        count += child == this->Products.end() ? 0 : this->CountSolids(*child->second);
      }
      this->SolidCounts[product.Id] = count;
    }
    return this->SolidCounts[product.Id];
  }

  /// Adds a product at a place; `occurrence`: as a part of an assembly.
  ProductNode Visit(const CensusProduct& product, const CensusOccurrence* occurrence, const Places& places,
    Inherited inherited)
  {
    this->Open.insert(product.Id);
    ProductNode node;
    node.Place = places.Product;
    node.Name = GetOwnName(product.Name);
    node.Name = node.Name.empty() && occurrence ? GetOwnName(occurrence->Name) : node.Name;
    const auto stated = this->Stated.find(product.Id);
    const bool isSingle = this->CountSolids(product) == 1;
    if (!isSingle)
    {
      inherited.Volume = inherited.Area = Nothing;
    }
    else if (stated != this->Stated.end())
    {
      inherited.Volume = std::isfinite(stated->second.Volume) ? stated->second.Volume : inherited.Volume;
      inherited.Area = std::isfinite(stated->second.Area) ? stated->second.Area : inherited.Area;
    }
    const auto material = this->Materials.find(product.Id);
    inherited.Material = material == this->Materials.end() ? inherited.Material : material->second;
    for (const CensusOccurrence* part : this->Occurrences[product.Id])
    {
      const auto child = this->Products.find(part->Child);
      Places own;
      // The census reports an occurrence of nothing, and one of a product that contains itself.
      if (child != this->Products.end() && this->Open.count(part->Child) == 0 &&
        this->GetPlaces(*part, places.Product, own))
      {
        const auto color = this->Colors.find(part->Id);
        Inherited passed = inherited;
        passed.Color = color == this->Colors.end() ? inherited.Color : color->second;
        passed.IsHidden = inherited.IsHidden || this->Hidden.count(part->Id) > 0 ||
          std::any_of(part->MappedItems.begin(), part->MappedItems.end(),
            [this](const CensusPlacedShape& item) { return this->Hidden.count(item.Id) > 0; });
        this->Repeated.Enter();
        node.Children.push_back(this->Visit(*child->second, part, own, passed));
        this->Repeated.Leave();
      }
    }
    this->Open.erase(product.Id);
    PartBody part;
    part.Name = GetOwnName(product.Name);
    part.FileVolume = inherited.Volume;
    part.FileArea = inherited.Area;
    part.Material = inherited.Material;
    // A body in several shapes of a product is its shape in other words.
    std::set<std::uint32_t> added;
    for (const std::size_t shape : product.Shapes)
    {
      const auto own = places.Shapes.find(shape);
      this->AddShapeOf(
        shape, part, own == places.Shapes.end() ? places.Product : own->second, inherited, added, node);
    }
    return node;
  }

  void AddShapeOf(std::size_t shape, const PartBody& part, const Placement& placement,
    const Inherited& inherited, std::set<std::uint32_t>& added, ProductNode& node)
  {
    this->VisitItems(shape, added, Placement(),
      [&](std::uint32_t body, const Placement& motion)
      {
        const std::size_t first = this->Result.Instances.size();
        this->Adder.Add(this->Bodies.at(body).Shapes, this->Describe(body, part), Compose(placement, motion),
          inherited.Color, node);
        const bool isHidden =
          inherited.IsHidden || this->HiddenDepth > 0 || this->Hidden.count(this->Census.Bodies[body].Id) > 0;
        for (std::size_t i = first; i < this->Result.Instances.size(); ++i)
        {
          this->Result.Instances[i].IsHidden = isHidden;
        }
        if (first < this->Result.Instances.size() &&
          (this->Mode == HiddenMode::Count || isHidden == (this->Mode == HiddenMode::Only)))
        {
          this->CheckRepeated(body, Compose(placement, motion));
        }
      });
    for (const std::uint64_t representation : this->Census.Shapes[shape].Representations)
    {
      this->CountFreeFaces(representation);
      this->SetLayer(representation, node);
    }
  }

  /// Reports a solid that is in one place a second time. Materials or a selection may leave out one of them
  /// later.
  void CheckRepeated(std::uint32_t index, const Placement& placement)
  {
    if (this->Repeated.Add(index, placement))
    {
      this->RepeatedSolids.Add(
        [&]
        {
          return "Solid #" + std::to_string(this->Census.Bodies[index].Id) +
            " of the file is in one place twice: its product has it in two shapes, or another product or an "
            "assembly of its product has it, too. Both count, unless materials (counted once in place) or a "
            "selection leave one out. Export the file again.";
        });
    }
  }

  /// Sets the layer of a product: the first one of its shapes and their items.
  void SetLayer(std::uint64_t representation, ProductNode& node) const
  {
    std::vector<std::uint64_t> ids{ representation };
    for (const Index item : this->GetItems(representation))
    {
      ids.push_back(this->Entities.File.GetId(item));
    }
    for (const std::uint64_t id : ids)
    {
      const auto layer = this->Layers.find(id);
      node.Layer = node.Layer.empty() && layer != this->Layers.end() ? layer->second : node.Layer;
    }
  }

  /// Counts the faces of surface models, which are left out if there are solids, and reports closed shells.
  void CountFreeFaces(std::uint64_t representation)
  {
    for (const Index item : this->GetItems(representation))
    {
      const auto surfaces = this->FreeFaces.find(this->Entities.File.GetId(item));
      if (surfaces == this->FreeFaces.end())
      {
        continue;
      }
      this->Result.FreeFaces += static_cast<int>(surfaces->second);
      if (this->HasClosedShell(item))
      {
        this->ClosedShells.Add(
          [&]
          {
            return "Surface model #" + std::to_string(surfaces->first) +
              " of the file has a closed shell, next to solids: it is not counted, although it may "
              "be meant as a solid. Make it a solid, or remove it.";
          });
      }
    }
  }

  /// Returns true if a SHELL_BASED_SURFACE_MODEL has a CLOSED_SHELL (ISO 10303-42).
  bool HasClosedShell(Index model) const
  {
    std::string_view parameters;
    if (!this->Entities.FindRecord(model, "SHELL_BASED_SURFACE_MODEL", parameters))
    {
      return false;
    }
    Part21Values values(parameters);
    Part21Value name;
    Part21Value boundary;
    if (!values.Next(name) || !values.Next(boundary))
    {
      return false;
    }
    Part21Values shells(boundary.Text);
    for (Part21Value shell; shells.Next(shell);)
    {
      if (this->Entities.FindRecord(this->Entities.Follow(shell), "CLOSED_SHELL", parameters))
      {
        return true;
      }
    }
    return false;
  }

  /// Returns the items of a representation, each once.
  std::vector<Index> GetItems(std::uint64_t representation) const
  {
    std::vector<Index> items;
    std::unordered_set<Index> seen;
    Part21Values values(
      this->Entities.Get(this->Entities.File.Find(representation), ItemsOfRepresentation).Text);
    for (Part21Value value; values.Next(value);)
    {
      const Index item = this->Entities.Follow(value);
      if (item != Part21File::None && seen.insert(item).second)
      {
        items.push_back(item);
      }
    }
    return items;
  }

  /// Returns what is known of a body: what its part is, and what the file states about it.
  PartBody Describe(std::uint32_t index, const PartBody& part) const
  {
    const CensusBody& body = this->Census.Bodies[index];
    const STEPBody& read = this->Bodies.at(index);
    PartBody result = part;
    result.Density = body.Density;
    result.Uncertainty = read.Uncertainty;
    result.LostFaces = read.LostFaces;
    result.Messages = read.Messages;
    return result;
  }

  using BodyVisit = std::function<void(std::uint32_t, const Placement&)>;

  /// Calls visit(body, motion) for the bodies of a shape that are not in `seen`, and for those of the shapes
  /// that are placed in it. What is not visited is reported here, or by the census: an item that is none, and
  /// a shape that contains itself.
  void VisitItems(
    std::size_t shape, std::set<std::uint32_t>& seen, const Placement& motion, const BodyVisit& visit)
  {
    if (!this->OpenShapes.insert(shape).second)
    {
      return;
    }
    for (const std::uint64_t representation : this->Census.Shapes[shape].Representations)
    {
      const HiddenScope ofRepresentation(this->HiddenDepth, this->Hidden.count(representation) > 0);
      for (const Index item : this->GetItems(representation))
      {
        const auto body = this->BodyIndices.find(this->Entities.File.GetId(item));
        if (body != this->BodyIndices.end() && seen.insert(body->second).second)
        {
          visit(body->second, motion);
        }
        else if (this->Entities.Has(item, STEPRole::MappedItem))
        {
          const Index map = this->Entities.Follow(this->Entities.Get(item, MappingSource));
          const Index mapped = this->Entities.Follow(this->Entities.Get(map, MappedRepresentation));
          const auto place = mapped == Part21File::None
            ? this->ShapesOfRepresentations.end()
            : this->ShapesOfRepresentations.find(this->Entities.File.GetId(mapped));
          Placement own;
          // An occurrence has the items that place it.
          if (place != this->ShapesOfRepresentations.end() && this->Joined.count(item) == 0 &&
            this->Motions.GetMapping(map, item, representation, this->Entities.File.GetId(mapped), own))
          {
            this->VisitPlaced(
              { this->Entities.File.GetId(item), place->second }, Compose(motion, own), visit);
          }
        }
      }
    }
    for (const CensusPlacedShape& placed : this->Census.Shapes[shape].Placed)
    {
      Placement own;
      if (this->Motions.GetRelation(placed.Id, own))
      {
        this->VisitPlaced(placed, Compose(motion, own), visit);
      }
    }
    this->OpenShapes.erase(shape);
  }

  /// Calls visit(body, motion) for the bodies of a shape that is placed in another one.
  void VisitPlaced(const CensusPlacedShape& placed, const Placement& motion, const BodyVisit& visit)
  {
    const HiddenScope ofItem(this->HiddenDepth, this->Hidden.count(placed.Id) > 0);
    std::set<std::uint32_t> seen;
    this->VisitItems(placed.Shape, seen, motion, visit);
  }

  /// Gets the places of an occurrence in an assembly that is placed itself. Returns false, with a defect, if
  /// one is not read.
  bool GetPlaces(const CensusOccurrence& occurrence, const Placement& assembly, Places& places)
  {
    Placement own;
    for (const CensusPlacedShape& placed : occurrence.MappedItems)
    {
      const CensusMappedItem& item = *this->MappedItems.at(placed.Id);
      const Index entity = this->Entities.File.Find(item.Id);
      if (!this->Motions.GetMapping(this->Entities.Follow(this->Entities.Get(entity, MappingSource)), entity,
            item.Parent, item.Child, own))
      {
        return false;
      }
      places.Shapes[placed.Shape] = Compose(assembly, own);
    }
    if (!occurrence.MappedItems.empty())
    {
      // Parts of the product, and shapes without an item, are where its first shape is.
      places.Product = places.Shapes.at(occurrence.MappedItems.front().Shape);
      return true;
    }
    const bool isRead = this->Motions.GetPlacement(occurrence, own);
    places.Product = Compose(assembly, own);
    return isRead;
  }

  const STEPAttributes& Entities;
  const STEPCensus& Census;
  const CensusBodyKind Kind;
  const STEPBodies& Bodies;
  const std::unordered_map<std::uint64_t, Vector3>& Colors;
  const std::unordered_set<std::uint64_t>& Hidden;
  const HiddenMode Mode;
  /// Above 0 while what is visited is in a hidden representation or mapped item.
  int HiddenDepth = 0;
  RepeatedBodies Repeated;
  FirstOfSeveral RepeatedSolids;
  FirstOfSeveral ClosedShells;
  Document& Result;
  ShapeAdder Adder;
  /// Indices of bodies in the census by the number of their entity.
  std::unordered_map<std::uint64_t, std::uint32_t> BodyIndices;
  /// Numbers of faces of surface models that are left out, by the number of their entity.
  std::unordered_map<std::uint64_t, std::uint64_t> FreeFaces;
  std::unordered_map<std::uint64_t, std::size_t> ShapesOfRepresentations;
  std::unordered_map<std::uint64_t, const CensusProduct*> Products;
  std::unordered_map<std::uint64_t, const CensusMappedItem*> MappedItems;
  /// Mapped items that place an occurrence.
  std::unordered_set<Index> Joined;
  std::unordered_map<std::uint64_t, std::vector<const CensusOccurrence*>> Occurrences;
  std::unordered_map<std::uint64_t, std::size_t> SolidCounts;
  std::unordered_map<std::uint64_t, STEPValidation> Stated;
  std::unordered_map<std::uint64_t, std::string> Materials;
  std::unordered_map<std::uint64_t, std::string> Layers;
  /// Products and shapes that contain what is visited.
  std::unordered_set<std::uint64_t> Open;
  std::unordered_set<std::size_t> OpenShapes;
  STEPMotions Motions;
};
}

void AddSTEPProducts(const STEPAttributes& entities, const STEPCensus& census, CensusBodyKind kind,
  const STEPBodies& bodies, const std::unordered_map<std::uint64_t, Vector3>& colors,
  const std::unordered_set<std::uint64_t>& hidden, HiddenMode mode, Document& document)
{
  ProductTree(entities, census, kind, bodies, colors, hidden, mode, document).Build();
}
}
