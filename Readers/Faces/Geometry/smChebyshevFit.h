/**
 * @file smChebyshevFit.h
 * @brief Polynomial pieces in Bernstein form for a smooth function, to rounding level
 */
#ifndef smChebyshevFit_h
#define smChebyshevFit_h

#include "smPolynomialCurve.h"
#include "smReadersFacesModule.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace sm
{

/// A piece is sampled at FitOrder + 1 Chebyshev points of the second kind, both ends included.
constexpr int FitOrder = 16;
using FitSamples = std::array<double, FitOrder + 1>;

/// The sample points in [0,1], increasing; the first is 0, the last 1 and the middle one 1/2, exactly.
SMREADERSFACES_EXPORT const FitSamples& GetFitNodes();

/// Chebyshev coefficients (in the argument 1 - 2x) of the polynomial through the samples.
SMREADERSFACES_EXPORT void ComputeChebyshevCoefficients(const FitSamples& samples, FitSamples& coefficients);

/// Bernstein coefficients, `degree` + 1 of them, of the Chebyshev series cut off after `degree`.
SMREADERSFACES_EXPORT void ConvertToBernstein(const FitSamples& chebyshev, int degree, double* bernstein);

/// When an interval is halved, the residual of a smooth function decreases by far more than this ratio, even
/// across a kink. A residual that does not is the rounding of the function itself, which bisection cannot
/// reduce.
constexpr double NoiseRatio = 0.3;
/// A residual above this many tolerances is not taken for rounding, even if bisection does not reduce it.
constexpr double MaximumNoise = 1e5;
/// Largest depth of bisection.
constexpr int MaximumDepth = 14;
/// Largest number of pieces; if a curve needs more, std::runtime_error is thrown.
constexpr int MaximumPieces = 50000;

template <int Dimension>
struct FittedPiece
{
  int Degree = 0;
  std::array<std::array<double, Dimension>, FitOrder + 1> Coefficients;
  /// Per coordinate: largest distance from the samples, plus an estimate of the error between the samples.
  std::array<double, Dimension> Residual{};
};

/**
 * Fits one polynomial to the samples: the smallest degree <= maximumDegree whose neglected Chebyshev
 * coefficients stay below `tolerance` in each coordinate. The ends are interpolated exactly. Returns
 * false, with the fit of the maximum degree, when the tolerance is not met. Throws std::runtime_error when a
 * sample is not finite.
 */
template <int Dimension>
bool FitPiece(const std::array<std::array<double, Dimension>, FitOrder + 1>& samples, int maximumDegree,
  const std::array<double, Dimension>& tolerance, FittedPiece<Dimension>& piece)
{
  std::array<FitSamples, Dimension> series;
  int degree = 0;
  bool met = true;
  std::array<double, Dimension> hidden{};
  for (int d = 0; d < Dimension; ++d)
  {
    FitSamples values;
    const double reference = samples[0][d];
    for (int i = 0; i <= FitOrder; ++i)
    {
      values[i] = samples[i][d] - reference;
      if (!std::isfinite(values[i]))
      {
        throw std::runtime_error("a curve is not finite");
      }
    }
    ComputeChebyshevCoefficients(values, series[d]);
    double tail = 0.0;
    int needed = FitOrder;
    while (needed > 0 && tail + std::abs(series[d][needed]) <= tolerance[d])
    {
      tail += std::abs(series[d][needed]);
      --needed;
    }
    met = met && needed <= maximumDegree;
    degree = std::max(degree, std::min(needed, maximumDegree));
    hidden[d] = std::abs(series[d][FitOrder]) + std::abs(series[d][FitOrder - 1]);
  }
  // A piece with equal ends may have degree 0; with different ends it needs degree 1 to interpolate them.
  piece.Degree = degree = std::max(degree, 1);
  for (int d = 0; d < Dimension; ++d)
  {
    double bernstein[FitOrder + 1];
    ConvertToBernstein(series[d], degree, bernstein);
    for (int i = 0; i <= degree; ++i)
    {
      piece.Coefficients[i][d] = bernstein[i] + samples[0][d];
    }
    piece.Coefficients[0][d] = samples[0][d];
    piece.Coefficients[degree][d] = samples[FitOrder][d];
    piece.Residual[d] = 0.0;
  }
  const BernsteinPiece<Dimension> polynomial{ piece.Coefficients.data(), degree };
  for (int i = 1; i < FitOrder; ++i)
  {
    const auto point = polynomial.Evaluate(GetFitNodes()[i]);
    for (int d = 0; d < Dimension; ++d)
    {
      piece.Residual[d] = std::max(piece.Residual[d], std::abs(point[d] - samples[i][d]));
    }
  }
  for (int d = 0; d < Dimension; ++d)
  {
    piece.Residual[d] += hidden[d];
  }
  return met;
}
}

#endif
