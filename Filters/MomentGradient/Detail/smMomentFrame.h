/**
 * @file smMomentFrame.h
 * @brief Derivatives of moments in another frame, and those of centre, inertia and principal moments
 */
#ifndef smMomentFrame_h
#define smMomentFrame_h

#include "smMassTable.h"
#include "smMomentGradient.h"
#include "smNetGradient.h"

#include <array>

namespace sm
{
/// Ten numbers, the moments of a density or their derivatives, with bounds of their errors.
struct MomentVector
{
  std::array<double, NumberOfMoments> Values{};
  std::array<double, NumberOfMoments> Bounds{};
};

/// The map of moments about one point to those about another one, in axes that are rotated or mirrored:
/// z = A (y + origin) + t - reference.
class MomentFrame
{
public:
  /// `placement`: row-major 4x4.
  MomentFrame(const double placement[16], const double origin[3], const std::array<double, 3>& reference);

  MomentVector Map(const MomentVector& moments) const;
  /// Rotates a vector of three such derivatives, by x, y and z.
  std::array<MomentVector, 3> Rotate(const std::array<MomentVector, 3>& derivatives) const;
  /// Returns a bound of the relative error of a vector that the axes rotate.
  double GetAxesOff() const { return this->AxesOff; }
  /// Rotates three numbers with bounds.
  void Rotate(std::array<double, 3>& values, std::array<double, 3>& bounds) const;

private:
  using Row = std::array<double, NumberOfMoments>;
  double Axes[3][3];
  std::array<Row, NumberOfMoments> Matrix{};
  /// Rounding of the entries, and what a placement is off a rotation, as a bound.
  std::array<Row, NumberOfMoments> Off{};
  /// The same of Axes, times their rows' sums.
  double AxesOff = 0.0;
};

/// Sets the derivatives of centre, inertia and principal moments in an array of NumberOfGradientQuantities
/// from those of moments about the centre of the body.
class DerivedGradient
{
public:
  explicit DerivedGradient(const MassProperties& body);

  /// Returns false if principal moment k (0 to 2) coincides with another one within their bounds.
  bool IsSingle(int k) const { return this->Single[k]; }
  void Set(const MomentVector& aboutCenter, double* values, double* bounds) const;

private:
  const MassProperties& Body;
  std::array<bool, 3> Single{};
  /// Bounds of the angles by which the axes may be off.
  std::array<double, 3> Angle{};
};
}

#endif
