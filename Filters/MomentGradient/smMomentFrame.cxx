#include "Detail/smMomentFrame.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
// Roundings of the entries of a placement (96, Bounds.md, 4), of products of few sums, and of sums of ten
// products.
constexpr double MapRoundings = 160.0 * UnitRoundoff;
constexpr double FewRoundings = 32.0 * UnitRoundoff;
/// Pairs of axes of second moments, XX YY ZZ XY YZ XZ, and the index of a pair.
constexpr int Pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
constexpr int PairIndex[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };

// Places of derived quantities among those of smMomentGradient.h.
constexpr int CenterAt = 10;
constexpr int InertiaAt = 13;
constexpr int PrincipalAt = 19;

using Row = std::array<double, NumberOfMoments>;

/// Fills the map of moments by z = A y + d: V; A m + d V; A S A^T + d (A m)^T + (A m) d^T + d d^T V.
void FillMap(const double a[3][3], const double d[3], std::array<Row, NumberOfMoments>& map)
{
  map = {};
  map[0][0] = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    map[1 + i][0] = d[i];
    for (int j = 0; j < 3; ++j)
    {
      map[1 + i][1 + j] = a[i][j];
    }
  }
  for (int k = 0; k < 6; ++k)
  {
    const int i = Pairs[k][0];
    const int j = Pairs[k][1];
    Row& row = map[4 + k];
    row[0] = d[i] * d[j];
    for (int l = 0; l < 3; ++l)
    {
      row[1 + l] = d[i] * a[j][l] + a[i][l] * d[j];
      for (int m = 0; m < 3; ++m)
      {
        row[4 + PairIndex[l][m]] += a[i][l] * a[j][m];
      }
    }
  }
}
}

MomentFrame::MomentFrame(
  const double placement[16], const double origin[3], const std::array<double, 3>& reference)
{
  double d[3];
  double size[3];
  double absolute[3][3];
  for (int i = 0; i < 3; ++i)
  {
    d[i] = placement[4 * i + 3] - reference[i];
    size[i] = std::abs(placement[4 * i + 3]) + std::abs(reference[i]);
    for (int j = 0; j < 3; ++j)
    {
      this->Axes[i][j] = placement[4 * i + j];
      absolute[i][j] = std::abs(placement[4 * i + j]);
      d[i] += placement[4 * i + j] * origin[j];
      size[i] += std::abs(placement[4 * i + j] * origin[j]);
    }
  }
  double defect = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double product = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k)
      {
        product += this->Axes[k][i] * this->Axes[k][j];
      }
      defect = std::max(defect, std::abs(product));
    }
  }
  // With A^T A = 1 + E, the volume's factor and the inverse transpose are off by at most 3 |E|, each axis by
  // |E|.
  const double off = MapRoundings + (defect > MapRoundings ? 8.0 * defect : 0.0);
  FillMap(this->Axes, d, this->Matrix);
  FillMap(absolute, size, this->Off);
  for (Row& row : this->Off)
  {
    for (double& entry : row)
    {
      entry *= off;
    }
  }
  this->AxesOff = off;
}

MomentVector MomentFrame::Map(const MomentVector& moments) const
{
  MomentVector result;
  for (int i = 0; i < NumberOfMoments; ++i)
  {
    for (int j = 0; j < NumberOfMoments; ++j)
    {
      // A moment that has no part in the result may be unknown.
      if (this->Matrix[i][j] != 0.0 || this->Off[i][j] != 0.0)
      {
        result.Values[i] += this->Matrix[i][j] * moments.Values[j];
        result.Bounds[i] += (std::abs(this->Matrix[i][j]) + this->Off[i][j]) * moments.Bounds[j] +
          this->Off[i][j] * std::abs(moments.Values[j]);
      }
    }
  }
  return result;
}

void MomentFrame::Rotate(std::array<double, 3>& values, std::array<double, 3>& bounds) const
{
  const std::array<double, 3> v = values;
  const std::array<double, 3> b = bounds;
  for (int i = 0; i < 3; ++i)
  {
    values[i] = bounds[i] = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      values[i] += this->Axes[i][j] * v[j];
      bounds[i] += std::abs(this->Axes[i][j]) * (1.0 + this->AxesOff) * b[j] + this->AxesOff * std::abs(v[j]);
    }
  }
}

