#include "smSTEPFaceLoops.h"

#include "smParallelFor.h"
#include "smSTEPTopologyAttributes.h"

namespace sm
{
namespace
{
/// Number of bounds that a thread reads at a time.
constexpr std::size_t Grain = 64;

/// Reads the oriented edges of a loop; returns false if one is missing or there is none.
bool ReadEdges(const STEPAttributes& entities, STEPFaceLoop& loop)
{
  Part21Values values(entities.Get(loop.Entity, EdgesOfLoop).Text);
  for (Part21Value value; values.Next(value);)
  {
    const Part21File::Index oriented = entities.Follow(value);
    const Part21File::Index edge = entities.Follow(entities.Get(oriented, EdgeOfOriented));
    if (!entities.Has(edge, STEPRole::Edge))
    {
      return false;
    }
    loop.Uses.push_back({ edge, entities.Get(oriented, SenseOfOriented).Text != "F" });
  }
  return !loop.Uses.empty();
}

STEPFaceLoop ReadLoop(const STEPAttributes& entities, Part21File::Index bound)
{
  STEPFaceLoop loop;
  loop.Entity = entities.Follow(entities.Get(bound, LoopOfBound));
  loop.IsForward = entities.Get(bound, SenseOfBound).Text != "F";
  const auto is = [&](const char* record)
  {
    std::string_view parameters;
    return entities.FindRecord(loop.Entity, record, parameters);
  };
  if (is("VERTEX_LOOP"))
  {
    loop.Kind = STEPFaceLoop::Type::Vertex;
  }
  else if (is("POLY_LOOP"))
  {
    loop.Kind = STEPFaceLoop::Type::Polygon;
  }
  else if ((is(EdgesOfLoop.Record) || is("EDGE_LOOP")) && ReadEdges(entities, loop))
  {
    loop.Kind = STEPFaceLoop::Type::Edges;
  }
  return loop;
}
}

STEPFaceLoops::STEPFaceLoops(const STEPAttributes& entities, const STEPCensus& census)
  : Loops(census.Bounds.size())
{
  ParallelFor(this->Loops.size(), Grain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t b = begin; b < end; ++b)
      {
        this->Loops[b] = ReadLoop(entities, entities.File.Find(census.Bounds[b]));
      }
    });
}
}
