// The entities that the bodies of a census depend on, and their damage.
#include "smSTEPCensusTaker.h"
#include "smSTEPFrames.h"
#include "smSTEPTopologyAttributes.h"

#include <algorithm>

namespace sm
{
namespace
{
constexpr STEPAttribute BoundsOfWholeFace = { "FACE", 0, 1, "bounds" };
constexpr STEPAttribute SurfaceOfWholeFace = { "FACE_SURFACE", 0, 2, "surface" };
constexpr STEPAttribute SenseOfWholeFace = { "FACE_SURFACE", 1, 3, "same sense" };
constexpr STEPAttribute PlaceOfWholeSurface = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute RadiusOfWholeSphere = { "SPHERICAL_SURFACE", 0, 2, "radius" };
constexpr STEPAttribute RadiiOfWholeTorus[] = { { "TOROIDAL_SURFACE", 0, 2, "major radius" },
  { "TOROIDAL_SURFACE", 1, 3, "minor radius" } };

/// Returns true for a face with an empty list of bounds that is a whole sphere, or a whole torus that does
/// not cross itself.
bool IsWholeSurface(const STEPAttributes& entities, Part21File::Index face)
{
  const Part21Value bounds = entities.Get(face, BoundsOfWholeFace);
  const Part21Value sense = entities.Get(face, SenseOfWholeFace);
  Part21Value first;
  if (!bounds.IsList() || Part21Values(bounds.Text).Next(first) || sense.Kind != Part21Kind::Enumeration ||
    (sense.Text != "T" && sense.Text != "F"))
  {
    return false;
  }
  const Part21File::Index surface = entities.Follow(entities.Get(face, SurfaceOfWholeFace));
  double radii[2] = { 0.0, 0.0 };
  const bool hasRadii = entities.Get(surface, RadiusOfWholeSphere).GetNumber(radii[1]) ||
    (entities.Get(surface, RadiiOfWholeTorus[0]).GetNumber(radii[0]) &&
      entities.Get(surface, RadiiOfWholeTorus[1]).GetNumber(radii[1]) && radii[0] >= radii[1]);
  STEPFrame frame;
  return hasRadii && radii[1] > 0.0 &&
    ReadSTEPFrame(entities, entities.Follow(entities.Get(surface, PlaceOfWholeSurface)), frame);
}

/// Bits of Visited.
constexpr unsigned char InSpace = 1;
constexpr unsigned char InPlane = 2;
}

void STEPCensusTaker::WalkBodies()
{
  std::vector<Step> used;
  std::vector<Step> unused;
  for (std::size_t k = 0; k < this->Census.Bodies.size(); ++k)
  {
    const CensusBody& body = this->Census.Bodies[k];
    // Sets of curves and of triangles are not integrated, so their entities are not examined.
    if (body.Kind == CensusBodyKind::Solid || body.Kind == CensusBodyKind::SurfaceModel)
    {
      (body.Instances > 0 ? used : unused).push_back({ this->BodyEntities[k], false });
    }
  }
  this->Walk(used, CensusUse::Geometry);
  // Entities of bodies that no product uses are marked but not checked.
  while (!unused.empty())
  {
    const Index i = unused.back().Entity;
    unused.pop_back();
    if (this->Census.Uses[i] & (CensusUse::Geometry | CensusUse::UnusedGeometry))
    {
      continue;
    }
    this->Use(i, CensusUse::UnusedGeometry);
    for (const Index next : this->File.GetReferences(i))
    {
      if (next != None)
      {
        unused.push_back({ next, false });
      }
    }
  }
}

void STEPCensusTaker::Walk(std::vector<Step>& open, unsigned char use)
{
  while (!open.empty())
  {
    const Step step = open.back();
    open.pop_back();
    this->Use(step.Entity, use);
    unsigned char& visited = this->Visited[step.Entity];
    const unsigned char bit = step.Flat ? InPlane : InSpace;
    if (visited & bit)
    {
      continue;
    }
    visited |= bit;
    this->Visit(step.Entity, step.Flat);
    const bool flat = step.Flat || this->Entities.Has(step.Entity, STEPRole::DefinitionalRepresentation);
    for (const Index next : this->File.GetReferences(step.Entity))
    {
      // The context of a trim curve is not needed.
      if (next != None && !this->Entities.Has(next, STEPRole::Context))
      {
        open.push_back({ next, flat });
      }
    }
  }
}

/// Finds entities that contain themselves, and the deepest chain of the others, by a depth-first search over
/// the entities on which bodies depend, with an explicit stack.
void STEPCensusTaker::FindCycles()
{
  enum State : unsigned char
  {
    New,
    Open,
    Done
  };
  std::vector<unsigned char> states(this->File.GetNumberOfInstances(), New);
  std::vector<std::uint32_t> levels(this->File.GetNumberOfInstances(), 1);
  std::vector<std::pair<Index, std::size_t>> path;
  for (Index start = 0; start < this->File.GetNumberOfInstances(); ++start)
  {
    if (this->Visited[start] != 0 && states[start] == New)
    {
      states[start] = Open;
      path.emplace_back(start, 0);
    }
    while (!path.empty())
    {
      const Index from = path.back().first;
      const Part21Range<Index> references = this->File.GetReferences(from);
      if (path.back().second == references.size())
      {
        states[from] = Done;
        path.pop_back();
        if (levels[from] > this->Census.Geometry.Levels)
        {
          this->Census.Geometry = { levels[from], this->File.GetId(from) };
        }
        if (!path.empty())
        {
          levels[path.back().first] = std::max(levels[path.back().first], levels[from] + 1);
        }
        continue;
      }
      const Index to = references[path.back().second++];
      if (to == None || this->Visited[to] == 0)
      {
        continue;
      }
      if (states[to] == New)
      {
        states[to] = Open;
        path.emplace_back(to, 0);
      }
      else if (states[to] == Done)
      {
        levels[from] = std::max(levels[from], levels[to] + 1);
      }
      else if (states[to] == Open && !this->Entities.Has(from, STEPRole::Shell | STEPRole::Face))
      {
        // Oriented shells and faces were unwrapped when bodies were counted.
        this->AddPeril(CensusDefect::CyclicReference, from, this->File.GetId(to), "");
      }
    }
  }
}

void STEPCensusTaker::Visit(Index i, bool flat)
{
  if (this->File.IsDamaged(i))
  {
    const Part21Range<Index> references = this->File.GetReferences(i);
    const bool undefined = std::find(references.begin(), references.end(), None) != references.end();
    this->Add(undefined ? CensusDefect::UndefinedReference : CensusDefect::DamagedEntity, i);
  }
  const bool complex = this->File.IsComplex(i);
  // Some systems write solder balls so, against the standard; the meaning is certain.
  const bool isWhole = this->Entities.Has(i, STEPRole::Face) && IsWholeSurface(this->Entities, i);
  for (std::size_t k = 0; k < this->File.GetNumberOfRecords(i) && !isWhole; ++k)
  {
    const STEPEntityType* type = this->Entities.GetType(i, k);
    const char* signature = !type ? nullptr : complex ? type->Own : type->Simple;
    if (signature)
    {
      this->CheckRecord(i, this->File.GetParameters(i, k), signature, flat);
    }
  }
  // OpenCASCADE takes any point of a vertex for a CARTESIAN_POINT.
  std::string_view record;
  const Index point = this->Entities.FindRecord(i, PointOfVertex.Record, record)
    ? this->Entities.Follow(this->Entities.Get(i, PointOfVertex))
    : None;
  if (this->Entities.Has(point, STEPRole::Point) &&
    !this->Entities.FindRecord(point, "CARTESIAN_POINT", record))
  {
    this->AddPeril(CensusDefect::WrongType, i, this->File.GetId(point), "a point that is not read");
  }
  if (!flat && this->Entities.Has(i, STEPRole::Placement))
  {
    this->CheckLocation(i);
  }
  if (this->Entities.Has(i, STEPRole::SplineCurve))
  {
    this->CheckSplineCurve(i);
  }
  if (this->Entities.Has(i, STEPRole::SplineSurface))
  {
    this->CheckSplineSurface(i);
  }
}
}
