#include "smRowSums.h"

#include "smPortableCxx.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
struct ErrorFree
{
#include "glsl/smErrorFree.glsl"
};
}

void SumRows(const double* rows, std::size_t count, int stride, std::vector<double>& errors, double* sums)
{
  std::fill(sums, sums + stride, 0.0);
  errors.assign(stride, 0.0);
  for (std::size_t row = 0; row < count; ++row, rows += stride)
  {
    for (int column = 0; column < stride; ++column)
    {
      const dvec2 next = ErrorFree().smTwoSum(sums[column], rows[column]);
      sums[column] = next.x;
      errors[column] += next.y;
    }
  }
  for (int column = 0; column < stride; ++column)
  {
    // The accumulated errors of an infinite sum are NaN.
    sums[column] += std::isfinite(sums[column]) ? errors[column] : 0.0;
  }
}
}
