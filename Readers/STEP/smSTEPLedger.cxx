#include "smSTEPLedger.h"

#include "smSTEPCensus.h"

#include <unordered_map>
#include <unordered_set>

namespace sm
{
std::string DescribeCause(const Part21File& file, const STEPLedger& ledger, Part21File::Index entity)
{
  using Index = Part21File::Index;
  std::unordered_map<std::uint64_t, const LedgerRow*> rows;
  for (const LedgerRow& row : ledger.Rows)
  {
    rows.emplace(row.Id, &row);
  }
  const auto describe = [&file](Index i, const std::string& reason)
  {
    return "entity #" + std::to_string(file.GetId(i)) + " (" + file.GetTypeNames()[file.GetType(i)] +
      ") is not read, " + reason;
  };
  std::vector<Index> reached{ entity };
  std::unordered_set<Index> seen{ entity };
  std::string cause = "its entities are not understood";
  for (std::size_t k = 0; k < reached.size(); ++k)
  {
    const Index i = reached[k];
    const auto row = rows.find(file.GetId(i));
    bool isUndefined = false;
    for (const Index next : file.GetReferences(i))
    {
      isUndefined = isUndefined || next == Part21File::None;
      if (next != Part21File::None && seen.insert(next).second)
      {
        reached.push_back(next);
      }
    }
    if (isUndefined || file.IsDamaged(i))
    {
      return describe(
        i, GetName(isUndefined ? CensusDefect::UndefinedReference : CensusDefect::DamagedEntity));
    }
    cause = row == rows.end() ? cause : describe(i, row->second->Reason);
  }
  return cause;
}
}
