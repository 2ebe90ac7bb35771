#include "smGeometricSurface.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using SurfaceDerivatives = GeometricSurface::Derivatives;

constexpr double FullTurn = 2.0 * vtkMath::Pi();

/// Difference of a range from a whole period, relative to it, that is rounding.
constexpr double PeriodRounding = 1e-12;

bool IsUnitVector(const Vector3& v)
{
  return std::abs(Dot(v, v) - 1.0) < 1e-12;
}

bool IsFinitePoint(const Vector3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

bool IsFrame(const GeometricFrame& frame)
{
  const std::array<Vector3, 3>& a = frame.Axes;
  return IsFinitePoint(frame.Origin) && std::all_of(a.begin(), a.end(), IsUnitVector) &&
    std::abs(Dot(a[0], a[1])) < 1e-12 && std::abs(Dot(a[1], a[2])) < 1e-12 &&
    std::abs(Dot(a[2], a[0])) < 1e-12;
}

/// Radius and height of the profile of a surface of revolution in its frame, as derivatives.
void GetElementaryProfile(const ElementarySurface& s, double t, double radius[3], double height[3])
{
  std::fill_n(radius, 3, 0.0);
  std::fill_n(height, 3, 0.0);
  const bool isTorus = s.Kind == ElementarySurface::Type::Torus;
  if (isTorus || s.Kind == ElementarySurface::Type::Sphere)
  {
    const double minor = isTorus ? s.Radii[1] : s.Radii[0];
    const double c = std::cos(t);
    const double d = std::sin(t);
    radius[0] = (isTorus ? s.Radii[0] : 0.0) + minor * c;
    radius[1] = -minor * d;
    radius[2] = -minor * c;
    height[0] = minor * d;
    height[1] = minor * c;
    height[2] = -minor * d;
    return;
  }
  const bool isCone = s.Kind == ElementarySurface::Type::Cone;
  radius[1] = isCone ? std::sin(s.Angle) : 0.0;
  height[1] = isCone ? std::cos(s.Angle) : 1.0;
  radius[0] = s.Radii[0] + t * radius[1];
  height[0] = t * height[1];
}

void EvaluateValue(const ElementarySurface& value, double s, double t, int order, SurfaceDerivatives& result)
{
  const std::array<Vector3, 3>& axes = value.Frame.Axes;
  double x[3] = { s, 1.0, 0.0 };
  double y[3] = { t, 0.0, 0.0 };
  double radius[3] = { 1.0, 0.0, 0.0 };
  double height[3] = { 0.0, 0.0, 0.0 };
  const bool isPlane = value.Kind == ElementarySurface::Type::Plane;
  if (!isPlane)
  {
    GetElementaryProfile(value, t, radius, height);
    const double c = std::cos(s);
    const double d = std::sin(s);
    const double cosines[3] = { c, -d, -c };
    const double sines[3] = { d, c, -d };
    std::copy_n(cosines, 3, x);
    std::copy_n(sines, 3, y);
  }
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; i + j <= order; ++j)
    {
      double a = radius[j] * x[i];
      double b = radius[j] * y[i];
      if (isPlane)
      {
        a = j == 0 ? x[i] : 0.0;
        b = i > 0 ? 0.0 : j == 0 ? t : j == 1 ? 1.0 : 0.0;
      }
      const double h = i == 0 ? height[j] : 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const double sum = a * axes[0][c] + b * axes[1][c] + h * axes[2][c];
        result[i][j][c] = i + j == 0 ? sum + value.Frame.Origin[c] : sum;
      }
    }
  }
}

void EvaluateValue(const ExtrudedSurface& value, double s, double t, int order, SurfaceDerivatives& result)
{
  GeometricCurve<3>::Derivatives curve;
  value.Profile->Evaluate(s, order, curve);
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; i + j <= order; ++j)
    {
      result[i][j] = j == 0 ? curve[i] : i == 0 && j == 1 ? value.Direction : Vector3{};
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    result[0][0][c] += t * value.Direction[c];
  }
}

