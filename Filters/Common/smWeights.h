/**
 * @file smWeights.h
 * @brief The densities and masses that results can be computed from
 */
#ifndef smWeights_h
#define smWeights_h

namespace sm
{
/// The range of IsWeight(), for messages.
constexpr const char* WeightRange = "1e-200 to 1e200";

/// Returns true for a density in kg/m^3 or a mass in kg whose products with volumes and squared lengths keep
/// all digits: outside of these limits they might be infinite, or subnormal numbers, which have few digits.
inline bool IsWeight(double value)
{
  return value >= 1e-200 && value <= 1e200;
}
}

#endif
