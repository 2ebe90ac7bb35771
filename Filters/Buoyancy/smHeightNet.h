/**
 * @file smHeightNet.h
 * @brief The height of a rational Bézier patch above a plane, as a polynomial over the weight, and what bounds it on boxes
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
/// The points x of a model with Up . x + Offset = 0; Up is a unit vector. Height is positive on its side.
struct HeightPlane
{
  std::array<double, 3> Up{};
  /// A length; more digits than a double has, where there are any.
  long double Offset = 0.0L;

  double GetHeight(const std::array<double, 3>& x) const
  {
    return static_cast<double>(static_cast<long double>(this->Up[0]) * x[0] +
      static_cast<long double>(this->Up[1]) * x[1] + static_cast<long double>(this->Up[2]) * x[2] +
      this->Offset);
  }
};

/// A box in the parameters of the trim pieces: (u, v), or (v, u) where panels have them exchanged.
struct ParameterRange
{
  std::array<double, 2> Low{};
  std::array<double, 2> High{};

  ParameterRange Exchanged() const
  {
    return { { this->Low[1], this->Low[0] }, { this->High[1], this->High[0] } };
  }
};

/// What is known of height and weight on a box. Derivatives are in the patch's own s and r.
struct SMFILTERSBUOYANCY_EXPORT NetRange
{
  /// Of the numerator N = w h, by the convex hull of its coefficients.
  double Low, High;
  /// Of its derivatives.
  double SlopeLow[2], SlopeHigh[2];
  double LowestWeight;

  /// No less than |h|.
  double GetLargestHeight() const;
};

/// N(s,r) = sum B_i(s) B_j(r) w_ij h_ij of one patch. Its zeros are the waterline's.
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
  /// Where N(., v) vanishes in [low, high], on which it is monotone; the nearer end where it does not.
  double Solve(double v, double low, double high) const;
  /// No less than |Ss x Sr| du dv per area in the parameters of the trim pieces, anywhere on the patch.
  double GetLargestNormal() const { return this->Normal; }
  /// Not a number counts as infinite.
  void RaiseNormal(double normal)
  {
    this->Normal = normal <= this->Normal ? this->Normal
      : normal > this->Normal             ? normal
                                          : std::numeric_limits<double>::infinity();
  }

  /// The same with the two parameters exchanged.
  HeightNet Exchanged() const;

private:
  HeightNet() = default;
  int Degree[2] = { 1, 1 };
  double Start[2] = { 0.0, 0.0 };
  double Width[2] = { 1.0, 1.0 };
  double Normal = 0.0;
  /// (N, w), s fastest.
  std::vector<std::array<double, 2>> Coefficients;
};
}

#endif
