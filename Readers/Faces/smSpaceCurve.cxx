#include "smSpaceCurve.h"

#include "Geometry/smGeometricCurve.h"
#include "smPolynomialCurve.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{

/// Longest arc that one Gauss rule integrates: its error is 1e-11 of the radius's powers.
constexpr double MaxArc = 0.25 * vtkMath::Pi();

/// Tolerance of splines whose integrands one Gauss rule does not integrate exactly.
constexpr double SplineTolerance = 1e-9;

/// Samples for the extent of a part, which the tolerance is relative to.
constexpr int ExtentSamples = 7;

/// Vertices that are closer than this, relative to the size of the curve, are one.
constexpr double SameVertex = 1e-9;

/// Samples of a knot span among which the one next to a vertex is sought.
constexpr int SpanSamples = 8;

double GetSize(const SpaceCurve& curve)
{
  double size = curve.Radii[0] + curve.Radii[1];
  for (const Vector3& point : curve.Points)
  {
    size = std::max(size, Norm(Subtract(point, curve.Points[0])));
  }
  return size;
}

/// Returns how far the points of a part of a curve are from its first one. Control points may be much
/// farther.
double GetExtent(const SpaceCurve& curve, double a, double b)
{
  const Vector3 first = curve.Evaluate(a);
  double extent = 0.0;
  for (int i = 1; i <= ExtentSamples; ++i)
  {
    const double t = a + (b - a) * i / ExtentSamples;
    extent = std::max(extent, Norm(Subtract(curve.Evaluate(t), first)));
  }
  return extent;
}

void IntegrateRange(const SpaceCurve& curve, double a, double b, const Vector3& origin, LineIntegrals& result)
{
  std::vector<double> breaks{ a };
  if (curve.Kind == SpaceCurve::Type::Spline)
  {
    for (const double knot : curve.Knots)
    {
      if (knot > std::min(a, b) && knot < std::max(a, b) && knot != breaks.back())
      {
        breaks.push_back(knot);
      }
    }
    if (b < a)
    {
      std::reverse(breaks.begin() + 1, breaks.end());
    }
  }
  breaks.push_back(b);
  const auto evaluate = [&](double t, Vector3& x, Vector3& slope)
  { x = Subtract(curve.Evaluate(t, &slope), origin); };
  // A polynomial of degree three has integrands of degree eight.
  const bool isSpline = curve.Kind == SpaceCurve::Type::Spline;
  const bool isExact =
    isSpline ? curve.Degree <= 3 && curve.Weights.empty() : curve.Kind == SpaceCurve::Type::Parabola;
  const double tolerance = isSpline && !isExact ? SplineTolerance : 0.0;
  const double size = tolerance > 0.0 ? GetExtent(curve, a, b) : 1.0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
  {
    const double width = std::abs(breaks[i + 1] - breaks[i]);
    const int parts = isSpline || isExact ? 1 : std::max(1, static_cast<int>(std::ceil(width / MaxArc)));
    for (int k = 0; k < parts; ++k)
    {
      const double step = (breaks[i + 1] - breaks[i]) / parts;
      result.AddPart(evaluate, breaks[i] + k * step, breaks[i] + (k + 1) * step, tolerance, size);
    }
  }
}

/// Returns the parameter of the point of a spline that is closest to a vertex.
double FindOnSpline(const SpaceCurve& curve, double first, double last, const Vector3& vertex)
{
  double best = first;
  double minimum = Norm(Subtract(curve.Evaluate(first), vertex));
  double step = last - first;
  for (std::size_t k = curve.Degree; k + 1 + curve.Degree < curve.Knots.size(); ++k)
  {
    const double width = curve.Knots[k + 1] - curve.Knots[k];
    for (int i = 1; i <= SpanSamples && width > 0.0; ++i)
    {
      const double t = curve.Knots[k] + width * i / SpanSamples;
      const double distance = Norm(Subtract(curve.Evaluate(t), vertex));
      if (distance < minimum)
      {
        minimum = distance;
        best = t;
        step = width / SpanSamples;
      }
    }
  }
  for (int i = 0; i < 60; ++i)
  {
    Vector3 derivative;
    const Vector3 away = Subtract(vertex, curve.Evaluate(best, &derivative));
    const double square = Dot(derivative, derivative);
    const double move = square > 0.0 ? std::clamp(Dot(away, derivative) / square, -step, step) : 0.0;
    const double next = std::clamp(best + move, first, last);
    const double distance = Norm(Subtract(curve.Evaluate(next), vertex));
    if (!(distance < minimum) && move != 0.0)
    {
      step = 0.25 * std::abs(move);
      if (step <= 1e-15 * std::max(std::abs(first), std::abs(last)))
      {
        break;
      }
      continue;
    }
    if (next == best)
    {
      break;
    }
    best = next;
    minimum = distance;
  }
  return best;
}

