#include "smSTEPKnownForms.h"

#include "smSTEPFrames.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPStructureAttributes.h"
#include "smSTEPTopologyAttributes.h"

#include <cmath>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
constexpr STEPAttribute BoundsOfKnownFace = { "FACE", 0, 1, "bounds" };
constexpr STEPAttribute SurfaceOfKnownFace = { "FACE_SURFACE", 0, 2, "surface" };
constexpr STEPAttribute SenseOfKnownFace = { "FACE_SURFACE", 1, 3, "same sense" };
constexpr STEPAttribute SenseOfKnownBound = { "FACE_BOUND", 1, 2, "orientation" };
constexpr STEPAttribute PlaceOfWholeSurface = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute RadiusOfWholeSphere = { "SPHERICAL_SURFACE", 0, 2, "radius" };
constexpr STEPAttribute RadiiOfWholeTorus[] = { { "TOROIDAL_SURFACE", 0, 2, "major radius" },
  { "TOROIDAL_SURFACE", 1, 3, "minor radius" } };
constexpr STEPAttribute ElementOfOriented = { "ORIENTED_FACE", 0, 2, "face" };
constexpr STEPAttribute SenseOfOriented = { "ORIENTED_FACE", 1, 3, "orientation" };
constexpr STEPAttribute OuterOfSolid = { "MANIFOLD_SOLID_BREP", 0, 1, "outer shell" };
constexpr STEPAttribute VoidsOfSolid = { "BREP_WITH_VOIDS", 0, 2, "voids" };
constexpr STEPAttribute RelationOfPlacement = { "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", 0, 0,
  "relationship" };

constexpr std::uint64_t ExactRoles = STEPRole::Solid | STEPRole::OtherSolid | STEPRole::SurfaceModel |
  STEPRole::Shell | STEPRole::Face | STEPRole::GeometricSet | STEPRole::WireModel | STEPRole::MappedItem;

bool IsEmptyList(const Part21Value& value)
{
  Part21Value first;
  return value.IsList() && !Part21Values(value.Text).Next(first);
}

bool IsSense(const Part21Value& value)
{
  return value.Kind == Part21Kind::Enumeration && (value.Text == "T" || value.Text == "F");
}

/// Finds a point of a whole sphere, its lower pole, or of a torus that does not cross itself. Returns false
/// for other surfaces.
bool FindPoint(const STEPAttributes& entities, Part21File::Index surface, STEPVector& point)
{
  std::string_view record;
  double radii[2] = { 0.0, 0.0 };
  const bool isSphere = entities.FindRecord(surface, RadiusOfWholeSphere.Record, record);
  STEPFrame frame;
  if (isSphere ? !entities.Get(surface, RadiusOfWholeSphere).GetNumber(radii[1])
               : !entities.FindRecord(surface, RadiiOfWholeTorus[0].Record, record) ||
        !entities.Get(surface, RadiiOfWholeTorus[0]).GetNumber(radii[0]) ||
        !entities.Get(surface, RadiiOfWholeTorus[1]).GetNumber(radii[1]) || !(radii[0] >= radii[1]))
  {
    return false;
  }
  if (!(radii[1] > 0.0) ||
    !ReadSTEPFrame(entities, entities.Follow(entities.Get(surface, PlaceOfWholeSurface)), frame))
  {
    return false;
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    point[c] =
      frame.Origin[c] + (isSphere ? -radii[1] * frame.Axes[2][c] : (radii[0] + radii[1]) * frame.Axes[0][c]);
  }
  return true;
}

class FormChanger
{
public:
  using Index = Part21File::Index;

  FormChanger(const STEPAttributes& entities, Part21Changes& changes)
    : Entities(entities)
    , File(entities.File)
    , Changes(changes)
  {
  }

