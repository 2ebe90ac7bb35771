/**
 * @file smRationalBound.h
 * @brief Bounds of the second derivatives of a rational patch whose weights are not products
 *
 * With c, d_u, d_v: position and derivatives in the middle, H = (P, w):
 *     w S_uu = (P_uu - w_uu c - 2 w_u d_u)             - w_uu (S - c) - 2 w_u (S_u - d_u)
 *     w S_uv = (P_uv - w_uv c - w_u d_v - w_v d_u)     - w_uv (S - c) - w_u (S_v - d_v) - w_v (S_u - d_u)
 * The brackets are polynomials, bounded by their coefficients; |S_u - d_u| <= (M_uu + M_uv) / 2 and so on on
 * [0,1]^2. That is M <= g + A M with A, g >= 0; any M with M >= g + A M and g > 0 bounds the true one, for
 * then the spectral radius of A is below 1. The same holds for components along a unit vector.
 */
#ifndef smRationalBound_h
#define smRationalBound_h

#include "smBernsteinNet.h"
#include "smCurvatureBounds.h"

#include <array>

namespace sm
{
/// Beyond the borders of a rational surface's domain a weight may vanish: bounds are immense then, not
/// negative.
constexpr double MinWeight = 1e-100;

class RationalBound
{
public:
  /// The arguments must outlive it.
  RationalBound(const BernsteinNet& net, const Vector3& normal);

  /// False where there is no bound. Raises `reached` to what derivatives reach at the corners, about.
  bool Run(CurvatureBounds& bound, CurvatureBounds& reached);

  /// Largest change of the weights in each direction, relative to them.
  const std::array<double, 2>& GetSlope() const { return this->Slope; }

private:
  /// A bracket's coefficients, and those of the weight's derivative.
  struct Bracket
  {
    explicit Bracket(const Vector3& normal)
      : Coefficients(normal)
      , Corners(normal)
    {
    }
    MaxVector Coefficients;
    /// Values over the weight, at the corners.
    MaxVector Corners;
    double Weight = 0.0;
  };
  void AddLines(int direction, Bracket& bracket) const;
  void AddMixed(Bracket& bracket) const;
  bool Solve(const std::array<double, 3>& g, const std::array<double, 3>& twice,
    const std::array<double, 2>& middle, std::array<double, 3>& bound) const;

  const BernsteinNet& Net;
  const Vector3& Normal;
  /// (P - w c, w).
  BernsteinNet Centered;
  NetMiddle Middle;
  double Lightest;
  /// Largest |w_u| and |w_v| over the smallest weight.
  std::array<double, 2> Slope{};
};
}

#endif
