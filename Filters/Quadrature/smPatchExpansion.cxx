// Computes the series of PatchMajorants: expands a patch on a box of its parameters.
#include "smBezierPatch.h"
#include "smChebyshev.h"
#include "smPatchMajorants.h"
#include "smVector.h"

#include "smBernstein.h"
#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Coefficients of series longer than MaxKept that are this small, relative to the largest, are rounding of
// the samples: in an ellipse they would grow with their degree. They are left out of it, and their absolute
// values are added to the bound.
constexpr int MaxKept = 12;
constexpr double NoiseSize = 2e-16; // times the number of coefficients in both directions

/// The sum of `count` factors times points of four numbers, which lie `stride` numbers apart.
inline void SumFours(const double* factors, const double* points, int count, int stride, double* sum)
{
  // Summed in local variables, which stay in registers: the compiler cannot know that `sum` does not overlap
  // `points`.
  double value[4] = {};
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      value[c] += factors[i] * points[stride * i + c];
    }
  }
  std::copy_n(value, 4, sum);
}

/// Chebyshev coefficients k of the Bernstein polynomials j of a degree on [middle - half, middle + half]: row
/// k.
void MakeConversion(int degree, double middle, double half, std::vector<double>& conversion)
{
  const int n = degree + 1;
  const ChebyshevRule& rule = ChebyshevRule::Get(n);
  conversion.assign(n * n, 0.0);
  double basis[MaximumDegree + 1];
  for (int i = 0; i < n; ++i)
  {
    FillBernsteinBasis(degree, middle + half * rule.GetNode(i), basis);
    for (int k = 0; k < n; ++k)
    {
      const double factor = rule.GetTransform(k)[i];
      for (int j = 0; j < n; ++j)
      {
        conversion[k * n + j] += factor * basis[j];
      }
    }
  }
}

}

void PatchMajorants::ExpandNet(const double* net, int countS, int countR, std::vector<double>& series)
{
  static thread_local std::vector<double> toS;
  static thread_local std::vector<double> toR;
  MakeConversion(countS - 1, this->Box.Middle[0], this->Box.Half[0], toS);
  MakeConversion(countR - 1, this->Box.Middle[1], this->Box.Half[1], toR);
  const int columns = this->P + 1;
  this->Scratch.resize(4 * static_cast<std::size_t>(countS) * countR);
  for (int j = 0; j < countR; ++j)
  {
    for (int k = 0; k < countS; ++k)
    {
      SumFours(toS.data() + k * countS, net + 4 * countS * j, countS, 4,
        this->Scratch.data() + 4 * (k + countS * j));
    }
  }
  series.assign(4 * static_cast<std::size_t>(columns) * (this->Q + 1), 0.0);
  for (int l = 0; l < countR; ++l)
  {
    for (int k = 0; k < countS; ++k)
    {
      SumFours(toR.data() + l * countR, this->Scratch.data() + 4 * k, countR, 4 * countS,
        series.data() + 4 * (k + columns * l));
    }
  }
}

void PatchMajorants::ExpandDerivatives(const std::array<double, 4>* points)
{
  // Derivatives from differences of control points: differentiating a series would amplify its rounding by
  // the square of the degree, and on a small box again.
  const int columns = this->P + 1;
  const int rows = this->Q + 1;
  static thread_local std::vector<double> net;
  net.resize(4 * static_cast<std::size_t>(columns) * rows);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < this->P; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        net[4 * (i + this->P * j) + c] =
          this->P * (points[i + 1 + columns * j][c] - points[i + columns * j][c]);
      }
    }
  }
  this->ExpandNet(net.data(), this->P, rows, this->Series[1]);
  for (int j = 0; j < this->Q; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        net[4 * (i + columns * j) + c] =
          this->Q * (points[i + columns * (j + 1)][c] - points[i + columns * j][c]);
      }
    }
  }
  this->ExpandNet(net.data(), columns, this->Q, this->Series[2]);
}

