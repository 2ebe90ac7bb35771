#include "smEqualParts.h"

#include "smEqualBodies.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <unordered_map>

namespace sm
{
namespace
{
/// A body is compared with so many first bodies of its hash, the last ones.
constexpr std::size_t MaxComparisons = 8;

/// Roundings of the largest coordinate by which a copy is elsewhere, besides those of the conversion of the
/// first body: one each for the decimals of both bodies, two for the difference of a point, which is up to
/// twice the coordinate, and one for the copy's origin.
constexpr int CopyRoundings = 5;
/// Roundings of the product with another output unit: the factor and the product, of a translation up to
/// twice the coordinate, and of the sum.
constexpr int ScaledRoundings = 6;

bool CanEqual(const PartBody& part)
{
  return IsIdentity(part.Scale) && part.LostFaces == 0;
}
}

std::vector<EqualPart> FindEqualParts(const std::vector<PartBody>& bodies, int roundings, bool isScaled)
{
  const double steps = CopyRoundings + 2.0 * roundings + (isScaled ? ScaledRoundings : 0);
  std::vector<EqualPart> parts(bodies.size());
  std::unordered_map<std::size_t, std::vector<std::size_t>> firsts;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    parts[i].First = i;
    if (!CanEqual(bodies[i]))
    {
      continue;
    }
    std::vector<std::size_t>& candidates = firsts[GetShapeHash(bodies[i].Shape)];
    const std::size_t skipped = candidates.size() - std::min(candidates.size(), MaxComparisons);
    for (std::size_t k = candidates.size(); k > skipped && parts[i].First == i; --k)
    {
      const std::size_t first = candidates[k - 1];
      const BodyShift shift = CompareBodies(bodies[first].Shape, bodies[i].Shape);
      if (!shift.IsEqual || bodies[first].Solid != bodies[i].Solid)
      {
        continue;
      }
      parts[i].First = first;
      parts[i].Shift = shift.Shift;
      parts[first].HasCopies = true;
      for (int c = 0; c < 3; ++c)
      {
        parts[first].Moved[c] =
          std::max(parts[first].Moved[c], shift.Deviation[c] + steps * UnitRoundoff * shift.Reach[c]);
      }
    }
    if (parts[i].First == i)
    {
      candidates.push_back(i);
    }
  }
  return parts;
}
}
