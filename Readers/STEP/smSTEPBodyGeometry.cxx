#include "smSTEPBodyGeometry.h"

#include "Loops/smAxialProfile.h"
#include "smCatchFailure.h"
#include "smParallelFor.h"
#include "smSTEPRevolvedConics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace sm
{
namespace
{
/// A trim that is closer to an end of its domain than this, relative to the domain, is there.
constexpr double EndRounding = 1e-12;

/// Smallest number of edges and surfaces that one thread makes with a ledger of its own, and largest number
/// of such chunks: of as many a curve is made again at most, if it has no basis in common with the others.
constexpr std::size_t ChunkSize = 256;
constexpr std::size_t MaxChunks = 64;
/// Number of chunks between two calls of `shouldContinue`.
constexpr std::size_t ChunksPerReport = 16;
/// Largest number of entities from one to its basis.
constexpr int MaxBasisChain = 64;

SurfacePointer Require(const SurfacePointer& surface, const std::string& problem)
{
  return surface ? surface : throw std::runtime_error(problem);
}
}

STEPBodyGeometry::STEPBodyGeometry(
  const STEPAttributes& entities, const STEPUnitSizes& units, STEPLedger& ledger)
  : Values(entities, units, ledger)
  , Edges(entities, units, this->Values, ledger)
  , Units(units)
  , Entities(entities)
  , Ledger(ledger)
{
}

/// Returns the curve or surface at the end of a chain of those that refer to one another: what entities have
/// in common.
Part21File::Index STEPBodyGeometry::FindBasis(Index entity) const
{
  constexpr std::uint64_t roles = STEPRole::Curve | STEPRole::Surface | STEPRole::CurveSegment;
  for (int step = 0; step < MaxBasisChain && entity != Part21File::None; ++step)
  {
    const Part21Range<Index> references = this->Entities.File.GetReferences(entity);
    const auto next = std::find_if(references.begin(), references.end(),
      [this](Index reference) { return this->Entities.Has(reference, roles); });
    if (next == references.end())
    {
      break;
    }
    entity = *next;
  }
  return entity;
}

std::vector<std::vector<STEPBodyGeometry::Item>> STEPBodyGeometry::Divide(
  const std::vector<Index>& edges, const std::vector<Index>& surfaces) const
{
  std::unordered_map<Index, std::size_t> groupOf;
  std::vector<std::vector<Item>> groups;
  const auto add = [&](const Item& item)
  {
    const auto [found, isNew] = groupOf.emplace(this->FindBasis(item.Entity), groups.size());
    if (isNew)
    {
      groups.emplace_back();
    }
    groups[found->second].push_back(item);
  };
  for (const Index edge : edges)
  {
    add({ edge, true });
  }
  for (const Index surface : surfaces)
  {
    add({ surface, false });
  }
  const std::size_t size = std::max(ChunkSize, (edges.size() + surfaces.size()) / MaxChunks);
  std::vector<std::vector<Item>> chunks;
  for (std::vector<Item>& group : groups)
  {
    if (chunks.empty() || chunks.back().size() >= size)
    {
      chunks.emplace_back();
    }
    chunks.back().insert(chunks.back().end(), group.begin(), group.end());
  }
  return chunks;
}

bool STEPBodyGeometry::Make(
  const std::vector<Index>& edges, const std::vector<Index>& surfaces, const ContinueCallback& shouldContinue)
{
  struct Chunk
  {
    STEPLedger Ledger;
    std::unique_ptr<STEPBodyGeometry> Geometry;
  };
  const std::vector<std::vector<Item>> items = this->Divide(edges, surfaces);
  for (std::size_t start = 0; start < items.size(); start += ChunksPerReport)
  {
    if (!shouldContinue())
    {
      return false;
    }
    std::vector<Chunk> chunks(std::min(ChunksPerReport, items.size() - start));
    ParallelFor(chunks.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t k = begin; k < end; ++k)
        {
          Chunk& chunk = chunks[k];
          chunk.Geometry = std::make_unique<STEPBodyGeometry>(this->Entities, this->Units, chunk.Ledger);
          for (const Item& item : items[start + k])
          {
            if (item.IsEdge)
            {
              chunk.Geometry->Edges.GetEdge(item.Entity);
            }
            else
            {
              chunk.Geometry->GetSurface(item.Entity);
            }
          }
        }
      });
    for (Chunk& chunk : chunks)
    {
      this->Take(*chunk.Geometry);
    }
  }
  return true;
}