void PatchMajorants::SampleNumerators(const Vector3& origin)
{
  const int columns = this->P + 1;
  const int rows = this->Q + 1;
  const int countS = 3 * this->P - 1;
  const int countR = 3 * this->Q - 1;
  const ChebyshevRule& ruleS = ChebyshevRule::Get(countS);
  const ChebyshevRule& ruleR = ChebyshevRule::Get(countR);
  this->Samples.resize(static_cast<std::size_t>(Components) * countS * countR);
  this->Weights.resize(static_cast<std::size_t>(countS) * countR);
  static thread_local std::vector<double> lines;
  lines.resize(12 * rows);
  for (int a = 0; a < countS; ++a)
  {
    // The three series at this s, as polynomials in r.
    const double* t = ruleS.GetValues(a);
    for (int f = 0; f < 3; ++f)
    {
      for (int l = 0; l < rows; ++l)
      {
        SumFours(t, this->Series[f].data() + 4 * columns * l, columns, 4, lines.data() + 4 * (rows * f + l));
      }
    }
    const double s = this->Box.Middle[0] + this->Box.Half[0] * ruleS.GetNode(a);
    for (int b = 0; b < countR; ++b)
    {
      const double* tr = ruleR.GetValues(b);
      double h[3][4];
      for (int f = 0; f < 3; ++f)
      {
        SumFours(tr, lines.data() + 4 * rows * f, rows, 4, h[f]);
      }
      const Vector3 sr = Cross(h[1], h[2]);
      const Vector3 rp = Cross(h[2], h[0]);
      const Vector3 ps = Cross(h[0], h[1]);
      const double r = this->Box.Middle[1] + this->Box.Half[1] * ruleR.GetNode(b);
      const double factor = this->GetFactor(s, r);
      double* sample = this->Samples.data() + Components * (a + static_cast<std::size_t>(countS) * b);
      this->Weights[a + static_cast<std::size_t>(countS) * b] = h[0][3];
      double m[3];
      for (int c = 0; c < 3; ++c)
      {
        m[c] = h[0][3] * sr[c] + h[1][3] * rp[c] + h[2][3] * ps[c];
        sample[1 + c] = m[c] / factor;
      }
      sample[0] = h[0][0] * sr[0] + h[0][1] * sr[1] + h[0][2] * sr[2] + origin[0] * m[0] + origin[1] * m[1] +
        origin[2] * m[2];
      sample[4] = Norm(sample + 1);
    }
  }
}

template <int Used>
void PatchMajorants::Transform(int countS, int countR)
{
  const std::size_t line = static_cast<std::size_t>(Used) * countS;
  const ChebyshevRule& ruleS = ChebyshevRule::Get(countS);
  const ChebyshevRule& ruleR = ChebyshevRule::Get(countR);
  this->Scratch.resize(line * countR);
  // Sums stay in registers; their order is always that of the nodes.
  for (int b = 0; b < countR; ++b)
  {
    const double* from = this->Samples.data() + static_cast<std::size_t>(Components) * countS * b;
    double* to = this->Scratch.data() + line * b;
    for (int k = 0; k < countS; ++k)
    {
      const double* row = ruleS.GetTransform(k);
      double sum[Used] = {};
      for (int a = 0; a < countS; ++a)
      {
        for (int c = 0; c < Used; ++c)
        {
          sum[c] += row[a] * from[Components * a + c];
        }
      }
      std::copy_n(sum, Used, to + Used * k);
    }
  }
  for (int l = 0; l < countR; ++l)
  {
    const double* row = ruleR.GetTransform(l);
    for (int k = 0; k < countS; ++k)
    {
      const double* from = this->Scratch.data() + Used * k;
      double* to = this->Samples.data() + Components * (k + static_cast<std::size_t>(countS) * l);
      double sum[Components] = {};
      for (int b = 0; b < countR; ++b, from += line)
      {
        for (int c = 0; c < Used; ++c)
        {
          sum[c] += row[b] * from[c];
        }
      }
      std::copy_n(sum, Components, to);
    }
  }
}

template void PatchMajorants::Transform<PatchMajorants::Components>(int countS, int countR);

void PatchMajorants::DropNoise(std::size_t count, double noise)
{
  // D, m~ and h, each against its own largest coefficient.
  const auto size = [](const double* entry, int which) {
    return which == 0 ? std::abs(entry[0]) : which == 1 ? Norm(entry + 1) : std::abs(entry[4]);
  };
  for (int which = 0; which < 3; ++which)
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      largest = std::max(largest, size(this->Samples.data() + Components * i, which));
    }
    for (std::size_t i = 1; i < count; ++i)
    {
      double* entry = this->Samples.data() + Components * i;
      const double length = size(entry, which);
      if (length <= noise * largest)
      {
        this->Dropped[which] += length;
        const int begin = which == 0 ? 0 : which == 1 ? 1 : 4;
        std::fill(entry + begin, entry + (which == 0 ? 1 : which == 1 ? 4 : 5), 0.0);
      }
    }
  }
}

