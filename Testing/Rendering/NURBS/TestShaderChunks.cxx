// The chunks of mathematics that the shaders are made of, compiled as C++: against extended precision.
#include "smPortableCxx.h"
#include "smReferenceBernstein.h"
#include "smTesting.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
#define SM_BASIS_SIZE 26
#define SM_ROW_SIZE 26

std::vector<double> coefficients;
std::vector<dvec4> controlPoints;

double smCoefficient(uint index)
{
  return coefficients[index];
}

dvec4 smControlPoint(uint index)
{
  return controlPoints[index];
}

#include "glsl/smErrorFree.glsl"

#include "glsl/smBernstein.glsl"
#include "glsl/smPatch.glsl"

using smtest::Bernstein;
using smtest::BernsteinSlope;
constexpr double Unit = sm::UnitRoundoff;

/// Exact sums of doubles within 2^10 of each other fit into the 64 bits of a long double, products of
/// integers below 2^53 into 128 bits.
void CheckErrorFree()
{
  __extension__ using Wide = __int128;
  std::mt19937_64 random(11);
  int wrongSums = 0;
  int wrongProducts = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const std::int64_t m = static_cast<std::int64_t>(random() >> 11) * (random() % 2 == 0 ? -1 : 1);
    const std::int64_t n = static_cast<std::int64_t>(random() >> 11);
    const double a = static_cast<double>(m);
    const double b = std::ldexp(static_cast<double>(n), static_cast<int>(random() % 10));
    const dvec2 sum = smTwoSum(a, b);
    const bool sumIsRight = static_cast<long double>(sum.x) + sum.y == static_cast<long double>(a) + b;
    wrongSums += sum.x != a + b || !sumIsRight;
    const double product = a * static_cast<double>(n);
    const Wide lack = static_cast<Wide>(m) * n - static_cast<Wide>(product);
    wrongProducts += smProductError(a, static_cast<double>(n), product) != static_cast<double>(lack);
  }
  smtest::Check("error-free sums", 0.0, wrongSums, 0.0, "exact");
  smtest::Check("error-free products", 0.0, wrongProducts, 0.0, "exact");
}

void CheckBasis()
{
  double worst = 0.0;
  for (int n = 0; n <= 25; ++n)
  {
    for (double x = 0.0; x <= 1.0; x += 0.0625)
    {
      double basis[SM_BASIS_SIZE];
      smBernsteinBasis(n, x, basis);
      for (int i = 0; i <= n; ++i)
      {
        worst = std::max(worst, std::abs(basis[i] - static_cast<double>(Bernstein<long double>(n, i, x))));
      }
    }
  }
  smtest::Check(
    "Bernstein basis, degrees 0 to 25", 0.0, worst, 3 * 25 * Unit, "3 roundings a level, terms below 1");
}

void CheckPieces()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double worst[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int n = 0; n <= 25; ++n)
  {
    coefficients.assign(3 * (n + 1) + 1, 0.0);
    std::generate(coefficients.begin(), coefficients.end(), [&]() { return uniform(random); });
    for (double x = 0.0; x <= 1.0; x += 0.03125)
    {
      dvec2 point;
      dvec2 derivative;
      dvec3 edge;
      dvec3 tangent;
      dvec2 reach;
      const dvec2 trimOrigin(0.25, -0.5);
      const dvec3 edgeOrigin(-0.25, 0.5, 0.75);
      smTrimEvaluate(1u, n, x, trimOrigin, point, derivative, reach);
      smEdgeEvaluate(1u, n, x, edgeOrigin, edge, tangent);
      long double expected[4] = { 0.0L, 0.0L, 0.0L, 0.0L };
      for (int i = 0; i <= n; ++i)
      {
        expected[0] += Bernstein<long double>(n, i, x) * coefficients[1 + 2 * i + 1];
        expected[1] += BernsteinSlope<long double>(n, i, x) * coefficients[1 + 2 * i + 1];
        expected[2] += Bernstein<long double>(n, i, x) * coefficients[1 + 3 * i + 2];
        expected[3] += BernsteinSlope<long double>(n, i, x) * coefficients[1 + 3 * i + 2];
      }
      expected[0] -= static_cast<long double>(trimOrigin.y);
      expected[2] -= static_cast<long double>(edgeOrigin.z);
      const double actual[4] = { point.y, derivative.y, edge.z, tangent.z };
      for (int k = 0; k < 4; ++k)
      {
        const double scale = k % 2 ? std::max(1, 2 * n) : 1.0;
        worst[k] = std::max(worst[k], static_cast<double>(std::abs(actual[k] - expected[k])) / scale);
      }
    }
  }
  const char* names[4] = { "trim point", "trim derivative", "edge point", "edge derivative" };
  for (int k = 0; k < 4; ++k)
  {
    const bool compensated = k < 3;
    smtest::Check(std::string(names[k]) + ", degrees 0 to 25", 0.0, worst[k],
      (compensated ? 1.01 * 1.75 : 6 * 26) * Unit,
      compensated ? "compensated: one rounding of up to 1.75"
                  : "6 roundings a coefficient, relative to the largest");
  }
}

