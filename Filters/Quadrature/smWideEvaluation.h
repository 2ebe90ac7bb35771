/**
 * @file smWideEvaluation.h
 * @brief Patches and curve pieces evaluated in extended precision; not installed
 */
#ifndef smWideEvaluation_h
#define smWideEvaluation_h

#include "smBezierPatch.h"

#include <array>

namespace sm
{
using Wide = long double;

/// B_i^degree(t), i = 0 .. degree: products of powers, each with at most 2 degree + 2 roundings.
void FillWideBasis(int degree, Wide t, Wide* basis);

/// (w x, w y, w z, w) of a patch of degrees p and q.
void EvaluatePatch(const std::array<double, 4>* points, int p, int q, Wide s, Wide r, Wide h[4]);
}

#endif
