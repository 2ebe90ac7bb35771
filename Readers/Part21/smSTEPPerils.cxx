#include "smSTEPPerils.h"

#include <utility>

namespace sm
{
STEPPerils::STEPPerils(const Part21File& file, const STEPCensus& census)
  : File(file)
{
  for (const CensusProblem& peril : census.Perils)
  {
    this->Perils.emplace(file.Find(peril.Id), &peril);
  }
}

const CensusProblem* STEPPerils::Find(Part21File::Index entity)
{
  if (this->Perils.empty() || entity == Part21File::None)
  {
    return nullptr;
  }
  // An entity gets its peril when the last of its references is done. One on a cycle is a peril itself, so
  // that nothing is missed where the search meets an entity that is still open.
  this->IsVisited.resize(this->File.GetNumberOfInstances());
  std::vector<std::pair<Part21File::Index, std::size_t>> path;
  const auto enter = [&](Part21File::Index i)
  {
    if (i != Part21File::None && !this->IsVisited[i])
    {
      this->IsVisited[i] = true;
      path.emplace_back(i, 0);
    }
  };
  enter(entity);
  while (!path.empty())
  {
    const auto [i, k] = path.back();
    const Part21Range<Part21File::Index> references = this->File.GetReferences(i);
    const auto own = this->Perils.find(i);
    if (k < references.size() && own == this->Perils.end())
    {
      ++path.back().second;
      enter(references[k]);
      continue;
    }
    const CensusProblem* found = own == this->Perils.end() ? nullptr : own->second;
    for (std::size_t r = 0; r < references.size() && !found; ++r)
    {
      const auto reached = this->Reached.find(references[r]);
      found = reached == this->Reached.end() ? nullptr : reached->second;
    }
    if (found)
    {
      this->Reached.emplace(i, found);
    }
    path.pop_back();
  }
  const auto reached = this->Reached.find(entity);
  return reached == this->Reached.end() ? nullptr : reached->second;
}
}
