#include "Detail/smSubPatches.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Homogeneous = std::array<double, 4>;

// Largest number of points for which products of polynomials are used; patches of degrees above about 7 x 7
// are bounded by intervals, as their products cost too much.
constexpr int MaximumProductPoints = 64;
// (3p+1)(3q+1) = 9 (p+1)(q+1) - 6 (p+q+2) + 4, largest for p = q = 7.
constexpr int MaximumProductCoefficients = 484;

/// The interval [Low, High]. Operations return an interval that contains all results for operands in their
/// intervals.
struct Interval
{
  double Low = 0.0;
  double High = 0.0;

  double GetMagnitude() const { return std::max(std::abs(this->Low), std::abs(this->High)); }
  void Include(double x)
  {
    this->Low = std::min(this->Low, x);
    this->High = std::max(this->High, x);
  }
};

Interval operator-(const Interval& a, const Interval& b)
{
  return { a.Low - b.High, a.High - b.Low };
}

Interval operator*(const Interval& a, const Interval& b)
{
  const double products[4] = { a.Low * b.Low, a.Low * b.High, a.High * b.Low, a.High * b.High };
  const auto ends = std::minmax_element(products, products + 4);
  return { *ends.first, *ends.second };
}

/// Requires positive `b`.
Interval operator/(const Interval& a, const Interval& b)
{
  return a * Interval{ 1.0 / b.High, 1.0 / b.Low };
}

/// A sub-patch as a rational Bézier patch on its unit domain, relative to the centre of its control points.
struct SubPatch
{
  int Degree[2];
  Homogeneous Points[(MaximumDegree + 1) * (MaximumDegree + 1)];

  SubPatch(const NURBSSurface& surface, double u0, double u1, double v0, double v1);

  const Homogeneous& Get(int i, int j) const { return this->Points[i + j * (this->Degree[0] + 1)]; }

  /// Returns the range of the derivative of order (a, b) of a homogeneous coordinate, which is that of its
  /// Bernstein coefficients: differences of the control points times p (p-1) ..; derivatives of an order
  /// above the degree are 0.
  Interval GetRange(int a, int b, int coordinate) const;
};

SubPatch::SubPatch(const NURBSSurface& surface, double u0, double u1, double v0, double v1)
  : Degree{ surface.Degree[0], surface.Degree[1] }
{
  surface.ExtractBezier(u0, u1, v0, v1, this->Points);
  const int count = (this->Degree[0] + 1) * (this->Degree[1] + 1);
  // Derivatives do not depend on the origin, but the bounds of a quotient do; they are tightest about the
  // centre.
  for (int c = 0; c < 3; ++c)
  {
    Interval range = { this->Points[0][c] / this->Points[0][3], this->Points[0][c] / this->Points[0][3] };
    for (int i = 1; i < count; ++i)
    {
      range.Include(this->Points[i][c] / this->Points[i][3]);
    }
    const double center = 0.5 * (range.Low + range.High);
    for (int i = 0; i < count; ++i)
    {
      this->Points[i][c] -= center * this->Points[i][3];
    }
  }
}

Interval SubPatch::GetRange(int a, int b, int coordinate) const
{
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  if (a > p || b > q)
  {
    return {};
  }
  double factor = 1.0;
  for (int k = 0; k < a; ++k)
  {
    factor *= p - k;
  }
  for (int k = 0; k < b; ++k)
  {
    factor *= q - k;
  }
  const auto alongU = [this, coordinate, a](int i, int j)
  {
    const auto x = [this, coordinate, j](int k) { return this->Get(k, j)[coordinate]; };
    return a == 0 ? x(i) : a == 1 ? x(i + 1) - x(i) : (x(i + 2) - x(i + 1)) - (x(i + 1) - x(i));
  };
  Interval range;
  for (int j = 0; j + b <= q; ++j)
  {
    for (int i = 0; i + a <= p; ++i)
    {
      const double d = b == 0 ? alongU(i, j)
        : b == 1              ? alongU(i, j + 1) - alongU(i, j)
                              : (alongU(i, j + 2) - alongU(i, j + 1)) - (alongU(i, j + 1) - alongU(i, j));
      if (i == 0 && j == 0)
      {
        range = { factor * d, factor * d };
      }
      range.Include(factor * d);
    }
  }
  return range;
}

