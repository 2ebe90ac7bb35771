#include "smRepeatedBodies.h"

#include <cmath>

namespace sm
{
bool RepeatedBodies::Add(std::uint64_t body, const Placement& placement)
{
  constexpr double Step = 1e-6;
  constexpr double Largest = 1e18;
  Key key;
  std::get<0>(key) = body;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const double value = (k < 3 ? placement.Linear[i][k] : placement.Translation[i]) / Step;
      std::get<2>(key)[4 * i + k] = std::abs(value) < Largest ? std::llround(value) : 0;
    }
  }
  std::get<1>(key) = this->Path.back();
  bool result = this->Below.count(key) > 0;
  this->Own.insert(key);
  for (const std::uint64_t occurrence : this->Path)
  {
    std::get<1>(key) = occurrence;
    result = result || (occurrence != this->Path.back() && this->Own.count(key) > 0);
    this->Below.insert(key);
  }
  return result;
}
}
