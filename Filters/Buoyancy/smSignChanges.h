/**
 * @file smSignChanges.h
 * @brief Where a polynomial of high degree, known by evaluation, is negative: proved by its Chebyshev series
 */
#ifndef smSignChanges_h
#define smSignChanges_h

#include <functional>
#include <vector>

namespace sm
{
/// Chebyshev coefficients on [start, end] of the polynomial that `evaluate` gives, of `degree` at most.
/// 0 <= degree < ChebyshevRule::MaximumSize.
void ExpandPolynomial(const std::function<double(double)>& evaluate, int degree, double start, double end,
  std::vector<double>& series);
/// No less than the polynomial's absolute value on [-1,1].
double GetLargest(const std::vector<double>& series);

struct SignedRange
{
  double Start, End;
  bool Negative;
};

/**
 * Appends the ranges of [start, end], in order, in which the polynomial of `degree` is negative, or is not. A range is halved until
 * the series shows one sign, or that it is monotone, so that bisection finds its only zero; or until `isSmall` says that a
 * polynomial no larger than `largest` there may have either sign. That is asked with halvings left and without; its last answer is
 * not heard.
 */
void FindSignedRanges(const std::function<double(double)>& evaluate, int degree, double start, double end,
  const std::function<bool(double start, double end, double largest, bool last)>& isSmall,
  std::vector<SignedRange>& ranges);
}

#endif