void PatchMajorants::MakeTables(int countS, int countR)
{
  this->CountS = countS;
  this->CountR = countR;
  const double* first = this->Samples.data();
  this->FirstLength = this->Traits.PolynomialLength ? std::abs(first[4]) : Norm(first + 1);
  double rest = 0.0;
  double beside = 0.0;
  Vector3 e{ 0.0, 0.0, 0.0 };
  for (int c = 0; c < 3; ++c)
  {
    e[c] = this->FirstLength > 0.0 ? first[1 + c] / this->FirstLength : 0.0;
  }
  const std::size_t count = static_cast<std::size_t>(countS) * countR;
  this->Products.assign(count, {});
  this->Dropped = {};
  if (std::max(countS, countR) > MaxKept)
  {
    this->DropNoise(count, NoiseSize * (countS + countR));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* entry = first + Components * i;
    ProductEntry& product = this->Products[i];
    product[Numerator] = std::abs(entry[0]);
    product[Normal] = Norm(entry + 1);
    if (this->Traits.PolynomialLength)
    {
      product[Along] = i == 0 ? 0.0 : std::abs(entry[4]);
      rest += product[Along];
      continue;
    }
    const double along = entry[1] * e[0] + entry[2] * e[1] + entry[3] * e[2];
    const double across[3] = { entry[1] - along * e[0], entry[2] - along * e[1], entry[3] - along * e[2] };
    product[Along] = i == 0 ? 0.0 : std::abs(along);
    rest += product[Along];
    product[Across] = i == 0 ? 0.0 : Norm(across);
    beside += product[Across];
  }
  rest += this->Dropped[this->Traits.PolynomialLength ? 2 : 1];
  this->Positive = rest < 0.999999 * this->FirstLength;
  this->MinimumLength = this->FirstLength - rest;
  this->Nonzero = rest + beside < 0.999999 * this->FirstLength;
}

void PatchMajorants::ExpandWithoutNormal(
  const std::array<double, 4>* points, int p, int q, const PatchTraits& traits, const ParameterBox& box)
{
  this->P = p;
  this->Q = q;
  this->Box = box;
  this->Traits = traits;
  this->ExpandNet(points->data(), p + 1, q + 1, this->Series[0]);
  const std::vector<double>& series = this->Series[0];
  this->FirstWeight = series[3];
  const Vector3 center{ series[0] / series[3], series[1] / series[3], series[2] / series[3] };
  this->CenterOffset = Norm(center.data());
  this->Weight.Resize(p + 1, q + 1);
  this->Position.Resize(p + 1, q + 1);
  for (std::size_t i = 0; i < this->Weight.Entries.size(); ++i)
  {
    const double* entry = series.data() + 4 * i;
    const double offset[3] = { entry[0] - center[0] * entry[3], entry[1] - center[1] * entry[3],
      entry[2] - center[2] * entry[3] };
    this->Position.Entries[i] = Norm(offset);
    this->Weight.Entries[i] = i == 0 || traits.Polynomial ? 0.0 : std::abs(entry[3]);
  }
}

void PatchMajorants::MeasureNet(const std::array<double, 4>* points)
{
  const int columns = this->P + 1;
  this->NetRadius = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    this->NetSteps[d] = this->WeightSteps[d] = 0.0;
  }
  for (int j = 0; j <= this->Q; ++j)
  {
    for (int i = 0; i <= this->P; ++i)
    {
      const std::array<double, 4>& a = points[i + columns * j];
      this->NetRadius = std::max(this->NetRadius, Norm(a.data()));
      for (int d = 0; d < 2; ++d)
      {
        if (d == 0 ? i < this->P : j < this->Q)
        {
          const std::array<double, 4>& b = points[i + columns * j + (d == 0 ? 1 : columns)];
          const double degree = d == 0 ? this->P : this->Q;
          this->NetSteps[d] =
            std::max(this->NetSteps[d], degree * std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
          this->WeightSteps[d] = std::max(this->WeightSteps[d], degree * std::abs(b[3] - a[3]));
        }
      }
    }
  }
}

void PatchMajorants::ExpandSamples(const std::array<double, 4>* points, int p, int q,
  const PatchTraits& traits, const ParameterBox& box, const Vector3& origin)
{
  this->ExpandWithoutNormal(points, p, q, traits, box);
  this->MeasureNet(points);
  this->ExpandDerivatives(points);
  const std::vector<double>& series = this->Series[0];
  const double fromOrigin[3] = { origin[0] + series[0] / series[3], origin[1] + series[1] / series[3],
    origin[2] + series[2] / series[3] };
  this->CenterDistance = Norm(fromOrigin);
  this->SampleNumerators(origin);
}

void PatchMajorants::ReleaseSamples()
{
  for (std::vector<double>* values :
    { &this->Samples, &this->Weights, &this->Scratch, &this->Series[0], &this->Series[1], &this->Series[2] })
  {
    *values = std::vector<double>();
  }
}

void PatchMajorants::Expand(const std::array<double, 4>* points, int p, int q, const PatchTraits& traits,
  const ParameterBox& box, const Vector3& origin)
{
  this->ExpandSamples(points, p, q, traits, box, origin);
  if (traits.PolynomialLength)
  {
    this->Transform<Components>(3 * p - 1, 3 * q - 1);
  }
  else
  {
    this->Transform<Components - 1>(3 * p - 1, 3 * q - 1);
  }
  this->MakeTables(3 * p - 1, 3 * q - 1);
}
}
