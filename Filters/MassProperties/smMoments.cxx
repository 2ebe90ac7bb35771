#include "smMoments.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// Index of (i,j) in XX YY ZZ XY YZ XZ.
constexpr int Packed[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };

using Symmetric = std::array<double, 6>;

double Largest(const double* values, int count)
{
  double largest = 0.0;
  for (int i = 0; i < count; ++i)
  {
    // std::max may drop a NaN, and then an unknown bound would be returned as a small one.
    if (std::isnan(values[i]))
    {
      return values[i];
    }
    largest = std::max(largest, std::abs(values[i]));
  }
  return largest;
}

/// Returns the row-major 3x3 inertia of second moments: I_xx = C_yy + C_zz, I_xy = -C_xy.
std::array<double, 9> InertiaOf(const Symmetric& second)
{
  const double trace = second[0] + second[1] + second[2];
  std::array<double, 9> inertia;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inertia[3 * i + j] = i == j ? trace - second[i] : -second[Packed[i][j]];
    }
  }
  // The trace minus one entry is computed as the sum of the two others, without cancellation.
  inertia[0] = second[1] + second[2];
  inertia[4] = second[0] + second[2];
  inertia[8] = second[0] + second[1];
  return inertia;
}

/// Returns the bound of each entry of the inertia from the bounds of the second moments, with the rounding of
/// the sums.
std::array<double, 9> InertiaBoundOf(const Symmetric& bound, const Symmetric& second)
{
  std::array<double, 9> result;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result[3 * i + j] = bound[Packed[i][j]];
    }
    const int a = (i + 1) % 3;
    const int b = (i + 2) % 3;
    result[3 * i + i] =
      bound[a] + bound[b] + 8.0 * UnitRoundoff * (std::abs(second[a]) + std::abs(second[b]));
  }
  return result;
}
}

void Moments::Place(const double placement[16])
{
  const auto rotation = [placement](int i, int j) { return placement[4 * i + j]; };
  Moments placed;
  placed.Volume = this->Volume;
  placed.VolumeBound = this->VolumeBound;
  for (int i = 0; i < 3; ++i)
  {
    placed.Reference[i] = placement[4 * i + 3];
    double magnitude = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      placed.Reference[i] += rotation(i, j) * this->Reference[j];
      placed.First[i] += rotation(i, j) * this->First[j];
      placed.FirstBound[i] += std::abs(rotation(i, j)) * this->FirstBound[j];
      magnitude += std::abs(rotation(i, j) * this->First[j]);
    }
    placed.FirstBound[i] += 8.0 * UnitRoundoff * magnitude;
  }
  for (int i = 0; i < 3; ++i)
  {
    double reach = std::abs(placement[4 * i + 3]);
    for (int j = 0; j < 3; ++j)
    {
      reach += std::abs(rotation(i, j) * this->Reference[j]);
    }
    placed.ReferenceBound += 8.0 * UnitRoundoff * reach;
  }
  placed.ReferenceBound += this->ReferenceBound;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      double value = 0.0;
      double bound = 0.0;
      double magnitude = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          const double factor = rotation(i, k) * rotation(j, l);
          value += factor * this->Second[Packed[k][l]];
          bound += std::abs(factor) * this->SecondBound[Packed[k][l]];
          magnitude += std::abs(factor * this->Second[Packed[k][l]]);
        }
      }
      placed.Second[Packed[i][j]] = value;
      placed.SecondBound[Packed[i][j]] = bound + 16.0 * UnitRoundoff * magnitude;
    }
  }
  *this = placed;
}

void Moments::MoveReference(const std::array<double, 3>& reference)
{
  // r' = r + a with a = old reference - new one.
  Vector3 a;
  for (int i = 0; i < 3; ++i)
  {
    a[i] = this->Reference[i] - reference[i];
  }
  const double v = this->Volume;
  const double b = this->VolumeBound;
  const Vector3 m = this->First;
  Vector3 mb = this->FirstBound;
  if (this->ReferenceBound > 0.0)
  {
    // The shift has an error of up to e: first moments change by V e, second ones by (|m_i| + |m_j|) e + V
    // e^2.
    const double e = this->ReferenceBound;
    for (int k = 0; k < 6; ++k)
    {
      this->SecondBound[k] +=
        2.0 * e * (Largest(m.data(), 3) + Largest(mb.data(), 3)) + (std::abs(v) + b) * e * e;
    }
    for (double& bound : mb)
    {
      bound += (std::abs(v) + b) * e;
    }
    this->ReferenceBound = 0.0;
  }
  for (int i = 0; i < 3; ++i)
  {
    this->First[i] = m[i] + a[i] * v;
    this->FirstBound[i] =
      mb[i] + std::abs(a[i]) * b + 4.0 * UnitRoundoff * (std::abs(m[i]) + std::abs(a[i] * v));
    for (int j = i; j < 3; ++j)
    {
      const int k = Packed[i][j];
      this->SecondBound[k] += std::abs(a[i]) * mb[j] + std::abs(a[j]) * mb[i] + std::abs(a[i] * a[j]) * b +
        8.0 * UnitRoundoff *
          (std::abs(this->Second[k]) + std::abs(a[i] * m[j]) + std::abs(a[j] * m[i]) +
            std::abs(a[i] * a[j] * v));
      this->Second[k] += a[i] * m[j] + a[j] * m[i] + a[i] * a[j] * v;
    }
  }
  this->Reference = reference;
}

