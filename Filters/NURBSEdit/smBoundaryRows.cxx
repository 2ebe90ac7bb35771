#include "Detail/smBoundaryRows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sm
{
namespace
{
using Wide = long double;
using WidePoint = std::array<Wide, 3>;

// Largest distance of a trim curve from the side that it lies on, relative to the domain's width.
constexpr double SideTolerance = 1e-12;
// Limits of a fit: degree of a piece, halvings, and the residual relative to the largest displacement.
constexpr int FitDegree = 12;
constexpr int FitHalvings = 8;
constexpr double FitTolerance = 1e-14;

bool IsClamped(const NURBSSurface& surface, int direction)
{
  const std::vector<double>& knots = surface.Knots[direction];
  const int degree = surface.Degree[direction];
  const std::size_t last = knots.size() - 1;
  return knots[1] == knots[degree] && knots[last - 1] == knots[last - degree];
}

/// Returns true if coordinate `d` of every coefficient is `value` within the tolerance.
bool LiesAt(const TrimCurve& trim, int d, double value, double tolerance)
{
  return std::all_of(trim.Coefficients.begin(), trim.Coefficients.end(),
    [=](const TrimCurve::Point& point) { return std::abs(point[d] - value) <= tolerance; });
}

/// Returns the parameter in the row, from 0 to 1, that corresponds to parameter t of the edge.
Wide GetRowParameter(const NURBSSurface& surface, const BoundaryRow& row, const TrimCurve& trim, double t)
{
  const Wide start = surface.GetDomainStart(row.Direction);
  const Wide end = surface.GetDomainEnd(row.Direction);
  const Wide x = (trim.Evaluate(t)[row.Direction] - start) / (end - start);
  return std::clamp(row.Falling ? 1 - x : x, Wide(0), Wide(1));
}

/// Returns the t at which x(t), which does not decrease, reaches `knot`.
template <typename Function>
double FindParameter(const Function& x, double start, double end, double knot)
{
  for (int i = 0; i < 100; ++i)
  {
    const double middle = 0.5 * (start + end);
    if (middle <= start || middle >= end)
    {
      break;
    }
    (x(middle) < knot ? start : end) = middle;
  }
  // The closer one of two adjacent doubles, so that a parameter that is a double itself is found exactly.
  return std::abs(x(start) - knot) < std::abs(x(end) - knot) ? start : end;
}

/// Replaces `values` at the local parameters `nodes` by the Bernstein coefficients of degree n that
/// interpolate them.
void SolveBernstein(int n, const std::vector<Wide>& nodes, std::vector<WidePoint>& values)
{
  std::vector<std::vector<Wide>> matrix(n + 1, std::vector<Wide>(n + 1));
  for (int i = 0; i <= n; ++i)
  {
    // Row i has the Bernstein polynomials at node i, computed degree by degree.
    std::vector<Wide>& b = matrix[i];
    b[0] = 1;
    for (int degree = 1; degree <= n; ++degree)
    {
      for (int k = degree; k > 0; --k)
      {
        b[k] = (1 - nodes[i]) * (k < degree ? b[k] : 0) + nodes[i] * b[k - 1];
      }
      b[0] *= 1 - nodes[i];
    }
  }
  for (int column = 0; column <= n; ++column)
  {
    int pivot = column;
    for (int i = column + 1; i <= n; ++i)
    {
      pivot = std::abs(matrix[i][column]) > std::abs(matrix[pivot][column]) ? i : pivot;
    }
    std::swap(matrix[column], matrix[pivot]);
    std::swap(values[column], values[pivot]);
    for (int i = 0; i <= n; ++i)
    {
      const Wide factor = i == column ? 0 : matrix[i][column] / matrix[column][column];
      for (int k = column; k <= n && factor != 0; ++k)
      {
        matrix[i][k] -= factor * matrix[column][k];
      }
      for (int c = 0; c < 3; ++c)
      {
        values[i][c] -= factor * values[column][c];
      }
    }
  }
  for (int i = 0; i <= n; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      values[i][c] /= matrix[i][i];
    }
  }
}

WidePoint EvaluateBernstein(std::vector<WidePoint> points, Wide x)
{
  for (std::size_t level = points.size() - 1; level > 0; --level)
  {
    for (std::size_t i = 0; i < level; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        points[i][c] = (1 - x) * points[i][c] + x * points[i + 1][c];
      }
    }
  }
  return points[0];
}

