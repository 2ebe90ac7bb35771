#include "smGeometricCurve.h"

#include "smGeometricSurface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sm
{
namespace
{
constexpr double WholeTurn = 6.283185307179586;

template <int Dimension>
using PointOf = std::array<double, Dimension>;
template <int Dimension>
using DerivativesOf = typename GeometricCurve<Dimension>::Derivatives;

template <std::size_t Dimension>
bool IsFinite(const std::array<double, Dimension>& point)
{
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

template <std::size_t Dimension>
double DotProduct(const std::array<double, Dimension>& a, const std::array<double, Dimension>& b)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < Dimension; ++c)
  {
    sum += a[c] * b[c];
  }
  return sum;
}

/// Returns factors with which the axes contribute to the derivative of an order.
void GetConicFactors(double a, double b, int kind, double t, int order, double factors[2])
{
  if (kind == 0)
  {
    // The derivatives of cosine and sine turn by a quarter.
    const double c = std::cos(t);
    const double s = std::sin(t);
    const double x[4] = { c, -s, -c, s };
    const double y[4] = { s, c, -s, -c };
    factors[0] = a * x[order % 4];
    factors[1] = b * y[order % 4];
  }
  else if (kind == 1)
  {
    const double x[4] = { t * t / (4.0 * a), t / (2.0 * a), 1.0 / (2.0 * a), 0.0 };
    const double y[4] = { t, 1.0, 0.0, 0.0 };
    factors[0] = x[order];
    factors[1] = y[order];
  }
  else
  {
    factors[0] = a * (order % 2 == 0 ? std::cosh(t) : std::sinh(t));
    factors[1] = b * (order % 2 == 0 ? std::sinh(t) : std::cosh(t));
  }
}

template <int Dimension>
void EvaluateValue(const LineCurve<Dimension>& line, double t, int order, DerivativesOf<Dimension>& result)
{
  for (int c = 0; c < Dimension; ++c)
  {
    result[0][c] = line.Origin[c] + t * line.Direction[c];
  }
  for (int r = 1; r <= order; ++r)
  {
    result[r] = r == 1 ? line.Direction : PointOf<Dimension>{};
  }
}

template <int Dimension>
void EvaluateValue(const ConicCurve<Dimension>& conic, double t, int order, DerivativesOf<Dimension>& result)
{
  for (int r = 0; r <= order; ++r)
  {
    double factors[2];
    GetConicFactors(conic.Radii[0], conic.Radii[1], static_cast<int>(conic.Kind), t, r, factors);
    for (int c = 0; c < Dimension; ++c)
    {
      const double value = factors[0] * conic.X[c] + factors[1] * conic.Y[c];
      result[r][c] = r == 0 ? value + conic.Center[c] : value;
    }
  }
}

template <int Dimension>
void EvaluateValue(
  const SplineCurve<Dimension>& spline, double t, int order, DerivativesOf<Dimension>& result)
{
  SplineBasis::Values basis;
  spline.Basis.Evaluate(t, order, basis);
  const bool rational = !spline.Weights.empty();
  double weights[MaximumOrder + 1];
  for (int r = 0; r <= order; ++r)
  {
    result[r].fill(0.0);
    weights[r] = 0.0;
    for (int i = 0; i <= spline.Basis.Degree; ++i)
    {
      const int pole = basis.Poles[i];
      const double factor = rational ? basis.N[r][i] * spline.Weights[pole] : basis.N[r][i];
      weights[r] += factor;
      for (int c = 0; c < Dimension; ++c)
      {
        result[r][c] += factor * spline.Poles[pole][c];
      }
    }
  }
  // The quotient's derivatives by Leibniz' rule: A^(r) = sum binomial(r, k) w^(k) C^(r-k).
  for (int r = 0; rational && r <= order; ++r)
  {
    double binomial = 1.0;
    for (int k = 1; k <= r; ++k)
    {
      binomial *= static_cast<double>(r - k + 1) / k;
      for (int c = 0; c < Dimension; ++c)
      {
        result[r][c] -= binomial * weights[k] * result[r - k][c];
      }
    }
    for (double& x : result[r])
    {
      x /= weights[0];
    }
  }
}

PointOf<2> Turn(const PointOf<2>&, const PointOf<2>& tangent)
{
  return { -tangent[1], tangent[0] };
}

PointOf<3> Turn(const PointOf<3>& reference, const PointOf<3>& tangent)
{
  return Cross(reference, tangent);
}

template <int Dimension>
void EvaluateValue(
  const OffsetCurve<Dimension>& offset, double t, int order, DerivativesOf<Dimension>& result)
{
  DerivativesOf<Dimension> basis;
  offset.Basis->Evaluate(t, order + 1, basis);
  // N = W / L with W = V x B'; L' = N . W', L'' = N' . W' + N . W''.
  DerivativesOf<Dimension> w{};
  DerivativesOf<Dimension> n{};
  double length[3] = { 0.0, 0.0, 0.0 };
  for (int r = 0; r <= order; ++r)
  {
    w[r] = Turn(offset.Reference, basis[r + 1]);
  }
  length[0] = std::sqrt(DotProduct(w[0], w[0]));
  for (int r = 0; r <= order; ++r)
  {
    length[r] = r == 0 ? length[0] : DotProduct(n[0], w[r]) + (r == 2 ? DotProduct(n[1], w[1]) : 0.0);
    for (int c = 0; c < Dimension; ++c)
    {
      const double rest = r == 0 ? 0.0 : n[0][c] * length[r] + (r == 2 ? 2.0 * n[1][c] * length[1] : 0.0);
      n[r][c] = (w[r][c] - rest) / length[0];
      result[r][c] = basis[r][c] + offset.Distance * n[r][c];
    }
  }
}

template <int Dimension>
void EvaluateValue(const CurveOnSurface&, double, int, DerivativesOf<Dimension>& result)
{
  // Make() accepts no such curve in the plane.
  result = {};
}

void EvaluateOnSurface(const CurveOnSurface& value, double t, int order, DerivativesOf<3>& result)
{
  DerivativesOf<2> c;
  value.Curve->Evaluate(t, order, c);
  GeometricSurface::Derivatives s;
  value.Surface->Evaluate(c[0][0], c[0][1], order, s);
  result[0] = s[0][0];
  for (int k = 0; k < 3 && order >= 1; ++k)
  {
    result[1][k] = s[1][0][k] * c[1][0] + s[0][1][k] * c[1][1];
    if (order >= 2)
    {
      result[2][k] = s[2][0][k] * c[1][0] * c[1][0] + 2.0 * s[1][1][k] * c[1][0] * c[1][1] +
        s[0][2][k] * c[1][1] * c[1][1] + s[1][0][k] * c[2][0] + s[0][1][k] * c[2][1];
    }
  }
}

template <>
void EvaluateValue<3>(const CurveOnSurface& value, double t, int order, DerivativesOf<3>& result)
{
  EvaluateOnSurface(value, t, order, result);
}

template <int Dimension>
void EvaluateComposite(const CompositeCurve<Dimension>& composite, const std::vector<double>& starts,
  double t, int order, DerivativesOf<Dimension>& result)
{
  const auto after = std::upper_bound(starts.begin() + 1, starts.end() - 1, t);
  const std::size_t k = after - starts.begin() - 1;
  const CurveSegment<Dimension>& segment = composite.Segments[k];
  const double speed = (segment.Last - segment.First) / segment.Length;
  segment.Curve->Evaluate(segment.First + (t - starts[k]) * speed, order, result);
  double factor = 1.0;
  for (int r = 1; r <= order; ++r)
  {
    factor *= speed;
    for (double& x : result[r])
    {
      x *= factor;
    }
  }
}

/// Returns a short reason if a value cannot be evaluated.
template <int Dimension>
std::string CheckValue(const LineCurve<Dimension>& line)
{
  const bool isUnit = std::abs(DotProduct(line.Direction, line.Direction) - 1.0) < 1e-12;
  return isUnit && IsFinite(line.Origin) ? "" : "its line has no direction, or no finite origin";
}

template <int Dimension>
std::string CheckValue(const ConicCurve<Dimension>& conic)
{
  const bool isParabola = conic.Kind == ConicCurve<Dimension>::Type::Parabola;
  const double other = isParabola ? conic.Radii[0] : conic.Radii[1];
  const bool hasRadii =
    std::min(conic.Radii[0], other) > 0.0 && std::isfinite(std::max(conic.Radii[0], other));
  const double squares[2] = { DotProduct(conic.X, conic.X), DotProduct(conic.Y, conic.Y) };
  const double product = DotProduct(conic.X, conic.Y);
  const bool hasAxes = squares[0] * squares[1] - product * product > 1e-24 * squares[0] * squares[1];
  return hasAxes && hasRadii && IsFinite(conic.Center)
    ? ""
    : "its radii are not positive, or its axes are parallel";
}

template <int Dimension>
std::string CheckValue(SplineCurve<Dimension>& spline)
{
  const std::string problem = spline.Basis.Complete();
  if (!problem.empty())
  {
    return problem;
  }
  const std::size_t count = spline.Basis.GetCount();
  if (spline.Poles.size() != count || (!spline.Weights.empty() && spline.Weights.size() != count))
  {
    return "the numbers of its control points, weights and knots do not fit together";
  }
  const bool isFinite = std::all_of(spline.Poles.begin(), spline.Poles.end(), IsFinite<Dimension>) &&
    std::all_of(
      spline.Weights.begin(), spline.Weights.end(), [](double w) { return w > 0.0 && std::isfinite(w); });
  return isFinite ? "" : "a control point is not finite, or a weight is not positive";
}

template <int Dimension>
std::string CheckValue(const OffsetCurve<Dimension>& offset)
{
  if (!offset.Basis || offset.Basis->GetMaxOrder() < 2)
  {
    return "it is an offset of a curve of which there are no second derivatives";
  }
  const bool isUnit =
    Dimension == 2 || std::abs(DotProduct(offset.Reference, offset.Reference) - 1.0) < 1e-12;
  return isUnit && std::isfinite(offset.Distance) ? "" : "its offset has no direction or no finite distance";
}

template <int Dimension>
std::string CheckValue(const CompositeCurve<Dimension>& composite)
{
  bool isComplete = !composite.Segments.empty();
  for (const CurveSegment<Dimension>& segment : composite.Segments)
  {
    isComplete = isComplete && segment.Curve && std::isfinite(segment.First) && std::isfinite(segment.Last) &&
      segment.First != segment.Last && segment.Length > 0.0 && std::isfinite(segment.Length);
  }
  return isComplete ? "" : "one of its segments is missing or has no length";
}
}

