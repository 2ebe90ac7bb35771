#include "smGroundNet.h"

#include "smBernstein.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace sm
{
namespace
{
using Points = std::vector<GroundPoint>;

std::pair<Points, Points> HalveNet(const Points& net, const int counts[2], int direction)
{
  std::pair<Points, Points> halves{ net, net };
  const int stride = direction == 0 ? 1 : counts[0];
  const int lines = direction == 0 ? counts[1] : counts[0];
  const int next = direction == 0 ? counts[0] : 1;
  for (int line = 0; line < lines; ++line)
  {
    HalveBernstein(
      halves.first.data() + line * next, halves.second.data() + line * next, counts[direction] - 1, stride);
  }
  return halves;
}

HeightRange RangeOf(const Points& points)
{
  HeightRange range{ points[0][2] / points[0][3], points[0][2] / points[0][3] };
  for (const GroundPoint& p : points)
  {
    const double h = p[2] / p[3];
    range.Low = std::min(range.Low, h);
    range.High = std::max(range.High, h);
  }
  return range;
}

/// Returns true if H' - h W' has one sign for both heights, by more than the slack.
bool KeepsSign(const Points& steps, const HeightRange& heights, double slack)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const GroundPoint& s : steps)
  {
    for (const double h : { heights.Low, heights.High })
    {
      const double slope = s[2] - h * s[3];
      low = std::min(low, slope);
      high = std::max(high, slope);
    }
  }
  return low > slack || high < -slack;
}

using Vector = Vector3;

/// Values, first and second derivatives of the Bernstein polynomials of a degree.
void EvaluateBasis(int degree, double x, std::vector<double> (&basis)[3])
{
  const auto value = [x](int n, int i)
  { return i < 0 || i > n || n < 0 ? 0.0 : GetBinomial(n, i) * std::pow(x, i) * std::pow(1.0 - x, n - i); };
  for (std::vector<double>& b : basis)
  {
    b.assign(degree + 1, 0.0);
  }
  for (int i = 0; i <= degree; ++i)
  {
    basis[0][i] = value(degree, i);
    basis[1][i] = degree * (value(degree - 1, i - 1) - value(degree - 1, i));
    basis[2][i] = degree * (degree - 1) *
      (value(degree - 2, i - 2) - 2.0 * value(degree - 2, i - 1) + value(degree - 2, i));
  }
}
}

double GetBinomial(int n, int k)
{
  double result = 1.0;
  for (int i = 1; i <= k; ++i)
  {
    result *= static_cast<double>(n - k + i) / i;
  }
  return result;
}

GroundPoint GroundFrame::Transform(const std::array<double, 4>& homogeneous, const double center[3]) const
{
  GroundPoint result;
  for (int i = 0; i < 3; ++i)
  {
    // The centre of the patch is moved first, so that rounding is relative to the distances from it.
    double moved = this->Shift[i];
    double local = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      moved += this->Rows[i][j] * center[j];
      local += this->Rows[i][j] * homogeneous[j];
    }
    result[i] = local + moved * homogeneous[3];
  }
  result[3] = homogeneous[3];
  return result;
}

GroundCurve GroundCurve::FromPoints(std::vector<GroundPoint> points)
{
  GroundCurve curve;
  const int degree = static_cast<int>(points.size()) - 1;
  for (int i = 0; i < degree; ++i)
  {
    GroundPoint step;
    for (int c = 0; c < 4; ++c)
    {
      step[c] = degree * (points[i + 1][c] - points[i][c]);
    }
    curve.Steps.push_back(step);
  }
  curve.Points = std::move(points);
  return curve;
}

HeightRange GroundCurve::GetHeights() const
{
  return RangeOf(this->Points);
}

bool GroundCurve::IsMonotone(double slack) const
{
  return !this->Steps.empty() && KeepsSign(this->Steps, this->GetHeights(), slack);
}

bool GroundCurve::IsLevel(double slack) const
{
  const HeightRange heights = this->GetHeights();
  return std::all_of(this->Steps.begin(), this->Steps.end(),
    [&](const GroundPoint& s) {
      return std::abs(s[2] - heights.Low * s[3]) <= slack && std::abs(s[2] - heights.High * s[3]) <= slack;
    });
}

std::pair<GroundCurve, GroundCurve> GroundCurve::Split() const
{
  std::pair<GroundCurve, GroundCurve> halves;
  const auto halve =
    [](const std::vector<GroundPoint>& net, std::vector<GroundPoint>& left, std::vector<GroundPoint>& right)
  {
    left = right = net;
    if (!net.empty())
    {
      HalveBernstein(left.data(), right.data(), static_cast<int>(net.size()) - 1, 1);
    }
  };
  halve(this->Points, halves.first.Points, halves.second.Points);
  halve(this->Steps, halves.first.Steps, halves.second.Steps);
  const double middle = 0.5 * (this->Start + this->End);
  halves.first.Start = this->Start;
  halves.first.End = halves.second.Start = middle;
  halves.second.End = this->End;
  return halves;
}

