#include "smGeometryTransform.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Largest difference of lengths and angles of the columns of a similarity.
constexpr double SimilarityRounding = 1e-9;

template <std::size_t Dimension>
double GetLength(const std::array<double, Dimension>& v)
{
  double square = 0.0;
  for (const double x : v)
  {
    square += x * x;
  }
  return std::sqrt(square);
}

template <std::size_t Dimension>
std::array<double, Dimension> Divide(std::array<double, Dimension> v, double divisor)
{
  for (double& x : v)
  {
    x /= divisor;
  }
  return v;
}

/// Transforms the values of a curve; each returns a reason, or an empty text.
template <int Dimension>
class CurveTransformer
{
public:
  using Variant = typename GeometricCurve<Dimension>::Variant;

  explicit CurveTransformer(const AffineTransform<Dimension>& transform)
    : Transform(transform)
  {
  }

  ParameterScale Parameter;
  Variant Result;

  std::string operator()(const LineCurve<Dimension>& line)
  {
    const auto direction = this->Transform.MapVector(line.Direction);
    const double length = GetLength(direction);
    this->Parameter.Scale = length;
    this->Result = LineCurve<Dimension>{ this->Transform.MapPoint(line.Origin), Divide(direction, length) };
    return length > 0.0 ? "" : "its image has no length";
  }

  std::string operator()(ConicCurve<Dimension> conic)
  {
    const double scale = this->Transform.GetScale();
    conic.Center = this->Transform.MapPoint(conic.Center);
    conic.X = this->Transform.MapVector(conic.X);
    conic.Y = this->Transform.MapVector(conic.Y);
    if (scale > 0.0)
    {
      // With C + t^2/(4 f) X + t Y, the image of t Y has the parameter scale t.
      conic.X = Divide(conic.X, scale);
      conic.Y = Divide(conic.Y, scale);
      conic.Radii[0] *= scale;
      conic.Radii[1] *= scale;
      this->Parameter.Scale = conic.Kind == ConicCurve<Dimension>::Type::Parabola ? scale : 1.0;
    }
    this->Result = conic;
    return {};
  }

  std::string operator()(SplineCurve<Dimension> spline)
  {
    for (auto& pole : spline.Poles)
    {
      pole = this->Transform.MapPoint(pole);
    }
    this->Result = std::move(spline);
    return {};
  }

  std::string operator()(OffsetCurve<Dimension> offset)
  {
    const double scale = this->Transform.GetScale();
    std::string problem;
    offset.Basis = TransformCurve<Dimension>(offset.Basis, this->Transform, this->Parameter, problem);
    if (!(scale > 0.0) || !offset.Basis)
    {
      return problem.empty() ? "it is an offset curve whose image is none" : problem;
    }
    // A reflection turns the sense of the vector product.
    offset.Distance *= this->Transform.IsMirrored() ? -scale : scale;
    offset.Reference = Divide(this->Transform.MapVector(offset.Reference), scale);
    this->Result = std::move(offset);
    return {};
  }

  std::string operator()(CompositeCurve<Dimension> composite)
  {
    for (CurveSegment<Dimension>& segment : composite.Segments)
    {
      ParameterScale own;
      std::string problem;
      segment.Curve = TransformCurve<Dimension>(segment.Curve, this->Transform, own, problem);
      if (!segment.Curve)
      {
        return problem;
      }
      segment.First = own(segment.First);
      segment.Last = own(segment.Last);
    }
    this->Result = std::move(composite);
    return {};
  }

  std::string operator()(CurveOnSurface onSurface)
  {
    if constexpr (Dimension == 3)
    {
      ParameterScale parameters[2];
      std::string problem;
      onSurface.Surface = TransformSurface(onSurface.Surface, this->Transform, parameters, problem);
      if (!onSurface.Surface)
      {
        return problem;
      }
      AffineTransform<2> plane;
      for (int d = 0; d < 2; ++d)
      {
        plane.Linear[d][d] = parameters[d].Scale;
        plane.Translation[d] = parameters[d].Offset;
      }
      onSurface.Curve = TransformCurve<2>(onSurface.Curve, plane, this->Parameter, problem);
      this->Result = std::move(onSurface);
      return problem;
    }
    return "it is on a surface";
  }

private:
  const AffineTransform<Dimension>& Transform;
};

/// Transforms the values of a surface likewise.
class SurfaceTransformer
{
public:
  SurfaceTransformer(const AffineTransform<3>& transform, ParameterScale parameters[2])
    : Transform(transform)
    , Scale(transform.GetScale())
    , Parameters(parameters)
  {
  }

  GeometricSurface::Variant Result;

  std::string operator()(ElementarySurface elementary)
  {
    using Type = ElementarySurface::Type;
    elementary.Frame.Origin = this->Transform.MapPoint(elementary.Frame.Origin);
    for (Vector3& axis : elementary.Frame.Axes)
    {
      axis = Divide(this->Transform.MapVector(axis), this->Scale);
    }
    elementary.Radii[0] *= this->Scale;
    elementary.Radii[1] *= this->Scale;
    const bool isPlane = elementary.Kind == Type::Plane;
    const bool isRuled = isPlane || elementary.Kind == Type::Cylinder || elementary.Kind == Type::Cone;
    this->Parameters[0].Scale = isPlane ? this->Scale : 1.0;
    this->Parameters[1].Scale = isRuled ? this->Scale : 1.0;
    this->Result = elementary;
    return {};
  }