double GetHyperbolaParameter(double y)
{
  const double size = std::abs(y);
  const double root = std::sqrt(1.0 + size * size);
  return std::copysign(
    size > 2.0 ? std::log(2.0 * size + 1.0 / (root + size)) : std::log1p(size + size * size / (1.0 + root)),
    y);
}

template <int Dimension>
CurvePointer<Dimension> GeometricCurve<Dimension>::Make(Variant value, std::string& problem)
{
  std::shared_ptr<GeometricCurve<Dimension>> curve(new GeometricCurve<Dimension>(std::move(value)));
  problem = curve->Complete();
  return problem.empty() ? curve : nullptr;
}

template <int Dimension>
std::string GeometricCurve<Dimension>::Complete()
{
  if (const auto* onSurface = std::get_if<CurveOnSurface>(&this->Value))
  {
    if (Dimension != 3 || !onSurface->Surface || !onSurface->Curve)
    {
      return "its surface or its curve is missing";
    }
    this->MaxOrder = std::min({ 2, onSurface->Surface->GetMaxOrder(), onSurface->Curve->GetMaxOrder() });
    this->Domain = onSurface->Curve->GetDomain();
    return {};
  }
  std::string problem;
  if (const auto* line = std::get_if<LineCurve<Dimension>>(&this->Value))
  {
    return CheckValue(*line);
  }
  if (const auto* conic = std::get_if<ConicCurve<Dimension>>(&this->Value))
  {
    if (conic->Kind == ConicCurve<Dimension>::Type::Ellipse)
    {
      this->Domain = { 0.0, WholeTurn };
      this->Period = WholeTurn;
    }
    return CheckValue(*conic);
  }
  if (auto* spline = std::get_if<SplineCurve<Dimension>>(&this->Value))
  {
    problem = CheckValue(*spline);
    if (problem.empty())
    {
      this->Domain = { spline->Basis.GetStart(), spline->Basis.GetEnd() };
      this->Period = spline->Basis.Periodic ? this->Domain.High - this->Domain.Low : 0.0;
    }
    return problem;
  }
  if (const auto* offset = std::get_if<OffsetCurve<Dimension>>(&this->Value))
  {
    problem = CheckValue(*offset);
    if (problem.empty())
    {
      this->Domain = offset->Basis->GetDomain();
      this->Period = offset->Basis->GetPeriod();
      this->MaxOrder = offset->Basis->GetMaxOrder() - 1;
    }
    return problem;
  }
  const auto& composite = std::get<CompositeCurve<Dimension>>(this->Value);
  problem = CheckValue(composite);
  this->Starts = { 0.0 };
  for (const CurveSegment<Dimension>& segment : composite.Segments)
  {
    if (problem.empty())
    {
      this->Starts.push_back(this->Starts.back() + segment.Length);
      this->MaxOrder = std::min(this->MaxOrder, segment.Curve->GetMaxOrder());
    }
  }
  this->Domain = { 0.0, this->Starts.back() };
  return problem;
}

