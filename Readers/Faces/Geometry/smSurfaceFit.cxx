#include "smSurfaceFit.h"

#include "smChebyshevFit.h"
#include "smFormat.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
namespace
{
constexpr int FitDegree = 10;
constexpr int MaximumIntervals = 64;
/// Largest number of cells; a cell takes 7 kB while it is fitted.
constexpr std::size_t MaximumCells = 16384;
/// Tolerance of a fit, relative to the size of the surface.
constexpr double FitTolerance = 1e-13;

using Grid = std::array<std::array<Vector3, FitOrder + 1>, FitOrder + 1>;

/// Computes the Chebyshev coefficients of one cell: grid[j][i] belongs to T_i(u) T_j(v).
void Sample(const SurfacePosition& position, const double u[2], const double v[2], Grid& grid, double& size)
{
  const FitSamples& x = GetFitNodes();
  for (int j = 0; j <= FitOrder; ++j)
  {
    for (int i = 0; i <= FitOrder; ++i)
    {
      grid[j][i] = position((1.0 - x[i]) * u[0] + x[i] * u[1], (1.0 - x[j]) * v[0] + x[j] * v[1]);
      for (const double c : grid[j][i])
      {
        if (!std::isfinite(c))
        {
          throw std::runtime_error("its surface is not finite");
        }
        size = std::max(size, std::abs(c));
      }
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    FitSamples line;
    FitSamples series;
    for (int j = 0; j <= FitOrder; ++j)
    {
      for (int i = 0; i <= FitOrder; ++i)
      {
        line[i] = grid[j][i][c];
      }
      ComputeChebyshevCoefficients(line, series);
      for (int i = 0; i <= FitOrder; ++i)
      {
        grid[j][i][c] = series[i];
      }
    }
    for (int i = 0; i <= FitOrder; ++i)
    {
      for (int j = 0; j <= FitOrder; ++j)
      {
        line[j] = grid[j][i][c];
      }
      ComputeChebyshevCoefficients(line, series);
      for (int j = 0; j <= FitOrder; ++j)
      {
        grid[j][i][c] = series[j];
      }
    }
  }
}

/// Computes the sums of the coefficients beyond FitDegree in direction 0 and in direction 1.
void MeasureTails(const Grid& grid, double tails[2])
{
  tails[0] = tails[1] = 0.0;
  for (int j = 0; j <= FitOrder; ++j)
  {
    for (int i = 0; i <= FitOrder; ++i)
    {
      const Vector3& c = grid[j][i];
      const double length = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
      if (i > FitDegree)
      {
        tails[0] += length;
      }
      else if (j > FitDegree)
      {
        tails[1] += length;
      }
    }
  }
}

/// Writes the Bernstein coefficients of a cell into the control net, whose knots have the degree as their
/// multiplicity.
void StoreCell(const Grid& grid, int column, int row, NURBSSurface& s)
{
  double rows[FitOrder + 1][FitDegree + 1];
  for (int c = 0; c < 3; ++c)
  {
    for (int j = 0; j <= FitDegree; ++j)
    {
      FitSamples series{};
      for (int i = 0; i <= FitDegree; ++i)
      {
        series[i] = grid[j][i][c];
      }
      ConvertToBernstein(series, FitDegree, rows[j]);
    }
    for (int i = 0; i <= FitDegree; ++i)
    {
      FitSamples series{};
      for (int j = 0; j <= FitDegree; ++j)
      {
        series[j] = rows[j][i];
      }
      double bernstein[FitDegree + 1];
      ConvertToBernstein(series, FitDegree, bernstein);
      for (int j = 0; j <= FitDegree; ++j)
      {
        s.ControlPoints[column * FitDegree + i +
          static_cast<std::size_t>(row * FitDegree + j) * s.NumberOfControlPoints[0]][c] = bernstein[j];
      }
    }
  }
}

/// Halves the marked intervals.
std::vector<double> Refine(const std::vector<double>& breaks, const std::vector<bool>& marked)
{
  std::vector<double> refined{ breaks[0] };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
  {
    if (marked[i])
    {
      refined.push_back(0.5 * (breaks[i] + breaks[i + 1]));
    }
    refined.push_back(breaks[i + 1]);
  }
  return refined;
}

/// Samples the cells between the breaks. `tails` gets the truncation errors of each in u and v; `size` is
/// raised to the largest coordinate.
void SampleCells(const SurfacePosition& position, const std::vector<double> breaks[2],
  std::vector<Grid>& cells, std::vector<std::array<double, 2>>& tails, double& size)
{
  const std::size_t columns = breaks[0].size() - 1;
  const std::size_t rows = breaks[1].size() - 1;
  if (columns * rows > MaximumCells)
  {
    throw std::runtime_error("it needs more than " + std::to_string(MaximumCells) + " pieces");
  }
  tails.assign(columns * rows, { 0.0, 0.0 });
  cells.resize(columns * rows);
  for (std::size_t j = 0; j < rows; ++j)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      Sample(position, &breaks[0][i], &breaks[1][j], cells[i + j * columns], size);
      MeasureTails(cells[i + j * columns], tails[i + j * columns].data());
    }
  }
}