void EvaluateValue(const RevolvedSurface& value, double s, double t, int order, SurfaceDerivatives& result)
{
  GeometricCurve<3>::Derivatives curve;
  value.Profile->Evaluate(t, order, curve);
  curve[0] = Subtract(curve[0], value.Origin);
  const double c = std::cos(s);
  const double d = std::sin(s);
  const double cosines[3] = { c, -d, -c };
  const double sines[3] = { d, c, -d };
  for (int j = 0; j <= order; ++j)
  {
    const double height = Dot(curve[j], value.Axis);
    Vector3 radius;
    for (int k = 0; k < 3; ++k)
    {
      radius[k] = curve[j][k] - height * value.Axis[k];
    }
    const Vector3 across = Cross(value.Axis, radius);
    for (int i = 0; i + j <= order; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        result[i][j][k] =
          cosines[i] * radius[k] + sines[i] * across[k] + (i == 0 ? height * value.Axis[k] : 0.0);
      }
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    result[0][0][k] += value.Origin[k];
  }
}

/// Sums the control points times the basis functions, and the weights, up to a total order.
template <int Order, bool IsRational>
void SumAllPoles(const SplineSurface& value, const SplineBasis::Values& u, const SplineBasis::Values& v,
  double (&weights)[3][3], SurfaceDerivatives& result)
{
  const int columns = value.Basis[0].GetCount();
  for (int b = 0; b <= value.Basis[1].Degree; ++b)
  {
    const std::size_t row = static_cast<std::size_t>(v.Poles[b]) * columns;
    for (int a = 0; a <= value.Basis[0].Degree; ++a)
    {
      const Vector3& pole = value.Poles[u.Poles[a] + row];
      for (int i = 0; i <= Order; ++i)
      {
        const double first = IsRational ? value.Weights[u.Poles[a] + row] * u.N[i][a] : u.N[i][a];
        for (int j = 0; i + j <= Order; ++j)
        {
          const double factor = first * v.N[j][b];
          weights[i][j] += IsRational ? factor : 0.0;
          for (int c = 0; c < 3; ++c)
          {
            result[i][j][c] += factor * pole[c];
          }
        }
      }
    }
  }
}

template <int Order>
void SumPoles(const SplineSurface& value, const SplineBasis::Values& u, const SplineBasis::Values& v,
  double (&weights)[3][3], SurfaceDerivatives& result)
{
  if (value.Weights.empty())
  {
    SumAllPoles<Order, false>(value, u, v, weights, result);
  }
  else
  {
    SumAllPoles<Order, true>(value, u, v, weights, result);
  }
}

void EvaluateValue(const SplineSurface& value, double s, double t, int order, SurfaceDerivatives& result)
{
  SplineBasis::Values u;
  SplineBasis::Values v;
  value.Basis[0].Evaluate(s, order, u);
  value.Basis[1].Evaluate(t, order, v);
  const bool rational = !value.Weights.empty();
  double weights[3][3] = {};
  result = {};
  if (order == 0)
  {
    SumPoles<0>(value, u, v, weights, result);
  }
  else if (order == 1)
  {
    SumPoles<1>(value, u, v, weights, result);
  }
  else
  {
    SumPoles<2>(value, u, v, weights, result);
  }
  // The quotient's derivatives by Leibniz' rule, lower orders first.
  for (int total = 0; rational && total <= order; ++total)
  {
    for (int i = 0; i <= total; ++i)
    {
      const int j = total - i;
      for (int k = 0; k <= i; ++k)
      {
        for (int l = 0; l <= j; ++l)
        {
          const double factor = k + l == 0 ? 0.0 : (k == 1 ? i : 1) * (l == 1 ? j : 1) * weights[k][l];
          for (int c = 0; c < 3 && k + l > 0; ++c)
          {
            result[i][j][c] -= factor * result[i - k][j - l][c];
          }
        }
      }
      for (double& x : result[i][j])
      {
        x /= weights[0][0];
      }
    }
  }
}

