/**
 * @file smSTEPPerils.h
 * @brief Finds faces that depend on entities which a reader must not follow
 */
#ifndef smSTEPPerils_h
#define smSTEPPerils_h

#include "smSTEPCensus.h"

#include <unordered_map>
#include <vector>

namespace sm
{
/// Answers which of the census' perils an entity reaches by its references. Each entity is visited once.
/// Keeps references to both. Not thread safe.
class SMREADERSPART21_EXPORT STEPPerils
{
public:
  STEPPerils(const Part21File& file, const STEPCensus& census);

  /// Returns the peril of the entity, or of one that it depends on; null for none.
  const CensusProblem* Find(Part21File::Index entity);

private:
  const Part21File& File;
  std::unordered_map<Part21File::Index, const CensusProblem*> Perils;
  std::vector<bool> IsVisited;
  std::unordered_map<Part21File::Index, const CensusProblem*> Reached;
};
}

#endif