  std::string operator()(ExtrudedSurface extruded)
  {
    extruded.Direction = Divide(this->Transform.MapVector(extruded.Direction), this->Scale);
    this->Parameters[1].Scale = this->Scale;
    return this->TakeProfile(std::move(extruded), this->Parameters[0]);
  }

  std::string operator()(RevolvedSurface revolved)
  {
    revolved.Origin = this->Transform.MapPoint(revolved.Origin);
    // A reflection turns the sense of the angle, which the opposite axis restores.
    revolved.Axis = Divide(
      this->Transform.MapVector(revolved.Axis), this->Transform.IsMirrored() ? -this->Scale : this->Scale);
    return this->TakeProfile(std::move(revolved), this->Parameters[1]);
  }

  std::string operator()(SplineSurface spline)
  {
    for (Vector3& pole : spline.Poles)
    {
      pole = this->Transform.MapPoint(pole);
    }
    this->Result = std::move(spline);
    return {};
  }

  std::string operator()(OffsetSurface offset)
  {
    std::string problem;
    offset.Basis = TransformSurface(offset.Basis, this->Transform, this->Parameters, problem);
    // A reflection turns the sense of the vector product that gives the normal.
    offset.Distance *= this->Transform.IsMirrored() ? -this->Scale : this->Scale;
    this->Result = std::move(offset);
    return problem;
  }

private:
  template <class Swept>
  std::string TakeProfile(Swept swept, ParameterScale& parameter)
  {
    std::string problem;
    swept.Profile = TransformCurve<3>(swept.Profile, this->Transform, parameter, problem);
    swept.Range.Low = parameter(swept.Range.Low);
    swept.Range.High = parameter(swept.Range.High);
    this->Result = std::move(swept);
    return problem;
  }

  const AffineTransform<3>& Transform;
  const double Scale;
  ParameterScale* Parameters;
};
}

template <int Dimension>
auto AffineTransform<Dimension>::MapVector(const std::array<double, Dimension>& v) const
  -> std::array<double, Dimension>
{
  std::array<double, Dimension> result{};
  for (int i = 0; i < Dimension; ++i)
  {
    for (int j = 0; j < Dimension; ++j)
    {
      result[i] += this->Linear[i][j] * v[j];
    }
  }
  return result;
}

template <int Dimension>
auto AffineTransform<Dimension>::MapPoint(const std::array<double, Dimension>& p) const
  -> std::array<double, Dimension>
{
  std::array<double, Dimension> result = this->MapVector(p);
  for (int i = 0; i < Dimension; ++i)
  {
    result[i] += this->Translation[i];
  }
  return result;
}

template <int Dimension>
double AffineTransform<Dimension>::GetScale() const
{
  double scale = 0.0;
  double worst = 0.0;
  for (int j = 0; j < Dimension; ++j)
  {
    for (int k = j; k < Dimension; ++k)
    {
      double product = 0.0;
      for (int i = 0; i < Dimension; ++i)
      {
        product += this->Linear[i][j] * this->Linear[i][k];
      }
      scale = j + k == 0 ? product : scale;
      worst = std::max(worst, std::abs(product - (j == k ? scale : 0.0)));
    }
  }
  return worst <= SimilarityRounding * scale ? std::sqrt(scale) : 0.0;
}

template <int Dimension>
bool AffineTransform<Dimension>::IsMirrored() const
{
  const auto& m = this->Linear;
  if constexpr (Dimension == 2)
  {
    return m[0][0] * m[1][1] - m[0][1] * m[1][0] < 0.0;
  }
  else
  {
    return Dot(m[0], Cross(m[1], m[2])) < 0.0;
  }
}

template <int Dimension>
CurvePointer<Dimension> TransformCurve(const CurvePointer<Dimension>& curve,
  const AffineTransform<Dimension>& transform, ParameterScale& parameter, std::string& problem)
{
  CurveTransformer<Dimension> transformer(transform);
  problem = std::visit(
    [&transformer](const auto& value)
    {
      // std::decay_t<> makes the copy that the transformer changes.
      return transformer(std::decay_t<decltype(value)>(value));
    },
    curve->GetValue());
  parameter = transformer.Parameter;
  return problem.empty() ? GeometricCurve<Dimension>::Make(std::move(transformer.Result), problem) : nullptr;
}

SurfacePointer TransformSurface(const SurfacePointer& surface, const AffineTransform<3>& transform,
  ParameterScale parameters[2], std::string& problem)
{
  parameters[0] = parameters[1] = ParameterScale();
  if (!(transform.GetScale() > 0.0))
  {
    problem = "its map is not a similarity";
    return nullptr;
  }
  SurfaceTransformer transformer(transform, parameters);
  problem = std::visit([&transformer](const auto& value)
    { return transformer(std::decay_t<decltype(value)>(value)); },
    surface->GetValue());
  return problem.empty() ? GeometricSurface::Make(std::move(transformer.Result), problem) : nullptr;
}

template struct AffineTransform<2>;
template struct AffineTransform<3>;
template CurvePointer<2> TransformCurve<2>(
  const CurvePointer<2>&, const AffineTransform<2>&, ParameterScale&, std::string&);
template CurvePointer<3> TransformCurve<3>(
  const CurvePointer<3>&, const AffineTransform<3>&, ParameterScale&, std::string&);
}