/// Largest absolute values of the second derivatives by u u, u v and v v.
using SecondDerivatives = std::array<double, 3>;

/// Bounds the second derivatives by interval arithmetic. With x = X/w, X = x w, and by differentiating twice:
///   x_u = (X_u - x w_u) / w,  x_uu = (X_uu - 2 x_u w_u - x w_uu) / w,  x_uv = (X_uv - x_u w_v - x_v w_u - x
///   w_uv) / w.
/// Each factor lies in the range of its Bernstein coefficients, and x in that of the control points (weights
/// are positive).
SecondDerivatives BoundByIntervals(const SubPatch& patch)
{
  const Interval w = patch.GetRange(0, 0, 3);
  const Interval wu = patch.GetRange(1, 0, 3);
  const Interval wv = patch.GetRange(0, 1, 3);
  const Interval wuu = patch.GetRange(2, 0, 3);
  const Interval wuv = patch.GetRange(1, 1, 3);
  const Interval wvv = patch.GetRange(0, 2, 3);
  const Interval two = { 2.0, 2.0 };
  const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  SecondDerivatives largest{};
  for (int c = 0; c < 3; ++c)
  {
    Interval x = { patch.Points[0][c] / patch.Points[0][3], patch.Points[0][c] / patch.Points[0][3] };
    for (int i = 1; i < count; ++i)
    {
      x.Include(patch.Points[i][c] / patch.Points[i][3]);
    }
    const Interval xu = (patch.GetRange(1, 0, c) - x * wu) / w;
    const Interval xv = (patch.GetRange(0, 1, c) - x * wv) / w;
    const Interval second[3] = { (patch.GetRange(2, 0, c) - two * xu * wu - x * wuu) / w,
      (patch.GetRange(1, 1, c) - xu * wv - xv * wu - x * wuv) / w,
      (patch.GetRange(0, 2, c) - two * xv * wv - x * wvv) / w };
    for (int k = 0; k < 3; ++k)
    {
      largest[k] = std::max(largest[k], second[k].GetMagnitude());
    }
  }
  return largest;
}

/// A polynomial of two variables on the unit square in scaled Bernstein form, u fastest: the coefficient b_ij
/// C(p,i) C(q,j) belongs to s^i (1-s)^(p-i) r^j (1-r)^(q-j), so that products are convolutions.
struct ScaledBernstein
{
  int Degree[2];
  int Count;
  std::array<double, MaximumProductCoefficients> Values;

  ScaledBernstein(int p, int q)
    : Degree{ p, q }
    , Count((p + 1) * (q + 1))
  {
    std::fill_n(this->Values.begin(), this->Count, 0.0);
  }
};

/// Adds factor a b to `sum`, whose degrees are the sums of the degrees of a and b. The cost is low if many
/// coefficients of `a` are 0.
void AddProduct(double factor, const ScaledBernstein& a, const ScaledBernstein& b, ScaledBernstein& sum)
{
  for (int j = 0; j <= a.Degree[1]; ++j)
  {
    for (int i = 0; i <= a.Degree[0]; ++i)
    {
      const double x = factor * a.Values[i + j * (a.Degree[0] + 1)];
      // Weights often vary in one direction only, and low degrees have few derivatives.
      if (x == 0.0)
      {
        continue;
      }
      for (int l = 0; l <= b.Degree[1]; ++l)
      {
        const double* from = b.Values.data() + l * (b.Degree[0] + 1);
        double* to = sum.Values.data() + (j + l) * (sum.Degree[0] + 1) + i;
        for (int k = 0; k <= b.Degree[0]; ++k)
        {
          to[k] += x * from[k];
        }
      }
    }
  }
}

