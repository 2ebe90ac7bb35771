#include "Detail/smGroundTrim.h"

#include <algorithm>

namespace sm
{
namespace
{
using Points = std::vector<GroundPoint>;

/// A scalar polynomial and a point-valued one with their Bernstein coefficients multiplied by the binomials:
/// products are convolutions of positive terms, so that nothing cancels.
using Scaled = std::vector<double>;

Points Multiply(const Scaled& f, const Points& g)
{
  Points product(f.size() + g.size() - 1, GroundPoint{});
  for (std::size_t i = 0; i < f.size(); ++i)
  {
    for (std::size_t j = 0; j < g.size(); ++j)
    {
      for (int c = 0; c < 4; ++c)
      {
        product[i + j][c] += f[i] * g[j][c];
      }
    }
  }
  return product;
}

/// De Casteljau's scheme with polynomials for the parameter and the points.
Points Collapse(std::vector<Points> line, const Scaled& x, const Scaled& rest)
{
  while (line.size() > 1)
  {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      Points sum = Multiply(rest, line[i]);
      const Points other = Multiply(x, line[i + 1]);
      for (std::size_t k = 0; k < sum.size(); ++k)
      {
        for (int c = 0; c < 4; ++c)
        {
          sum[k][c] += other[k][c];
        }
      }
      line[i] = std::move(sum);
    }
    line.pop_back();
  }
  return line[0];
}

/// Coefficients of the part [start, end] of a piece in the patch's (s, r).
std::vector<std::array<double, 2>> RestrictTrim(
  const Patch& patch, const double* uv, int degree, double start, double end)
{
  std::vector<std::array<double, 2>> local(degree + 1);
  for (int k = 0; k <= degree; ++k)
  {
    // Blossom with k arguments at the end.
    std::array<double, 2> b[MaximumDegree + 1];
    for (int i = 0; i <= degree; ++i)
    {
      b[i] = { uv[2 * i], uv[2 * i + 1] };
    }
    for (int level = 0; level < degree; ++level)
    {
      const double x = level < k ? end : start;
      for (int i = 0; i < degree - level; ++i)
      {
        for (int d = 0; d < 2; ++d)
        {
          // Equal coefficients stay equal.
          b[i][d] = b[i][d] + x * (b[i + 1][d] - b[i][d]);
        }
      }
    }
    for (int d = 0; d < 2; ++d)
    {
      local[k][d] = (b[0][d] - patch.Start[d]) / patch.Width[d];
    }
  }
  return local;
}

/// A coordinate of the trim as a polynomial of its true degree: 0 where it is constant.
void GetCoordinate(const std::vector<std::array<double, 2>>& local, int d, Scaled& x, Scaled& rest)
{
  const bool constant = std::all_of(
    local.begin(), local.end(), [&](const std::array<double, 2>& p) { return p[d] == local[0][d]; });
  const int degree = constant ? 0 : static_cast<int>(local.size()) - 1;
  x.resize(degree + 1);
  rest.resize(degree + 1);
  for (int i = 0; i <= degree; ++i)
  {
    const double binomial = GetBinomial(degree, i);
    x[i] = binomial * local[i][d];
    rest[i] = binomial * (1.0 - local[i][d]);
  }
}
}

GroundCurve ComposeTrim(
  const GroundPatch& root, const Patch& patch, const double* uv, int degree, double start, double end)
{
  const std::vector<std::array<double, 2>> local = RestrictTrim(patch, uv, degree, start, end);
  Scaled coordinate[2];
  Scaled rest[2];
  for (int d = 0; d < 2; ++d)
  {
    GetCoordinate(local, d, coordinate[d], rest[d]);
  }
  std::vector<Points> column;
  for (int j = 0; j <= root.Degree[1]; ++j)
  {
    std::vector<Points> line;
    for (int i = 0; i <= root.Degree[0]; ++i)
    {
      line.push_back({ root.Points[i + (root.Degree[0] + 1) * j] });
    }
    column.push_back(Collapse(std::move(line), coordinate[0], rest[0]));
  }
  Points points = Collapse(std::move(column), coordinate[1], rest[1]);
  const int last = static_cast<int>(points.size()) - 1;
  for (int i = 0; i <= last; ++i)
  {
    for (double& x : points[i])
    {
      x /= GetBinomial(last, i);
    }
  }
  return GroundCurve::FromPoints(std::move(points));
}

bool StaysInSquare(const Patch& patch, const double* uv, int degree, double start, double end)
{
  // Rounding of a trim curve by this much has far less effect on a height than the rounding of the height
  // itself.
  const double outside = 1e-14;
  const std::vector<std::array<double, 2>> local = RestrictTrim(patch, uv, degree, start, end);
  return std::all_of(local.begin(), local.end(),
    [outside](const std::array<double, 2>& p)
    { return std::min(p[0], p[1]) >= -outside && std::max(p[0], p[1]) <= 1.0 + outside; });
}

std::array<double, 2> GetTrimPoint(
  const Patch& patch, const double* uv, int degree, double start, double end, double t)
{
  const std::vector<std::array<double, 2>> local = RestrictTrim(patch, uv, degree, start, end);
  return BernsteinPiece<2>{ local.data(), degree }.Evaluate(t);
}
}