void Moments::Add(Moments other)
{
  other.MoveReference(this->Reference);
  this->Volume += other.Volume;
  this->VolumeBound += other.VolumeBound + 2.0 * UnitRoundoff * std::abs(this->Volume);
  for (int i = 0; i < 3; ++i)
  {
    this->First[i] += other.First[i];
    this->FirstBound[i] += other.FirstBound[i] + 2.0 * UnitRoundoff * std::abs(this->First[i]);
  }
  for (int i = 0; i < 6; ++i)
  {
    this->Second[i] += other.Second[i];
    this->SecondBound[i] += other.SecondBound[i] + 2.0 * UnitRoundoff * std::abs(this->Second[i]);
  }
}

Moments Moments::Sum(const std::vector<Moments>& bodies)
{
  Moments sum;
  Vector3 first{};
  double volume = 0.0;
  for (const Moments& body : bodies)
  {
    volume += body.Volume;
    for (int i = 0; i < 3; ++i)
    {
      first[i] += body.First[i] + body.Volume * body.Reference[i];
    }
  }
  if (bodies.size() == 1 || !(volume > 0.0))
  {
    sum = bodies.empty() ? sum : bodies.front();
    std::for_each(bodies.begin() + std::min<std::size_t>(bodies.size(), 1), bodies.end(),
      [&sum](const Moments& body) { sum.Add(body); });
    return sum;
  }
  for (int i = 0; i < 3; ++i)
  {
    sum.Reference[i] = first[i] / volume;
  }
  for (const Moments& body : bodies)
  {
    sum.Add(body);
  }
  return sum;
}

void Moments::Negate()
{
  this->Volume = -this->Volume;
  for (double& value : this->First)
  {
    value = -value;
  }
  for (double& value : this->Second)
  {
    value = -value;
  }
}

MassProperties::MassProperties()
  : Volume(NaN)
  , VolumeBound(NaN)
  , CenterBound(NaN)
  , FirstBound(NaN)
  , SecondBound(NaN)
  , InertiaBound(NaN)
  , InertiaAtOriginBound(NaN)
  , PrincipalBound(NaN)
  , AxesBound(NaN)
  , AxesDegenerate(false)
  , GyrationBound(NaN)
{
  this->Center.fill(NaN);
  this->First.fill(NaN);
  this->Second.fill(NaN);
  this->Inertia.fill(NaN);
  this->InertiaAtOrigin.fill(NaN);
  this->Principal.fill(NaN);
  this->Axes.fill(NaN);
  this->Gyration.fill(NaN);
}

namespace
{
/// First moments and inertia about the origin.
void SetPropertiesAtOrigin(const Moments& moments, MassProperties& result)
{
  Moments atOrigin = moments;
  atOrigin.MoveReference({ 0.0, 0.0, 0.0 });
  result.First = atOrigin.First;
  result.FirstBound = Largest(atOrigin.FirstBound.data(), 3);
  result.InertiaAtOrigin = InertiaOf(atOrigin.Second);
  const std::array<double, 9> originBound = InertiaBoundOf(atOrigin.SecondBound, atOrigin.Second);
  result.InertiaAtOriginBound = Largest(originBound.data(), 9);
}

/// Centre of mass, and second moments and inertia about it. Returns the bounds of the inertia's components.
std::array<double, 9> SetCentralProperties(const Moments& moments, MassProperties& result)
{
  const double v = moments.Volume;
  const double b = moments.VolumeBound;
  Vector3 c;
  Vector3 d;
  for (int i = 0; i < 3; ++i)
  {
    c[i] = moments.First[i] / v;
    d[i] =
      (moments.FirstBound[i] + std::abs(c[i]) * b) / (std::abs(v) - b) + 4.0 * UnitRoundoff * std::abs(c[i]);
    result.Center[i] = moments.Reference[i] + c[i];
  }
  result.CenterBound =
    Largest(d.data(), 3) + 2.0 * UnitRoundoff * Largest(result.Center.data(), 3) + moments.ReferenceBound;

  Symmetric bound;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      const int k = Packed[i][j];
      result.Second[k] = moments.Second[k] - c[i] * c[j] * v;
      bound[k] = moments.SecondBound[k] + std::abs(c[i]) * moments.FirstBound[j] +
        std::abs(c[j]) * moments.FirstBound[i] + std::abs(c[i] * c[j]) * b + (std::abs(v) + b) * d[i] * d[j] +
        8.0 * UnitRoundoff * (std::abs(moments.Second[k]) + std::abs(c[i] * c[j] * v));
    }
  }
  result.SecondBound = Largest(bound.data(), 6);
  result.Inertia = InertiaOf(result.Second);
  const std::array<double, 9> inertiaBound = InertiaBoundOf(bound, result.Second);
  result.InertiaBound = Largest(inertiaBound.data(), 9);
  return inertiaBound;
}

