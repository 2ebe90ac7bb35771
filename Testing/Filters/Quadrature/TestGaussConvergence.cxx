// Gauss quadrature of the integrands of a panel, evaluated by the shaders' own chunk: the error falls
// geometrically in the order, stays below the theorem's bound at every order (Mathematics.md: f analytic and
// at most M in the ellipse E_rho gives (32/15) M rho^(-2N) / (1 - rho^-2)), and comes near it.
#include "smGaussLegendre.h"
#include "smPortableCxx.h"
#include "smReferenceBernstein.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#define SM_BASIS_SIZE 26
#define SM_ROW_SIZE 26

namespace chunk
{
std::vector<dvec4> controlPoints;
/// Coefficients of trim curves, which the chunk evaluates too; none here.
std::vector<double> coefficients;

dvec4 smControlPoint(uint index)
{
  return controlPoints[index];
}

double smCoefficient(uint index)
{
  return coefficients[index];
}

#include "glsl/smErrorFree.glsl"

#include "glsl/smBernstein.glsl"
#include "glsl/smPatch.glsl"
}

namespace
{
using smtest::Bernstein;
using smtest::BernsteinSlope;
using Complex = std::complex<long double>;
constexpr long double Pi = 3.14159265358979323846264338327950288L;

enum class Integrand
{
  Volume,
  Area
};

struct Patch
{
  std::string Name;
  int Degree[2];
  /// Homogeneous, s fastest.
  std::vector<dvec4> Points;
  /// Where the integrand stops being analytic, in s and r: the radius of the ellipse through the nearest zero
  /// of w.
  long double Radius[2];
};

/// The rule of `points` by `points` nodes, with the chunk.
double Integrate(const Patch& patch, Integrand integrand, int points)
{
  chunk::controlPoints = patch.Points;
  std::vector<double> nodes;
  std::vector<double> weights;
  sm::ComputeGaussLegendre(points, nodes, weights);
  double sum = 0.0;
  for (int j = 0; j < points; ++j)
  {
    dvec4 row[SM_ROW_SIZE];
    dvec4 rowS[SM_ROW_SIZE];
    dvec4 rowR[SM_ROW_SIZE];
    chunk::smCollapse(0u, patch.Degree[0], patch.Degree[1], nodes[j], row, rowS, rowR);
    for (int i = 0; i < points; ++i)
    {
      dvec3 position;
      dvec3 ds;
      dvec3 dr;
      chunk::smEvaluateRow(patch.Degree[0], nodes[i], row, rowS, rowR, position, ds, dr);
      const dvec3 normal = cross(ds, dr);
      sum += weights[i] * weights[j] *
        (integrand == Integrand::Volume ? dot(position, normal) / 3.0 : length(normal));
    }
  }
  return sum;
}

/// Modulus of the integrand's continuation. A square root has the modulus' square root on either branch.
long double EvaluateModulus(const Patch& patch, Integrand integrand, Complex s, Complex r)
{
  Complex h[3][4] = {};
  for (int j = 0; j <= patch.Degree[1]; ++j)
  {
    for (int i = 0; i <= patch.Degree[0]; ++i)
    {
      const Complex factor[3] = { Bernstein(patch.Degree[0], i, s) * Bernstein(patch.Degree[1], j, r),
        BernsteinSlope(patch.Degree[0], i, s) * Bernstein(patch.Degree[1], j, r),
        Bernstein(patch.Degree[0], i, s) * BernsteinSlope(patch.Degree[1], j, r) };
      const dvec4& point = patch.Points[i + j * (patch.Degree[0] + 1)];
      for (int d = 0; d < 3; ++d)
      {
        for (int c = 0; c < 4; ++c)
        {
          h[d][c] += factor[d] * static_cast<long double>(point[c]);
        }
      }
    }
  }
  Complex x[3];
  Complex a[3];
  Complex b[3];
  for (int c = 0; c < 3; ++c)
  {
    x[c] = h[0][c] / h[0][3];
    a[c] = (h[1][c] - x[c] * h[1][3]) / h[0][3];
    b[c] = (h[2][c] - x[c] * h[2][3]) / h[0][3];
  }
  const Complex n[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  return integrand == Integrand::Volume ? std::abs(x[0] * n[0] + x[1] * n[1] + x[2] * n[2]) / 3
                                        : std::sqrt(std::abs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
}

/// Largest modulus for one parameter on the ellipse E_rho around [0,1] and the other in [0,1], from samples:
/// 2 percent are added for what lies between them.
long double FindMajorant(const Patch& patch, Integrand integrand, int direction, long double rho)
{
  long double largest = 0;
  for (int k = 0; k < 128; ++k)
  {
    const Complex z = std::polar(rho, 2 * Pi * k / 128);
    const Complex x = (1.0L + (z + 1.0L / z) / 2.0L) / 2.0L;
    for (int i = 0; i <= 32; ++i)
    {
      const Complex y = i / 32.0L;
      largest = std::max(largest,
        direction == 0 ? EvaluateModulus(patch, integrand, x, y) : EvaluateModulus(patch, integrand, y, x));
    }
  }
  return 1.02L * largest;
}

/// The theorem's bound of the product rule: the two directions added, each at its best radius.
std::vector<long double> FindBounds(const Patch& patch, Integrand integrand, int orders)
{
  std::vector<long double> bounds(orders + 1, 0);
  for (int direction = 0; direction < 2; ++direction)
  {
    std::vector<long double> best(orders + 1, std::numeric_limits<long double>::infinity());
    for (const long double share : { 0.3L, 0.5L, 0.6L, 0.7L, 0.8L, 0.85L, 0.9L, 0.94L, 0.97L })
    {
      const long double rho = std::max(1.05L, share * patch.Radius[direction]);
      const long double majorant = FindMajorant(patch, integrand, direction, rho);
      for (int n = 1; n <= orders; ++n)
      {
        best[n] = std::min(best[n], 32.0L / 15 * majorant * std::pow(rho, -2 * n) / (1 - 1 / (rho * rho)));
      }
    }
    for (int n = 1; n <= orders; ++n)
    {
      bounds[n] += best[n];
    }
  }
  return bounds;
}

void CheckConvergence(const Patch& patch, Integrand integrand, long double exact)
{
  const std::string name = patch.Name + (integrand == Integrand::Volume ? ", volume" : ", area");
  const std::vector<long double> bounds = FindBounds(patch, integrand, sm::MaximumRuleSize);
  // Rounding of a few hundred terms.
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * static_cast<double>(std::abs(exact));
  const long double radius = std::min(patch.Radius[0], patch.Radius[1]);
  double excess = 0.0;
  double slack = 0.0;
  int last = 0;
  std::vector<double> errors{ 0.0 };
  for (int n = 1; n <= sm::MaximumRuleSize; ++n)
  {
    errors.push_back(std::abs(static_cast<double>(Integrate(patch, integrand, n) - exact)));
    const double bound = static_cast<double>(bounds[n]);
    std::printf("     %s, %2d points: error %.1e bound %.1e\n", name.c_str(), n, errors[n], bound);
    excess = std::max(excess, (errors[n] - rounding) / bound);
    if (errors[n] > 8 * rounding && last == n - 1)
    {
      last = n;
      slack = std::max(slack, bound / errors[n]);
    }
  }
  smtest::CheckRange(name + ": error / bound", 0.0, excess, 1.0, "(the theorem)");
  smtest::CheckRange(name + ": bound / error", 1.0, slack, 2e4, "(not vacuous: two points of weights 1000)");
  // A pole of order k costs a factor n^(k-1), so the rate is reached from above: three quarters of the
  // radius.
  const double rate = std::pow(errors[last] / errors[2], 1.0 / (last - 2));
  const double expected = static_cast<double>(std::pow(0.75L * radius, -2));
  smtest::CheckRange(name + ": orders above rounding", 4, last, sm::MaximumRuleSize);
  smtest::CheckRange(name + ": factor a point", 0.0, rate, expected, "(rho^-2)");
  smtest::CheckRange(name + ": error of the largest rule", 0.0, errors[sm::MaximumRuleSize],
    static_cast<double>(bounds[sm::MaximumRuleSize]) + rounding);
}

/// Radius of the ellipse around [0,1] through a point.
long double GetRadius(Complex x)
{
  const long double a = std::abs(x) + std::abs(1.0L - x);
  return a + std::sqrt(a * a - 1);
}

/// A quarter of the equator by a quarter of the meridian, about the middle (1, 0, 0), of the unit sphere at
/// `center`.
Patch MakeSphere(const dvec3& center)
{
  Patch patch;
  patch.Name = "sphere";
  const double c = std::sqrt(0.5);
  // (cos, sin, weight): (1, cos a, 1) with a = 45 degrees, homogeneous.
  const double arc[3][3] = { { c, -c, 1 }, { 1, 0, c }, { c, c, 1 } };
  for (const auto& q : arc)
  {
    for (const auto& p : arc)
    {
      const double w = p[2] * q[2];
      patch.Points.push_back(
        dvec4(p[0] * q[0] + w * center.x, p[1] * q[0] + w * center.y, q[1] * p[2] + w * center.z, w));
    }
  }
  patch.Degree[0] = patch.Degree[1] = 2;
  // w = 0 at 2s - 1 = i / tan(a / 2).
  const Complex zero(0.5L, 0.5L / std::tan(Pi / 8));
  patch.Radius[0] = patch.Radius[1] = GetRadius(zero);
  return patch;
}

/// A polynomial patch of degrees (3, 2), and itself with u = f s / (1 - s + f s): weights 1, f, f^2, f^3.
Patch MakeMoebius(double factor)
{
  const double heights[3][4] = { { 0, 2, -1, 1 }, { 1, 0.5, 3, 2 }, { -1, 1, 0, 1.5 } };
  Patch patch;
  patch.Name = "weights ratio " + std::to_string(static_cast<int>(std::lround(factor * factor * factor)));
  for (int j = 0; j <= 2; ++j)
  {
    for (int i = 0; i <= 3; ++i)
    {
      const double w = std::pow(factor, i);
      patch.Points.push_back(
        dvec4(w * (i + 0.25 * j), w * (2 * j - 0.125 * i * i), w * (4 + heights[j][i]), w));
    }
  }
  patch.Degree[0] = 3;
  patch.Degree[1] = 2;
  patch.Radius[0] = GetRadius(Complex(-1 / (static_cast<long double>(factor) - 1)));
  // Polynomial in r; any radius does.
  patch.Radius[1] = 20;
  return patch;
}
}

int TestGaussConvergence(int, char*[])
{
  const Patch sphere = MakeSphere(dvec3(0.3, -0.2, 0.4));
  // Area pi/2 sqrt(2); the integral of the normal is (sqrt(2) (pi/4 + 1/2), 0, 0).
  const long double area = Pi / 2 * std::sqrt(2.0L);
  const long double flux = (area + 0.3L * std::sqrt(2.0L) * (Pi / 4 + 0.5L)) / 3;
  CheckConvergence(sphere, Integrand::Area, area);
  CheckConvergence(sphere, Integrand::Volume, flux);

  Patch polynomial = MakeMoebius(1.0);
  // Degree 3 p - 1 = 8 in s: exact with 5 points.
  const double exact = Integrate(polynomial, Integrand::Volume, 8);
  smtest::Check("polynomial patch, 5 points", exact, Integrate(polynomial, Integrand::Volume, 5),
    64 * std::numeric_limits<double>::epsilon() * std::abs(exact), "rounding");
  CheckConvergence(MakeMoebius(4.0), Integrand::Volume, exact);
  CheckConvergence(MakeMoebius(10.0), Integrand::Volume, exact);
  return smtest::Finish();
}
