#include "Detail/smCoincidentSolids.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sm
{
namespace
{
/// Largest difference of coincident solids, relative to the volume and to its cube root.
constexpr double CoincidenceLimit = 1e-9;
/// Numbers of coincident pairs that a message names, and that are counted.
constexpr std::size_t NamedPairs = 5;
constexpr std::size_t MaxPairs = 100000;
}

void NoteCoincidences(const std::vector<BodyIntegrals>& bodies, MassAnalysis& analysis)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const MassProperties& properties = analysis.Rows[i].Properties;
    if (std::isfinite(properties.Volume) && std::isfinite(properties.Center[0]))
    {
      order.push_back(i);
    }
  }
  const auto get = [&](std::size_t k) -> const MassProperties& { return analysis.Rows[order[k]].Properties; };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return analysis.Rows[a].Properties.Center[0] < analysis.Rows[b].Properties.Center[0]; });
  std::string named;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const double slack = CoincidenceLimit * std::cbrt(get(i).Volume);
    for (std::size_t j = i + 1; j < order.size() && get(j).Center[0] - get(i).Center[0] <= slack; ++j)
    {
      if (std::abs(get(j).Volume - get(i).Volume) <= CoincidenceLimit * get(i).Volume &&
        vtkMath::Distance2BetweenPoints(get(i).Center.data(), get(j).Center.data()) <= slack * slack)
      {
        if (++pairs <= NamedPairs)
        {
          named += (pairs > 1 ? "; " : "") + bodies[order[i]].Id + " and " + bodies[order[j]].Id;
        }
        if (pairs == MaxPairs)
        {
          i = order.size();
          break;
        }
      }
    }
  }
  if (pairs == 1)
  {
    analysis.Messages.push_back("solids " + named +
      " have the same volume and centre of mass: they overlap, and both are counted; if one of them is too "
      "many, add the line \"*,counted once in place\" to the materials");
  }
  else if (pairs > 1)
  {
    analysis.Messages.push_back((pairs == MaxPairs ? "at least " : "") + std::to_string(pairs) +
      " pairs of solids (" + named + (pairs > NamedPairs ? "; ..." : "") +
      ") have the same volume and centre of mass: they overlap, and all are counted; if some are too many, "
      "add the line \"*,counted once in place\" to the materials");
  }
}
}
