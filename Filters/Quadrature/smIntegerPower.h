/**
 * @file smIntegerPower.h
 * @brief Powers with whole exponents
 */
#ifndef smIntegerPower_h
#define smIntegerPower_h

namespace sm
{
/// Returns base^exponent by repeated squaring; 1 for exponents below 1.
inline double IntegerPower(double base, int exponent)
{
  double power = 1.0;
  for (; exponent > 0; exponent /= 2, base *= base)
  {
    power *= exponent % 2 ? base : 1.0;
  }
  return power;
}
}

#endif