/// Returns a b - c d.
ScaledBernstein Determinant(
  const ScaledBernstein& a, const ScaledBernstein& b, const ScaledBernstein& c, const ScaledBernstein& d)
{
  ScaledBernstein result(a.Degree[0] + b.Degree[0], a.Degree[1] + b.Degree[1]);
  AddProduct(1.0, b, a, result);
  AddProduct(-1.0, d, c, result);
  return result;
}

/// Returns the derivative of order (a, b) of a homogeneous coordinate, elevated to the patch's own degrees.
ScaledBernstein Differentiate(const SubPatch& patch, int a, int b, int coordinate)
{
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  ScaledBernstein result(p, q);
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      result.Values[i + j * (p + 1)] = patch.Get(i, j)[coordinate];
    }
  }
  // f' has the coefficients p (f_i+1 - f_i); elevated by one degree, i (f_i - f_i-1) + (p - i) (f_i+1 - f_i).
  const auto differentiate = [&result](int count, int stride, int start)
  {
    double* f = result.Values.data() + start;
    double before = 0.0;
    for (int i = 0; i <= count; ++i)
    {
      const double after = i < count ? f[(i + 1) * stride] - f[i * stride] : 0.0;
      f[i * stride] = i * before + (count - i) * after;
      before = after;
    }
  };
  for (int j = 0; j <= q; ++j)
  {
    for (int k = 0; k < a; ++k)
    {
      differentiate(p, 1, j * (p + 1));
    }
  }
  for (int i = 0; i <= p; ++i)
  {
    for (int k = 0; k < b; ++k)
    {
      differentiate(q, p + 1, i);
    }
  }
  double across = 1.0;
  for (int j = 0; j <= q; across *= static_cast<double>(q - j) / (j + 1), ++j)
  {
    double binomial = across;
    for (int i = 0; i <= p; binomial *= static_cast<double>(p - i) / (i + 1), ++i)
    {
      result.Values[i + j * (p + 1)] *= binomial;
    }
  }
  return result;
}

/**
 * Bounds the second derivatives by the quotient rule, multiplied by the denominator: with [f] = w X_f - X
 * w_f, which is w^2 x_f when f is u or v, w^3 x_uu = w [uu] - 2 w_u [u],   w^3 x_uv = w [uv] - w_v [u] - w_u
 * [v],   w^3 x_vv = w [vv] - 2 w_v [v]. If N and D are given by Bernstein coefficients (both scaled or
 * neither) and those of D = w^3 are positive, N/D is a mean of the N_i/D_i, with weights D_i B_i, and does
 * not exceed the largest of them. This bound is tighter than interval arithmetic, which takes the worst case
 * of every factor separately.
 */
SecondDerivatives BoundByProducts(const SubPatch& patch)
{
  const ScaledBernstein w = Differentiate(patch, 0, 0, 3);
  const ScaledBernstein wu = Differentiate(patch, 1, 0, 3);
  const ScaledBernstein wv = Differentiate(patch, 0, 1, 3);
  const ScaledBernstein second[3] = { Differentiate(patch, 2, 0, 3), Differentiate(patch, 1, 1, 3),
    Differentiate(patch, 0, 2, 3) };
  const int orders[3][2] = { { 2, 0 }, { 1, 1 }, { 0, 2 } };
  ScaledBernstein square(2 * w.Degree[0], 2 * w.Degree[1]);
  AddProduct(1.0, w, w, square);
  ScaledBernstein cube(3 * w.Degree[0], 3 * w.Degree[1]);
  AddProduct(1.0, square, w, cube);
  SecondDerivatives largest{};
  for (int c = 0; c < 3; ++c)
  {
    const ScaledBernstein x = Differentiate(patch, 0, 0, c);
    const ScaledBernstein bracketU = Determinant(w, Differentiate(patch, 1, 0, c), x, wu);
    const ScaledBernstein bracketV = Determinant(w, Differentiate(patch, 0, 1, c), x, wv);
    for (int k = 0; k < 3; ++k)
    {
      ScaledBernstein numerator(cube.Degree[0], cube.Degree[1]);
      AddProduct(
        1.0, Determinant(w, Differentiate(patch, orders[k][0], orders[k][1], c), x, second[k]), w, numerator);
      AddProduct(-1.0, k == 0 ? wu : wv, k == 2 ? bracketV : bracketU, numerator);
      AddProduct(-1.0, k == 2 ? wv : wu, k == 0 ? bracketU : bracketV, numerator);
      for (int i = 0; i < cube.Count; ++i)
      {
        largest[k] = std::max(largest[k], std::abs(numerator.Values[i]) / cube.Values[i]);
      }
    }
  }
  return largest;
}

