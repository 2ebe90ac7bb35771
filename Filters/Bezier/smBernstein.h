/**
 * @file smBernstein.h
 * @brief Bernstein polynomials: binomial coefficients, values, parts of a polynomial; not installed
 */
#ifndef smBernstein_h
#define smBernstein_h

#include "smFiltersBezierModule.h"
#include "smPolynomialCurve.h"

#include <array>

namespace sm
{
namespace detail
{
using PascalTriangle = std::array<std::array<double, MaximumDegree + 1>, MaximumDegree + 1>;

constexpr PascalTriangle MakePascalTriangle()
{
  PascalTriangle rows{};
  for (int n = 0; n <= MaximumDegree; ++n)
  {
    for (int i = 0; i <= n; ++i)
    {
      rows[n][i] = i == 0 || i == n ? 1.0 : rows[n - 1][i - 1] + rows[n - 1][i];
    }
  }
  return rows;
}
}

/// Binomial coefficients [n][i] of n over i up to the largest degree, exact.
inline constexpr detail::PascalTriangle Binomials = detail::MakePascalTriangle();

/// Values at x of the degree + 1 Bernstein polynomials, by the triangular recurrence.
SMFILTERSBEZIER_EXPORT void FillBernsteinBasis(int degree, double x, double* basis);

/// Derivatives of the degree + 1 polynomials, from the `degree` values of one degree less.
inline void FillBernsteinSlopes(int degree, const double* lower, double* slopes)
{
  for (int i = 0; i <= degree; ++i)
  {
    slopes[i] = degree * ((i > 0 ? lower[i - 1] : 0.0) - (i < degree ? lower[i] : 0.0));
  }
}

/// The values by powers of x and 1 - x: fewer operations, other last digits.
inline void EvaluateBasis(double x, int degree, double* values)
{
  double power = 1.0;
  for (int i = 0; i <= degree; ++i)
  {
    values[i] = Binomials[degree][i] * power;
    power *= x;
  }
  power = 1.0;
  for (int i = degree; i >= 0; --i)
  {
    values[i] *= power;
    power *= 1.0 - x;
  }
}

/// Point at parameter t. It takes a third of the operations of PolynomialCurve::Evaluate() at degree 9 and
/// differs in the last digits; ends of pieces are exact.
template <int Dimension>
std::array<double, Dimension> EvaluateByBasis(const PolynomialCurve<Dimension>& curve, double t)
{
  const int k = curve.FindPiece(t);
  const BernsteinPiece<Dimension> piece = curve.GetPiece(k);
  const double x = (t - curve.Breaks[k]) / (curve.Breaks[k + 1] - curve.Breaks[k]);
  std::array<double, Dimension> point{};
  if (piece.Degree == 1)
  {
    for (int d = 0; d < Dimension; ++d)
    {
      point[d] = (1.0 - x) * piece.Coefficients[0][d] + x * piece.Coefficients[1][d];
    }
    return point;
  }
  double basis[MaximumDegree + 1];
  EvaluateBasis(x, piece.Degree, basis);
  for (int i = 0; i <= piece.Degree; ++i)
  {
    for (int d = 0; d < Dimension; ++d)
    {
      point[d] += basis[i] * piece.Coefficients[i][d];
    }
  }
  return point;
}

/// Bernstein coefficients, `stride` apart, of a polynomial on [0,1] become those on [low, high], low < high.
/// The interval may extend a little beyond [0,1].
template <std::size_t Dimension>
void RestrictBernstein(
  std::array<double, Dimension>* coefficients, int degree, int stride, double low, double high)
{
  const auto split = [&](double x, bool keepLeft)
  {
    // The whole interval is kept.
    if (x == (keepLeft ? 1.0 : 0.0))
    {
      return;
    }
    for (int level = 1; level <= degree; ++level)
    {
      // In place: the finished coefficients fill the array from one end.
      for (int step = 0; step <= degree - level; ++step)
      {
        const int i = keepLeft ? degree - step : step;
        std::array<double, Dimension>& a = coefficients[stride * (keepLeft ? i - 1 : i)];
        std::array<double, Dimension>& b = coefficients[stride * (keepLeft ? i : i + 1)];
        std::array<double, Dimension>& to = keepLeft ? b : a;
        for (std::size_t c = 0; c < Dimension; ++c)
        {
          to[c] = (1.0 - x) * a[c] + x * b[c];
        }
      }
    }
  };
  // The larger part first, so that no coordinate is divided by a small number.
  if (high >= 1.0 - low)
  {
    split(high, true);
    split(low / high, false);
  }
  else
  {
    split(low, false);
    split((high - low) / (1.0 - low), true);
  }
}

/// Halves a polynomial on [0,1], in place into the halves: `right` has its coefficients, `stride` apart, and
/// `left` room for as many.
template <std::size_t Dimension>
void HalveBernstein(
  std::array<double, Dimension>* left, std::array<double, Dimension>* right, int degree, int stride)
{
  left[0] = right[0];
  for (int level = 1; level <= degree; ++level)
  {
    for (int i = 0; i <= degree - level; ++i)
    {
      for (std::size_t c = 0; c < Dimension; ++c)
      {
        right[i * stride][c] = 0.5 * (right[i * stride][c] + right[(i + 1) * stride][c]);
      }
    }
    left[level * stride] = right[0];
  }
}
}

#endif
