#include "smSTEPShapes.h"

#include "smSTEPTopologyAttributes.h"

#include <map>
#include <unordered_set>

namespace sm
{
Part21File::Index STEPShapes::GetSurfaceEntity(Index face) const
{
  return this->Entities.Follow(this->Entities.Get(face, SurfaceOfFace));
}

STEPBodyGeometry& STEPShapes::GetGeometry(int context)
{
  std::unique_ptr<STEPBodyGeometry>& geometry = this->Geometries[context];
  if (!geometry)
  {
    STEPUnitSizes units;
    if (context >= 0)
    {
      const CensusContext& stated = this->Census.Contexts[context];
      units.Length = stated.Length.Factor > 0.0 ? stated.Length.Factor : 1.0;
      units.Angle = stated.Angle.Factor > 0.0 ? stated.Angle.Factor : 1.0;
    }
    geometry = std::make_unique<STEPBodyGeometry>(this->Entities, units, this->Ledger);
  }
  return *geometry;
}

bool STEPShapes::MakeGeometry(
  const std::vector<const CensusBody*>& bodies, const ContinueCallback& shouldContinue)
{
  struct Needed
  {
    std::vector<Index> Edges;
    std::vector<Index> Surfaces;
    std::unordered_set<Index> Seen{ Part21File::None };
  };
  std::map<int, Needed> contexts;
  for (const CensusBody* body : bodies)
  {
    Needed& needed = contexts[body->Context];
    const auto add = [&needed](Index entity, std::vector<Index>& list)
    {
      if (needed.Seen.insert(entity).second)
      {
        list.push_back(entity);
      }
    };
    for (std::uint32_t s = body->FirstShell; s < body->FirstShell + body->NumberOfShells; ++s)
    {
      const CensusShell& shell = this->Census.Shells[this->Census.ShellUses[s].Shell];
      for (std::uint32_t f = shell.FirstFace; f < shell.FirstFace + shell.NumberOfFaces; ++f)
      {
        const CensusFace& face = this->Census.Faces[this->Census.FaceUses[f]];
        const Index entity = this->Entities.File.Find(face.Id);
        if (this->Perils.Find(entity))
        {
          continue;
        }
        add(this->GetSurfaceEntity(entity), needed.Surfaces);
        for (const STEPFaceLoop& loop : this->Loops[face])
        {
          for (const STEPFaceLoop::Use& use : loop.Uses)
          {
            add(use.Edge, needed.Edges);
          }
        }
      }
    }
  }
  for (const auto& [context, needed] : contexts)
  {
    if (!this->GetGeometry(context).Make(needed.Edges, needed.Surfaces, shouldContinue))
    {
      return false;
    }
  }
  return true;
}
}
