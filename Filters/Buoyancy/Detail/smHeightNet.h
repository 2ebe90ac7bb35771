/**
 * @file smHeightNet.h
 * @brief Height of a rational Bézier patch above a plane, as a quotient of polynomials N / w, with bounds on
 * parameter boxes
 */
#ifndef smHeightNet_h
#define smHeightNet_h

#include "smFacePanels.h"
#include "smFiltersBuoyancyModule.h"

#include <array>
#include <limits>
#include <vector>

namespace sm
{
/// The plane of all points x of a model with Up . x + Offset = 0. Up is a unit vector; the height is positive
/// on the side it points to.
struct HeightPlane
{
  std::array<double, 3> Up{};
  /// Offset, a length, in extended precision where the platform's long double has it.
  long double Offset = 0.0L;

  double GetHeight(const std::array<double, 3>& x) const
  {
    return static_cast<double>(static_cast<long double>(this->Up[0]) * x[0] +
      static_cast<long double>(this->Up[1]) * x[1] + static_cast<long double>(this->Up[2]) * x[2] +
      this->Offset);
  }
};

/// A box in the parameters of the trim pieces: (u, v), or (v, u) for transposed panels.
struct ParameterRange
{
  std::array<double, 2> Low{};
  std::array<double, 2> High{};

  ParameterRange Exchanged() const
  {
    return { { this->Low[1], this->Low[0] }, { this->High[1], this->High[0] } };
  }
};

/// Bounds of height and weight on a box. Derivatives are with respect to the patch's own parameters s and r.
struct SMFILTERSBUOYANCY_EXPORT NetRange
{
  /// Range of the numerator N = w h, by the convex hull of its coefficients.
  double Low, High;
  /// Ranges of the derivatives of N.
  double SlopeLow[2], SlopeHigh[2];
  double MinWeight;

  /// Returns an upper bound of |h| on the box; infinity if the weight may be 0.
  double GetMaxHeight() const;
};

/// The numerator N(s,r) = sum B_i(s) B_j(r) w_ij h_ij of the height over one patch. Its zeros are the
/// waterline on the patch.
class SMFILTERSBUOYANCY_EXPORT HeightNet
{
public:
  HeightNet(const FacePanels& panels, const Patch& patch, const HeightPlane& plane);

  int GetDegree(int direction) const { return this->Degree[direction]; }
  double ToLocal(int direction, double x) const
  {
    return (x - this->Start[direction]) / this->Width[direction];
  }

  NetRange GetRange(const ParameterRange& box) const;
  double Evaluate(double u, double v) const;
  /// Returns the u in [low, high] with N(u, v) = 0; N(., v) must be monotone there. Without a zero, returns
  /// the end with the smaller |N|.
  double Solve(double v, double low, double high) const;
  /// Returns an upper bound of |S_u x S_v| on the patch: surface area per area in the parameters of the trim
  /// pieces.
  double GetMaxNormal() const { return this->Normal; }
  /// Raises the bound of GetMaxNormal(); NaN counts as infinity.
  void RaiseNormal(double normal)
  {
    this->Normal = normal <= this->Normal ? this->Normal
      : normal > this->Normal             ? normal
                                          : std::numeric_limits<double>::infinity();
  }

  /// Returns a bound of the error of N by the rounding of its coefficients and of its evaluation on the
  /// patch.
  double GetRounding() const;
  /// Returns a bound of the error of N if every point is displaced by at most `displacement` relative to the
  /// plane.
  double GetNoise(double displacement) const
  {
    return this->GetRounding() + 1.001 * this->MaxWeight * displacement;
  }

  /// Returns the net with its two parameters exchanged.
  HeightNet Exchanged() const;

private:
  HeightNet() = default;
  int Degree[2] = { 1, 1 };
  double Start[2] = { 0.0, 0.0 };
  double Width[2] = { 1.0, 1.0 };
  double Normal = 0.0;
  double MaxNumerator = 0.0;
  double MaxWeight = 0.0;
  /// Coefficients (N, w), with s varying fastest.
  std::vector<std::array<double, 2>> Coefficients;
};
}

#endif
