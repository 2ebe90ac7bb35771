#include "smSubPatches.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace sm
{
namespace
{
using Point2 = std::array<double, 2>;
using Homogeneous = std::array<double, 4>;

// Of a texel's width; see SubPatchFace::Polygons.
constexpr double ChordShareOfTexel = 1.0 / 16.0;

/// All values from Low to High. Operations give every value that the operands can give.
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

/// `b` is positive.
Interval operator/(const Interval& a, const Interval& b)
{
  return a * Interval{ 1.0 / b.High, 1.0 / b.Low };
}

/// The sub-patch as a rational Bézier patch on its unit domain, about the centre of its control points.
struct SubPatch
{
  int Degree[2];
  double Center[3];
  Homogeneous Points[(MaximumDegree + 1) * (MaximumDegree + 1)];

  SubPatch(const NURBSSurface& surface, double u0, double u1, double v0, double v1);

  const Homogeneous& Get(int i, int j) const { return this->Points[i + j * (this->Degree[0] + 1)]; }

  /// Range of the derivative of order (a, b) of a homogeneous coordinate: that of its Bernstein coefficients, which are
  /// differences of the control points times p (p-1) ..; empty sums are 0.
  Interval GetRange(int a, int b, int coordinate) const;
};

SubPatch::SubPatch(const NURBSSurface& surface, double u0, double u1, double v0, double v1)
  : Degree{ surface.Degree[0], surface.Degree[1] }
{
  surface.ExtractBezier(u0, u1, v0, v1, this->Points);
  const int count = (this->Degree[0] + 1) * (this->Degree[1] + 1);
  // Derivatives do not depend on the origin, but the bounds of a quotient do: about the centre they are close.
  for (int c = 0; c < 3; ++c)
  {
    Interval range = { this->Points[0][c] / this->Points[0][3], this->Points[0][c] / this->Points[0][3] };
    for (int i = 1; i < count; ++i)
    {
      range.Include(this->Points[i][c] / this->Points[i][3]);
    }
    this->Center[c] = 0.5 * (range.Low + range.High);
    for (int i = 0; i < count; ++i)
    {
      this->Points[i][c] -= this->Center[c] * this->Points[i][3];
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

/// The largest |second derivatives| by u u, u v and v v.
using SecondDerivatives = std::array<double, 3>;

/// x = X/w, so X = x w and by differentiating twice
///   x_u = (X_u - x w_u) / w,  x_uu = (X_uu - 2 x_u w_u - x w_uu) / w,  x_uv = (X_uv - x_u w_v - x_v w_u - x w_uv) / w.
/// Each factor lies in the range of its Bernstein coefficients, x in that of the control points (weights are positive).
SecondDerivatives BoundSecondDerivatives(const SubPatch& patch)
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

/// Value, first and second derivative at s of a polynomial given by its Bernstein coefficients, which are destroyed.
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

/// |x_uu|, |x_uv| and |x_vv| at (s,r), raised into `largest`.
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

std::vector<double> DivideIntervals(const std::vector<double>& breaks, int factor)
{
  std::vector<double> borders;
  borders.reserve((breaks.size() - 1) * factor + 1);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
  {
    for (int k = 0; k < factor; ++k)
    {
      borders.push_back(k == 0 ? breaks[i] : breaks[i] + (breaks[i + 1] - breaks[i]) * k / factor);
    }
  }
  borders.push_back(breaks.back());
  return borders;
}

/// What a face must fulfil before anything of it is computed; throws what is wrong.
void CheckFace(const Face& face, const SchemeOptions& options)
{
  const std::string reason = face.Surface.Check();
  if (!reason.empty())
  {
    throw std::runtime_error(reason);
  }
  if (options.Factor < 1 || options.TextureFactor < 1)
  {
    throw std::runtime_error("the factors of sub-patches and of the trim texture must be at least 1");
  }
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      if (coedge.Curve.GetNumberOfPieces() == 0)
      {
        throw std::runtime_error("a coedge has no trim curve");
      }
      for (int k = 0; k < coedge.Curve.GetNumberOfPieces(); ++k)
      {
        if (coedge.Curve.GetDegree(k) > MaximumDegree)
        {
          throw std::runtime_error("a trim curve has a degree above " + std::to_string(MaximumDegree));
        }
      }
      for (const Point2& point : coedge.Curve.Coefficients)
      {
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
        {
          throw std::runtime_error("a trim curve is not finite");
        }
      }
    }
  }
}

void AddPatch(SubPatchFace& face, double u0, double u1, double v0, double v1)
{
  const NURBSSurface& surface = face.Source->Surface;
  const SubPatch cell(surface, u0, u1, v0, v1);
  Patch patch{};
  patch.FirstPoint = static_cast<std::uint32_t>(face.Points.size());
  patch.Degree[0] = surface.Degree[0];
  patch.Degree[1] = surface.Degree[1];
  patch.Start[0] = u0;
  patch.Start[1] = v0;
  patch.Width[0] = u1 - u0;
  patch.Width[1] = v1 - v0;
  std::copy_n(cell.Center, 3, patch.Center);
  const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  for (int i = 0; i < count; ++i)
  {
    const Homogeneous& p = cell.Points[i];
    patch.Radius = std::max(patch.Radius, std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / p[3]);
    face.Points.push_back(p);
  }
  face.Patches.push_back(patch);
}

/// The narrowest of the intervals of `borders` that [low, high] touches.
double FindNarrowest(const std::vector<double>& borders, double low, double high)
{
  const auto last = borders.end() - 2;
  auto from = std::upper_bound(borders.begin(), borders.end() - 1, low);
  from = from == borders.begin() ? from : from - 1;
  double narrowest = HUGE_VAL;
  for (auto border = std::min(from, last);
       border <= last && (border == std::min(from, last) || *border <= high); ++border)
  {
    narrowest = std::min(narrowest, *(border + 1) - *border);
  }
  return narrowest;
}

void PreparePlane(SubPatchFace& face, const SchemeOptions& options)
{
  face.Planar = true;
  if (face.Source->Loops.empty())
  {
    return;
  }
  if (!(options.ChordTolerance > 0.0))
  {
    throw std::runtime_error("the chord tolerance of planes must be positive");
  }
  const NURBSSurface& surface = face.Source->Surface;
  double position[3];
  double du[3];
  double dv[3];
  surface.Evaluate(surface.GetDomainStart(0), surface.GetDomainStart(1), position, du, dv);
  const auto shareOf = [&options](const double(&d)[3])
  {
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    return 0.5 * options.ChordTolerance / std::max(length, 1e-300);
  };
  // |S(c) - S(chord)| <= |du| |Su| + |dv| |Sv|, and the derivatives are constant.
  face.Polygons = FlattenLoops(*face.Source, Point2{ shareOf(du), shareOf(dv) });
}

void PrepareCurved(SubPatchFace& face, const SchemeOptions& options)
{
  const NURBSSurface& surface = face.Source->Surface;
  const std::vector<double> breaks[2] = { surface.GetSpanBreaks(0), surface.GetSpanBreaks(1) };
  const double count =
    static_cast<double>(breaks[0].size() - 1) * (breaks[1].size() - 1) * options.Factor * options.Factor;
  if (count > MaximumSubPatches)
  {
    throw std::runtime_error(std::to_string(static_cast<long long>(count)) + " sub-patches are more than " +
      std::to_string(MaximumSubPatches));
  }
  face.Grid = MakeSubPatchGrid(surface, options.Factor);
  for (std::size_t row = 0; row + 1 < breaks[1].size(); ++row)
  {
    for (std::size_t column = 0; column + 1 < breaks[0].size(); ++column)
    {
      AddPatch(face, breaks[0][column], breaks[0][column + 1], breaks[1][row], breaks[1][row + 1]);
    }
  }
  face.Deviations.reserve(static_cast<std::size_t>(count));
  for (int row = 0; row < face.Grid.GetNumberOfRows(); ++row)
  {
    for (int column = 0; column < face.Grid.GetNumberOfColumns(); ++column)
    {
      face.Deviations.push_back(ComputeDeviation(surface, face.Grid.U[column], face.Grid.U[column + 1],
        face.Grid.V[row], face.Grid.V[row + 1], options.Deviation));
    }
  }
  const double share = ChordShareOfTexel / (static_cast<double>(options.Factor) * options.TextureFactor);
  face.Polygons = FlattenLoops(*face.Source,
    [&breaks, share](const Point2& low, const Point2& high)
    {
      return Point2{ share * FindNarrowest(breaks[0], low[0], high[0]),
        share * FindNarrowest(breaks[1], low[1], high[1]) };
    });
}
}

SubPatchGrid MakeSubPatchGrid(const NURBSSurface& surface, int factor)
{
  SubPatchGrid grid;
  grid.Factor = std::max(factor, 1);
  grid.U = DivideIntervals(surface.GetSpanBreaks(0), grid.Factor);
  grid.V = DivideIntervals(surface.GetSpanBreaks(1), grid.Factor);
  return grid;
}

double ComputeDeviation(
  const NURBSSurface& surface, double u0, double u1, double v0, double v1, DeviationMode mode)
{
  const SubPatch patch(surface, u0, u1, v0, v1);
  SecondDerivatives largest{};
  if (mode == DeviationMode::Bounded)
  {
    largest = BoundSecondDerivatives(patch);
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

bool IsPlanar(const NURBSSurface& surface)
{
  if (surface.Degree[0] != 1 || surface.Degree[1] != 1 || surface.NumberOfControlPoints[0] != 2 ||
    surface.NumberOfControlPoints[1] != 2)
  {
    return false;
  }
  const Homogeneous* p = surface.ControlPoints.data();
  const double w = p[0][3];
  double size = 0.0;
  double gap = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    gap = std::max(gap, std::abs((p[0][c] - p[1][c]) - (p[2][c] - p[3][c])));
    for (int i = 0; i < 4; ++i)
    {
      size = std::max(size, std::abs(p[i][c]));
    }
  }
  // The corners of a plane are rounded: each of the four by half a unit in its last place, twice for the arithmetic.
  return p[1][3] == w && p[2][3] == w && p[3][3] == w && gap <= 16 * 1.1e-16 * size;
}

SubPatchFace PrepareSubPatchFace(const FacePointer& face, const SchemeOptions& options)
{
  SubPatchFace result;
  std::string reason;
  try
  {
    if (!face)
    {
      throw std::runtime_error("there is no face");
    }
    result.Source = face;
    CheckFace(*face, options);
    if (IsPlanar(face->Surface))
    {
      PreparePlane(result, options);
    }
    else
    {
      PrepareCurved(result, options);
    }
    return result;
  }
  catch (const std::exception& error)
  {
    reason = error.what();
  }
  SubPatchFace failed;
  failed.Source = face;
  failed.Error = (face ? "face #" + std::to_string(face->FileId) + ": " : std::string()) + reason;
  return failed;
}
}