GroundPatch::GroundPatch(const FacePanels& panels, const Patch& patch, const GroundFrame& frame)
{
  this->Degree[0] = patch.Degree[0];
  this->Degree[1] = patch.Degree[1];
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  for (int i = 0; i < (p + 1) * (q + 1); ++i)
  {
    this->Points.push_back(frame.Transform(panels.Points[patch.FirstPoint + i], patch.Center));
  }
  for (int d = 0; d < 2; ++d)
  {
    const int stride = d == 0 ? 1 : p + 1;
    for (int j = 0; j <= q - d; ++j)
    {
      for (int i = 0; i <= p - (1 - d); ++i)
      {
        const GroundPoint& from = this->Points[i + (p + 1) * j];
        const GroundPoint& to = this->Points[i + (p + 1) * j + stride];
        GroundPoint step;
        for (int c = 0; c < 4; ++c)
        {
          step[c] = this->Degree[d] * (to[c] - from[c]);
        }
        this->Steps[d].push_back(step);
      }
    }
  }
}

HeightRange GroundPatch::GetHeights() const
{
  return RangeOf(this->Points);
}

bool GroundPatch::IsMonotone(int direction, double slack) const
{
  return KeepsSign(this->Steps[direction], this->GetHeights(), slack);
}

double GroundPatch::GetVariation(int direction) const
{
  const HeightRange heights = this->GetHeights();
  const double h = 0.5 * (heights.Low + heights.High);
  double variation = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    const int columns = this->Degree[0] + (d == 0 ? 0 : 1);
    const int rows = this->Degree[1] + (d == 1 ? 0 : 1);
    const int stride = direction == 0 ? 1 : columns;
    const int next = direction == 0 ? columns : 1;
    for (int line = 0; line < (direction == 0 ? rows : columns); ++line)
    {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (int i = 0; i < (direction == 0 ? columns : rows); ++i)
      {
        const GroundPoint& s = this->Steps[d][line * next + i * stride];
        low = std::min(low, s[2] - h * s[3]);
        high = std::max(high, s[2] - h * s[3]);
      }
      variation = std::max(variation, high - low);
    }
  }
  return variation;
}

std::pair<GroundPatch, GroundPatch> GroundPatch::Split(int direction) const
{
  std::pair<GroundPatch, GroundPatch> halves{ *this, *this };
  const int counts[2] = { this->Degree[0] + 1, this->Degree[1] + 1 };
  std::tie(halves.first.Points, halves.second.Points) = HalveNet(this->Points, counts, direction);
  for (int d = 0; d < 2; ++d)
  {
    const int fewer[2] = { counts[0] - (d == 0 ? 1 : 0), counts[1] - (d == 1 ? 1 : 0) };
    std::tie(halves.first.Steps[d], halves.second.Steps[d]) = HalveNet(this->Steps[d], fewer, direction);
  }
  const double middle = 0.5 * (this->Low[direction] + this->High[direction]);
  halves.first.High[direction] = halves.second.Low[direction] = middle;
  return halves;
}

GroundCurve GroundPatch::GetBorder(int direction, int end) const
{
  const int columns = this->Degree[0] + 1;
  const int other = 1 - direction;
  std::vector<GroundPoint> points;
  for (int i = 0; i <= this->Degree[other]; ++i)
  {
    const int fixed = end ? this->Degree[direction] : 0;
    points.push_back(this->Points[direction == 0 ? fixed + columns * i : i + columns * fixed]);
  }
  return GroundCurve::FromPoints(std::move(points));
}

double GroundPatch::GetExtent(int direction) const
{
  const int columns = this->Degree[0] + 1;
  double extent = 0.0;
  for (int line = 0; line <= this->Degree[1 - direction]; ++line)
  {
    const int stride = direction == 0 ? 1 : columns;
    const GroundPoint* first = this->Points.data() + line * (direction == 0 ? columns : 1);
    for (int i = 1; i <= this->Degree[direction]; ++i)
    {
      const GroundPoint& p = first[i * stride];
      extent = std::max(
        extent, std::hypot(p[0] / p[3] - first[0][0] / first[0][3], p[1] / p[3] - first[0][1] / first[0][3]));
    }
  }
  return extent;
}

