/**
 * @file smRepeatedBodies.h
 * @brief Bodies of a file that are in one place of the product structure twice
 */
#ifndef smRepeatedBodies_h
#define smRepeatedBodies_h

#include "Geometry/smPlacement.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace sm
{
/**
 * Finds bodies that are counted twice in one place, where one product has the body in two ways, or an
 * assembly has it next to the part that it is. Two occurrences of a part in one place are another matter: the
 * file states both. Call Enter() and Leave() around the visit of an occurrence.
 */
class RepeatedBodies
{
public:
  void Enter() { this->Path.push_back(this->NumberOfOccurrences++); }
  void Leave() { this->Path.pop_back(); }

  /// Adds a body of the occurrence that is visited, by its number. Returns true if it is in the same place
  /// already, in this occurrence, in one of its assemblies or in one of its parts.
  bool Add(std::uint64_t body, const Placement& placement);

private:
  /// The rows of a placement. Motions of one place may differ by roundings, so they are compared with a
  /// tolerance.
  using Numbers = std::array<double, 12>;
  /// Body, occurrence, a sum of the numbers that is close for close places, and the index of the place.
  using Key = std::tuple<std::uint64_t, std::uint64_t, double, std::size_t>;

  std::uint64_t NumberOfOccurrences = 1;
  /// The occurrences that are visited, from the outermost one; 0 stands for the file.
  std::vector<std::uint64_t> Path{ 0 };
  std::vector<Numbers> Places;
  /// Bodies of each occurrence, and those with the bodies of its parts.
  std::set<Key> Own;
  std::set<Key> Below;
};
}

#endif