/// Ascending principal moments and a right-handed frame of axes, each of the first two with its largest
/// component positive.
void SetPrincipalAxes(MassProperties& result)
{
  double matrix[3][3];
  double vectors[3][3];
  double* rows[3] = { matrix[0], matrix[1], matrix[2] };
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  for (int i = 0; i < 9; ++i)
  {
    matrix[i / 3][i % 3] = result.Inertia[i];
  }
  double values[3];
  vtkMath::Jacobi(rows, values, columns);
  int order[3] = { 0, 1, 2 };
  std::sort(order, order + 3, [&values](int x, int y) { return values[x] < values[y]; });
  for (int i = 0; i < 3; ++i)
  {
    result.Principal[i] = values[order[i]];
    for (int j = 0; j < 3; ++j)
    {
      result.Axes[3 * i + j] = vectors[j][order[i]];
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    double* axis = result.Axes.data() + 3 * i;
    const double* largest =
      std::max_element(axis, axis + 3, [](double x, double y) { return std::abs(x) < std::abs(y); });
    if (*largest < 0.0)
    {
      std::transform(axis, axis + 3, axis, [](double x) { return -x; });
    }
  }
  vtkMath::Cross(result.Axes.data(), result.Axes.data() + 3, result.Axes.data() + 6);
}

/// Bounds of principal moments and axes, from those of the inertia's components.
void SetPrincipalBounds(const std::array<double, 9>& inertiaBound, MassProperties& result)
{
  // Weyl: eigenvalues move by at most the largest absolute row sum of the perturbation.
  double e = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    e = std::max(e, inertiaBound[3 * i] + inertiaBound[3 * i + 1] + inertiaBound[3 * i + 2]);
  }
  e += 8.0 * UnitRoundoff * Largest(result.Inertia.data(), 9);
  result.PrincipalBound = e;
  const double gap =
    std::min(result.Principal[1] - result.Principal[0], result.Principal[2] - result.Principal[1]);
  // Moments count as equal if they agree within the bound, or within the rounding of the file's coordinates.
  result.AxesDegenerate = gap <= std::max(2.0 * e, 1e-9 * std::abs(result.Principal[2]));
  result.AxesBound = result.AxesDegenerate ? NaN : std::asin(std::min(1.0, e / (gap - e)));
}

/// Radii of gyration about the principal axes.
void SetRadiiOfGyration(MassProperties& result)
{
  const double v = result.Volume;
  const double b = result.VolumeBound;
  const double e = result.PrincipalBound;
  result.GyrationBound = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double lambda = result.Principal[i];
    result.Gyration[i] = lambda / v >= 0.0 ? std::sqrt(lambda / v) : NaN;
    const double low = std::sqrt(std::max(0.0, (std::abs(lambda) - e) / (std::abs(v) + b)));
    const double high = std::sqrt((std::abs(lambda) + e) / (std::abs(v) - b));
    const double error = std::max(high - result.Gyration[i], result.Gyration[i] - low);
    // std::max is not used here because it may drop a NaN, whether new or already present.
    result.GyrationBound = error > result.GyrationBound || std::isnan(error) ? error : result.GyrationBound;
  }
}
}

MassProperties ComputeMassProperties(const Moments& moments)
{
  MassProperties result;
  if (!std::isfinite(moments.Volume))
  {
    return result;
  }
  result.Volume = moments.Volume;
  result.VolumeBound = moments.VolumeBound;
  SetPropertiesAtOrigin(moments, result);
  if (!(moments.VolumeBound < std::abs(moments.Volume)))
  {
    return result;
  }
  const std::array<double, 9> inertiaBound = SetCentralProperties(moments, result);
  SetPrincipalAxes(result);
  SetPrincipalBounds(inertiaBound, result);
  SetRadiiOfGyration(result);
  return result;
}
}