bool GroundPatch::IsRegular() const
{
  // With x = X/w the determinant of the map is w^-2 of that of the rows X_s - x w_s: linear in x, so
  // intervals of both directions at the extremes of a and b enclose it.
  double low[2][2];
  double high[2][2];
  for (int c = 0; c < 2; ++c)
  {
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    for (const GroundPoint& p : this->Points)
    {
      minimum = std::min(minimum, p[c] / p[3]);
      maximum = std::max(maximum, p[c] / p[3]);
    }
    for (int d = 0; d < 2; ++d)
    {
      low[d][c] = std::numeric_limits<double>::infinity();
      high[d][c] = -low[d][c];
      for (const GroundPoint& s : this->Steps[d])
      {
        for (const double x : { minimum, maximum })
        {
          low[d][c] = std::min(low[d][c], s[c] - x * s[3]);
          high[d][c] = std::max(high[d][c], s[c] - x * s[3]);
        }
      }
    }
  }
  const auto product = [&](int c, int e)
  {
    const double corners[4] = { low[0][c] * low[1][e], low[0][c] * high[1][e], high[0][c] * low[1][e],
      high[0][c] * high[1][e] };
    return std::make_pair(*std::min_element(corners, corners + 4), *std::max_element(corners, corners + 4));
  };
  const auto first = product(0, 1);
  const auto second = product(1, 0);
  // A net that is not degenerate differs from 0 by far more than this rounding.
  const double size = std::max(
    { std::abs(first.first), std::abs(first.second), std::abs(second.first), std::abs(second.second) });
  return first.first - second.second > 1e-12 * size || first.second - second.first < -1e-12 * size;
}

GroundPatch::Shape GroundPatch::GetShape(double s, double r) const
{
  std::vector<double> basis[2][3];
  EvaluateBasis(this->Degree[0], s, basis[0]);
  EvaluateBasis(this->Degree[1], r, basis[1]);
  // Derivatives of the homogeneous point: 0, s, r, ss, sr, rr.
  const int orders[6][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };
  GroundPoint x[6] = {};
  for (int k = 0; k < 6; ++k)
  {
    for (int j = 0; j <= this->Degree[1]; ++j)
    {
      for (int i = 0; i <= this->Degree[0]; ++i)
      {
        const double b = basis[0][orders[k][0]][i] * basis[1][orders[k][1]][j];
        for (int c = 0; c < 4; ++c)
        {
          x[k][c] += b * this->Points[i + (this->Degree[0] + 1) * j][c];
        }
      }
    }
  }
  Vector d[6];
  for (int c = 0; c < 3; ++c)
  {
    const double w = x[0][3];
    d[0][c] = x[0][c] / w;
    d[1][c] = (x[1][c] - x[1][3] * d[0][c]) / w;
    d[2][c] = (x[2][c] - x[2][3] * d[0][c]) / w;
    d[3][c] = (x[3][c] - 2.0 * x[1][3] * d[1][c] - x[3][3] * d[0][c]) / w;
    d[4][c] = (x[4][c] - x[1][3] * d[2][c] - x[2][3] * d[1][c] - x[4][3] * d[0][c]) / w;
    d[5][c] = (x[5][c] - 2.0 * x[2][3] * d[2][c] - x[5][3] * d[0][c]) / w;
  }
  Vector normal = Cross(d[1], d[2]);
  const double length = std::sqrt(Dot(normal, normal));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Shape shape{ 0.0, nan, nan, { { d[1][0], d[1][1] }, { d[2][0], d[2][1] } } };
  double reach = 0.0;
  for (int direction = 0; direction < 2; ++direction)
  {
    for (const GroundPoint& step : this->Steps[direction])
    {
      reach = std::max(reach, std::hypot(step[0], step[1], step[2]));
    }
  }
  if (!(length > 1e-9 * reach * reach))
  {
    return shape;
  }
  for (double& n : normal)
  {
    n /= normal[2] < 0.0 ? -length : length;
  }
  shape.Normal = std::abs(normal[2]);
  const double e = Dot(d[1], d[1]);
  const double f = Dot(d[1], d[2]);
  const double g = Dot(d[2], d[2]);
  const double l = Dot(d[3], normal);
  const double m = Dot(d[4], normal);
  const double n = Dot(d[5], normal);
  // The second form in an orthonormal basis whose first vector is along s: where both curvatures are equal,
  // the root of mean^2 - gauss would be that of a rounding error.
  const double skew = f / e;
  const double across = std::sqrt(g - f * skew);
  const double ss = l / e;
  const double sr = (m - skew * l) / (std::sqrt(e) * across);
  const double rr = (n - 2.0 * skew * m + skew * skew * l) / (across * across);
  const double mean = 0.5 * (ss + rr);
  const double half = std::hypot(0.5 * (ss - rr), sr);
  shape.Curvature = mean + half;
  shape.MinimumCurvature = mean - half;
  return shape;
}
}
