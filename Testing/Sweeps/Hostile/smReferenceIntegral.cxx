#include "smReferenceIntegral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace smhostile
{
namespace
{
constexpr int Points = 24;
// Relative to the integral of |x|^(1 + deg g) |n|: some ten times what extended precision leaves.
constexpr Real Target = 1e-18L;
constexpr int Packed[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };

using Values = std::array<Real, NumberOfIntegrals>;

struct Cell
{
  const ReferencePatch* Patch = nullptr;
  Real Start[2] = { 0.0L, 0.0L };
  Real Width = 1.0L;
  Values Integral{};
  Values Magnitude{};
  /// A quarter of the change by the last quartering of the parent cell; and its largest value in units of the
  /// target.
  Values Change{};
  Real Urgency = std::numeric_limits<Real>::infinity();

  bool operator<(const Cell& other) const { return this->Urgency < other.Urgency; }
};

struct Rule
{
  std::vector<Real> Nodes, Weights;
  Rule() { ComputeExtendedGauss(Points, this->Nodes, this->Weights); }
};

void IntegrateCell(Cell& cell)
{
  static const Rule rule;
  const ReferencePatch& patch = *cell.Patch;
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  std::vector<Real> basis[2][Points];
  for (int d = 0; d < 2; ++d)
  {
    for (int i = 0; i < Points; ++i)
    {
      std::vector<Real> derivatives;
      EvaluateBernstein(
        patch.Degree[d], cell.Start[d] + cell.Width * rule.Nodes[i], basis[d][i], derivatives);
      basis[d][i].insert(basis[d][i].end(), derivatives.begin(), derivatives.end());
    }
  }
  std::vector<RealPoint> row(p + 1), rowV(p + 1);
  for (int j = 0; j < Points; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      row[i] = rowV[i] = RealPoint{};
      for (int k = 0; k <= q; ++k)
      {
        const RealPoint& point = patch.Points[i + static_cast<std::size_t>(k) * (p + 1)];
        for (int c = 0; c < 4; ++c)
        {
          row[i][c] += basis[1][j][k] * point[c];
          rowV[i][c] += basis[1][j][q + 1 + k] * point[c];
        }
      }
    }
    for (int i = 0; i < Points; ++i)
    {
      RealPoint h{}, hu{}, hv{};
      for (int k = 0; k <= p; ++k)
      {
        for (int c = 0; c < 4; ++c)
        {
          h[c] += basis[0][i][k] * row[k][c];
          hu[c] += basis[0][i][p + 1 + k] * row[k][c];
          hv[c] += basis[0][i][k] * rowV[k][c];
        }
      }
      Real x[3], a[3], b[3];
      for (int c = 0; c < 3; ++c)
      {
        x[c] = h[c] / h[3];
        a[c] = (hu[c] - x[c] * hu[3]) / h[3];
        b[c] = (hv[c] - x[c] * hv[3]) / h[3];
      }
      const Real n[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
      const Real side = patch.Reversed ? -1.0L : 1.0L;
      const Real weight = rule.Weights[i] * rule.Weights[j] * cell.Width * cell.Width;
      const Real flux = side * weight * (x[0] * n[0] + x[1] * n[1] + x[2] * n[2]);
      const Real area = weight * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      const Real size = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      cell.Integral[0] += flux / 3.0L;
      cell.Magnitude[0] += size * area / 3.0L;
      for (int c = 0; c < 3; ++c)
      {
        cell.Integral[1 + c] += flux * x[c] / 4.0L;
        cell.Magnitude[1 + c] += size * size * area / 4.0L;
        for (int e = c; e < 3; ++e)
        {
          cell.Integral[4 + Packed[c][e]] += flux * x[c] * x[e] / 5.0L;
          cell.Magnitude[4 + Packed[c][e]] += size * size * size * area / 5.0L;
        }
      }
      cell.Integral[AreaIntegral] += area;
      cell.Magnitude[AreaIntegral] += area;
    }
  }
}

/// Eigenvalues of a symmetric matrix, ascending, by Jacobi's rotations.
std::array<Real, 3> ComputeEigenvalues(std::array<Real, 9> m)
{
  for (int sweep = 0; sweep < 60; ++sweep)
  {
    for (int p = 0; p < 2; ++p)
    {
      for (int q = p + 1; q < 3; ++q)
      {
        if (m[3 * p + q] == 0.0L)
        {
          continue;
        }
        const Real theta = (m[4 * q] - m[4 * p]) / (2.0L * m[3 * p + q]);
        const Real t = (theta >= 0.0L ? 1.0L : -1.0L) / (std::abs(theta) + std::sqrt(theta * theta + 1.0L));
        const Real c = 1.0L / std::sqrt(t * t + 1.0L);
        const Real s = t * c;
        for (int k = 0; k < 3; ++k)
        {
          const Real a = m[3 * k + p];
          const Real b = m[3 * k + q];
          m[3 * k + p] = c * a - s * b;
          m[3 * k + q] = s * a + c * b;
        }
        for (int k = 0; k < 3; ++k)
        {
          const Real a = m[3 * p + k];
          const Real b = m[3 * q + k];
          m[3 * p + k] = c * a - s * b;
          m[3 * q + k] = s * a + c * b;
        }
        m[3 * p + q] = m[3 * q + p] = 0.0L;
      }
    }
  }
  std::array<Real, 3> values{ m[0], m[4], m[8] };
  std::sort(values.begin(), values.end());
  return values;
}

std::array<Real, 9> MakeInertia(const std::array<Real, 6>& second)
{
  return { second[1] + second[2], -second[3], -second[5], -second[3], second[0] + second[2], -second[4],
    -second[5], -second[4], second[0] + second[1] };
}
}

void EvaluateBernstein(int degree, Real x, std::vector<Real>& values, std::vector<Real>& derivatives)
{
  values.assign(degree + 1, 0.0L);
  derivatives.assign(degree + 1, 0.0L);
  values[0] = 1.0L;
  for (int n = 1; n <= degree; ++n)
  {
    if (n == degree)
    {
      for (int i = 0; i <= degree; ++i)
      {
        derivatives[i] = degree * ((i > 0 ? values[i - 1] : 0.0L) - (i < degree ? values[i] : 0.0L));
      }
    }
    for (int i = n; i >= 0; --i)
    {
      values[i] = (1.0L - x) * (i < n ? values[i] : 0.0L) + x * (i > 0 ? values[i - 1] : 0.0L);
    }
  }
}

void ComputeExtendedGauss(int n, std::vector<Real>& nodes, std::vector<Real>& weights)
{
  nodes.resize(n);
  weights.resize(n);
  for (int i = 0; i < n; ++i)
  {
    Real x = std::cos(3.14159265358979323846L * (i + 0.75L) / (n + 0.5L));
    Real slope = 1.0L;
    for (int step = 0; step < 20; ++step)
    {
      Real p0 = 1.0L;
      Real p1 = x;
      for (int k = 2; k <= n; ++k)
      {
        const Real p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      slope = n == 1 ? 1.0L : n * (x * p1 - p0) / (x * x - 1.0L);
      x -= p1 / slope;
    }
    nodes[i] = 0.5L * (1.0L - x);
    weights[i] = 1.0L / ((1.0L - x * x) * slope * slope);
  }
}

ReferenceIntegrals IntegratePatches(const std::vector<ReferencePatch>& patches, int maximumCells)
{
  std::priority_queue<Cell> open;
  Values magnitude{};
  for (const ReferencePatch& patch : patches)
  {
    Cell cell;
    cell.Patch = &patch;
    IntegrateCell(cell);
    open.push(cell);
    for (int k = 0; k < NumberOfIntegrals; ++k)
    {
      magnitude[k] += cell.Magnitude[k];
    }
  }
  ReferenceIntegrals result;
  for (int k = 0; k < NumberOfIntegrals; ++k)
  {
    result.Error[k] = Target * magnitude[k];
  }
  for (int cells = 0; !open.empty(); ++cells)
  {
    const Cell cell = open.top();
    open.pop();
    if (cells >= maximumCells && std::isfinite(cell.Urgency))
    {
      // The budget is spent. Along a line where the normal vanishes the error falls irregularly: over a finer
      // truth it was up to 2.1 times the last change.
      for (int k = 0; k < NumberOfIntegrals; ++k)
      {
        result.Value[k] += cell.Integral[k];
        result.Error[k] += 8.0L * cell.Change[k];
      }
      continue;
    }
    Cell quarters[4];
    Values sum{};
    for (int i = 0; i < 4; ++i)
    {
      quarters[i].Patch = cell.Patch;
      quarters[i].Width = 0.5L * cell.Width;
      for (int d = 0; d < 2; ++d)
      {
        quarters[i].Start[d] = cell.Start[d] + (i >> d & 1) * quarters[i].Width;
      }
      IntegrateCell(quarters[i]);
      for (int k = 0; k < NumberOfIntegrals; ++k)
      {
        sum[k] += quarters[i].Integral[k];
      }
    }
    Values change{};
    Real urgency = 0.0L;
    for (int k = 0; k < NumberOfIntegrals; ++k)
    {
      change[k] = std::abs(sum[k] - cell.Integral[k]);
      urgency = std::max(urgency, change[k] / (Target * magnitude[k]));
    }
    for (Cell& quarter : quarters)
    {
      for (int k = 0; k < NumberOfIntegrals && urgency <= 1.0L; ++k)
      {
        result.Value[k] += quarter.Integral[k];
        result.Error[k] += 0.25L * change[k];
      }
      if (urgency > 1.0L)
      {
        quarter.Urgency = urgency;
        for (int k = 0; k < NumberOfIntegrals; ++k)
        {
          quarter.Change[k] = 0.25L * change[k];
        }
        open.push(quarter);
      }
    }
  }
  return result;
}

std::array<Real, NumberOfIntegrals> IntegrateBlock(const ReferenceBlock& block, int n)
{
  std::vector<Real> nodes, weights;
  ComputeExtendedGauss(n, nodes, weights);
  std::vector<std::vector<Real>> values[3], derivatives[3];
  for (int d = 0; d < 3; ++d)
  {
    values[d].resize(n);
    derivatives[d].resize(n);
    for (int i = 0; i < n; ++i)
    {
      EvaluateBernstein(block.Degree[d], nodes[i], values[d][i], derivatives[d][i]);
    }
  }
  Values result{};
  for (int g = 0; g < n * n * n; ++g)
  {
    const int at[3] = { g % n, g / n % n, g / n / n };
    RealPoint h[4] = {};
    std::size_t index = 0;
    for (int k = 0; k <= block.Degree[2]; ++k)
    {
      for (int j = 0; j <= block.Degree[1]; ++j)
      {
        for (int i = 0; i <= block.Degree[0]; ++i, ++index)
        {
          const Real b[3] = { values[0][at[0]][i], values[1][at[1]][j], values[2][at[2]][k] };
          const Real factors[4] = { b[0] * b[1] * b[2], derivatives[0][at[0]][i] * b[1] * b[2],
            b[0] * derivatives[1][at[1]][j] * b[2], b[0] * b[1] * derivatives[2][at[2]][k] };
          for (int f = 0; f < 4; ++f)
          {
            for (int c = 0; c < 4; ++c)
            {
              h[f][c] += factors[f] * block.Points[index][c];
            }
          }
        }
      }
    }
    Real x[3], d[3][3];
    for (int c = 0; c < 3; ++c)
    {
      x[c] = h[0][c] / h[0][3];
      for (int f = 0; f < 3; ++f)
      {
        d[f][c] = (h[f + 1][c] - x[c] * h[f + 1][3]) / h[0][3];
      }
    }
    const Real determinant = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
      d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    const Real f = determinant * weights[at[0]] * weights[at[1]] * weights[at[2]];
    result[0] += f;
    for (int c = 0; c < 3; ++c)
    {
      result[1 + c] += f * x[c];
      for (int e = c; e < 3; ++e)
      {
        result[4 + Packed[c][e]] += f * x[c] * x[e];
      }
    }
  }
  return result;
}

ReferenceProperties PlaceReference(
  const ReferenceIntegrals& integrals, const double origin[3], const double placement[16])
{
  ReferenceProperties result;
  const Real side = integrals.Value[0] < 0.0L ? -1.0L : 1.0L;
  const Real v = side * integrals.Value[0];
  const Real ev = integrals.Error[0];
  Real local[3], reach = 0, e1 = 0, e2 = 0, distance = 0;
  for (int i = 0; i < 3; ++i)
  {
    local[i] = side * integrals.Value[1 + i] / v;
    reach = std::max(reach, std::abs(local[i]));
    e1 = std::max(e1, integrals.Error[1 + i]);
  }
  for (int i = 0; i < 6; ++i)
  {
    e2 = std::max(e2, integrals.Error[4 + i]);
  }
  Real c[3];
  for (int i = 0; i < 3; ++i)
  {
    c[i] = placement[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      c[i] += static_cast<Real>(placement[4 * i + j]) * (origin[j] + local[j]);
    }
    distance = std::max(distance, std::abs(c[i]));
    result.Center.Value[i] = c[i];
    result.First.Value[i] = v * c[i];
  }
  // Extended precision's own rounding where far translations are added.
  const Real roundoff = 1e-18L;
  result.Volume.Value[0] = v;
  result.Volume.Error = ev;
  result.Area.Value[0] = integrals.Value[AreaIntegral];
  result.Area.Error = integrals.Error[AreaIntegral];
  result.Center.Error = 2.0L * (e1 + reach * ev) / v + roundoff * distance;
  result.First.Error = 2.0L * e1 + distance * ev + roundoff * v * distance;

  Real spread = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      Real sum = 0;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          sum += static_cast<Real>(placement[4 * i + k]) * placement[4 * j + l] *
            (side * integrals.Value[4 + Packed[k][l]] - local[k] * local[l] * v);
        }
      }
      result.Second.Value[Packed[i][j]] = sum;
      spread = std::max(spread, std::abs(sum));
    }
  }
  result.Second.Error =
    4.0L * (e2 + 2.0L * reach * e1 + reach * reach * ev) + roundoff * (spread + v * reach * reach);
  result.Inertia.Value = MakeInertia(result.Second.Value);
  result.Inertia.Error = 2.0L * result.Second.Error;
  std::array<Real, 6> atOrigin{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      atOrigin[Packed[i][j]] = result.Second.Value[Packed[i][j]] + v * c[i] * c[j];
    }
  }
  result.InertiaAtOrigin.Value = MakeInertia(atOrigin);
  result.InertiaAtOrigin.Error = 2.0L *
    (result.Second.Error + 2.0L * distance * v * result.Center.Error + distance * distance * ev +
      roundoff * v * distance * distance);
  result.Principal.Value = ComputeEigenvalues(result.Inertia.Value);
  result.Principal.Error = 3.0L * result.Inertia.Error;
  for (int i = 0; i < 3; ++i)
  {
    result.Gyration.Value[i] = std::sqrt(result.Principal.Value[i] / v);
    result.Gyration.Error = std::max(result.Gyration.Error,
      result.Gyration.Value[i] * (result.Principal.Error / result.Principal.Value[i] + ev / v));
  }
  return result;
}
}
