/**
 * @file smWideEvaluation.h
 * @brief Patches and curve pieces evaluated in extended precision; not installed
 */
#ifndef smWideEvaluation_h
#define smWideEvaluation_h

#include <array>

namespace sm
{
using Wide = long double;

/// (w x, w y, w z, w) of a patch of degrees p and q, and its derivatives in s and r.
void EvaluatePatch(const std::array<double, 4>* points, int p, int q, Wide s, Wide r, Wide h[3][4]);

/// A polynomial piece of `size` coordinates in Bernstein form, relative to `origin`.
void EvaluatePiece(
  const double* coefficients, int size, int degree, Wide t, const double* origin, Wide* point);
}

#endif
