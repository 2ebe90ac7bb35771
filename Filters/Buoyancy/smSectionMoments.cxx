#include "Detail/smSectionMoments.h"

#include "smUnitRoundoff.h"
#include "smVector.h"

#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Coordinates of the second moments xx, yy and xy.
constexpr int Pairs[3][2] = { { 0, 0 }, { 1, 1 }, { 0, 1 } };
/// Roundings of the few operations of each formula below, relative to the sum of the magnitudes of its terms.
constexpr double Roundings = 16.0 * UnitRoundoff;

SectionProperties MakeUnknown()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SectionProperties unknown;
  unknown.Centroid.fill(nan);
  unknown.CentroidBound = nan;
  unknown.Second.fill(nan);
  unknown.SecondBound = nan;
  unknown.Principal.fill(nan);
  unknown.PrincipalBound = nan;
  unknown.Directions[0].fill(nan);
  unknown.Directions[1].fill(nan);
  return unknown;
}
}

void SectionMoments::Add(const SectionMoments& other)
{
  const Vector3 way = Subtract(other.Origin, this->Origin);
  double shift[2];
  // Bound of the error of the shift.
  double shiftBound = 0.0;
  for (int k = 0; k < 2; ++k)
  {
    shift[k] = Dot(this->Axes[k], way);
  }
  shiftBound = Roundings * (Norm(this->Origin) + Norm(other.Origin));
  for (int i = 0; i < 3; ++i)
  {
    const int a = Pairs[i][0];
    const int b = Pairs[i][1];
    const double size = std::abs(other.Second[i]) + std::abs(shift[a] * other.First[b]) +
      std::abs(shift[b] * other.First[a]) + std::abs(shift[a] * shift[b] * other.Area);
    const double slope = std::abs(other.First[a]) + std::abs(other.First[b]) +
      (std::abs(shift[a]) + std::abs(shift[b]) + shiftBound) * std::abs(other.Area);
    this->Second[i] += other.Second[i] + shift[a] * other.First[b] + shift[b] * other.First[a] +
      shift[a] * shift[b] * other.Area;
    this->SecondBound[i] += other.SecondBound[i] + std::abs(shift[a]) * other.FirstBound[b] +
      std::abs(shift[b]) * other.FirstBound[a] + std::abs(shift[a] * shift[b]) * other.AreaBound +
      shiftBound * slope + Roundings * (size + std::abs(this->Second[i]));
  }
  for (int k = 0; k < 2; ++k)
  {
    this->First[k] += other.First[k] + shift[k] * other.Area;
    this->FirstBound[k] += other.FirstBound[k] + std::abs(shift[k]) * other.AreaBound +
      shiftBound * std::abs(other.Area) +
      Roundings * (std::abs(this->First[k]) + std::abs(other.First[k]) + std::abs(shift[k] * other.Area));
  }
  this->Area += other.Area;
  this->AreaBound += other.AreaBound + Roundings * std::abs(this->Area);
}

/**
 * With the computed centroid c about the origin and the true one c + e, |e_i| <= d_i = (b_i + |c_i| b) / (A -
 * b), the second moments about c are S_ij - c_i m_j - c_j m_i + A c_i c_j, whose bounds follow from those of
 * S, m and A, and those about the true centroid are less by A e_i e_j. A symmetric matrix that is off by E
 * has, along any unit vectors u and v, a value off by |u E v| <= |E|, the Frobenius norm, and so have its
 * eigenvalues (Weyl).
 */
SectionProperties SectionMoments::ComputeProperties() const
{
  if (!(this->Area > this->AreaBound))
  {
    return MakeUnknown();
  }
  SectionProperties found;
  double c[2];
  double d[2];
  found.Centroid = this->Origin;
  double offset = 0.0;
  for (int k = 0; k < 2; ++k)
  {
    c[k] = this->First[k] / this->Area;
    d[k] = (this->FirstBound[k] + std::abs(c[k]) * this->AreaBound) / (this->Area - this->AreaBound) +
      Roundings * std::abs(c[k]);
    offset = std::hypot(offset, c[k]);
    for (int i = 0; i < 3; ++i)
    {
      found.Centroid[i] += c[k] * this->Axes[k][i];
    }
  }
  found.CentroidBound = std::hypot(d[0], d[1]) + Roundings * (offset + Norm(this->Origin));
  double m[3];
  double bound = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int a = Pairs[i][0];
    const int b = Pairs[i][1];
    const double terms[4] = { this->Second[i], -c[a] * this->First[b], -c[b] * this->First[a],
      this->Area * c[a] * c[b] };
    m[i] = terms[0] + terms[1] + terms[2] + terms[3];
    double own = this->SecondBound[i] + std::abs(c[a]) * this->FirstBound[b] +
      std::abs(c[b]) * this->FirstBound[a] + std::abs(c[a] * c[b]) * this->AreaBound +
      (this->Area + this->AreaBound) * d[a] * d[b];
    for (const double term : terms)
    {
      own += Roundings * std::abs(term);
    }
    bound = std::hypot(bound, a == b ? own : std::sqrt(2.0) * own);
  }
  bound += Roundings * (std::abs(m[0]) + std::abs(m[1]) + std::abs(m[2]));
  found.SecondBound = found.PrincipalBound = bound;
  constexpr int Entries[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  const std::array<double, 3>& x = this->Axes[0];
  const std::array<double, 3>& y = this->Axes[1];
  for (int i = 0; i < 6; ++i)
  {
    const int p = Entries[i][0];
    const int q = Entries[i][1];
    found.Second[i] = m[0] * x[p] * x[q] + m[1] * y[p] * y[q] + m[2] * (x[p] * y[q] + y[p] * x[q]);
  }
  const double mean = 0.5 * (m[0] + m[1]);
  const double half = 0.5 * (m[0] - m[1]);
  const double radius = std::hypot(half, m[2]);
  found.Principal = { mean - radius, mean + radius };
  // Direction of the largest, at half of the angle of (half, m[2]).
  const double angle = 0.5 * std::atan2(m[2], half);
  for (int i = 0; i < 3; ++i)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const bool isKnown = radius > bound;
    found.Directions[1][i] = isKnown ? std::cos(angle) * x[i] + std::sin(angle) * y[i] : nan;
    found.Directions[0][i] = isKnown ? -std::sin(angle) * x[i] + std::cos(angle) * y[i] : nan;
  }
  return found;
}
}