/// Finds the range of parameters of an ellipse, and for a hyperbola and a parabola.
bool FindConicRange(
  const SpaceCurve& curve, const Vector3& start, const Vector3& end, bool isForward, double range[2])
{
  const Vector3* const vertices[2] = { &start, &end };
  for (int k = 0; k < 2; ++k)
  {
    const Vector3 away = Subtract(*vertices[k], curve.Origin);
    const double x = Dot(away, curve.Axes[0]);
    const double y = Dot(away, curve.Axes[1]);
    range[k] = curve.Kind == SpaceCurve::Type::Ellipse ? std::atan2(y / curve.Radii[1], x / curve.Radii[0])
      : curve.Kind == SpaceCurve::Type::Hyperbola      ? GetHyperbolaParameter(y / curve.Radii[1])
                                                       : y / (2.0 * curve.Radii[0]);
  }
  if (curve.Kind == SpaceCurve::Type::Ellipse)
  {
    const bool isWhole = Norm(Subtract(end, start)) <= SameVertex * GetSize(curve);
    const double turn = isForward ? 2.0 * vtkMath::Pi() : -2.0 * vtkMath::Pi();
    if (isWhole)
    {
      range[1] = range[0] + turn;
    }
    else if ((range[1] > range[0]) != isForward)
    {
      range[1] += turn;
    }
  }
  return std::isfinite(range[0]) && std::isfinite(range[1]);
}

bool IntegrateSpline(
  const SpaceCurve& curve, const Vector3& start, const Vector3& end, bool isForward, LineIntegrals& result)
{
  const double first = curve.Knots[curve.Degree];
  const double last = curve.Knots[curve.Knots.size() - 1 - curve.Degree];
  const double size = GetSize(curve);
  const Vector3 ends[2] = { curve.Evaluate(first), curve.Evaluate(last) };
  const double near = SameVertex * size;
  const bool isClosed = Norm(Subtract(ends[0], ends[1])) <= 1e-6 * size;
  double range[2] = { isForward ? first : last, isForward ? last : first };
  const bool isWhole = Norm(Subtract(start, end)) <= near ||
    (Norm(Subtract(start, ends[isForward ? 0 : 1])) <= near &&
      Norm(Subtract(end, ends[isForward ? 1 : 0])) <= near);
  const auto add = [&](double a, double b)
  {
    const Vector3 from = curve.Evaluate(a);
    IntegrateRange(curve, a, b, start, result);
    return std::make_pair(from, curve.Evaluate(b));
  };
  const auto connect = [&](const Vector3& from, const Vector3& to)
  { result.AddSegment(Subtract(from, start), Subtract(to, start)); };
  if (!isWhole)
  {
    range[0] = FindOnSpline(curve, first, last, start);
    range[1] = FindOnSpline(curve, first, last, end);
    if (isClosed)
    {
      // The seam of a closed spline is its first and its last parameter.
      const double seam = 1e-9 * (last - first);
      range[0] = range[0] - first <= seam || last - range[0] <= seam ? (isForward ? first : last) : range[0];
      range[1] = range[1] - first <= seam || last - range[1] <= seam ? (isForward ? last : first) : range[1];
      if ((range[1] > range[0]) != isForward)
      {
        const auto before = add(range[0], isForward ? last : first);
        const auto behind = add(isForward ? first : last, range[1]);
        connect(start, before.first);
        connect(before.second, behind.first);
        connect(behind.second, end);
        return true;
      }
    }
  }
  const auto part = add(range[0], range[1]);
  connect(start, part.first);
  connect(part.second, end);
  return true;
}
}