template <int Dimension>
auto GeometricCurve<Dimension>::Evaluate(double t) const -> Point
{
  Derivatives result;
  this->Evaluate(t, 0, result);
  return result[0];
}

template <int Dimension>
void GeometricCurve<Dimension>::Evaluate(double t, int order, Derivatives& result) const
{
  std::visit(
    [&](const auto& value)
    {
      using Type = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<Type, CompositeCurve<Dimension>>)
      {
        EvaluateComposite<Dimension>(value, this->Starts, t, order, result);
      }
      else
      {
        EvaluateValue<Dimension>(value, t, order, result);
      }
    },
    this->Value);
}

template <int Dimension>
std::vector<double> GeometricCurve<Dimension>::GetBreaks(double first, double last) const
{
  if (const auto* offset = this->template GetIf<OffsetCurve<Dimension>>())
  {
    return offset->Basis->GetBreaks(first, last);
  }
  if (const auto* spline = this->template GetIf<SplineCurve<Dimension>>())
  {
    return MakeBreaks(first, last, spline->Basis.Flatten(first, last).Knots);
  }
  if (const auto* onSurface = this->template GetIf<CurveOnSurface>())
  {
    return onSurface->Curve->GetBreaks(first, last);
  }
  std::vector<double> breaks;
  if (const auto* composite = this->template GetIf<CompositeCurve<Dimension>>())
  {
    for (std::size_t k = 0; k < composite->Segments.size(); ++k)
    {
      const CurveSegment<Dimension>& segment = composite->Segments[k];
      const bool forward = segment.First < segment.Last;
      const double scale = segment.Length / (segment.Last - segment.First);
      std::vector<double> own = segment.Curve->GetBreaks(
        std::min(segment.First, segment.Last), std::max(segment.First, segment.Last));
      if (!forward)
      {
        std::reverse(own.begin(), own.end());
      }
      for (const double knot : own)
      {
        breaks.push_back(this->Starts[k] + (knot - segment.First) * scale);
      }
    }
  }
  return MakeBreaks(first, last, breaks);
}

template class GeometricCurve<2>;
template class GeometricCurve<3>;
}
