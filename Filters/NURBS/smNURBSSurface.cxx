#include "smNURBSSurface.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace sm
{
namespace
{
using Homogeneous = std::array<double, 4>;

// Patches are extracted in extended precision and stored in double, so that neighbours differ by the rounding
// of their stored points only.
using Wide = long double;

/// Index k with knots[k] <= x < knots[k+1], clamped to the domain.
int FindSpan(const std::vector<double>& knots, int degree, double x)
{
  const int last = static_cast<int>(knots.size()) - 2 - degree;
  const auto after = std::upper_bound(knots.begin() + degree, knots.begin() + last + 1, x);
  return std::clamp(static_cast<int>(after - knots.begin()) - 1, degree, last);
}

/// Returns the span that [a,b] lies in. Between neighbouring doubles there is no middle.
int FindSpanOf(const std::vector<double>& knots, int degree, double a, double b)
{
  const double middle = 0.5 * (a + b);
  return FindSpan(knots, degree, middle < b ? middle : a);
}

/// Several rows or columns of control points, each a curve of its own.
struct Lines
{
  int Count;
  /// From point to point of a line, and from line to line.
  int Stride;
  int LineStride;
};

/// (argument - low knot) / (high knot - low knot) for de Boor point j of a level on span k.
template <class Number>
Number GetBlend(const std::vector<double>& knots, int degree, int k, int level, int j, Number argument)
{
  const Number low = knots[k - degree + j];
  const Number high = knots[k + 1 + j - level];
  return (argument - low) / (high - low);
}

/// Returns true where span k is [a,b] and its knots have full multiplicity: de Boor points are Bézier
/// coefficients then.
bool IsBezierSpan(const std::vector<double>& knots, int degree, int k, double a, double b)
{
  return a == knots[k] && b == knots[k + 1] && knots[k - degree + 1] == a && knots[k + degree] == b;
}

/// Bézier coefficients on [a,b] of the polynomials that B-splines have on span k: coefficient i is the
/// blossom (polar form) at (a, .., a, b, .., b) with i times b. `points` holds the degree+1 active de Boor
/// points of each line. The lines share the factors, whose divisions cost more than the rest, and the
/// coefficients the levels that they have in common.
template <class Number>
void Blossom(const std::vector<double>& knots, int degree, int k, double a, double b,
  const std::array<Number, 4>* points, std::array<Number, 4>* result, const Lines& lines)
{
  if (IsBezierSpan(knots, degree, k, a, b))
  {
    std::copy(points, points + (degree + 1) * lines.Count, result);
    return;
  }
  std::array<Number, 4> common[(MaximumDegree + 1) * (MaximumDegree + 1)];
  std::array<Number, 4> own[(MaximumDegree + 1) * (MaximumDegree + 1)];
  Number blends[MaximumDegree + 1][MaximumDegree + 1];
  for (int j = 0; j <= degree; ++j)
  {
    for (int line = 0; line < lines.Count; ++line)
    {
      common[j * lines.Count + line] = points[j * lines.Stride + line * lines.LineStride];
    }
    for (int level = 1; level <= j; ++level)
    {
      blends[level][j] = GetBlend<Number>(knots, degree, k, level, j, b);
    }
  }
  const auto advance = [&lines](std::array<Number, 4>* d, int j, Number alpha)
  {
    std::array<Number, 4>* to = d + j * lines.Count;
    for (int line = 0; line < lines.Count; ++line)
    {
      for (int c = 0; c < 4; ++c)
      {
        to[line][c] = (1 - alpha) * to[line - lines.Count][c] + alpha * to[line][c];
      }
    }
  };
  for (int i = degree; i >= 0; --i)
  {
    const int levels = degree - i;
    for (int j = degree; levels > 0 && j >= levels; --j)
    {
      advance(common, j, GetBlend<Number>(knots, degree, k, levels, j, a));
    }
    std::copy(common + levels * lines.Count, common + (degree + 1) * lines.Count, own + levels * lines.Count);
    for (int level = levels + 1; level <= degree; ++level)
    {
      for (int j = degree; j >= level; --j)
      {
        advance(own, j, blends[level][j]);
      }
    }
    for (int line = 0; line < lines.Count; ++line)
    {
      result[i * lines.Stride + line * lines.LineStride] = own[degree * lines.Count + line];
    }
  }
}

/// Bézier points on [u0,u1] x [v0,v1] for spans ku and kv.
template <class Number>
void ExtractCell(const NURBSSurface& surface, int ku, int kv, const double (&u)[2], const double (&v)[2],
  std::array<Number, 4>* cell)
{
  const int p = surface.Degree[0];
  const int q = surface.Degree[1];
  std::array<Number, 4> active[(MaximumDegree + 1) * (MaximumDegree + 1)];
  std::array<Number, 4> partial[(MaximumDegree + 1) * (MaximumDegree + 1)];
  // For compilers that do not see that p and q are 1 at least.
  active[0] = partial[0] = {};
  for (int j = 0; j <= q; ++j)
  {
    const Homogeneous* row = surface.ControlPoints.data() + (ku - p) +
      static_cast<std::size_t>(kv - q + j) * surface.NumberOfControlPoints[0];
    for (int i = 0; i <= p; ++i)
    {
      std::copy(row[i].begin(), row[i].end(), active[i + j * (p + 1)].begin());
    }
  }
  Blossom(surface.Knots[0], p, ku, u[0], u[1], active, partial, { q + 1, 1, p + 1 });
  Blossom(surface.Knots[1], q, kv, v[0], v[1], partial, cell, { p + 1, p + 1, 1 });
}

/// Point and derivatives of a cell at local parameters. P, Q: its degrees where these are known to the
/// compiler, else 0; every sum runs in the same order.
template <int P, int Q>
void EvaluateCell(const Homogeneous* cell, const std::array<int, 2>& degrees, double s, double r,
  Homogeneous& h, Homogeneous& hs, Homogeneous& hr)
{
  constexpr bool isKnown = P > 0;
  const int p = isKnown ? P : degrees[0];
  const int q = isKnown ? Q : degrees[1];
  Homogeneous column[isKnown ? P + 1 : MaximumDegree + 1];
  Homogeneous columnR[isKnown ? P + 1 : MaximumDegree + 1];
  // For compilers that do not see that p and q are 1 at least.
  column[0] = columnR[0] = {};
  for (int i = 0; i <= p; ++i)
  {
    Homogeneous line[isKnown ? Q + 1 : MaximumDegree + 1];
    line[0] = {};
    for (int j = 0; j <= q; ++j)
    {
      line[j] = cell[i + j * (p + 1)];
    }
    column[i] = BernsteinPiece<4>{ line, q }.Evaluate(r, &columnR[i]);
  }
  h = BernsteinPiece<4>{ column, p }.Evaluate(s, &hs);
  hr = BernsteinPiece<4>{ columnR, p }.Evaluate(s);
}
}

namespace
{
/// Returns true if the control points at an index of a direction are those at another one, except for a
/// common factor and rounding: the surface has the same curve on both sides.
bool AreRowsEqual(const NURBSSurface& surface, int direction, int first, int second)
{
  const int columns = surface.NumberOfControlPoints[0];
  const int count = surface.NumberOfControlPoints[1 - direction];
  const auto get = [&](int index, int i) -> const Homogeneous&
  {
    return surface.ControlPoints[direction == 0 ? index + static_cast<std::size_t>(columns) * i
                                                : i + static_cast<std::size_t>(columns) * index];
  };
  const double scale[2] = { get(second, 0)[3], get(first, 0)[3] };
  for (int i = 0; i < count; ++i)
  {
    double size = 0.0;
    double difference = 0.0;
    for (int c = 0; c < 4; ++c)
    {
      const double a = get(first, i)[c] * scale[0];
      const double b = get(second, i)[c] * scale[1];
      size = std::max({ size, std::abs(a), std::abs(b) });
      difference = std::max(difference, std::abs(a - b));
    }
    if (!(difference <= 8.0 * UnitRoundoff * size))
    {
      return false;
    }
  }
  return true;
}

/// Returns the first knot inside the domain that occurs more often than the degree, with other control points
/// on either side; NaN if there is none.
double FindJump(const NURBSSurface& surface, int direction)
{
  const std::vector<double>& knots = surface.Knots[direction];
  const auto degree = static_cast<std::ptrdiff_t>(surface.Degree[direction]);
  auto first = std::upper_bound(knots.begin(), knots.end(), surface.GetDomainStart(direction));
  while (first != knots.end() && *first < surface.GetDomainEnd(direction))
  {
    const auto last = std::upper_bound(first, knots.end(), *first);
    const auto left = static_cast<int>(first - knots.begin()) - 1;
    const auto right = static_cast<int>(last - knots.begin() - degree) - 1;
    if (last - first > degree && !AreRowsEqual(surface, direction, left, right))
    {
      return *first;
    }
    first = last;
  }
  return std::numeric_limits<double>::quiet_NaN();
}
}

std::vector<double> NURBSSurface::GetSpanBreaks(int direction) const
{
  const std::vector<double>& knots = this->Knots[direction];
  std::vector<double> breaks;
  for (std::size_t i = this->Degree[direction]; i + this->Degree[direction] < knots.size(); ++i)
  {
    if (breaks.empty() || knots[i] > breaks.back())
    {
      breaks.push_back(knots[i]);
    }
  }
  return breaks;
}

std::string NURBSSurface::Check() const
{
  std::ostringstream what;
  for (int d = 0; d < 2; ++d)
  {
    const char* name = d == 0 ? "u" : "v";
    if (this->Degree[d] < 1 || this->Degree[d] > MaximumDegree)
    {
      what << "degree " << this->Degree[d] << " in " << name << " is outside 1.." << MaximumDegree;
      return what.str();
    }
    if (this->NumberOfControlPoints[d] <= this->Degree[d] ||
      this->Knots[d].size() != static_cast<std::size_t>(this->NumberOfControlPoints[d] + this->Degree[d] + 1))
    {
      what << this->Knots[d].size() << " knots in " << name << " do not fit "
           << this->NumberOfControlPoints[d] << " control points of degree " << this->Degree[d];
      return what.str();
    }
    if (!std::is_sorted(this->Knots[d].begin(), this->Knots[d].end()) ||
      !(this->GetDomainEnd(d) > this->GetDomainStart(d)))
    {
      what << "knots in " << name << " decrease or span nothing";
      return what.str();
    }
  }
  if (this->ControlPoints.size() !=
    static_cast<std::size_t>(this->NumberOfControlPoints[0]) * this->NumberOfControlPoints[1])
  {
    what << this->ControlPoints.size() << " control points instead of " << this->NumberOfControlPoints[0]
         << " x " << this->NumberOfControlPoints[1];
    return what.str();
  }
  for (int d = 0; d < 2; ++d)
  {
    const double jump = FindJump(*this, d);
    if (!std::isnan(jump))
    {
      what << "the surface jumps at " << (d == 0 ? "u" : "v") << " = " << jump
           << ", where a knot occurs more often than the degree";
      return what.str();
    }
  }
  for (std::size_t i = 0; i < this->ControlPoints.size(); ++i)
  {
    const Homogeneous& p = this->ControlPoints[i];
    if (!(p[3] > 0.0) || !std::isfinite(p[0] + p[1] + p[2] + p[3]))
    {
      what << "control point " << i << " is not finite or its weight is not positive";
      return what.str();
    }
  }
  return {};
}

std::array<double, 3> NURBSSurface::ExtractBezier(
  double u0, double u1, double v0, double v1, std::array<double, 4>* points, double center[3]) const
{
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  const int ku = FindSpanOf(this->Knots[0], p, u0, u1);
  const int kv = FindSpanOf(this->Knots[1], q, v0, v1);
  std::array<Wide, 4> cell[(MaximumDegree + 1) * (MaximumDegree + 1)];
  ExtractCell(*this, ku, kv, { u0, u1 }, { v0, v1 }, cell);
  double farthest = 0.0;
  double heaviest = 0.0;
  double lightest = std::numeric_limits<double>::max();
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const Homogeneous& point = this->ControlPoints[(ku - p + i) +
        static_cast<std::size_t>(kv - q + j) * this->NumberOfControlPoints[0]];
      farthest = std::max(farthest, std::hypot(point[0], point[1], point[2]) / point[3]);
      heaviest = std::max(heaviest, point[3]);
      lightest = std::min(lightest, point[3]);
    }
  }
  const bool isPlain = heaviest == lightest;
  const int count = (p + 1) * (q + 1);
  for (int i = 0; i < count; ++i)
  {
    cell[i][3] = isPlain ? heaviest : cell[i][3];
    std::copy(cell[i].begin(), cell[i].end(), points[i].begin());
  }
  for (int c = 0; c < 3 && center; ++c)
  {
    double low = points[0][c] / points[0][3];
    double high = low;
    for (int i = 1; i < count; ++i)
    {
      low = std::min(low, points[i][c] / points[i][3]);
      high = std::max(high, points[i][c] / points[i][3]);
    }
    center[c] = 0.5 * (low + high);
    for (int i = 0; i < count; ++i)
    {
      points[i][c] = static_cast<double>(cell[i][c] - center[c] * cell[i][3]);
    }
  }
  std::array<double, 3> largest{};
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      largest[c] = std::max(largest[c], std::abs(points[i][c]) / points[i][3]);
    }
  }
  // The rounding of the result, of w x and where weights differ of w. Before it, a level of blossoming rounds
  // a convex sum of neighbours, two products, a sum, and factors of three roundings that shift weight between
  // neighbours: at most 9 u of the largest, of w x and of w alike. There are p + q levels; on a whole Bézier
  // span the factors are 0 and 1, exactly. Centring rounds twice, and multiplies the error of w by the
  // centre. For these u is that of the wider numbers (where there are none, that of double).
  const double distance = farthest + (center ? std::hypot(center[0], center[1], center[2]) : 0.0);
  int levels = 0;
  for (int d = 0; d < 2; ++d)
  {
    const bool isWhole = this->NumberOfControlPoints[d] == this->Degree[d] + 1 &&
      (d == 0 ? u0 : v0) == this->Knots[d].front() && (d == 0 ? u1 : v1) == this->Knots[d].back();
    levels += isWhole ? 0 : this->Degree[d];
  }
  std::array<double, 3> moved;
  for (int c = 0; c < 3; ++c)
  {
    moved[c] = (isPlain ? 1.0 : 2.0) * UnitRoundoff * largest[c] +
      WideRoundoff * (2.0 + (isPlain ? 9.0 : 18.0 * heaviest / lightest) * levels) * distance;
  }
  return moved;
}

