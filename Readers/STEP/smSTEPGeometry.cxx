#include "smSTEPGeometry.h"

#include "smSTEPGeometryMakers.h"

namespace sm
{
namespace
{
/// Longest chain of entities of geometry that refer to one another.
constexpr int MaxGeometryChain = 1000;

std::string DescribeType(const Part21File& file, Part21File::Index entity)
{
  std::string type;
  for (std::size_t k = 0; k < file.GetNumberOfRecords(entity); ++k)
  {
    type += (k > 0 ? " " : "") + file.GetTypeNames()[file.GetType(entity, k)];
  }
  return type;
}
}

STEPGeometry::STEPGeometry(const STEPAttributes& entities, const STEPUnitSizes& units, STEPLedger& ledger)
  : Entities(entities)
  , Units(units)
  , Ledger(ledger)
{
}

STEPGeometry::~STEPGeometry() = default;

template <class Value, class Make>
const Value* STEPGeometry::Find(
  std::unordered_map<Index, Entry<Value>>& entries, Index entity, const char* consequence, const Make& make)
{
  if (entity == Part21File::None)
  {
    return nullptr;
  }
  const auto [found, isNew] = entries.try_emplace(entity);
  if (!isNew)
  {
    // An entity that is not finished depends on itself; the first one that asked for it gets the row.
    return found->second.IsOpen ? nullptr : found->second.Result.get();
  }
  const Part21File& file = this->Entities.File;
  std::unique_ptr<Value> result;
  std::string reason;
  ++this->Depth;
  try
  {
    if (this->Depth > MaxGeometryChain)
    {
      throw STEPGeometryFailure{ "it is at the end of a chain of more than " +
        std::to_string(MaxGeometryChain) + " curves and surfaces" };
    }
    if (file.IsDamaged(entity))
    {
      throw STEPGeometryFailure{ "it is damaged" };
    }
    result = std::make_unique<Value>(make(entity));
  }
  catch (const STEPGeometryFailure& failure)
  {
    reason = failure.Reason;
  }
  --this->Depth;
  if (!result)
  {
    this->Ledger.Rows.push_back({ file.GetId(entity), DescribeType(file, entity), reason, consequence });
  }
  // Others may have been added in between.
  Entry<Value>& entry = entries[entity];
  entry.Result = std::move(result);
  entry.IsOpen = false;
  return entry.Result.get();
}

const STEPCurve<3>* STEPGeometry::GetCurve(Index entity)
{
  return this->Find(this->Curves, entity, "edges on it have no curve",
    [this](Index i) { return STEPCurveMaker<3>(*this).Make(i); });
}

const STEPCurve<2>* STEPGeometry::GetPlaneCurve(Index entity)
{
  return this->Find(this->PlaneCurves, entity, "edges have no parameter curve on the surface",
    [this](Index i) { return STEPCurveMaker<2>(*this).Make(i); });
}

const STEPSurface* STEPGeometry::GetSurface(Index entity)
{
  return this->Find(this->Surfaces, entity, "faces on it are missing",
    [this](Index i) { return STEPSurfaceMaker(*this).Make(i); });
}

void STEPGeometry::Take(STEPGeometry& other)
{
  const auto take = [](auto& own, auto& others)
  {
    own.merge(others);
    // At the end of a long chain one of the two may have a row for what the other one has made.
    for (auto& [entity, entry] : others)
    {
      if (!own[entity].Result)
      {
        own[entity].Result = std::move(entry.Result);
      }
    }
  };
  take(this->Curves, other.Curves);
  take(this->PlaneCurves, other.PlaneCurves);
  take(this->Surfaces, other.Surfaces);
}

STEPCurve<2> STEPGeometry::MapToNatural(
  const STEPCurve<2>& curve, const STEPSurface& surface, std::string& problem) const
{
  AffineTransform<2> transform;
  for (int d = 0; d < 2; ++d)
  {
    transform.Linear[d][d] = surface.Parameters[d].Scale;
    transform.Translation[d] = surface.Parameters[d].Offset;
  }
  ParameterScale own;
  STEPCurve<2> result;
  result.Value = TransformCurve<2>(curve.Value, transform, own, problem);
  result.Range = { own(curve.Range.Low), own(curve.Range.High) };
  result.Parameter = { own.Scale * curve.Parameter.Scale, own(curve.Parameter.Offset) };
  return result;
}
}
