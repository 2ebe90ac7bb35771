/**
 * @file smQuadratureBound.h
 * @brief The error of a Gauss rule from bounds of the integrand on ellipses, and the order that meets a share
 *
 * f analytic where |z| + |z - 1| <= (rho + 1/rho) / 2 and |f| <= M there: the N-point Gauss rule on [0,1] errs by at most
 *
 *     (32/15) M rho^(-2N) / (1 - rho^-2).
 *
 * The Chebyshev coefficients of f are at most 2 M rho^-k, the rule is exact up to degree 2N - 1, odd terms vanish by
 * symmetry, and each even term costs at most 32/15 on [-1,1] (Filters/Quadrature/Bounds.md; Trefethen, Approximation Theory and
 * Approximation Practice, theorem 19.3 is the like). For a product rule the errors of the two directions add up: the
 * weights of a Gauss rule are positive and have the sum 1.
 */
#ifndef smQuadratureBound_h
#define smQuadratureBound_h

#include <vector>

namespace sm
{
/// Bounds of several integrands along one direction, on a number of ellipses.
class DirectionBound
{
public:
  explicit DirectionBound(std::size_t integrands = 0);

  void Reset(std::size_t integrands);
  /// Adds an ellipse of this radius (> 1). `bounds` holds the bound of |f| on it for every integrand; infinite where f may not
  /// be analytic.
  void AddEllipse(double radius, const std::vector<double>& bounds);
  /// States that this integrand is a polynomial that `order` points integrate exactly.
  void SetExactOrder(std::size_t integrand, int order);
  /// Sets this order for all integrands.
  void SetExactOrder(int order);

  /// Bound of the error of `order` points.
  double GetError(std::size_t integrand, int order) const;
  /// Fewest points whose bound is at most `share`; more than `largest` when none of so many is.
  int FindOrder(std::size_t integrand, double share, int largest) const;
  /// Returns the same from the ellipse added last alone, and ignores SetExactOrder().
  int FindLastOrder(std::size_t integrand, double share, int largest) const;

private:
  struct Radius
  {
    double Value;
    double Logarithm;
  };
  /// `share` and its logarithm.
  int GetOrder(std::size_t radius, std::size_t integrand, double share, double logarithm, int largest) const;

  std::size_t Classes;
  std::vector<Radius> Radii;
  /// The error of N points is this times rho^(-2N).
  std::vector<double> Factors;
  std::vector<double> FactorLogarithms;
  std::vector<int> ExactOrders;
};
}

#endif
