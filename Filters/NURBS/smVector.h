/**
 * @file smVector.h
 * @brief Vectors of three doubles; not installed
 *
 * Sums run from the first component to the last, so that every user gets the same bits.
 */
#ifndef smVector_h
#define smVector_h

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
using Vector3 = std::array<double, 3>;

inline double Dot(const double* a, const double* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return Dot(a.data(), b.data());
}

inline Vector3 Cross(const double* a, const double* b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return Cross(a.data(), b.data());
}

inline Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline double Norm(const double* a)
{
  return std::sqrt(Dot(a, a));
}

inline double Norm(const Vector3& a)
{
  return Norm(a.data());
}

/// A unit vector. The components are divided by the largest first, so that no square overflows.
inline Vector3 Normalized(const Vector3& v)
{
  const double largest = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  const Vector3 scaled{ v[0] / largest, v[1] / largest, v[2] / largest };
  const double length = Norm(scaled);
  return { scaled[0] / length, scaled[1] / length, scaled[2] / length };
}
}

#endif
