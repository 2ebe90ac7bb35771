#include "smRepeatedBodies.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Largest difference of the numbers of two placements that are one place, without that of roundings: a
/// millionth for directions, and a nanometre.
constexpr double SamePlace = 1e-6;

/// Bound of the roundings of a number of two motions.
double GetRounding(double value)
{
  return 32.0 * UnitRoundoff * std::abs(value);
}

bool IsSame(const std::array<double, 12>& a, const std::array<double, 12>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(),
    [](double x, double y)
    { return std::abs(x - y) <= SamePlace + GetRounding(std::max(std::abs(x), std::abs(y))); });
}
}

bool RepeatedBodies::Add(std::uint64_t body, const Placement& placement)
{
  Numbers numbers;
  double mark = 0.0;
  double width = 0.0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = i % 4 < 3 ? placement.Linear[i / 4][i % 4] : placement.Translation[i / 4];
    // Roots of different numbers: regular patterns of places have different marks, too. No sum overflows.
    const double weight = std::sqrt(static_cast<double>(i + 2)) / 64.0;
    mark += weight * numbers[i];
    // Twice: also that of the other place, and of these sums.
    width += 2.0 * weight * (SamePlace + GetRounding(numbers[i]));
  }
  if (!std::isfinite(mark))
  {
    return false;
  }
  const auto contains = [&](const std::set<Key>& places, std::uint64_t occurrence)
  {
    auto place = places.lower_bound({ body, occurrence, mark - width, 0 });
    const auto end = places.lower_bound({ body, occurrence, mark + width, this->Places.size() });
    return std::any_of(
      place, end, [&](const Key& key) { return IsSame(numbers, this->Places[std::get<3>(key)]); });
  };
  bool result = contains(this->Below, this->Path.back());
  for (std::size_t i = 0; i + 1 < this->Path.size() && !result; ++i)
  {
    result = contains(this->Own, this->Path[i]);
  }
  const std::size_t index = this->Places.size();
  this->Places.push_back(numbers);
  this->Own.insert({ body, this->Path.back(), mark, index });
  for (const std::uint64_t occurrence : this->Path)
  {
    this->Below.insert({ body, occurrence, mark, index });
  }
  return result;
}
}
