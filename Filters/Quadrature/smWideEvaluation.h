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

/// A patch of degrees p and q, or the curve on it where a parameter is constant.
class WidePatch
{
public:
  /// `points` are not copied. `s` and `r`: the constant value of a parameter, or null.
  WidePatch(const std::array<double, 4>* points, int p, int q, const Wide* s, const Wide* r);

  /// (w x, w y, w z, w); a constant parameter is not read.
  void Evaluate(Wide s, Wide r, Wide h[4]) const;

private:
  const std::array<double, 4>* Points;
  int Degree[2];
  bool Constant[2];
  /// The control points of the curve.
  Wide Curve[MaximumDegree + 1][4];
};
}

#endif
