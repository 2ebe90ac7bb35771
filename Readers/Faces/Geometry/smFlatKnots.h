/**
 * @file smFlatKnots.h
 * @brief Flat knot vectors of splines, with unrolled periods, and their Bézier pieces
 */
#ifndef smFlatKnots_h
#define smFlatKnots_h

#include "smParameterMap.h"
#include "smPolynomialCurve.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace sm
{
/// One direction of a B-spline. Control point i is the pole with index Poles[i], from 0, of the source.
struct FlatKnots
{
  int Degree = 1;
  std::vector<double> Knots;
  std::vector<int> Poles;

  int GetLastSpan() const { return static_cast<int>(this->Knots.size()) - 2 - this->Degree; }
  /// Returns the span that contains t, or the nearest one of the domain.
  int FindSpan(double t) const
  {
    const auto after =
      std::upper_bound(this->Knots.begin() + this->Degree, this->Knots.begin() + this->GetLastSpan() + 1, t);
    return std::clamp(static_cast<int>(after - this->Knots.begin()) - 1, this->Degree, this->GetLastSpan());
  }
};

/**
 * Makes flat knots that cover [low, high] from distinct knots with their multiplicities. A direction that is
 * not periodic is converted as a whole. A periodic one is unrolled over as many spans as the range needs; its
 * knots are not clamped then. Throws std::runtime_error for a range beyond MaximumTurns periods.
 */
inline FlatKnots MakeFlatKnots(int degree, const std::vector<double>& knots,
  const std::vector<int>& multiplicities, bool periodic, double low, double high)
{
  FlatKnots flat;
  flat.Degree = degree;
  std::vector<double> base;
  const std::size_t last = knots.size() - (periodic ? 1 : 0);
  for (std::size_t i = 0; i < last; ++i)
  {
    base.insert(base.end(), multiplicities[i], knots[i]);
  }
  const int count = static_cast<int>(base.size());
  if (!periodic)
  {
    flat.Knots = base;
    for (int i = 0; i < count - degree - 1; ++i)
    {
      flat.Poles.push_back(i);
    }
    return flat;
  }
  // F(i + count) = F(i) + period for every integer i.
  const double period = knots.back() - knots.front();
  if (!(std::max(std::abs(low - base[0]), std::abs(high - base[0])) <= MaximumTurns * period))
  {
    throw std::runtime_error("it goes round a periodic spline more often than any face does");
  }
  const auto wrap = [count](int i) { return ((i % count) + count) % count; };
  const auto knot = [&](int i)
  {
    const int turn = (i - wrap(i)) / count;
    return base[wrap(i)] + turn * period;
  };
  const double slack = 1e-10 * period;
  int first = static_cast<int>(std::floor((low - base[0]) / period) - 1.0) * count;
  while (knot(first + 1) <= low + slack)
  {
    ++first;
  }
  int end = first + 1;
  while (knot(end) < high - slack)
  {
    ++end;
  }
  for (int i = first - degree; i <= end + degree; ++i)
  {
    flat.Knots.push_back(knot(i));
  }
  // Pole 0 of a periodic spline is the first one that the first span uses: in the flat vector, the one that
  // starts `degree` knots before the last copy of the first knot.
  const int shift = multiplicities.front() - 1 - degree;
  for (int i = first - degree; i < end; ++i)
  {
    flat.Poles.push_back(wrap(i - shift));
  }
  return flat;
}

/**
 * Computes the Bézier coefficients on [a,b] of the polynomial on span k, by blossoming: coefficient i is the
 * polar form at (a .. a, b .. b) with i times b. `poles` holds all control points of the flat knots.
 */
template <std::size_t Dimension>
void ExtractBezierPiece(const FlatKnots& flat, const std::vector<std::array<double, Dimension>>& poles,
  double a, double b, std::array<double, Dimension>* result)
{
  const int p = flat.Degree;
  const int k = flat.FindSpan(0.5 * (a + b));
  std::array<double, Dimension> d[MaximumDegree + 1];
  for (int i = 0; i <= p; ++i)
  {
    std::copy_n(poles.begin() + (k - p), p + 1, d);
    for (int level = 1; level <= p; ++level)
    {
      const double argument = level <= p - i ? a : b;
      for (int j = p; j >= level; --j)
      {
        const double low = flat.Knots[k - p + j];
        const double alpha = (argument - low) / (flat.Knots[k + 1 + j - level] - low);
        for (std::size_t c = 0; c < Dimension; ++c)
        {
          d[j][c] = (1.0 - alpha) * d[j - 1][c] + alpha * d[j][c];
        }
      }
    }
    result[i] = d[p];
  }
}

/// Returns first, last, and the knots that lie between them by more than rounding.
inline std::vector<double> MakeBreaks(double first, double last, const std::vector<double>& knots)
{
  std::vector<double> breaks{ first };
  const double slack =
    std::max(1e-13 * (last - first), 4.0 * UnitRoundoff * std::max(std::abs(first), std::abs(last)));
  for (const double knot : knots)
  {
    if (knot > breaks.back() + slack && knot < last - slack)
    {
      breaks.push_back(knot);
    }
  }
  breaks.push_back(last);
  return breaks;
}
}

#endif