void EvaluateValue(const OffsetSurface& value, double s, double t, int order, SurfaceDerivatives& result)
{
  SurfaceDerivatives b;
  value.Basis->Evaluate(s, t, order + 1, b);
  const Vector3 w = Cross(b[1][0], b[0][1]);
  const double length = Norm(w);
  Vector3 n;
  for (int c = 0; c < 3; ++c)
  {
    n[c] = w[c] / length;
    result[0][0][c] = b[0][0][c] + value.Distance * n[c];
  }
  for (int d = 0; d < 2 && order >= 1; ++d)
  {
    const int i = 1 - d;
    const Vector3 first = Cross(b[1 + i][d], b[0][1]);
    const Vector3 second = Cross(b[1][0], b[i][1 + d]);
    Vector3 change;
    for (int c = 0; c < 3; ++c)
    {
      change[c] = first[c] + second[c];
    }
    const double along = Dot(n, change);
    for (int c = 0; c < 3; ++c)
    {
      result[i][d][c] = b[i][d][c] + value.Distance * (change[c] - along * n[c]) / length;
    }
  }
}

std::string CheckElementary(const ElementarySurface& s)
{
  using Type = ElementarySurface::Type;
  const bool hasRadius = s.Radii[0] > 0.0 && std::isfinite(s.Radii[0]);
  bool isSound = IsFrame(s.Frame);
  switch (s.Kind)
  {
    case Type::Plane:
      break;
    case Type::Cone:
      isSound = isSound && s.Radii[0] >= 0.0 && std::isfinite(s.Radii[0]) && s.Angle != 0.0 &&
        std::abs(s.Angle) < 0.5 * vtkMath::Pi();
      break;
    case Type::Torus:
      isSound = isSound && std::isfinite(s.Radii[0]) && s.Radii[1] > 0.0 && std::isfinite(s.Radii[1]);
      break;
    default:
      isSound = isSound && hasRadius;
  }
  return isSound ? "" : "its radii or its angle are out of range, or its axes are not normal to each other";
}

/// Sets domain and period of a direction along a curve, of which `range` is used. Returns false if that is
/// empty.
bool TakeProfile(
  const GeometricCurve<3>& curve, ParameterRange& range, ParameterRange& domain, double& period)
{
  const bool isPart = std::isfinite(range.Low) || std::isfinite(range.High);
  domain = isPart ? range : curve.GetDomain();
  period = curve.GetPeriod();
  if (isPart && period > 0.0 && std::abs(range.High - range.Low - period) > PeriodRounding * period)
  {
    period = 0.0;
  }
  return domain.Low < domain.High;
}
}

SurfacePointer GeometricSurface::Make(Variant value, std::string& problem)
{
  const std::shared_ptr<GeometricSurface> surface(new GeometricSurface(std::move(value)));
  problem = surface->Complete();
  return problem.empty() ? surface : nullptr;
}