/// Computes the displaced curve of an edge, piece by piece.
class Displacer
{
public:
  Displacer(const EdgeOrigin& origin, const RowCurve& now, const NURBSSurface& surface,
    const BoundaryRow& row, const TrimCurve& trim)
    : Origin(origin)
    , Now(now)
    , Surface(surface)
    , Row(row)
    , Trim(trim)
    , Polynomial(now.IsPolynomial() && origin.Row.IsPolynomial())
  {
    for (std::size_t i = 0; i < now.Points.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Scale = std::max({ this->Scale, std::abs(now.Points[i][c] / now.Points[i][3]),
          std::abs(origin.Row.Points[i][c] / origin.Row.Points[i][3]) });
      }
    }
  }

  EdgeCurve Make()
  {
    const EdgeCurve& base = this->Origin.Source->Curve;
    this->Result.Residual = base.Residual;
    const std::vector<double> breaks = this->GetBreaks();
    this->Result.Breaks = { breaks.front() };
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      const double middle = 0.5 * (breaks[i] + breaks[i + 1]);
      const int along = this->Trim.GetDegree(this->Trim.FindPiece(middle));
      this->Piece = base.FindPiece(middle);
      const int exact = std::max(base.GetDegree(this->Piece), along * this->Now.Degree);
      const bool fits = this->Polynomial && exact <= MaximumDegree;
      this->Append(breaks[i], breaks[i + 1], fits ? exact : std::max(base.GetDegree(this->Piece), FitDegree),
        fits ? 0 : FitHalvings);
    }
    return this->Result;
  }