bool SpaceCurve::IsConsistent() const
{
  if (this->Kind != Type::Spline)
  {
    return true;
  }
  return this->Degree >= 1 && this->Degree <= MaximumDegree &&
    this->Points.size() > static_cast<std::size_t>(this->Degree) &&
    this->Knots.size() == this->Points.size() + this->Degree + 1 &&
    (this->Weights.empty() || this->Weights.size() == this->Points.size()) &&
    std::is_sorted(this->Knots.begin(), this->Knots.end()) &&
    this->Knots[this->Degree] < this->Knots[this->Points.size()];
}

Vector3 SpaceCurve::Evaluate(double t, Vector3* derivative) const
{
  double factors[2] = { 0.0, 0.0 };
  double slopes[2] = { 0.0, 0.0 };
  switch (this->Kind)
  {
    case Type::Ellipse:
      factors[0] = this->Radii[0] * std::cos(t);
      factors[1] = this->Radii[1] * std::sin(t);
      slopes[0] = -this->Radii[0] * std::sin(t);
      slopes[1] = this->Radii[1] * std::cos(t);
      break;
    case Type::Parabola:
      factors[0] = this->Radii[0] * t * t;
      factors[1] = 2.0 * this->Radii[0] * t;
      slopes[0] = factors[1];
      slopes[1] = 2.0 * this->Radii[0];
      break;
    case Type::Hyperbola:
      factors[0] = this->Radii[0] * std::cosh(t);
      factors[1] = this->Radii[1] * std::sinh(t);
      slopes[0] = this->Radii[0] * std::sinh(t);
      slopes[1] = this->Radii[1] * std::cosh(t);
      break;
    default:
      break;
  }
  if (this->Kind != Type::Spline)
  {
    Vector3 point = this->Origin;
    for (int c = 0; c < 3; ++c)
    {
      point[c] += factors[0] * this->Axes[0][c] + factors[1] * this->Axes[1][c];
      if (derivative)
      {
        (*derivative)[c] = slopes[0] * this->Axes[0][c] + slopes[1] * this->Axes[1][c];
      }
    }
    return point;
  }
  const int p = this->Degree;
  const auto after = std::upper_bound(this->Knots.begin() + p, this->Knots.begin() + this->Points.size(), t);
  const int span = std::max(p, static_cast<int>(after - this->Knots.begin()) - 1);
  std::array<double, 4> net[MaximumDegree + 1];
  for (int j = 0; j <= p; ++j)
  {
    const std::size_t i = span - p + j;
    const double w = this->Weights.empty() ? 1.0 : this->Weights[i];
    net[j] = { w * this->Points[i][0], w * this->Points[i][1], w * this->Points[i][2], w };
  }
  std::array<double, 4> slope{};
  for (int level = 1; level <= p; ++level)
  {
    for (int j = p; j >= level; --j)
    {
      const double low = this->Knots[span - p + j];
      const double high = this->Knots[span + 1 + j - level];
      const double x = high > low ? (t - low) / (high - low) : 0.0;
      for (int c = 0; c < 4; ++c)
      {
        if (level == p && derivative)
        {
          slope[c] = high > low ? p * (net[j][c] - net[j - 1][c]) / (high - low) : 0.0;
        }
        net[j][c] = (1.0 - x) * net[j - 1][c] + x * net[j][c];
      }
    }
  }
  Vector3 point;
  for (int c = 0; c < 3; ++c)
  {
    point[c] = net[p][c] / net[p][3];
    if (derivative)
    {
      (*derivative)[c] = (slope[c] - slope[3] * point[c]) / net[p][3];
    }
  }
  return point;
}

bool IntegrateEdge(
  const SpaceCurve& curve, const Vector3& start, const Vector3& end, bool isForward, LineIntegrals& result)
{
  result = LineIntegrals();
  if (curve.Kind == SpaceCurve::Type::Line)
  {
    result.AddSegment({ 0.0, 0.0, 0.0 }, Subtract(end, start));
    return true;
  }
  if (curve.Kind == SpaceCurve::Type::Spline)
  {
    return IntegrateSpline(curve, start, end, isForward, result);
  }
  double range[2];
  if (!FindConicRange(curve, start, end, isForward, range))
  {
    return false;
  }
  IntegrateRange(curve, range[0], range[1], start, result);
  result.AddSegment({ 0.0, 0.0, 0.0 }, Subtract(curve.Evaluate(range[0]), start));
  result.AddSegment(Subtract(curve.Evaluate(range[1]), start), Subtract(end, start));
  return true;
}
}