void NURBSSurface::Evaluate(double u, double v, double position[3], double du[3], double dv[3]) const
{
  Walker(*this).Evaluate(u, v, position, du, dv);
}

void NURBSSurface::Walker::Evaluate(double u, double v, double position[3], double du[3], double dv[3])
{
  const int p = this->Surface.Degree[0];
  const int q = this->Surface.Degree[1];
  const std::vector<double>* knots = this->Surface.Knots;
  const int ku = FindSpan(knots[0], p, u);
  const int kv = FindSpan(knots[1], q, v);
  const double u0 = knots[0][ku], u1 = knots[0][ku + 1];
  const double v0 = knots[1][kv], v1 = knots[1][kv + 1];
  if (ku != this->Span[0] || kv != this->Span[1])
  {
    this->Cell.resize(static_cast<std::size_t>(p + 1) * (q + 1));
    ExtractCell(this->Surface, ku, kv, { u0, u1 }, { v0, v1 }, this->Cell.data());
    this->Span[0] = ku;
    this->Span[1] = kv;
  }
  const double s = (u - u0) / (u1 - u0);
  const double r = (v - v0) / (v1 - v0);
  Homogeneous h;
  Homogeneous hs;
  Homogeneous hr;
  // Planes, ruled surfaces by arcs, tori, splines of degree 3.
  const auto evaluate = p == 1 && q == 1 ? EvaluateCell<1, 1>
    : p == 2 && q == 1                   ? EvaluateCell<2, 1>
    : p == 1 && q == 2                   ? EvaluateCell<1, 2>
    : p == 2 && q == 2                   ? EvaluateCell<2, 2>
    : p == 3 && q == 3                   ? EvaluateCell<3, 3>
                                         : EvaluateCell<0, 0>;
  evaluate(this->Cell.data(), { p, q }, s, r, h, hs, hr);
  for (int c = 0; c < 3; ++c)
  {
    position[c] = h[c] / h[3];
    if (du)
    {
      du[c] = (hs[c] - position[c] * hs[3]) / h[3] / (u1 - u0);
    }
    if (dv)
    {
      dv[c] = (hr[c] - position[c] * hr[3]) / h[3] / (v1 - v0);
    }
  }
}

NURBSSurface NURBSSurface::Transposed() const
{
  NURBSSurface other;
  other.Degree[0] = this->Degree[1];
  other.Degree[1] = this->Degree[0];
  other.Knots[0] = this->Knots[1];
  other.Knots[1] = this->Knots[0];
  other.NumberOfControlPoints[0] = this->NumberOfControlPoints[1];
  other.NumberOfControlPoints[1] = this->NumberOfControlPoints[0];
  other.Rational = this->Rational;
  other.Residual = this->Residual;
  other.Rounding = this->Rounding;
  other.ControlPoints.resize(this->ControlPoints.size());
  for (int j = 0; j < this->NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < this->NumberOfControlPoints[0]; ++i)
    {
      other.ControlPoints[j + static_cast<std::size_t>(i) * other.NumberOfControlPoints[0]] =
        this->ControlPoints[i + static_cast<std::size_t>(j) * this->NumberOfControlPoints[0]];
    }
  }
  return other;
}
}
