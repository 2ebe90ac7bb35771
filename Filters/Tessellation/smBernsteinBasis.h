/**
 * @file smBernsteinBasis.h
 * @brief Points of piecewise polynomial curves by values of the Bernstein polynomials
 *
 * A point takes a third of the operations of BernsteinPiece::Evaluate() at degree 9. It differs from that in the last digits; ends of pieces
 * are exact.
 */
#ifndef smBernsteinBasis_h
#define smBernsteinBasis_h

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
inline constexpr PascalTriangle Binomials = MakePascalTriangle();
}

/// Values at x of the degree + 1 Bernstein polynomials.
inline void EvaluateBasis(double x, int degree, double* values)
{
  double power = 1.0;
  for (int i = 0; i <= degree; ++i)
  {
    values[i] = detail::Binomials[degree][i] * power;
    power *= x;
  }
  power = 1.0;
  for (int i = degree; i >= 0; --i)
  {
    values[i] *= power;
    power *= 1.0 - x;
  }
}

/// Point at parameter t.
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
}

#endif
