#include "smBezierPatch.h"

#include "smBernstein.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/**
 * With P the centred homogeneous points and S = P/w: dS/ds = (P_s - w_s S) / w, P_s = p sum B_i^(p-1)
 * (P_(i+1) - P_i), and w is no less than sum B_i^(p-1) min(w_i, w_(i+1)). So |dS/ds| <= p max (|P_(i+1) -
 * P_i| + |w_(i+1) - w_i| |S|) / min(w_i, w_(i+1)); the rounding error of the sum is relative to this bound,
 * too. Returns the bound of |dS/ds|, with |S| at most the patch's radius, and sets `components` to those of
 * its x, y and z, with |S| at most `reach`. Raises patch.WeightRatio to the largest ratio of neighbouring
 * weights.
 */
double StretchOf(
  const std::array<double, 4>* points, Patch& patch, const Point3& reach, int direction, Point3& components)
{
  const int row = patch.Degree[0] + 1;
  const int stride = direction == 0 ? 1 : row;
  const double degree = patch.Degree[direction];
  double length = 0.0;
  components = { 0.0, 0.0, 0.0 };
  for (int j = 0; j <= patch.Degree[1] - direction; ++j)
  {
    for (int i = 0; i <= patch.Degree[0] - (1 - direction); ++i)
    {
      const std::array<double, 4>& a = points[i + row * j];
      const std::array<double, 4>& b = points[i + row * j + stride];
      const double weight = std::min(a[3], b[3]);
      const double turn = std::abs(b[3] - a[3]);
      patch.WeightRatio = std::max(patch.WeightRatio, std::max(a[3], b[3]) / weight);
      const double step = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      length = std::max(length, degree * (step + turn * patch.Radius) / weight);
      for (int c = 0; c < 3; ++c)
      {
        components[c] = std::max(components[c], degree * (std::abs(b[c] - a[c]) + turn * reach[c]) / weight);
      }
    }
  }
  return length;
}
}

std::array<double, 3> GetReach(const std::array<double, 4>* points, int count)
{
  Point3 reach{};
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      reach[c] = std::max(reach[c], std::abs(points[i][c]) / points[i][3]);
    }
  }
  return reach;
}

void MeasurePatch(const std::array<double, 4>* points, Patch& patch)
{
  const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  patch.Radius = 0.0;
  patch.WeightRatio = 0.0;
  for (int i = 0; i < count; ++i)
  {
    patch.Radius =
      std::max(patch.Radius, std::hypot(points[i][0], points[i][1], points[i][2]) / points[i][3]);
  }
  const Point3 reach = GetReach(points, count);
  Point3 stretch[2];
  for (int d = 0; d < 2; ++d)
  {
    patch.Stretch[d] = StretchOf(points, patch, reach, d, stretch[d]);
  }
  for (int c = 0; c < 3; ++c)
  {
    const int x = (c + 1) % 3;
    const int y = (c + 2) % 3;
    patch.Normal[c] = stretch[0][x] * stretch[1][y] + stretch[0][y] * stretch[1][x];
  }
}

Patch MakePatch(const NURBSSurface& surface, double u0, double u1, double v0, double v1,
  std::vector<std::array<double, 4>>& points)
{
  Patch patch{};
  patch.FirstPoint = static_cast<std::uint32_t>(points.size());
  patch.Degree[0] = surface.Degree[0];
  patch.Degree[1] = surface.Degree[1];
  patch.Start[0] = u0;
  patch.Start[1] = v0;
  patch.Width[0] = u1 - u0;
  patch.Width[1] = v1 - v0;

  std::array<double, 4> cell[(MaximumDegree + 1) * (MaximumDegree + 1)];
  const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  const Point3 moved = surface.ExtractBezier(u0, u1, v0, v1, cell, patch.Center);
  points.insert(points.end(), cell, cell + count);
  std::copy(moved.begin(), moved.end(), patch.Displacement);
  MeasurePatch(cell, patch);
  return patch;
}

void EvaluatePatch(const Patch& patch, const std::array<double, 4>* points, double s, double r,
  double position[3], double ds[3], double dr[3])
{
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  double across[MaximumDegree + 1];
  double along[MaximumDegree + 1];
  FillBernsteinBasis(q - 1, r, across);
  FillBernsteinBasis(p - 1, s, along);
  // The sums of smCollapse and smEvaluateRow in one: all differences are taken before anything else.
  double column[MaximumDegree + 1][4];
  double columnTurn[MaximumDegree + 1][4];
  double step[MaximumDegree + 1][4];
  for (int i = 0; i <= p; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      column[i][c] = columnTurn[i][c] = step[i][c] = 0.0;
    }
    for (int j = 0; j < q; ++j)
    {
      const std::array<double, 4>* at = points + i + static_cast<std::ptrdiff_t>(j) * (p + 1);
      for (int c = 0; c < 4; ++c)
      {
        column[i][c] += across[j] * ((1.0 - r) * at[0][c] + r * at[p + 1][c]);
        columnTurn[i][c] += across[j] * (at[p + 1][c] - at[0][c]);
      }
      if (i < p)
      {
        for (int c = 0; c < 4; ++c)
        {
          step[i][c] += across[j] * ((1.0 - r) * (at[1][c] - at[0][c]) + r * (at[p + 2][c] - at[p + 1][c]));
        }
      }
    }
  }
  double h[4] = {};
  double hs[4] = {};
  double hr[4] = {};
  for (int i = 0; i < p; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      h[c] += along[i] * ((1.0 - s) * column[i][c] + s * column[i + 1][c]);
      hs[c] += along[i] * step[i][c];
      hr[c] += along[i] * ((1.0 - s) * columnTurn[i][c] + s * columnTurn[i + 1][c]);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    position[c] = h[c] / h[3];
    ds[c] = p * (hs[c] - hs[3] * position[c]) / h[3];
    dr[c] = q * (hr[c] - hr[3] * position[c]) / h[3];
  }
}
}
