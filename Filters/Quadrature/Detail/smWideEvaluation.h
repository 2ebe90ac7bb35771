/**
 * @file smWideEvaluation.h
 * @brief Patches and curve pieces evaluated in extended precision; not installed
 */
#ifndef smWideEvaluation_h
#define smWideEvaluation_h

#include "smFacePanels.h"

#include <array>

namespace sm
{
using Wide = long double;

/// B_i^degree(t), i = 0 .. degree: products of powers, each with at most 2 degree + 2 roundings.
void FillWideBasis(int degree, Wide t, Wide* basis);

/// The bases at the nodes of a Chebyshev rule (smChebyshev.h) on [0,1], degree + 1 numbers for each node,
/// which are computed once. Thread safe.
const Wide* GetWideBases(int degree, int nodes);

/// Sums of a basis times coefficients.
template <int Dimension>
void SumBasis(const Wide* basis, const Wide coefficients[][Dimension], int degree, Wide* sums)
{
  for (int d = 0; d < Dimension; ++d)
  {
    // In a register: storing a wide number costs more than adding one.
    Wide sum = 0;
    for (int i = 0; i <= degree; ++i)
    {
      sum += basis[i] * coefficients[i][d];
    }
    sums[d] = sum;
  }
}

/// The trim and edge pieces of a ribbon: the trim's in the parameters of the patch, the edge's about its
/// centre.
struct WideCurves
{
  Wide Trim[MaximumDegree + 1][2];
  Wide Edge[MaximumDegree + 1][3];
  int TrimDegree;
  int EdgeDegree;
  /// True where s, and where r, is constant along the trim curve.
  bool Constant[2] = { true, true };

  /// `raised`: the degree of the lower one is raised to that of the other.
  WideCurves(const FacePanels& panels, const Ribbon& ribbon, bool raised);
};

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
