/**
 * @file smLineIntegrals.h
 * @brief Line integrals that are, by Stokes' theorem, the vector area and the moments of a face
 */
#ifndef smLineIntegrals_h
#define smLineIntegrals_h

#include "smReadersFacesModule.h"
#include "smVector.h"

#include <array>

namespace sm
{
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// One sample of a five-point Gauss rule on [0,1], exact to degree 9.
struct GaussSample
{
  double Node;
  double Weight;
};
inline constexpr std::array<GaussSample, 5> GaussSamples = { {
  { 0.046910077030668004, 0.118463442528094544 },
  { 0.230765344947158454, 0.239314335249683234 },
  { 0.5, 0.284444444444444444 },
  { 0.769234655052841546, 0.239314335249683234 },
  { 0.953089922969331996, 0.118463442528094544 },
} };

/**
 * The integrals of dx, of x_i dx_k and of x_i x_j dx_k along a curve. They are added over the curves of a
 * loop, change their sign with the direction, and follow from one another for another origin, so that each
 * edge is integrated once for all its faces.
 *
 * For a loop that bounds a face with unit normal n, counter-clockwise as seen from the tip of n:
 *
 *     integral of n dA                    = 1/2 loop integral of x cross dx
 *     integral of (M x).n dA, trace M = 0 = 1/3 loop integral of ((M x) cross x).dx,   since curl((M x) cross
 * x) = 3 M x
 */
struct SMREADERSFACES_EXPORT LineIntegrals
{
  Vector3 Step{};
  /// First[i][k]: x_i dx_k.
  Matrix3 First{};
  /// Second[n][k]: x_i x_j dx_k; n = 0 .. 5 for ij = 00, 11, 22, 01, 02, 12.
  std::array<std::array<double, 3>, 6> Second{};
  double Length = 0.0;

  /// Adds a sample at x with the step dx, weight included.
  void AddSample(const Vector3& x, const Vector3& dx)
  {
    const double square[6] = { x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[0] * x[2], x[1] * x[2] };
    for (int k = 0; k < 3; ++k)
    {
      this->Step[k] += dx[k];
      for (int i = 0; i < 3; ++i)
      {
        this->First[i][k] += x[i] * dx[k];
      }
      for (int n = 0; n < 6; ++n)
      {
        this->Second[n][k] += square[n] * dx[k];
      }
    }
    this->Length += Norm(dx);
  }
  /// Adds the integrals along the part from a to b of a curve: `evaluate(t, x, slope)` gets point and
  /// derivative. With a `tolerance` above 0, relative to the powers of `size`, the part is halved until two
  /// halves agree with their whole.
  template <class Evaluate>
  void AddPart(const Evaluate& evaluate, double a, double b, double tolerance = 0.0, double size = 1.0)
  {
    LineIntegrals whole;
    whole.AddRule(evaluate, a, b);
    this->AddPart(evaluate, a, b, tolerance, size, whole, 0);
  }
  /// Adds a straight piece.
  void AddSegment(const Vector3& from, const Vector3& to);
  /// Adds the integrals of another curve, whose origin is at `place` of this one's coordinates, `sign` times
  /// (1 or -1).
  void Add(const LineIntegrals& other, const Vector3& place, double sign);
  /// Returns the integrals of the curve that a linear map makes of this one, which leaves the origin where it
  /// is.
  LineIntegrals Map(const Matrix3& map) const;

  ///@{
  /** The vector area, and the traceless part of the integrals of n_i x_j, of a closed curve. */
  Vector3 GetVectorArea() const;
  Matrix3 GetMoments() const;
  ///@}

private:
  /// Largest number of halvings of a part.
  static constexpr int MaxHalvings = 24;

  template <class Evaluate>
  void AddRule(const Evaluate& evaluate, double a, double b)
  {
    for (const GaussSample& sample : GaussSamples)
    {
      Vector3 x;
      Vector3 slope;
      evaluate(a + sample.Node * (b - a), x, slope);
      for (double& s : slope)
      {
        s *= sample.Weight * (b - a);
      }
      this->AddSample(x, slope);
    }
  }

  template <class Evaluate>
  void AddPart(const Evaluate& evaluate, double a, double b, double tolerance, double size,
    const LineIntegrals& whole, int halvings)
  {
    if (!(tolerance > 0.0) || halvings == MaxHalvings)
    {
      this->Add(whole, { 0.0, 0.0, 0.0 }, 1.0);
      return;
    }
    const double middle = 0.5 * (a + b);
    LineIntegrals halves[2];
    halves[0].AddRule(evaluate, a, middle);
    halves[1].AddRule(evaluate, middle, b);
    LineIntegrals sum = halves[0];
    sum.Add(halves[1], { 0.0, 0.0, 0.0 }, 1.0);
    if (!(sum.GetDifference(whole, size) > tolerance))
    {
      this->Add(sum, { 0.0, 0.0, 0.0 }, 1.0);
      return;
    }
    this->AddPart(evaluate, a, middle, tolerance, size, halves[0], halvings + 1);
    this->AddPart(evaluate, middle, b, tolerance, size, halves[1], halvings + 1);
  }

  /// Returns the largest difference of the integrals, relative to the powers of a size.
  double GetDifference(const LineIntegrals& other, double size) const;
};
}

#endif