std::array<MomentVector, 3> MomentFrame::Rotate(const std::array<MomentVector, 3>& derivatives) const
{
  std::array<MomentVector, 3> result;
  for (int k = 0; k < NumberOfMoments; ++k)
  {
    std::array<double, 3> values;
    std::array<double, 3> bounds;
    for (int c = 0; c < 3; ++c)
    {
      values[c] = derivatives[c].Values[k];
      bounds[c] = derivatives[c].Bounds[k];
    }
    this->Rotate(values, bounds);
    for (int c = 0; c < 3; ++c)
    {
      result[c].Values[k] = values[c];
      result[c].Bounds[k] = bounds[c];
    }
  }
  return result;
}

DerivedGradient::DerivedGradient(const MassProperties& body)
  : Body(body)
{
  // The eigenvalue problem is solved to rounding of the largest moment.
  const double e = body.PrincipalBound + 64.0 * UnitRoundoff * std::abs(body.Principal[2]);
  for (int k = 0; k < 3; ++k)
  {
    double gap = std::numeric_limits<double>::infinity();
    for (int j = 0; j < 3; ++j)
    {
      gap = j == k ? gap : std::min(gap, std::abs(body.Principal[j] - body.Principal[k]));
    }
    // sin(angle) <= e / (gap - e), Davis and Kahan.
    this->Single[k] = e >= 0.0 && gap > 2.0 * e;
    this->Angle[k] = this->Single[k] ? std::asin(std::min(1.0, e / (gap - e))) : NotKnown;
  }
}

void DerivedGradient::Set(const MomentVector& aboutCenter, double* values, double* bounds) const
{
  const MassProperties& p = this->Body;
  const std::array<double, NumberOfMoments>& v = aboutCenter.Values;
  const std::array<double, NumberOfMoments>& b = aboutCenter.Bounds;
  // The true centre is off by up to `off` in each direction, which moves the moments about it.
  const double off = p.CenterBound;
  const double volume = std::abs(v[0]) + b[0];
  const double left = std::abs(p.Volume) - p.VolumeBound;
  for (int i = 0; i < 3; ++i)
  {
    // dc = integral of (x - c) dx . n / V.
    const double value = v[1 + i] / p.Volume;
    values[CenterAt + i] = value;
    bounds[CenterAt + i] = left > 0.0
      ? (b[1 + i] + off * volume + std::abs(value) * p.VolumeBound) / left + FewRoundings * std::abs(value)
      : NotKnown;
  }
  // Second moments about the centre: its own motion adds nothing, as the first ones vanish there.
  double second[6];
  double secondBound[6];
  for (int k = 0; k < 6; ++k)
  {
    const int i = 1 + Pairs[k][0];
    const int j = 1 + Pairs[k][1];
    second[k] = v[4 + k];
    secondBound[k] = b[4 + k] + off * (std::abs(v[i]) + b[i] + std::abs(v[j]) + b[j]) + off * off * volume;
  }
  double inertia[3][3];
  double inertiaBound[3][3];
  for (int k = 0; k < 6; ++k)
  {
    const int i = Pairs[k][0];
    const int j = Pairs[k][1];
    const int first = (i + 1) % 3;
    const int other = (i + 2) % 3;
    double value = -second[k];
    double bound = secondBound[k];
    if (i == j)
    {
      value = second[first] + second[other];
      bound = secondBound[first] + secondBound[other] +
        FewRoundings * (std::abs(second[first]) + std::abs(second[other]));
    }
    values[InertiaAt + k] = inertia[i][j] = inertia[j][i] = value;
    bounds[InertiaAt + k] = inertiaBound[i][j] = inertiaBound[j][i] = bound;
  }
  double norm = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      norm += std::abs(inertia[i][j]) + inertiaBound[i][j];
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    if (!this->Single[k])
    {
      values[PrincipalAt + k] = bounds[PrincipalAt + k] = NotKnown;
      continue;
    }
    // First order perturbation theory: a . I' a with the unit vector a of the axis.
    const double* a = p.Axes.data() + 3 * k;
    double value = 0.0;
    double bound = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        value += a[i] * inertia[i][j] * a[j];
        bound += std::abs(a[i] * a[j]) * inertiaBound[i][j];
      }
    }
    const double turned = this->Angle[k];
    values[PrincipalAt + k] = value;
    bounds[PrincipalAt + k] = (1.0 + 1e-12) * bound + norm * (2.0 * turned + turned * turned + FewRoundings);
  }
}
}