std::string GeometricSurface::Complete()
{
  if (const auto* elementary = this->GetIf<ElementarySurface>())
  {
    using Type = ElementarySurface::Type;
    const Type kind = elementary->Kind;
    if (kind != Type::Plane)
    {
      this->Domain[0] = { 0.0, FullTurn };
      this->Period[0] = FullTurn;
    }
    if (kind == Type::Sphere)
    {
      this->Domain[1] = { -0.5 * vtkMath::Pi(), 0.5 * vtkMath::Pi() };
    }
    if (kind == Type::Torus)
    {
      const double border = std::acos(std::clamp(-elementary->Radii[0] / elementary->Radii[1], -1.0, 1.0));
      const bool isWhole = elementary->Selected == ElementarySurface::Part::Whole;
      this->Domain[1] = isWhole ? ParameterRange{ 0.0, FullTurn }
        : elementary->Selected == ElementarySurface::Part::Outer
        ? ParameterRange{ -border, border }
        : ParameterRange{ border, FullTurn - border };
      this->Period[1] = isWhole ? FullTurn : 0.0;
    }
    return CheckElementary(*elementary);
  }
  if (auto* extruded = std::get_if<ExtrudedSurface>(&this->Value))
  {
    if (!extruded->Profile || !IsUnitVector(extruded->Direction) ||
      !TakeProfile(*extruded->Profile, extruded->Range, this->Domain[0], this->Period[0]))
    {
      return "its profile or its direction is missing";
    }
    this->MaxOrder = std::min(2, extruded->Profile->GetMaxOrder());
    return {};
  }
  if (auto* revolved = std::get_if<RevolvedSurface>(&this->Value))
  {
    if (!revolved->Profile || !IsUnitVector(revolved->Axis) || !IsFinitePoint(revolved->Origin) ||
      !TakeProfile(*revolved->Profile, revolved->Range, this->Domain[1], this->Period[1]))
    {
      return "its profile or its axis is missing";
    }
    this->Domain[0] = { 0.0, FullTurn };
    this->Period[0] = FullTurn;
    this->MaxOrder = std::min(2, revolved->Profile->GetMaxOrder());
    return {};
  }
  if (auto* spline = std::get_if<SplineSurface>(&this->Value))
  {
    for (int d = 0; d < 2; ++d)
    {
      const std::string problem = spline->Basis[d].Complete();
      if (!problem.empty())
      {
        return problem;
      }
      this->Domain[d] = { spline->Basis[d].GetStart(), spline->Basis[d].GetEnd() };
      this->Period[d] = spline->Basis[d].Periodic ? this->Domain[d].High - this->Domain[d].Low : 0.0;
    }
    const std::size_t count =
      static_cast<std::size_t>(spline->Basis[0].GetCount()) * spline->Basis[1].GetCount();
    if (spline->Poles.size() != count || (!spline->Weights.empty() && spline->Weights.size() != count))
    {
      return "the numbers of its control points, weights and knots do not fit together";
    }
    const bool isFinite = std::all_of(spline->Poles.begin(), spline->Poles.end(), IsFinitePoint) &&
      std::all_of(
        spline->Weights.begin(), spline->Weights.end(), [](double w) { return w > 0.0 && std::isfinite(w); });
    return isFinite ? "" : "a control point is not finite, or a weight is not positive";
  }
  const auto& offset = std::get<OffsetSurface>(this->Value);
  if (!offset.Basis || offset.Basis->GetIf<OffsetSurface>() || offset.Basis->GetMaxOrder() < 2 ||
    !std::isfinite(offset.Distance))
  {
    return "it is an offset of a surface of which there are no second derivatives";
  }
  this->MaxOrder = 1;
  for (int d = 0; d < 2; ++d)
  {
    this->Domain[d] = offset.Basis->GetDomain(d);
    this->Period[d] = offset.Basis->GetPeriod(d);
  }
  return {};
}

Vector3 GeometricSurface::Evaluate(double s, double t) const
{
  Derivatives result;
  this->Evaluate(s, t, 0, result);
  return result[0][0];
}

void GeometricSurface::Evaluate(double s, double t, int order, Derivatives& result) const
{
  std::visit([&](const auto& value) { EvaluateValue(value, s, t, order, result); }, this->Value);
}

std::vector<double> GeometricSurface::GetBreaks(int direction, double first, double last) const
{
  if (const auto* offset = this->GetIf<OffsetSurface>())
  {
    return offset->Basis->GetBreaks(direction, first, last);
  }
  if (const auto* spline = this->GetIf<SplineSurface>())
  {
    return MakeBreaks(first, last, spline->Basis[direction].Flatten(first, last).Knots);
  }
  const auto* extruded = this->GetIf<ExtrudedSurface>();
  if (extruded && direction == 0)
  {
    return extruded->Profile->GetBreaks(first, last);
  }
  const auto* revolved = this->GetIf<RevolvedSurface>();
  if (revolved && direction == 1)
  {
    return revolved->Profile->GetBreaks(first, last);
  }
  return { first, last };
}
}
