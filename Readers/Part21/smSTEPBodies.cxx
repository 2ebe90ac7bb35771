// Bodies, shells and faces of a census.
#include "smSTEPCensusTaker.h"
#include "smSTEPPropertyAttributes.h"

#include <algorithm>

namespace sm
{
namespace
{
constexpr STEPAttribute OuterShell = { "MANIFOLD_SOLID_BREP", 0, 1, "outer shell" };
constexpr STEPAttribute VoidShells = { "BREP_WITH_VOIDS", 0, 2, "voids" };
constexpr STEPAttribute ShellsOfModel = { "SHELL_BASED_SURFACE_MODEL", 0, 1, "shells" };
constexpr STEPAttribute FaceSetsOfModel = { "FACE_BASED_SURFACE_MODEL", 0, 1, "face sets" };
constexpr STEPAttribute FacesOfShell = { "CONNECTED_FACE_SET", 0, 1, "faces" };
constexpr STEPAttribute BoundsOfFace = { "FACE", 0, 1, "bounds" };
constexpr STEPAttribute OrientedClosedShell = { "ORIENTED_CLOSED_SHELL", 0, 2, "shell" };
constexpr STEPAttribute OrientedOpenShell = { "ORIENTED_OPEN_SHELL", 0, 2, "shell" };
constexpr STEPAttribute OrientedFace = { "ORIENTED_FACE", 0, 2, "face" };
constexpr STEPAttribute SenseOfOrientedFace = { "ORIENTED_FACE", 1, 3, "orientation" };

constexpr std::uint64_t BodyRoles = STEPRole::Solid | STEPRole::OtherSolid | STEPRole::SurfaceModel |
  STEPRole::WireModel | STEPRole::GeometricSet | STEPRole::Tessellated | STEPRole::Shell | STEPRole::Face;

/// Largest length of a chain of oriented faces or shells that refer to each other; the standard allows one.
constexpr int MaxChain = 16;

CensusBodyKind GetKind(std::uint64_t roles)
{
  if (roles & STEPRole::Solid)
  {
    return CensusBodyKind::Solid;
  }
  if (roles & STEPRole::OtherSolid)
  {
    return CensusBodyKind::OtherSolid;
  }
  if (roles & STEPRole::Tessellated)
  {
    return CensusBodyKind::Tessellated;
  }
  return roles & (STEPRole::SurfaceModel | STEPRole::Shell | STEPRole::Face) ? CensusBodyKind::SurfaceModel
                                                                             : CensusBodyKind::GeometricSet;
}
}

void STEPCensusTaker::AddBodies()
{
  std::vector<Index> items;
  for (const Index i : this->Representations)
  {
    items.clear();
    Part21Values values(this->Entities.Get(i, ItemsOfRepresentation).Text);
    for (Part21Value value; values.Next(value);)
    {
      const Index item = this->Entities.Follow(value);
      if (this->Entities.Has(item, BodyRoles))
      {
        items.push_back(item);
      }
    }
    std::sort(items.begin(), items.end());
    const int context = items.empty() ? -1 : this->AddContext(i);
    const bool isConstruction =
      this->File.GetTypeNames()[this->File.GetType(i)] == "CONSTRUCTIVE_GEOMETRY_REPRESENTATION";
    bool isExact = false;
    bool isFaceted = false;
    for (std::size_t k = 0; k < items.size(); ++k)
    {
      if (k > 0 && items[k] == items[k - 1])
      {
        this->Add(CensusDefect::RepeatedItem, i, this->File.GetId(items[k]), ItemsOfRepresentation.Name);
        continue;
      }
      const std::uint32_t index = this->AddBody(items[k]);
      CensusBody& body = this->Census.Bodies[index];
      ++body.Representations;
      body.Constructions += isConstruction ? 1 : 0;
      body.Context = body.Context < 0 ? context : body.Context;
      if (context < 0)
      {
        this->WithoutContext.emplace(index, i);
      }
      const bool hasFacets = body.Type.find("FACETED_BREP") != std::string::npos;
      isFaceted = isFaceted || (body.Kind == CensusBodyKind::Solid && hasFacets);
      isExact = isExact || (body.Kind == CensusBodyKind::Solid && !hasFacets);
      this->BodiesOfGroups.emplace_back(this->FindGroup(i), index);
    }
    if (isExact || isFaceted)
    {
      (isExact ? this->ExactGroups : this->FacetedGroups).insert(this->FindGroup(i));
    }
  }
  // Two representations of one shape may both list a body.
  std::sort(this->BodiesOfGroups.begin(), this->BodiesOfGroups.end());
  this->BodiesOfGroups.erase(
    std::unique(this->BodiesOfGroups.begin(), this->BodiesOfGroups.end()), this->BodiesOfGroups.end());
}

std::uint32_t STEPCensusTaker::AddBody(Index item)
{
  const auto [found, added] =
    this->BodyIndices.emplace(item, static_cast<std::uint32_t>(this->Census.Bodies.size()));
  if (!added)
  {
    return found->second;
  }
  this->BodyEntities.push_back(item);
  CensusBody body;
  const std::uint64_t roles = this->Entities.GetRoles(item);
  body.Kind = GetKind(roles);
  body.Id = this->File.GetId(item);
  body.Name = this->Entities.Get(item, NameOfItem).Text;
  for (std::size_t k = 0; k < this->File.GetNumberOfRecords(item); ++k)
  {
    const STEPEntityType* type = this->Entities.GetType(item, k);
    if (type && (type->Roles & BodyRoles))
    {
      body.Type += body.Type.empty() ? type->Name : std::string(" ") + type->Name;
    }
  }
  body.FirstShell = static_cast<std::uint32_t>(this->Census.ShellUses.size());
  this->AddShells(body, item);
  body.NumberOfShells = static_cast<std::uint32_t>(this->Census.ShellUses.size()) - body.FirstShell;
  for (std::uint32_t k = 0; k < body.NumberOfShells; ++k)
  {
    body.Faces += this->Census.Shells[this->Census.ShellUses[body.FirstShell + k].Shell].NumberOfFaces;
  }
  this->Census.Bodies.push_back(std::move(body));
  return found->second;
}

void STEPCensusTaker::AddShells(CensusBody& body, Index item)
{
  const auto addList = [this, item](const STEPAttribute& attribute, bool isVoid)
  {
    Part21Values values(this->Entities.Get(item, attribute).Text);
    for (Part21Value value; values.Next(value);)
    {
      this->AddShellUse(item, value, isVoid, attribute.Name);
    }
  };
  const std::uint64_t roles = this->Entities.GetRoles(item);
  std::string_view parameters;
  if (body.Kind == CensusBodyKind::Solid)
  {
    this->AddShellUse(item, this->Entities.Get(item, OuterShell), false, OuterShell.Name);
    if (this->Entities.FindRecord(item, VoidShells.Record, parameters))
    {
      addList(VoidShells, true);
    }
  }
  else if (roles & STEPRole::SurfaceModel)
  {
    addList(
      this->Entities.FindRecord(item, ShellsOfModel.Record, parameters) ? ShellsOfModel : FaceSetsOfModel,
      false);
  }
  else if (roles & STEPRole::Shell)
  {
    this->Census.ShellUses.push_back({ this->AddShell(item), this->File.GetId(item), false });
  }
  else if (roles & STEPRole::Face)
  {
    CensusShell shell;
    shell.Id = this->File.GetId(item);
    shell.Kind = CensusShellKind::FaceSet;
    const std::uint32_t face = this->AddFace(item);
    shell.FirstFace = static_cast<std::uint32_t>(this->Census.FaceUses.size());
    shell.NumberOfFaces = 1;
    this->Census.FaceUses.push_back(face);
    this->Census.ShellUses.push_back(
      { static_cast<std::uint32_t>(this->Census.Shells.size()), this->File.GetId(item), false });
    this->Census.Shells.push_back(shell);
  }
}

void STEPCensusTaker::AddShellUse(Index user, const Part21Value& value, bool isVoid, const char* place)
{
  const Index used = this->Entities.Follow(value);
  if (!this->Entities.Has(used, STEPRole::Shell))
  {
    // If a product uses the body, WalkBodies() reports the defect.
    return;
  }
  const Index shell = this->Unwrap(this->Unwrap(used, OrientedClosedShell, place), OrientedOpenShell, place);
  if (!this->Entities.Has(shell, STEPRole::Shell))
  {
    this->Add(CensusDefect::CyclicReference, user, this->File.GetId(used), place);
    return;
  }
  this->Census.ShellUses.push_back({ this->AddShell(shell), this->File.GetId(used), isVoid });
}

STEPCensusTaker::Index STEPCensusTaker::Unwrap(Index i, const STEPAttribute& element, const char* place)
{
  std::string_view parameters;
  const Index first = i;
  for (int k = 0; i != None && this->Entities.FindRecord(i, element.Record, parameters); ++k)
  {
    if (k == MaxChain)
    {
      this->Add(CensusDefect::CyclicReference, first, this->File.GetId(i), place);
      return None;
    }
    i = this->Entities.Follow(this->Entities.Get(i, element));
  }
  return i;
}

std::uint32_t STEPCensusTaker::AddShell(Index entity)
{
  const auto [found, added] =
    this->ShellIndices.emplace(entity, static_cast<std::uint32_t>(this->Census.Shells.size()));
  if (!added)
  {
    return found->second;
  }
  CensusShell shell;
  shell.Id = this->File.GetId(entity);
  std::string_view parameters;
  shell.Kind = this->Entities.FindRecord(entity, "CLOSED_SHELL", parameters) ? CensusShellKind::Closed
    : this->Entities.FindRecord(entity, "OPEN_SHELL", parameters)            ? CensusShellKind::Open
                                                                             : CensusShellKind::FaceSet;
  std::vector<std::pair<std::uint32_t, bool>> faces;
  Part21Values values(this->Entities.Get(entity, FacesOfShell).Text);
  for (Part21Value value; values.Next(value);)
  {
    const Index used = this->Entities.Follow(value);
    const Index face = this->Unwrap(used, OrientedFace, FacesOfShell.Name);
    bool isReversed = false;
    for (Index i = used; i != face && face != None;
         i = this->Entities.Follow(this->Entities.Get(i, OrientedFace)))
    {
      isReversed = isReversed != (this->Entities.Get(i, SenseOfOrientedFace).Text == "F");
    }
    if (this->Entities.Has(face, STEPRole::Face))
    {
      faces.emplace_back(this->AddFace(face), isReversed);
    }
  }
  shell.FirstFace = static_cast<std::uint32_t>(this->Census.FaceUses.size());
  std::sort(faces.begin(), faces.end());
  for (std::size_t k = 0; k < faces.size(); ++k)
  {
    const auto [face, isReversed] = faces[k];
    if (k > 0 && face == faces[k - 1].first)
    {
      this->Add(CensusDefect::RepeatedFace, entity, this->Census.Faces[face].Id, FacesOfShell.Name);
      continue;
    }
    this->Census.FaceUses.push_back(face);
    this->Census.IsReversedUse.push_back(isReversed);
    ++shell.NumberOfFaces;
  }
  if (faces.empty())
  {
    this->Add(CensusDefect::EmptyShell, entity, 0, FacesOfShell.Name);
  }
  this->Census.Shells.push_back(shell);
  return found->second;
}

std::uint32_t STEPCensusTaker::AddFace(Index entity)
{
  const auto [found, added] =
    this->FaceIndices.emplace(entity, static_cast<std::uint32_t>(this->Census.Faces.size()));
  if (!added)
  {
    return found->second;
  }
  CensusFace face;
  face.Id = this->File.GetId(entity);
  face.FirstBound = static_cast<std::uint32_t>(this->Census.Bounds.size());
  Part21Values values(this->Entities.Get(entity, BoundsOfFace).Text);
  for (Part21Value value; values.Next(value);)
  {
    if (value.IsReference())
    {
      this->Census.Bounds.push_back(value.Id);
      ++face.NumberOfBounds;
    }
  }
  this->Census.Faces.push_back(face);
  this->FaceEntities.push_back(entity);
  return found->second;
}

void STEPCensusTaker::CheckBounds()
{
  std::vector<std::pair<std::uint64_t, Index>> uses;
  for (std::size_t k = 0; k < this->Census.Faces.size(); ++k)
  {
    const CensusFace& face = this->Census.Faces[k];
    for (std::uint32_t b = 0; b < face.NumberOfBounds; ++b)
    {
      uses.emplace_back(this->Census.Bounds[face.FirstBound + b], this->FaceEntities[k]);
    }
  }
  std::sort(uses.begin(), uses.end());
  for (std::size_t k = 1; k < uses.size(); ++k)
  {
    if (uses[k].first == uses[k - 1].first)
    {
      this->Add(CensusDefect::SharedBound, uses[k].second, uses[k].first, BoundsOfFace.Name);
    }
  }
}

void STEPCensusTaker::FindUnused()
{
  constexpr std::uint64_t parts =
    STEPRole::Solid | STEPRole::Shell | STEPRole::Face | STEPRole::Bound | STEPRole::Loop;
  constexpr std::uint64_t wholes = BodyRoles | STEPRole::Bound | STEPRole::Representation;
  const Index count = this->File.GetNumberOfInstances();
  std::vector<bool> used(count, false);
  for (Index i = 0; i < count; ++i)
  {
    if (this->Entities.Has(i, wholes))
    {
      for (const Index part : this->File.GetReferences(i))
      {
        if (part != None && part != i)
        {
          used[part] = true;
        }
      }
    }
  }
  for (Index i = 0; i < count; ++i)
  {
    if (!used[i] && this->Entities.Has(i, parts))
    {
      this->Add(CensusDefect::UnusedEntity, i, 0, "");
    }
  }
}
}