private:
  std::vector<double> GetBreaks() const
  {
    const EdgeCurve& base = this->Origin.Source->Curve;
    std::vector<double> breaks = base.Breaks;
    const double start = base.GetStart();
    const double end = base.GetEnd();
    breaks.insert(breaks.end(), this->Trim.Breaks.begin(), this->Trim.Breaks.end());
    const auto x = [this](double t)
    { return static_cast<double>(GetRowParameter(this->Surface, this->Row, this->Trim, t)); };
    for (const double knot : this->Now.Knots)
    {
      if (knot > 0.0 && knot < 1.0)
      {
        breaks.push_back(FindParameter(x, start, end, knot));
      }
    }
    std::sort(breaks.begin(), breaks.end());
    std::vector<double> distinct{ start };
    for (const double t : breaks)
    {
      if (t - distinct.back() > SideTolerance * (end - start) && end - t > SideTolerance * (end - start))
      {
        distinct.push_back(t);
      }
    }
    distinct.push_back(end);
    return distinct;
  }

  WidePoint Evaluate(double t) const
  {
    const EdgeCurve& base = this->Origin.Source->Curve;
    const BernsteinPiece<3> piece = base.GetPiece(this->Piece);
    std::vector<WidePoint> points;
    for (int i = 0; i <= piece.Degree; ++i)
    {
      points.push_back({ piece.Coefficients[i][0], piece.Coefficients[i][1], piece.Coefficients[i][2] });
    }
    const Wide width = static_cast<Wide>(base.Breaks[this->Piece + 1]) - base.Breaks[this->Piece];
    WidePoint point = EvaluateBernstein(points, (t - base.Breaks[this->Piece]) / width);
    const Wide x = GetRowParameter(this->Surface, this->Row, this->Trim, t);
    const WidePoint to = this->Now.Evaluate(x);
    const WidePoint from = this->Origin.Row.Evaluate(x);
    for (int c = 0; c < 3; ++c)
    {
      point[c] += to[c] - from[c];
    }
    return point;
  }

  void Append(double start, double end, int degree, int halvings)
  {
    std::vector<Wide> nodes(degree + 1, Wide(0));
    std::vector<WidePoint> values(degree + 1);
    for (int i = 0; i <= degree; ++i)
    {
      const double x = degree == 0 ? 0.0 : 0.5 - 0.5 * std::cos(M_PI * i / degree);
      const double t = i == degree && degree > 0 ? end : start + x * (end - start);
      nodes[i] = (static_cast<Wide>(t) - start) / (static_cast<Wide>(end) - start);
      values[i] = this->Evaluate(t);
    }
    SolveBernstein(degree, nodes, values);
    std::array<double, 3> residual{};
    for (int i = 0; i < degree && halvings > 0; ++i)
    {
      const auto x = static_cast<double>(0.5L * (nodes[i] + nodes[i + 1]));
      const double t = start + x * (end - start);
      const WidePoint exact = this->Evaluate(t);
      const WidePoint fitted =
        EvaluateBernstein(values, (static_cast<Wide>(t) - start) / (static_cast<Wide>(end) - start));
      for (int c = 0; c < 3; ++c)
      {
        residual[c] = std::max(residual[c], static_cast<double>(std::abs(fitted[c] - exact[c])));
      }
    }
    // Halving stops at a residual of FitTolerance: the rest is rounding of the samples, because trim curves
    // are evaluated in double.
    if (*std::max_element(residual.begin(), residual.end()) > FitTolerance * this->Scale && halvings > 1)
    {
      const double middle = 0.5 * (start + end);
      this->Append(start, middle, degree, halvings - 1);
      this->Append(middle, end, degree, halvings - 1);
      return;
    }
    std::vector<EdgeCurve::Point> points;
    for (const WidePoint& value : values)
    {
      points.push_back(
        { static_cast<double>(value[0]), static_cast<double>(value[1]), static_cast<double>(value[2]) });
    }
    this->Result.AppendPiece(end, points.data(), degree);
    for (int c = 0; c < 3; ++c)
    {
      // The residual was sampled between the nodes, where it is largest. It is doubled because samples may
      // miss its maximum.
      this->Result.RaiseResidual(c, this->Origin.Source->Curve.Residual[c] + 2.0 * residual[c]);
    }
  }

  const EdgeOrigin& Origin;
  const RowCurve& Now;
  const NURBSSurface& Surface;
  const BoundaryRow& Row;
  const TrimCurve& Trim;
  bool Polynomial;
  double Scale = 0.0;
  int Piece = 0;
  EdgeCurve Result;
};
}

std::size_t BoundaryRow::GetEntry(const NURBSSurface& surface, int k) const
{
  const int along = this->Falling ? this->GetSize(surface) - 1 - k : k;
  const int across = this->AtEnd ? surface.NumberOfControlPoints[1 - this->Direction] - 1 : 0;
  const int i = this->Direction == 0 ? along : across;
  const int j = this->Direction == 0 ? across : along;
  return static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * surface.NumberOfControlPoints[0];
}

bool FindBoundaryRow(const NURBSSurface& surface, const TrimCurve& trim, BoundaryRow& row)
{
  if (trim.GetNumberOfPieces() < 1 || !IsClamped(surface, 0) || !IsClamped(surface, 1))
  {
    return false;
  }
  for (int fixed = 0; fixed < 2; ++fixed)
  {
    const double low = surface.GetDomainStart(fixed);
    const double high = surface.GetDomainEnd(fixed);
    const double tolerance = SideTolerance * (high - low);
    const bool atEnd = LiesAt(trim, fixed, high, tolerance);
    if (!atEnd && !LiesAt(trim, fixed, low, tolerance))
    {
      continue;
    }
    const int d = 1 - fixed;
    const double start = surface.GetDomainStart(d);
    const double end = surface.GetDomainEnd(d);
    const bool falling = trim.GetStartPoint()[d] > trim.GetEndPoint()[d];
    const double slack = SideTolerance * (end - start);
    // If the coefficients are monotone, so is the curve.
    for (std::size_t i = 1; i < trim.Coefficients.size(); ++i)
    {
      const double step = trim.Coefficients[i][d] - trim.Coefficients[i - 1][d];
      if ((falling ? -step : step) < -slack)
      {
        return false;
      }
    }
    row = { d, atEnd, falling };
    return std::abs(trim.GetStartPoint()[d] - (falling ? end : start)) <= slack &&
      std::abs(trim.GetEndPoint()[d] - (falling ? start : end)) <= slack;
  }
  return false;
}

