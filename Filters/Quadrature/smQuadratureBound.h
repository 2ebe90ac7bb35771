/**
 * @file smQuadratureBound.h
 * @brief The error of a Gauss rule from bounds of the integrand on ellipses, and the order that meets a share
 *
 * f analytic where |z| + |z - 1| <= (rho + 1/rho) / 2 and |f| <= M there: the N-point Gauss rule on [0,1]
 * errs by at most
 *
 *     (32/15) M rho^(-2N) / (1 - rho^-2).
 *
 * The Chebyshev coefficients of f are at most 2 M rho^-k, the rule is exact up to degree 2N - 1, odd terms
 * vanish by symmetry, and each even term costs at most 32/15 on [-1,1] (Filters/Quadrature/Bounds.md; compare
 * Trefethen, Approximation Theory and Approximation Practice, theorem 19.3). For a product rule the errors of
 * the two directions add up: the weights of a Gauss rule are positive and have the sum 1.
 */
#ifndef smQuadratureBound_h
#define smQuadratureBound_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sm
{
/// The radius rho of an ellipse, with rho^(-2N) for all N that are asked for.
class EllipseRadius
{
public:
  explicit EllipseRadius(double radius);
  double GetValue() const { return this->Value; }
  /// rho^(-2N), or an upper bound of it for large N.
  double GetPower(int points) const { return this->Powers[std::min(points, MaxPoints)]; }

private:
  static constexpr int MaxPoints = 40;
  double Value;
  double Powers[MaxPoints + 1];
};

/// The result of adding an ellipse: its bounds need no more points than those of the ellipses before it, or
/// more points, or it has no finite bounds (None).
enum class EllipseGain
{
  None,
  Worse,
  Useful
};

/// Tries ellipses from a middle one outwards and inwards, as long as they are useful: errors fall with the
/// radius until the bounds rise faster. `add` takes an EllipseRadius and returns an EllipseGain.
template <std::size_t Count, class Add>
void SearchEllipses(const EllipseRadius (&radii)[Count], const Add& add)
{
  constexpr std::size_t first = Count / 2;
  for (std::size_t i = first; i < Count && add(radii[i]) == EllipseGain::Useful; ++i)
  {
  }
  for (std::size_t i = first; i-- > 0 && add(radii[i]) != EllipseGain::Worse;)
  {
  }
}

/// Bounds of several integrands along one direction, on a number of ellipses, and the orders that they allow.
class DirectionBound
{
public:
  /// Removes all ellipses. `shares` holds the error allowed in this direction for every integrand; a value
  /// that is not positive, or infinite, allows any error. Orders are at most `largest`.
  void Reset(const std::vector<double>& shares, int largest);
  /// Adds an ellipse of this radius (> 1), which stays where it is. `bounds` holds the bound of |f| on it for
  /// every integrand; infinite where f may not be analytic. Returns false if the ellipse asks for more points
  /// of every integrand than one before it, so that larger ones will not ask for fewer: orders fall with the
  /// radius until the bounds rise faster.
  bool AddEllipse(const EllipseRadius& radius, const std::vector<double>& bounds);
  /// Returns whether the last ellipse has a smaller error of `points` points for some integrand than all
  /// before it.
  bool IsLastBest(int points) const;
  /// States that this integrand is a polynomial that `order` points integrate exactly.
  void SetExactOrder(std::size_t integrand, int order);

  /// Bound of the error of `order` points.
  double GetError(std::size_t integrand, int order) const;
  /// The smallest number of points whose bound is at most the share; `largest` + 1 or more if `largest`
  /// points do not suffice.
  int GetOrder(std::size_t integrand) const
  {
    return std::min(this->Orders[integrand], this->ExactOrders[integrand]);
  }

private:
  std::vector<double> Shares;
  int Largest = 0;
  std::vector<const EllipseRadius*> Radii;
  /// The error of N points is this times rho^(-2N).
  std::vector<double> Factors;
  std::vector<int> Orders;
  std::vector<int> ExactOrders;
};
}

#endif
