/**
 * @file smSignChanges.h
 * @brief Sign changes of a polynomial of high degree that is known by evaluation, proved by its Chebyshev
 * series
 */
#ifndef smSignChanges_h
#define smSignChanges_h

#include <functional>
#include <vector>

namespace sm
{
/// Computes the Chebyshev coefficients on [start, end] of the polynomial `evaluate`, whose degree is at most
/// `degree`. Requires 0
/// <= degree < ChebyshevRule::MaximumSize.
void ExpandPolynomial(const std::function<double(double)>& evaluate, int degree, double start, double end,
  std::vector<double>& series);
/// Returns an upper bound of the polynomial's absolute value on [-1,1].
double GetLargest(const std::vector<double>& series);

/// An interval on which a polynomial has one sign.
struct SignedRange
{
  double Start, End;
  bool Negative;
};

/**
 * Splits [start, end] into ranges on which the polynomial of `degree` is negative, or is not, and appends
 * them in order. A range is halved until the series proves one sign, or proves monotonicity, so that
 * bisection finds the only zero, or until `isSmall` accepts that a polynomial of absolute value at most
 * `largest` may have either sign on it. `isSmall` is called with last = true when no halvings are left; its
 * return value is then ignored.
 */
void FindSignedRanges(const std::function<double(double)>& evaluate, int degree, double start, double end,
  const std::function<bool(double start, double end, double largest, bool last)>& isSmall,
  std::vector<SignedRange>& ranges);
}

#endif
