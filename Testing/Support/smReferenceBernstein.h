/**
 * @file smReferenceBernstein.h
 * @brief Bernstein polynomials from their definition, in any precision, also of complex parameters
 */
#ifndef smReferenceBernstein_h
#define smReferenceBernstein_h

#include <type_traits>

namespace smtest
{
/// Returns B_i^n(x); 0 for i below 0 or above n.
template <class Number>
Number Bernstein(int n, int i, const Number& x)
{
  static_assert(!std::is_same_v<Number, double>, "the precision of what is checked: name a wider one");
  if (i < 0 || i > n)
  {
    return Number(0);
  }
  Number value(1);
  for (int k = 1; k <= i; ++k)
  {
    value = value * Number(n - i + k) / Number(k);
  }
  for (int k = 0; k < n; ++k)
  {
    value = value * (k < i ? x : Number(1) - x);
  }
  return value;
}

/// Returns the derivative of B_i^n at x.
template <class Number>
Number BernsteinSlope(int n, int i, const Number& x)
{
  return Number(n) * (Bernstein(n - 1, i - 1, x) - Bernstein(n - 1, i, x));
}
}

#endif