void CheckPatches()
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const int degrees[][2] = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 3, 3 }, { 2, 7 }, { 5, 5 }, { 12, 25 },
    { 25, 25 } };
  for (const auto& degree : degrees)
  {
    const int p = degree[0];
    const int q = degree[1];
    controlPoints.assign((p + 1) * (q + 1) + 2, dvec4(0.0));
    for (dvec4& c : controlPoints)
    {
      const double w = 1.0 + 0.5 * uniform(random);
      c = dvec4(w * uniform(random), w * uniform(random), w * uniform(random), w);
    }
    double worst[3] = { 0.0, 0.0, 0.0 };
    for (double s = 0.0; s <= 1.0; s += 0.125)
    {
      for (double r = 0.0; r <= 1.0; r += 0.125)
      {
        dvec4 row[SM_ROW_SIZE];
        dvec4 rowS[SM_ROW_SIZE];
        dvec4 rowR[SM_ROW_SIZE];
        dvec3 position;
        dvec3 ds;
        dvec3 dr;
        smCollapse(2u, p, q, r, row, rowS, rowR);
        smEvaluateRow(p, s, row, rowS, rowR, position, ds, dr);
        long double h[3][4] = {};
        for (int i = 0; i <= p; ++i)
        {
          for (int j = 0; j <= q; ++j)
          {
            const dvec4& c = controlPoints[2 + i + j * (p + 1)];
            for (int d = 0; d < 4; ++d)
            {
              h[0][d] += Bernstein<long double>(p, i, s) * Bernstein<long double>(q, j, r) * c[d];
              h[1][d] += BernsteinSlope<long double>(p, i, s) * Bernstein<long double>(q, j, r) * c[d];
              h[2][d] += Bernstein<long double>(p, i, s) * BernsteinSlope<long double>(q, j, r) * c[d];
            }
          }
        }
        for (int d = 0; d < 3; ++d)
        {
          const long double x = h[0][d] / h[0][3];
          const long double expected[3] = { x, (h[1][d] - x * h[1][3]) / h[0][3],
            (h[2][d] - x * h[2][3]) / h[0][3] };
          const double actual[3] = { position[d], ds[d], dr[d] };
          for (int k = 0; k < 3; ++k)
          {
            worst[k] = std::max(worst[k], std::abs(actual[k] - static_cast<double>(expected[k])));
          }
        }
      }
    }
    const std::string name = "patch of degrees " + std::to_string(p) + "," + std::to_string(q);
    // Coordinates and weights are of order 1, differences of neighbours of order 4, weights at least 1/2.
    const double limit = 16 * (p + q) * Unit;
    smtest::Check(name + " position", 0.0, worst[0], limit, "a few roundings a level");
    smtest::Check(name + " ds", 0.0, worst[1], 8 * p * limit, "differences up to 4, times p");
    smtest::Check(name + " dr", 0.0, worst[2], 8 * q * limit, "differences up to 4, times q");
  }
}
}

int TestShaderChunks(int, char*[])
{
  CheckErrorFree();
  CheckBasis();
  CheckPieces();
  CheckPatches();
  return smtest::Finish();
}
