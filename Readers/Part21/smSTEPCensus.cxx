#include "smSTEPCensus.h"

#include "smSTEPCensusTaker.h"

namespace sm
{
STEPCensus STEPCensusTaker::Take()
{
  this->Census.Uses.assign(this->File.GetNumberOfInstances(), 0);
  this->GeometricDamage.assign(this->File.GetNumberOfInstances(), false);
  this->Visited.assign(this->File.GetNumberOfInstances(), 0);
  this->SortEntities();
  this->FindPlacements();
  this->JoinShapes();
  this->AddBodies();
  this->AddArcs();
  this->CountAll();
  this->SolidsBelow = this->FindAbove({ CensusBodyKind::Solid }, true);
  this->SetInstances();
  this->CheckTwicePlaced();
  this->CheckAlternatives();
  this->CheckVersions();
  this->FindAlternatives();
  this->FindShapelessProducts();
  this->ListProducts();
  this->ReadQuantities();
  this->WalkBodies();
  this->FindCycles();
  this->MarkStructure();
  this->CheckBounds();
  this->CheckLoops();
  this->CheckEdges();
  this->FindUnused();
  this->SpreadDamage();
  this->ReportUnits();
  return std::move(this->Census);
}

void STEPCensusTaker::Add(CensusDefect defect, Index entity, std::uint64_t other, const char* place)
{
  if (this->Census.Counts[static_cast<std::size_t>(defect)]++ < STEPCensus::ProblemLimit)
  {
    this->Census.Problems.push_back({ defect, this->File.GetId(entity), other, place });
  }
}

void STEPCensusTaker::AddPeril(CensusDefect defect, Index entity, std::uint64_t other, const char* place)
{
  this->GeometricDamage[entity] = true;
  this->Add(defect, entity, other, place);
  this->Census.Perils.push_back({ defect, this->File.GetId(entity), other, place });
}

STEPCensusTaker::Index STEPCensusTaker::Follow(
  Index from, const STEPAttribute& attribute, std::uint64_t roles)
{
  return this->Follow(from, this->Entities.Get(from, attribute), roles, attribute.Name);
}

STEPCensusTaker::Index STEPCensusTaker::Follow(
  Index from, const Part21Value& value, std::uint64_t roles, const char* place)
{
  const Index to = this->Entities.Follow(value);
  if (to == None)
  {
    this->Add(value.IsReference() ? CensusDefect::UndefinedReference : CensusDefect::WrongParameter, from,
      value.Id, place);
    return None;
  }
  if (roles != ~std::uint64_t{ 0 } && !this->Entities.Has(to, roles))
  {
    // The schemas have more types of representations and of shape definitions (for features, for example)
    // than the table, so another type is not a defect here. A solid that is reached only through one is
    // reported as lost.
    const bool mayBeUnknown = (roles & (STEPRole::Representation | STEPRole::ProductShape)) != 0;
    if (!mayBeUnknown || this->Entities.IsKnown(to))
    {
      this->Add(CensusDefect::WrongType, from, value.Id, place);
    }
    return None;
  }
  return to;
}

std::size_t STEPCensus::CountBodies(CensusBodyKind kind) const
{
  std::size_t count = 0;
  for (const CensusBody& body : this->Bodies)
  {
    count += body.Kind == kind && body.Instances > 0 ? 1 : 0;
  }
  return count;
}

CensusCount STEPCensus::CountInstances(CensusBodyKind kind) const
{
  CensusCount count = 0;
  for (const CensusBody& body : this->Bodies)
  {
    count = AddCounts(count, body.Kind == kind ? body.Instances : 0);
  }
  return count;
}

std::uint64_t STEPCensus::CountFaces(CensusBodyKind kind) const
{
  std::uint64_t count = 0;
  for (const CensusBody& body : this->Bodies)
  {
    count += body.Kind == kind && body.Instances > 0 ? body.Faces : 0;
  }
  return count;
}

STEPCensus TakeSTEPCensus(const Part21File& file)
{
  return STEPCensusTaker(file).Take();
}

const char* GetName(CensusDefect defect)
{
  static const char* const names[] = { "damaged entity", "undefined reference", "wrong type",
    "wrong parameter", "value out of range", "inconsistent spline", "cyclic reference", "bound of two faces",
    "a curved edge runs against its neighbours", "a vertex is off the surface of its face",
    "a curve does not pass through the vertices of its edge",
    "an edge runs against its loop or its curve, with the same points", "face twice in a shell",
    "item twice in a representation", "exact and faceted shapes of one product, which are both counted",
    "several definitions of one product, which are all counted",
    "a product of closed surfaces without a solid, whose volume is not added to that of solids",
    "used by nothing", "shell without faces", "assembly contains itself", "missing placement",
    "placed as an occurrence and by a mapped item, which are both counted", "placement of other products",
    "in no product", "missing unit", "wrong unit", "absurd unit" };
  static_assert(
    sizeof(names) / sizeof(names[0]) == static_cast<std::size_t>(CensusDefect::Count), "a name each");
  return names[static_cast<std::size_t>(defect)];
}
}
