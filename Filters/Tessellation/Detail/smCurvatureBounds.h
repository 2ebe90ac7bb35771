/**
 * @file smCurvatureBounds.h
 * @brief Bounds of |S_uu|, |S_uv| and |S_vv|, and how they are gathered
 */
#ifndef smCurvatureBounds_h
#define smCurvatureBounds_h

#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
struct CurvatureBounds
{
  /// Bounds of the lengths of S_uu, S_uv and S_vv, and of their components along a unit vector.
  std::array<double, 3> Full{};
  std::array<double, 3> Along{};

  void Raise(const CurvatureBounds& to)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Full[k] = std::max(this->Full[k], to.Full[k]);
      this->Along[k] = std::max(this->Along[k], to.Along[k]);
    }
  }
  void Lower(const CurvatureBounds& to)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Full[k] = std::min(this->Full[k], to.Full[k]);
      this->Along[k] = std::min(this->Along[k], to.Along[k]);
    }
  }
  /// Rescales the bounds to a parameter unit that is `factor` times longer in `direction`.
  void Refine(int direction, double factor)
  {
    for (std::array<double, 3>* const bounds : { &this->Full, &this->Along })
    {
      (*bounds)[2 * direction] *= factor * factor;
      (*bounds)[1] *= factor;
    }
  }
  /// Returns true where sharper bounds would change a mesh little; `reached`: about what the derivatives are
  /// somewhere.
  bool IsSharp(const CurvatureBounds& reached) const
  {
    constexpr double sharp = 1.1;
    constexpr double small = 0.03;
    const double maximum = small * std::max({ reached.Full[0], reached.Full[1], reached.Full[2] });
    bool isSharp = true;
    for (int k = 0; k < 3; ++k)
    {
      isSharp = isSharp && this->Full[k] <= std::max(sharp * reached.Full[k], maximum) &&
        this->Along[k] <= std::max(sharp * reached.Along[k], maximum);
    }
    return isSharp;
  }
};

/// Steps in the parameters with which a bound of the error need not be sharper.
struct EnoughBound
{
  std::array<double, 2> Step{};
  /// No bound is enough where this is 0.
  double Sum = 0.0;

  bool IsMet(const std::array<double, 3>& b) const
  {
    const std::array<double, 2>& h = this->Step;
    return b[0] * h[0] * h[0] + 2.0 * b[1] * h[0] * h[1] + b[2] * h[1] * h[1] < this->Sum;
  }
};

/// Largest length of vectors, and of their components along a unit vector.
class MaxVector
{
public:
  explicit MaxVector(const Vector3& normal)
    : Normal(normal)
  {
  }
  void Add(const Vector3& v)
  {
    this->Square = std::max(this->Square, Dot(v, v));
    this->Component = std::max(this->Component, std::abs(Dot(v, this->Normal)));
  }
  double GetLength() const { return std::sqrt(this->Square); }
  double GetComponent() const { return this->Component; }

private:
  const Vector3& Normal;
  double Square = 0.0;
  double Component = 0.0;
};
}

#endif
