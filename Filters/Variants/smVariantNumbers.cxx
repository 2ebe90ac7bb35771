#include "Detail/smVariantNumbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sm
{
bool IsInRange(const double* c, std::size_t directions)
{
  return std::all_of(c, c + directions, [](double number) { return std::abs(number) <= MaximumNumber; });
}

std::size_t& GetFailingBatch()
{
  static std::size_t largest = std::numeric_limits<std::size_t>::max();
  return largest;
}

bool UploadVariables(ComputeBuffer& to, const double* c, std::size_t count, std::size_t directions)
{
  if (count > GetFailingBatch())
  {
    return false;
  }
  std::vector<char> isUsable(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    isUsable[i] = IsInRange(c + i * directions, directions) ? 1 : 0;
  }
  return to.Fill<double>(count * directions,
    [&](double* number)
    {
      for (std::size_t k = 0; k < directions; ++k)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          *number++ = isUsable[i] ? c[i * directions + k] : 0.0;
        }
      }
    });
}
}
