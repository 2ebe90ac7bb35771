#include "smFaceResultCache.h"

namespace sm
{
std::size_t CountBytes(const FaceIntegrals& result)
{
  std::size_t bytes =
    sizeof(FaceIntegrals) + result.Gaps.capacity() * sizeof(CoedgeGap) + result.Error.capacity();
  for (const std::vector<double>* values : { &result.Face, &result.Closing, &result.QuadratureError,
         &result.Rounding, &result.Conversion, &result.Residual })
  {
    bytes += values->capacity() * sizeof(double);
  }
  return bytes;
}
}