RowCurve::RowCurve(const NURBSSurface& surface, const BoundaryRow& row)
  : Degree(surface.Degree[row.Direction])
{
  const double start = surface.GetDomainStart(row.Direction);
  const double width = surface.GetDomainEnd(row.Direction) - start;
  for (const double knot : surface.Knots[row.Direction])
  {
    const double x = (knot - start) / width;
    this->Knots.push_back(row.Falling ? 1.0 - x : x);
  }
  if (row.Falling)
  {
    std::reverse(this->Knots.begin(), this->Knots.end());
  }
  for (int k = 0; k < row.GetSize(surface); ++k)
  {
    this->Points.push_back(surface.ControlPoints[row.GetEntry(surface, k)]);
  }
}

bool RowCurve::IsPolynomial() const
{
  return std::all_of(this->Points.begin(), this->Points.end(),
    [this](const std::array<double, 4>& point) { return point[3] == this->Points.front()[3]; });
}

bool RowCurve::operator==(const RowCurve& other) const
{
  return this->Degree == other.Degree && this->Knots == other.Knots && this->Points == other.Points;
}

std::array<long double, 3> RowCurve::Evaluate(long double x) const
{
  const int last = static_cast<int>(this->Points.size()) - 1;
  const auto after = std::upper_bound(
    this->Knots.begin() + this->Degree, this->Knots.begin() + last + 1, static_cast<double>(x));
  const int span = std::clamp(static_cast<int>(after - this->Knots.begin()) - 1, this->Degree, last);
  std::array<Wide, 4> d[MaximumDegree + 1];
  for (int i = 0; i <= this->Degree; ++i)
  {
    std::copy_n(this->Points[span - this->Degree + i].begin(), 4, d[i].begin());
  }
  for (int level = 1; level <= this->Degree; ++level)
  {
    for (int i = this->Degree; i >= level; --i)
    {
      const Wide low = this->Knots[span - this->Degree + i];
      const Wide high = this->Knots[span + 1 + i - level];
      const Wide alpha = (x - low) / (high - low);
      for (int c = 0; c < 4; ++c)
      {
        d[i][c] = (1 - alpha) * d[i - 1][c] + alpha * d[i][c];
      }
    }
  }
  const std::array<Wide, 4>& h = d[this->Degree];
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

bool Coincide(const RowCurve& a, const RowCurve& b, double tolerance)
{
  if (a.Degree != b.Degree || a.Points.size() != b.Points.size() || a.Knots.size() != b.Knots.size())
  {
    return false;
  }
  for (std::size_t i = 1; i + 1 < a.Knots.size(); ++i)
  {
    if (std::abs(a.Knots[i] - b.Knots[i]) > SideTolerance)
    {
      return false;
    }
  }
  const double factor = b.Points[0][3] / a.Points[0][3];
  for (std::size_t i = 0; i < a.Points.size(); ++i)
  {
    const std::array<double, 4>& p = a.Points[i];
    const std::array<double, 4>& q = b.Points[i];
    if (std::abs(q[3] / p[3] - factor) > SideTolerance * factor ||
      std::hypot(p[0] / p[3] - q[0] / q[3], p[1] / p[3] - q[1] / q[3], p[2] / p[3] - q[2] / q[3]) > tolerance)
    {
      return false;
    }
  }
  return true;
}

EdgeCurve Displace(const EdgeOrigin& origin, const RowCurve& now, const NURBSSurface& surface,
  const BoundaryRow& row, const TrimCurve& trim)
{
  return Displacer(origin, now, surface, row, trim).Make();
}
}
