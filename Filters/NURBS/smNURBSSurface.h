/**
 * @file smNURBSSurface.h
 * @brief A rational B-spline surface as the file defines it: not tessellated and not fitted again
 */
#ifndef smNURBSSurface_h
#define smNURBSSurface_h

#include "smFiltersNURBSModule.h"

#include "smPolynomialCurve.h"

#include <array>
#include <string>
#include <vector>

namespace sm
{
/**
 * S(u,v) = sum_ij N_i(u) N_j(v) (x_ij, y_ij, z_ij) / sum_ij N_i(u) N_j(v) w_ij.
 *
 * Direction 0 is u, direction 1 is v. Knots need not be clamped; the domain in direction d is
 * [Knots[d][Degree[d]], Knots[d][size - 1 - Degree[d]]].
 */
struct SMFILTERSNURBS_EXPORT NURBSSurface
{
  int Degree[2] = { 1, 1 };
  /// Non-decreasing; NumberOfControlPoints[d] + Degree[d] + 1 values.
  std::vector<double> Knots[2];
  int NumberOfControlPoints[2] = { 0, 0 };
  /// Homogeneous (w x, w y, w z, w), u index fastest: entry i + j * NumberOfControlPoints[0]. Weights are
  /// positive.
  std::vector<std::array<double, 4>> ControlPoints;
  /// True when the weights differ.
  bool Rational = false;
  /// Largest distance from the surface it was made from, in model length units; 0: exact.
  double Residual = 0.0;
  /// Bound of the distance, in x, y and z and in model length units, by which rounding of the numbers that it
  /// was read from, and of their conversion, may have moved any point of it and of the edges around it. 0:
  /// its own numbers define the surface.
  std::array<double, 3> Rounding{};

  double GetDomainStart(int direction) const { return this->Knots[direction][this->Degree[direction]]; }
  double GetDomainEnd(int direction) const
  {
    return this->Knots[direction][this->Knots[direction].size() - 1 - this->Degree[direction]];
  }

  /// Distinct knots inside and at the ends of the domain, increasing.
  std::vector<double> GetSpanBreaks(int direction) const;

  /// An empty string when degrees, knots, counts and weights are consistent, else the first mistake.
  std::string Check() const;

  /// Position and (if not null) first derivatives at (u,v), in model coordinates.
  void Evaluate(double u, double v, double position[3], double du[3] = nullptr, double dv[3] = nullptr) const;

  /**
   * Control points of the Bézier patch on [u0,u1] x [v0,v1], which lies in one span of each direction, by
   * blossoming: (Degree[0]+1) x (Degree[1]+1) homogeneous points, u index fastest. A `center` that is not
   * null becomes the middle of the box of these points, and they are relative to it; it is subtracted before
   * they are rounded to double. Returns how far rounding may have moved a point in x, y and z, lengths.
   */
  std::array<double, 3> ExtractBezier(double u0, double u1, double v0, double v1,
    std::array<double, 4>* points, double center[3] = nullptr) const;

  /// Evaluates points one after another, the bits of Evaluate(); common terms of neighbours in one cell are
  /// computed once.
  class Walker;

  /// The same surface with u and v exchanged. Its normal Su x Sv points the other way.
  NURBSSurface Transposed() const;
};

/// Not thread safe; the surface must outlive it.
class SMFILTERSNURBS_EXPORT NURBSSurface::Walker
{
public:
  explicit Walker(const NURBSSurface& surface)
    : Surface(surface)
  {
  }
  void Evaluate(double u, double v, double position[3], double du[3] = nullptr, double dv[3] = nullptr);

private:
  const NURBSSurface& Surface;
  int Span[2] = { -1, -1 };
  std::vector<std::array<double, 4>> Cell;
};
}

#endif