void STEPBodyGeometry::Take(STEPBodyGeometry& other)
{
  this->Values.Take(other.Values);
  this->Edges.Take(other.Edges);
  for (auto& [entity, surface] : other.Surfaces)
  {
    surface.Value = this->Values.GetSurface(entity);
  }
  this->Surfaces.merge(other.Surfaces);
  std::move(other.Ledger.Rows.begin(), other.Ledger.Rows.end(), std::back_inserter(this->Ledger.Rows));
}

const STEPBodyGeometry::Surface& STEPBodyGeometry::GetSurface(Index entity)
{
  const auto [found, isNew] = this->Surfaces.try_emplace(entity);
  Surface& surface = found->second;
  surface.Value = isNew ? this->Values.GetSurface(entity) : surface.Value;
  if (isNew && surface.Value)
  {
    const std::string failure = CatchFailure([&] { this->MakeNative(entity, surface); });
    if (!failure.empty())
    {
      surface.Native = nullptr;
      this->AddRow(entity, failure, "faces on it are missing");
    }
  }
  return surface;
}

std::shared_ptr<const FootPointFinder> STEPBodyGeometry::GetFinder(Index entity)
{
  Surface& surface = this->Surfaces[entity];
  if (!surface.Finder && surface.Native)
  {
    CatchFailure([&] { surface.Finder = FootPointFinder::Make(surface.Native); });
  }
  return surface.Finder;
}

void STEPBodyGeometry::AddRow(Index entity, const std::string& reason, const char* consequence)
{
  const Part21File& file = this->Entities.File;
  this->Ledger.Rows.push_back(
    { file.GetId(entity), file.GetTypeNames()[file.GetType(entity)], reason, consequence });
}

SurfacePointer STEPBodyGeometry::TakeSelectedPart(const Surface& surface)
{
  const ElementarySurface* torus = FindElementary(*surface.Value->Value, ElementarySurface::Type::Torus);
  const bool isPart = torus && torus->Selected != ElementarySurface::Part::Whole &&
    torus->Radii[1] > torus->Radii[0] && torus->Radii[0] >= 0.0;
  return isPart ? RevolveTorus(*torus, surface.Value->Value->GetDomain(1)) : surface.Native;
}

void STEPBodyGeometry::MakeNative(Index entity, Surface& surface)
{
  const STEPSurface& value = *surface.Value;
  std::string problem;
  if (const ElementarySurface* torus = FindElementary(*value.Value, ElementarySurface::Type::Torus))
  {
    // Edges decide which part of a torus that crosses itself a face is on.
    ElementarySurface whole = *torus;
    whole.Selected = ElementarySurface::Part::Whole;
    whole.Radii[0] = std::abs(torus->Radii[0]);
    surface.IsFlipped = (torus->Radii[0] < 0.0) != value.IsReversed();
    surface.Native = Require(GeometricSurface::Make(whole, problem), problem);
  }
  else
  {
    surface.IsFlipped = value.IsReversed();
    surface.Native = value.Value;
  }
  ParameterRange turn;
  if (FindRevolvedRange(this->Entities, this->Values, entity, value, turn))
  {
    RevolvedSurface part = *value.Value->GetIf<RevolvedSurface>();
    part.Range = turn;
    surface.Native = Require(GeometricSurface::Make(std::move(part), problem), problem);
    return;
  }
  surface.Native = MakePeriodic(surface.Native, surface.Own);
  for (int d = 0; d < 2; ++d)
  {
    const ParameterRange& domain = value.Value->GetDomain(d);
    const ParameterRange& stated = value.Range[d];
    // The numbers of the file may lie beyond the ends by their rounding.
    const double width = domain.High - domain.Low;
    const double slack = std::isfinite(width) ? EndRounding * width : 0.0;
    if (std::abs(stated.Low - domain.Low) > slack || std::abs(stated.High - domain.High) > slack)
    {
      surface.Range[d] = stated;
    }
  }
}
}
