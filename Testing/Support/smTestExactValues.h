/**
 * @file smTestExactValues.h
 * @brief Every quantity of the mass filter that has a bound, exactly, from volume, area, centre and inertia
 */
#ifndef smTestExactValues_h
#define smTestExactValues_h

#include "smMassPropertyNames.h"
#include "smTestManifest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace smtest
{
struct ExactQuantity
{
  const char* Name;
  std::vector<double> Values;
  /// How far the digits of the file, gaps between faces and edges, and the double of the expected value can
  /// move it.
  double Allowance;
};

/// Eigenvalues of a symmetric matrix, ascending: Jacobi's rotations in extended precision.
inline std::array<long double, 3> GetEigenvalues(const std::array<double, 9>& matrix)
{
  long double a[3][3];
  for (int i = 0; i < 9; ++i)
  {
    a[i / 3][i % 3] = matrix[i];
  }
  for (int sweep = 0; sweep < 30; ++sweep)
  {
    for (int p = 0; p < 2; ++p)
    {
      for (int q = p + 1; q < 3; ++q)
      {
        const long double angle = std::atan2(2 * a[p][q], a[q][q] - a[p][p]) / 2;
        const long double c = std::cos(angle);
        const long double s = std::sin(angle);
        for (int k = 0; k < 3; ++k)
        {
          const long double x = a[k][p];
          a[k][p] = c * x - s * a[k][q];
          a[k][q] = s * x + c * a[k][q];
        }
        for (int k = 0; k < 3; ++k)
        {
          const long double x = a[p][k];
          a[p][k] = c * x - s * a[q][k];
          a[q][k] = s * x + c * a[q][k];
        }
      }
    }
  }
  std::array<long double, 3> values{ a[0][0], a[1][1], a[2][2] };
  std::sort(values.begin(), values.end());
  return values;
}

class ExactValues
{
public:
  /// `gapSquared`: integral of the squared gap along the edges, by which volumes with gaps closed in other
  /// ways differ. `gapArea`: area of the gaps, which changes the area of the faces to first order.
  ExactValues(const Expected& expected, double gapSquared, double gapArea)
  {
    namespace names = sm::names;
    const double v = expected.Volume;
    const double size = expected.Size;
    const double distance = expected.GetDistance();
    const std::array<double, 3>& c = expected.Center;
    const std::array<double, 9>& inertia = expected.Inertia;
    const double trace = expected.GetInertiaTrace();
    const double volumeError = expected.VolumeAccuracy + gapSquared;
    const double centerError = expected.CenterAccuracy + gapSquared * size / v;
    const double inertiaError = expected.InertiaAccuracy + gapSquared * size * size;
    // Differences of products as bounds of factors: d(v c) <= |c| dv + (v + dv) dc.
    const double firstError = distance * volumeError + (v + volumeError) * centerError;
    const double steinerError = distance * (firstError + (v + volumeError) * centerError);

    this->Add(names::Volume, { v }, volumeError, v);
    this->Add(names::SurfaceArea, { expected.Area }, expected.AreaAccuracy + gapArea, expected.Area);
    this->Add(names::CenterOfMass, { c[0], c[1], c[2] }, centerError, distance);
    this->Add(names::FirstMoments, { v * c[0], v * c[1], v * c[2] }, firstError, v * distance);
    this->Add(names::VolumeInertia, { inertia.begin(), inertia.end() }, inertiaError, trace);
    const double half = trace / 2;
    this->Add(names::SecondMoments,
      { half - inertia[0], half - inertia[4], half - inertia[8], -inertia[1], -inertia[5], -inertia[2] },
      1.5 * inertiaError, trace);
    std::vector<double> atOrigin;
    for (int i = 0; i < 9; ++i)
    {
      const double diagonal = i % 4 == 0 ? distance * distance : 0.0;
      atOrigin.push_back(inertia[i] + v * (diagonal - c[i / 3] * c[i % 3]));
    }
    this->Add(
      names::VolumeInertiaAtOrigin, atOrigin, inertiaError + steinerError, trace + v * distance * distance);
    // Weyl: the largest sum of a row.
    const double principalError = 3 * inertiaError;
    std::vector<double> principal;
    std::vector<double> gyration;
    double gyrationError = 0.0;
    for (const long double value : GetEigenvalues(inertia))
    {
      principal.push_back(static_cast<double>(value));
      gyration.push_back(static_cast<double>(std::sqrt(value / v)));
      gyrationError = std::max(
        gyrationError, (principalError + principal.back() * volumeError / v) / v / (2 * gyration.back()));
    }
    this->Add(names::PrincipalMoments, principal, principalError, trace);
    this->Add(names::RadiiOfGyration, gyration, gyrationError, size);
  }

  const ExactQuantity& Find(const char* name) const
  {
    for (const ExactQuantity& quantity : this->Quantities)
    {
      if (std::strcmp(quantity.Name, name) == 0)
      {
        return quantity;
      }
    }
    throw std::runtime_error(std::string("no exact value of ") + name);
  }

  std::vector<ExactQuantity> Quantities;

private:
  void Add(const char* name, const std::vector<double>& values, double error, double scale)
  {
    // The expected values are doubles and small sums of their products.
    this->Quantities.push_back({ name, values, error + 4 * std::numeric_limits<double>::epsilon() * scale });
  }
};
}

#endif
