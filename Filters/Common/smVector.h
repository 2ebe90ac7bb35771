/**
 * @file smVector.h
 * @brief Points, and vectors of three numbers of double or extended precision; not installed
 *
 * Sums run from the first component to the last, so that every user gets the same bits.
 */
#ifndef smVector_h
#define smVector_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sm
{
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;
using Vector3 = std::array<double, 3>;

template <typename Real = double>
Real Dot(const Real* a, const Real* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Real = double>
Real Dot(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
{
  return Dot(a.data(), b.data());
}

template <typename Real = double>
std::array<Real, 3> Cross(const Real* a, const Real* b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <typename Real = double>
std::array<Real, 3> Cross(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
{
  return Cross(a.data(), b.data());
}

template <typename Real = double>
std::array<Real, 3> Subtract(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

template <typename Real = double>
Real Norm(const Real* a)
{
  return std::sqrt(Dot(a, a));
}

template <typename Real = double>
Real Norm(const std::array<Real, 3>& a)
{
  return Norm(a.data());
}

/// Returns the largest of the values without their signs.
template <std::size_t N>
double GetLargest(const std::array<double, N>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

template <typename Real = double>
Real GetDistance(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A unit vector. The components are divided by the largest first, so that no square overflows.
template <typename Real = double>
std::array<Real, 3> Normalized(const std::array<Real, 3>& v)
{
  const Real largest = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  const std::array<Real, 3> scaled{ v[0] / largest, v[1] / largest, v[2] / largest };
  const Real length = Norm(scaled);
  return { scaled[0] / length, scaled[1] / length, scaled[2] / length };
}
}

#endif
