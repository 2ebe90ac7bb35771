#include "smHostileCuts.h"

#include <algorithm>
#include <cmath>

namespace smhostile
{
namespace
{
/// A monotone curve from (first, 0) to (last, 1) with u in [low, high]: sorted v coefficients cannot turn
/// back.
sm::TrimCurve MakeCut(Random& random, double first, double last, double low, double high)
{
  sm::TrimCurve curve;
  curve.Breaks = { 0.0 };
  const int pieces = random.Chance(0.3) ? 2 : 1;
  const double middle = random.Uniform(0.2, 0.8);
  Point2 from = { first, 0.0 };
  for (int k = 0; k < pieces; ++k)
  {
    const bool isLast = k + 1 == pieces;
    const Point2 to = isLast ? Point2{ last, 1.0 } : Point2{ random.Uniform(low, high), middle };
    const int degree = random.Integer(1, 9);
    std::vector<double> v;
    for (int i = 0; i <= degree; ++i)
    {
      v.push_back(random.Chance(0.5) ? static_cast<double>(i) / degree : random.Uniform());
    }
    std::sort(v.begin(), v.end());
    std::vector<Point2> points;
    for (int i = 0; i <= degree; ++i)
    {
      points.push_back({ random.Uniform(low, high), from[1] + (to[1] - from[1]) * v[i] });
    }
    points.front() = from;
    points.back() = to;
    curve.AppendPiece(isLast ? 1.0 : middle, points.data(), degree);
    from = to;
  }
  return curve;
}

Split MakeColumns(Random& random, const std::vector<double>& lines)
{
  Split split;
  split.How = Split::Kind::Columns;
  const double line = lines.empty() ? 0.5 : lines[random.Integer(0, static_cast<int>(lines.size()) - 1)];
  const double tiny = random.LogUniform(1e-12, 1e-3);
  const auto cut = [&random](double low, double high)
  {
    const double first = std::clamp(QuantizeParameter(random.Uniform(low, high)), 0.0, 1.0);
    const double last = std::clamp(QuantizeParameter(random.Uniform(low, high)), 0.0, 1.0);
    return MakeCut(random, first, last, low, high);
  };
  switch (random.Integer(0, 6))
  {
    case 0:
      split.Name = "graze-border";
      split.Curves.push_back(random.Chance(0.5) ? cut(0.0, tiny) : cut(1.0 - tiny, 1.0));
      break;
    case 1:
    {
      split.Name = "sliver";
      sm::TrimCurve left = cut(0.2, 0.7);
      sm::TrimCurve right = left;
      for (Point2& p : right.Coefficients)
      {
        p[0] += tiny * random.Uniform(0.1, 1.0);
      }
      right.Coefficients.front()[0] =
        std::ldexp(std::ceil(std::ldexp(right.Coefficients.front()[0], 42)), -42);
      right.Coefficients.back()[0] = std::ldexp(std::ceil(std::ldexp(right.Coefficients.back()[0], 42)), -42);
      // Pieces share their joints.
      for (int k = 1; k < right.GetNumberOfPieces(); ++k)
      {
        right.Coefficients[right.Offsets[k]] = right.Coefficients[right.Offsets[k] - 1];
      }
      split.Curves = { left, right };
      break;
    }
    case 2:
      split.Name = "along-knot";
      split.Curves.push_back(MakeCut(random, line, line, line, line));
      break;
    case 3:
      split.Name = "graze-knot";
      split.Curves.push_back(cut(line, std::min(1.0, line + tiny)));
      break;
    case 4:
      split.Name = "about-knot";
      split.Curves.push_back(cut(std::max(0.0, line - tiny), std::min(1.0, line + tiny)));
      break;
    case 5:
      split.Name = "corner-to-corner";
      split.Curves.push_back(
        random.Chance(0.5) ? MakeCut(random, 0.0, 1.0, 0.0, 1.0) : MakeCut(random, 1.0, 0.0, 0.0, 1.0));
      break;
    default:
    {
      split.Name = "columns";
      const int count = random.Integer(1, 3);
      double low = 0.0;
      for (int i = 1; i <= count; ++i)
      {
        const double high = i == count ? 1.0 : random.Uniform(low, 1.0);
        split.Curves.push_back(cut(low, high));
        low = high;
      }
    }
  }
  return split;
}

Split MakeCorner(Random& random)
{
  Split split;
  const bool low = random.Chance(0.5);
  split.How = low ? Split::Kind::LowCorner : Split::Kind::HighCorner;
  split.Name = "corner";
  const double size = random.Chance(0.6) ? random.LogUniform(1e-11, 1e-2) : random.Uniform(0.1, 0.9);
  const double a = std::max(QuantizeParameter(size * random.Uniform(0.3, 1.0)), std::ldexp(1.0, -40));
  const double b = std::max(QuantizeParameter(size * random.Uniform(0.3, 1.0)), std::ldexp(1.0, -40));
  const int degree = random.Integer(1, 9);
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= degree; ++i)
  {
    x.push_back(random.Uniform());
    y.push_back(random.Uniform());
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  std::vector<Point2> points;
  for (int i = 0; i <= degree; ++i)
  {
    points.push_back({ a * (1.0 - x[i]), b * y[i] });
  }
  points.front() = { a, 0.0 };
  points.back() = { 0.0, b };
  if (!low)
  {
    // From (1-a, 1) to (1, 1-b).
    for (Point2& p : points)
    {
      p = { 1.0 - p[0], 1.0 - p[1] };
    }
  }
  sm::TrimCurve curve;
  curve.Breaks = { 0.0 };
  curve.AppendPiece(1.0, points.data(), degree);
  split.Curves.push_back(curve);
  return split;
}

/// The loop as a polygon, whose first point is the loop's first corner.
std::vector<Point2> MakePolygon(const std::vector<sm::TrimCurve>& loop)
{
  constexpr int steps = 64;
  std::vector<Point2> polygon;
  for (const sm::TrimCurve& curve : loop)
  {
    const double first = curve.Breaks.front();
    const double width = curve.Breaks.back() - first;
    for (int i = 0; i < steps; ++i)
    {
      polygon.push_back(curve.Evaluate(first + width * i / steps));
    }
  }
  return polygon;
}

/// Twice the signed area of a triangle.
double Turn(const Point2& a, const Point2& b, const Point2& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Returns true if sides of two polygons, or of one, cross. Sides that share a corner do not.
bool Cross(const std::vector<Point2>& p, const std::vector<Point2>& q)
{
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point2& a = p[i];
    const Point2& b = p[(i + 1) % p.size()];
    for (std::size_t k = 0; k < q.size(); ++k)
    {
      const Point2& c = q[k];
      const Point2& d = q[(k + 1) % q.size()];
      const bool isJoined = a == c || a == d || b == c || b == d;
      if (!isJoined && Turn(a, b, c) * Turn(a, b, d) < 0.0 && Turn(c, d, a) * Turn(c, d, b) < 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

/// Makes the pieces of a loop straight.
void Straighten(std::vector<sm::TrimCurve>& loop)
{
  for (sm::TrimCurve& curve : loop)
  {
    const std::size_t last = curve.Coefficients.size() - 1;
    const Point2 from = curve.Coefficients.front();
    const Point2 to = curve.Coefficients.back();
    for (std::size_t j = 1; j < last; ++j)
    {
      const double x = static_cast<double>(j) / static_cast<double>(last);
      curve.Coefficients[j] = { from[0] + x * (to[0] - from[0]), from[1] + x * (to[1] - from[1]) };
    }
  }
}

Split MakeHoles(Random& random, const std::vector<double> lines[2])
{
  Split split;
  split.How = Split::Kind::Holes;
  split.Name = "hole";
  double radius = random.Chance(0.3) ? random.LogUniform(1e-10, 1e-2) : random.Uniform(0.02, 0.2);
  Point2 center = { random.Uniform(0.42, 0.58), random.Uniform(0.42, 0.58) };
  const int corners = random.Integer(2, 6);
  const bool onKnotLine = random.Chance(0.3) && !lines[0].empty() && lines[0][0] > 0.2 && lines[0][0] < 0.8;
  if (onKnotLine)
  {
    // The first corner on a knot line; two such loops side by side stay inside.
    radius = std::min(radius, 0.05);
    center[0] = lines[0][0] - radius;
  }
  std::vector<Point2> corner;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 6.283185307179586 * (i + (i > 0 ? random.Uniform(-0.15, 0.15) : 0.0)) / corners;
    corner.push_back({ center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle) });
  }
  if (onKnotLine)
  {
    corner[0][0] = lines[0][0];
  }
  std::vector<sm::TrimCurve> loop;
  for (int i = 0; i < corners; ++i)
  {
    const Point2 from = corner[i];
    const Point2 to = corner[(i + 1) % corners];
    const int degree = random.Integer(corners == 2 ? 2 : 1, 9);
    const double bulge = corners == 2 ? random.Uniform(0.2, 0.4) : random.Uniform(-0.12, 0.12);
    std::vector<Point2> points;
    for (int j = 0; j <= degree; ++j)
    {
      const double x = static_cast<double>(j) / degree;
      const double height = (j == 0 || j == degree) ? 0.0 : bulge * random.Uniform(0.5, 1.0);
      // To the right of the direction is outside.
      points.push_back({ from[0] + x * (to[0] - from[0]) + height * (to[1] - from[1]),
        from[1] + x * (to[1] - from[1]) - height * (to[0] - from[0]) });
    }
    points.front() = from;
    points.back() = to;
    sm::TrimCurve curve;
    curve.Breaks = { 0.0 };
    curve.AppendPiece(1.0, points.data(), degree);
    loop.push_back(curve);
  }
  // Bulges of high degree may lead across the next piece.
  if (corners > 2 && Cross(MakePolygon(loop), MakePolygon(loop)))
  {
    Straighten(loop);
  }
  split.Loops.push_back(loop);
  if (random.Chance(0.25))
  {
    split.Name = "one-edge-hole";
    split.Loops[0] = { JoinLoop(loop) };
  }
  else if (radius < 0.12 && random.Chance(0.4))
  {
    const Point2 pivot = corner[0];
    for (sm::TrimCurve& curve : loop)
    {
      for (Point2& p : curve.Coefficients)
      {
        p = { 2.0 * pivot[0] - p[0], 2.0 * pivot[1] - p[1] };
      }
    }
    // Or beyond the common corner into the other hole.
    if (!Cross(MakePolygon(split.Loops[0]), MakePolygon(loop)))
    {
      split.Name = "touching-holes";
      split.Loops.push_back(loop);
    }
  }
  return split;
}
}

sm::TrimCurve JoinLoop(const std::vector<sm::TrimCurve>& pieces)
{
  sm::TrimCurve joined;
  joined.Breaks = { 0.0 };
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    joined.AppendPiece(i + 1.0, pieces[i].Coefficients.data(), pieces[i].GetDegree(0));
  }
  return joined;
}

double QuantizeParameter(double t)
{
  return std::ldexp(std::nearbyint(std::ldexp(t, 42)), -42);
}

Split MakeSplit(Random& random, const std::vector<double> lines[2])
{
  const double kind = random.Uniform();
  if (kind < 0.45)
  {
    return {};
  }
  if (kind < 0.8)
  {
    return MakeColumns(random, lines[0]);
  }
  return kind < 0.9 ? MakeCorner(random) : MakeHoles(random, lines);
}

sm::EdgeCurve MakeEdgeCurve(const std::function<Point3(double)>& position, double start, double end,
  const EdgeQuality& quality, Random& random)
{
  sm::EdgeCurve curve;
  curve.Breaks = { start };
  const int n = quality.Degree;
  // Bernstein coefficients from values at Chebyshev-Lobatto points, by elimination.
  std::vector<std::vector<Real>> matrix(n + 1);
  std::vector<Real> nodes(n + 1);
  for (int i = 0; i <= n; ++i)
  {
    std::vector<Real> derivatives;
    nodes[i] = i == 0 ? 0.0L : i == n ? 1.0L : 0.5L - 0.5L * std::cos(3.14159265358979323846L * i / n);
    EvaluateBernstein(n, nodes[i], matrix[i], derivatives);
  }
  for (int k = 0; k < quality.Pieces; ++k)
  {
    const double low = start + (end - start) * k / quality.Pieces;
    const double high = k + 1 == quality.Pieces ? end : start + (end - start) * (k + 1) / quality.Pieces;
    std::vector<std::vector<Real>> rows = matrix;
    for (int i = 0; i <= n; ++i)
    {
      const double t = i == n ? high : static_cast<double>(low + (high - low) * nodes[i]);
      const double x = (t - start) / (end - start);
      const Point3 point = position(t + 4.0 * quality.Lag * x * (1.0 - x) * (end - start));
      rows[i].insert(rows[i].end(), point.begin(), point.end());
    }
    for (int column = 0; column <= n; ++column)
    {
      int pivot = column;
      for (int i = column; i <= n; ++i)
      {
        pivot = std::abs(rows[i][column]) > std::abs(rows[pivot][column]) ? i : pivot;
      }
      std::swap(rows[pivot], rows[column]);
      for (int i = 0; i <= n; ++i)
      {
        const Real factor = i == column ? 0.0L : rows[i][column] / rows[column][column];
        for (int j = column; factor != 0.0L && j < n + 4; ++j)
        {
          rows[i][j] -= factor * rows[column][j];
        }
      }
    }
    std::vector<Point3> coefficients(n + 1);
    for (int i = 0; i <= n; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        coefficients[i][c] = static_cast<double>(rows[i][n + 1 + c] / rows[i][i]) +
          (quality.Offset > 0.0 ? quality.Offset * random.Uniform(-1.0, 1.0) : 0.0);
      }
    }
    curve.AppendPiece(high, coefficients.data(), n);
  }
  return curve;
}
}