/// Halves the intervals of cells whose truncation error exceeds `tolerance`; returns false if none can be
/// halved.
bool RefineBreaks(
  const std::vector<std::array<double, 2>>& tails, double tolerance, std::vector<double> breaks[2])
{
  const std::size_t columns = breaks[0].size() - 1;
  std::vector<bool> marked[2] = { std::vector<bool>(columns), std::vector<bool>(breaks[1].size() - 1) };
  bool refine = false;
  for (std::size_t k = 0; k < tails.size(); ++k)
  {
    for (int d = 0; d < 2; ++d)
    {
      if (tails[k][d] > tolerance)
      {
        marked[d][d == 0 ? k % columns : k / columns] = true;
        refine = refine || breaks[d].size() <= MaximumIntervals;
      }
    }
  }
  std::vector<double> refined[2];
  for (int d = 0; d < 2; ++d)
  {
    refined[d] = breaks[d].size() <= MaximumIntervals ? Refine(breaks[d], marked[d]) : breaks[d];
  }
  if (!refine || (refined[0].size() - 1) * (refined[1].size() - 1) > MaximumCells)
  {
    return false;
  }
  for (int d = 0; d < 2; ++d)
  {
    breaks[d] = std::move(refined[d]);
  }
  return true;
}

/// Joins all cells to one B-spline surface.
NURBSSurface JoinCells(const std::vector<double> breaks[2], const std::vector<Grid>& cells)
{
  NURBSSurface s;
  for (int d = 0; d < 2; ++d)
  {
    s.Degree[d] = FitDegree;
    s.Knots[d].push_back(breaks[d].front());
    for (const double b : breaks[d])
    {
      s.Knots[d].insert(s.Knots[d].end(), FitDegree, b);
    }
    s.Knots[d].push_back(breaks[d].back());
    s.NumberOfControlPoints[d] = static_cast<int>(breaks[d].size() - 1) * FitDegree + 1;
  }
  s.ControlPoints.assign(static_cast<std::size_t>(s.NumberOfControlPoints[0]) * s.NumberOfControlPoints[1],
    { 0.0, 0.0, 0.0, 1.0 });
  const std::size_t columns = breaks[0].size() - 1;
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    StoreCell(cells[k], static_cast<int>(k % columns), static_cast<int>(k / columns), s);
  }
  return s;
}
}

NURBSSurface FitSurface(
  const SurfacePosition& position, const std::vector<double>& u, const std::vector<double>& v)
{
  std::vector<double> breaks[2] = { u, v };
  std::vector<Grid> cells;
  std::vector<std::array<double, 2>> tails;
  double size = 0.0;
  double tolerance = 0.0;
  do
  {
    SampleCells(position, breaks, cells, tails, size);
    // The tolerance must exceed the rounding of a sum of coefficients, or the refinement would not end.
    tolerance = size * std::max(FitTolerance, 64.0 * UnitRoundoff * FitOrder);
  } while (RefineBreaks(tails, tolerance, breaks));
  double worst = 0.0;
  for (const std::array<double, 2>& tail : tails)
  {
    worst = std::max({ worst, tail[0], tail[1] });
  }
  NURBSSurface s = JoinCells(breaks, cells);
  // Neighbouring cells were truncated separately and then made to share a border: three times the largest
  // error is a bound.
  s.Residual = 3.0 * worst + 8.0 * UnitRoundoff * size;
  if (!(s.Residual < 1e-6 * size))
  {
    throw std::runtime_error(
      "it could not be fitted: a residual of " + FormatDistance(s.Residual) + " is left");
  }
  return s;
}
}
