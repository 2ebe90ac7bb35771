#include "smSTEPCensus.h"

#include "smSTEPCensusTaker.h"

namespace sm
{
STEPCensus STEPCensusTaker::Take()
{
  this->Census.Uses.assign(this->File.GetNumberOfInstances(), 0);
  this->Visited.assign(this->File.GetNumberOfInstances(), 0);
  this->SortEntities();
  this->FindPlacements();
  this->JoinShapes();
  this->AddBodies();
  this->AddArcs();
  this->CountAll();
  this->ListProducts();
  this->SolidsBelow = this->FindAbove({ CensusBodyKind::Solid }, true);
  this->SetInstances();
  this->CheckTwicePlaced();
  this->CheckPlacedProducts();
  this->CheckJoinedProducts();
  this->CheckAlternatives();
  this->CheckVersions();
  this->FindAlternatives();
  this->FindShapelessProducts();
  this->ReadQuantities();
  this->WalkBodies();
  this->FindCycles();
  this->MarkStructure();
  this->CheckBounds();
  this->FindUnused();
  this->ReportUnits();
  return std::move(this->Census);
}

void STEPCensusTaker::Add(CensusDefect defect, Index entity, std::uint64_t other, const char* place)
{
  this->Census.AddProblem(defect, this->File.GetId(entity), other, place);
}

void STEPCensusTaker::AddPeril(CensusDefect defect, Index entity, std::uint64_t other, const char* place)
{
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

void STEPCensus::AddProblem(CensusDefect defect, std::uint64_t id, std::uint64_t other, const char* place)
{
  if (this->Counts[static_cast<std::size_t>(defect)]++ < ProblemLimit)
  {
    this->Problems.push_back({ defect, id, other, place });
  }
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

CensusCount STEPCensus::CountNodes() const
{
  CensusCount count = this->CountInstances(CensusBodyKind::Solid);
  if (count == 0)
  {
    count = this->CountInstances(CensusBodyKind::SurfaceModel);
  }
  for (const CensusOccurrence& occurrence : this->Occurrences)
  {
    count = AddCounts(count, occurrence.Instances);
  }
  for (const CensusMappedItem& item : this->MappedItems)
  {
    count = AddCounts(count, item.Instances);
  }
  for (const CensusShape& shape : this->Shapes)
  {
    for (std::size_t k = 0; k < shape.Placed.size(); ++k)
    {
      count = AddCounts(count, shape.Instances);
    }
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
    "placed as an occurrence and by a mapped item, which are both counted",
    "places the shape of an assembly without an occurrence: the parts of the assembly are missing there",
    "places the shape of a product without an occurrence, which is counted in addition to the product",
    "relates the shapes of an occurrence that has another placement, and is not counted",
    "its shape is related to that of another product, so that both have the solids of both",
    "placement of other products", "in no product", "missing unit", "wrong unit", "absurd unit" };
  static_assert(
    sizeof(names) / sizeof(names[0]) == static_cast<std::size_t>(CensusDefect::Count), "a name each");
  return names[static_cast<std::size_t>(defect)];
}
}