/// Evaluates a polynomial given by its Bernstein coefficients, and its first and second derivative, at s. It
/// overwrites the coefficients.
void EvaluateTwice(
  Homogeneous* b, int degree, double s, Homogeneous& value, Homogeneous& first, Homogeneous& second)
{
  first.fill(0.0);
  second.fill(0.0);
  for (int level = degree; level > 0; --level)
  {
    for (int c = 0; c < 4; ++c)
    {
      if (level == 2)
      {
        second[c] = degree * (degree - 1) * ((b[2][c] - b[1][c]) - (b[1][c] - b[0][c]));
      }
      if (level == 1)
      {
        first[c] = degree * (b[1][c] - b[0][c]);
      }
      for (int i = 0; i < level; ++i)
      {
        b[i][c] = (1.0 - s) * b[i][c] + s * b[i + 1][c];
      }
    }
  }
  value = b[0];
}

/// Raises `largest` to |x_uu|, |x_uv| and |x_vv| at (s,r).
void SampleSecondDerivatives(const SubPatch& patch, double s, double r, SecondDerivatives& largest)
{
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  Homogeneous row[MaximumDegree + 1];
  Homogeneous columns[3][MaximumDegree + 1];
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      row[i] = patch.Get(i, j);
    }
    EvaluateTwice(row, p, s, columns[0][j], columns[1][j], columns[2][j]);
  }
  Homogeneous h, hu, hv, huu, huv, hvv, unused, unused2;
  EvaluateTwice(columns[0], q, r, h, hv, hvv);
  EvaluateTwice(columns[1], q, r, hu, huv, unused);
  EvaluateTwice(columns[2], q, r, huu, unused, unused2);
  const double w = h[3];
  for (int c = 0; c < 3; ++c)
  {
    const double x = h[c] / w;
    const double xu = (hu[c] - x * hu[3]) / w;
    const double xv = (hv[c] - x * hv[3]) / w;
    largest[0] = std::max(largest[0], std::abs(huu[c] - 2.0 * xu * hu[3] - x * huu[3]) / w);
    largest[1] = std::max(largest[1], std::abs(huv[c] - xu * hv[3] - xv * hu[3] - x * huv[3]) / w);
    largest[2] = std::max(largest[2], std::abs(hvv[c] - 2.0 * xv * hv[3] - x * hvv[3]) / w);
  }
}

}

double ComputeDeviation(
  const NURBSSurface& surface, double u0, double u1, double v0, double v1, DeviationMode mode)
{
  const SubPatch patch(surface, u0, u1, v0, v1);
  SecondDerivatives largest{};
  if (mode == DeviationMode::Bounded)
  {
    // If the weights are equal up to rounding, the intervals reduce to the second differences.
    const Interval w = patch.GetRange(0, 0, 3);
    const bool rational = w.High - w.Low > 1e-12 * w.High;
    const int points = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
    largest = rational && points <= MaximumProductPoints ? BoundByProducts(patch) : BoundByIntervals(patch);
  }
  else
  {
    const int columns = std::max(3, patch.Degree[0]) - 1;
    const int rows = std::max(3, patch.Degree[1]) - 1;
    for (int j = 0; j <= rows; ++j)
    {
      for (int i = 0; i <= columns; ++i)
      {
        SampleSecondDerivatives(
          patch, static_cast<double>(i) / columns, static_cast<double>(j) / rows, largest);
      }
    }
  }
  return 0.125 * (largest[0] + 2.0 * largest[1] + largest[2]);
}
}