  void Run()
  {
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      if (this->File.IsDamaged(i))
      {
        continue;
      }
      const std::uint64_t roles = this->Entities.GetRoles(i);
      if (roles & STEPRole::Face)
      {
        this->VisitFace(i);
      }
      else if (roles & STEPRole::Solid)
      {
        this->SimplifyVoids(i);
      }
      else if (roles & STEPRole::ShapeDefinition)
      {
        this->Definitions.push_back(i);
      }
      else if (roles & STEPRole::ShapeRelationship)
      {
        this->Relationships.push_back(i);
      }
      else if (roles & STEPRole::OccurrenceShape)
      {
        this->Placing.insert(this->Entities.Follow(this->Entities.Get(i, RelationOfPlacement)));
      }
    }
    if (!this->Oriented.empty())
    {
      this->ReplaceOrientedFaces();
    }
    this->ReplaceRelations();
  }

private:
  void VisitFace(Index face)
  {
    std::string_view record;
    STEPVector point;
    if (this->Entities.FindRecord(face, ElementOfOriented.Record, record))
    {
      this->Oriented.push_back(face);
    }
    else if (IsWholeSurface(this->Entities, face) &&
      FindPoint(this->Entities, this->Entities.Follow(this->Entities.Get(face, SurfaceOfKnownFace)), point))
    {
      const std::string vertex = this->Changes.Add("VERTEX_POINT(''," +
        this->Changes.Add("CARTESIAN_POINT('',(" + FormatPart21Real(point[0]) + "," +
          FormatPart21Real(point[1]) + "," + FormatPart21Real(point[2]) + "))") +
        ")");
      const std::string loop = this->Changes.Add("VERTEX_LOOP(''," + vertex + ")");
      this->Changes.Replace(this->Entities.Get(face, BoundsOfKnownFace).Text,
        this->Changes.Add("FACE_BOUND(''," + loop + ",.T.)"));
    }
  }

  void SimplifyVoids(Index solid)
  {
    const Part21Value outer = this->Entities.Get(solid, OuterOfSolid);
    const Part21Value voids = this->Entities.Get(solid, VoidsOfSolid);
    if (this->File.IsComplex(solid) && outer.IsReference() && voids.IsList())
    {
      this->Changes.Replace(this->File.GetText(solid),
        "#" + std::to_string(this->File.GetId(solid)) + "=BREP_WITH_VOIDS('" +
          std::string(this->Entities.Get(solid, NameOfItem).Text) + "'," + std::string(outer.Text) + ",(" +
          std::string(voids.Text) + "));");
    }
  }

  /// Counts the uses of all entities, and keeps the shells.
  void CountUses(std::vector<Index>& shells)
  {
    this->Uses.assign(this->File.GetNumberOfInstances(), 0);
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      if (this->Entities.Has(i, STEPRole::Shell))
      {
        shells.push_back(i);
      }
      for (const Index to : this->File.GetReferences(i))
      {
        if (to != Part21File::None && this->Entities.Has(i, STEPRole::Shell | STEPRole::Face))
        {
          ++this->Uses[to];
        }
      }
    }
  }

  void ReplaceOrientedFaces()
  {
    std::vector<Index> shells;
    this->CountUses(shells);
    std::unordered_map<Index, std::string> faces;
    for (const Index oriented : this->Oriented)
    {
      const std::string name = this->MakeFace(oriented);
      if (!name.empty())
      {
        faces.emplace(oriented, name);
      }
    }
    for (const Index shell : shells)
    {
      for (std::size_t k = 0; k < this->File.GetNumberOfRecords(shell); ++k)
      {
        Part21Values parameters(this->File.GetParameters(shell, k));
        for (Part21Value list; parameters.Next(list);)
        {
          Part21Values values(list.IsList() ? list.Text : std::string_view());
          for (Part21Value value; values.Next(value);)
          {
            const auto face = faces.find(this->Entities.Follow(value));
            if (face != faces.end())
            {
              this->Changes.Replace(value.Text, face->second);
            }
          }
        }
      }
    }
  }

  /// Returns the name of the face that stands for an oriented one; empty if there is none.
  std::string MakeFace(Index oriented)
  {
    const Part21Value element = this->Entities.Get(oriented, ElementOfOriented);
    const Index face = this->Entities.Follow(element);
    const Part21Value sense = this->Entities.Get(face, SenseOfKnownFace);
    const Part21Value bounds = this->Entities.Get(face, BoundsOfKnownFace);
    if (!this->Entities.Has(face, STEPRole::Face) || this->File.IsComplex(face) ||
      this->File.IsDamaged(face) || !IsSense(sense))
    {
      return {};
    }
    if (this->Entities.Get(oriented, SenseOfOriented).Text != "F")
    {
      return std::string(element.Text);
    }
    bool isOwn = this->Uses[face] == 1;
    std::vector<Index> all;
    Part21Values values(bounds.Text);
    for (Part21Value value; values.Next(value);)
    {
      const Index bound = this->Entities.Follow(value);
      if (!this->Entities.Has(bound, STEPRole::Bound) || this->File.IsComplex(bound) ||
        !IsSense(this->Entities.Get(bound, SenseOfKnownBound)))
      {
        return {};
      }
      isOwn = isOwn && this->Uses[bound] == 1;
      all.push_back(bound);
    }
    if (!isOwn)
    {
      return this->CopyReversed(face, all);
    }
    this->Changes.Replace(sense.Text, GetOpposite(sense));
    for (const Index bound : all)
    {
      const Part21Value own = this->Entities.Get(bound, SenseOfKnownBound);
      this->Changes.Replace(own.Text, GetOpposite(own));
    }
    return std::string(element.Text);
  }

  std::string CopyReversed(Index face, const std::vector<Index>& bounds)
  {
    std::string list;
    for (const Index bound : bounds)
    {
      list += (list.empty() ? "" : ",") +
        this->Changes.Add(this->File.GetTypeNames()[this->File.GetType(bound)] + "(''," +
          std::string(this->Entities.Get(bound, LoopOfBound).Text) + ",." +
          GetOpposite(this->Entities.Get(bound, SenseOfKnownBound)) + ".)");
    }
    return this->Changes.Add(this->File.GetTypeNames()[this->File.GetType(face)] + "('',(" + list + ")," +
      std::string(this->Entities.Get(face, SurfaceOfKnownFace).Text) + ",." +
      GetOpposite(this->Entities.Get(face, SenseOfKnownFace)) + ".)");
  }

  static std::string GetOpposite(const Part21Value& sense) { return sense.Text == "T" ? "F" : "T"; }

  /// Returns true if the items of a representation have one of the roles.
  bool HasItems(Index representation, std::uint64_t roles) const
  {
    Part21Values values(this->Entities.Get(representation, ItemsOfRepresentation).Text);
    for (Part21Value value; values.Next(value);)
    {
      if (this->Entities.Has(this->Entities.Follow(value), roles))
      {
        return true;
      }
    }
    return false;
  }

  bool HasTrianglesOnly(Index representation) const
  {
    return this->HasItems(representation, STEPRole::Tessellated) &&
      !this->HasItems(representation, ExactRoles);
  }

  void ReplaceRelations()
  {
    std::vector<Index> omitted;
    // The relations of each representation.
    std::unordered_map<Index, std::vector<Index>> relations;
    for (const Index i : this->Relationships)
    {
      std::string_view record;
      const Index ends[2] = { this->Entities.Follow(this->Entities.Get(i, FirstRepresentation)),
        this->Entities.Follow(this->Entities.Get(i, SecondRepresentation)) };
      if (this->Placing.count(i) > 0 || this->Entities.FindRecord(i, OperatorOfRelationship.Record, record) ||
        !this->Entities.Has(ends[0], STEPRole::Representation) ||
        !this->Entities.Has(ends[1], STEPRole::Representation) || ends[0] == ends[1])
      {
        continue;
      }
      if (this->HasTrianglesOnly(ends[0]) || this->HasTrianglesOnly(ends[1]))
      {
        omitted.push_back(i);
        continue;
      }
      relations[ends[0]].push_back(i);
      relations[ends[1]].push_back(i);
    }
    std::unordered_map<Index, std::unordered_set<Index>> shapes;
    std::unordered_set<Index> isMoved;
    for (const Index i : this->Definitions)
    {
      const Index property = this->Entities.Follow(this->Entities.Get(i, RepresentedProperty));
      const Index product = this->Entities.Follow(this->Entities.Get(property, DefinitionOfProperty));
      const Index shape = this->Entities.Follow(this->Entities.Get(i, UsedRepresentation));
      if (!this->Entities.Has(product, STEPRole::ProductDefinition) ||
        !this->Entities.Has(shape, STEPRole::Representation))
      {
        continue;
      }
      std::unordered_set<Index>& known = shapes[product];
      if (this->HasTrianglesOnly(shape) || known.count(shape) > 0)
      {
        omitted.push_back(i);
        continue;
      }
      this->AddRelated(shape, relations, isMoved, known);
    }
    this->Omit(omitted);
  }

  /// Adds a representation and those related to it to `known`, and relates those at a distance to it if they
  /// have bodies.
  void AddRelated(Index shape, const std::unordered_map<Index, std::vector<Index>>& relations,
    std::unordered_set<Index>& isMoved, std::unordered_set<Index>& known)
  {
    std::vector<Index> open(1, shape);
    known.insert(shape);
    while (!open.empty())
    {
      const Index from = open.back();
      open.pop_back();
      const auto own = relations.find(from);
      for (std::size_t k = 0; own != relations.end() && k < own->second.size(); ++k)
      {
        const Index relation = own->second[k];
        const Part21Value first = this->Entities.Get(relation, FirstRepresentation);
        const Part21Value second = this->Entities.Get(relation, SecondRepresentation);
        const bool isFirst = this->Entities.Follow(first) == from;
        const Index to = this->Entities.Follow(isFirst ? second : first);
        if (!known.insert(to).second)
        {
          continue;
        }
        open.push_back(to);
        if (from != shape && this->HasItems(to, ExactRoles) && isMoved.insert(relation).second)
        {
          this->Changes.Replace(
            (isFirst ? first : second).Text, "#" + std::to_string(this->File.GetId(shape)));
        }
      }
    }
  }

  /// Leaves out entities to which nothing refers.
  void Omit(const std::vector<Index>& omitted)
  {
    if (omitted.empty())
    {
      return;
    }
    std::vector<bool> isUsed(this->File.GetNumberOfInstances(), false);
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      for (const Index to : this->File.GetReferences(i))
      {
        if (to != Part21File::None)
        {
          isUsed[to] = true;
        }
      }
    }
    for (const Index i : omitted)
    {
      if (!isUsed[i])
      {
        this->Changes.Replace(this->File.GetText(i), "");
      }
    }
  }

  const STEPAttributes& Entities;
  const Part21File& File;
  Part21Changes& Changes;
  std::vector<Index> Oriented;
  std::vector<Index> Definitions;
  std::vector<Index> Relationships;
  /// Relationships that place an occurrence.
  std::unordered_set<Index> Placing;
  /// Uses of each entity by shells and faces.
  std::vector<std::uint32_t> Uses;
};
}

bool IsWholeSurface(const STEPAttributes& entities, Part21File::Index face)
{
  STEPVector point;
  return IsEmptyList(entities.Get(face, BoundsOfKnownFace)) &&
    IsSense(entities.Get(face, SenseOfKnownFace)) &&
    FindPoint(entities, entities.Follow(entities.Get(face, SurfaceOfKnownFace)), point);
}

void UseKnownForms(const STEPAttributes& entities, Part21Changes& changes)
{
  FormChanger(entities, changes).Run();
}
}
