#include "smAxialProfile.h"

#include "Geometry/smPlacement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// A profile meets the axis if it is closer than this, relative to its extent: the tolerance of
/// FootPointFinder's poles.
constexpr double AxisTolerance = 1e-9;

/// Returns the minimum of a function with one minimum in the interval, which is divided by the golden
/// ratio.
template <class Function>
double Minimize(const Function& f, double low, double high)
{
  constexpr double ratio = 0.6180339887498949;
  double inner[2] = { high - ratio * (high - low), low + ratio * (high - low) };
  double values[2] = { f(inner[0]), f(inner[1]) };
  for (int i = 0; i < 80 && inner[0] < inner[1]; ++i)
  {
    if (values[0] < values[1])
    {
      high = inner[1];
      inner[1] = inner[0];
      values[1] = values[0];
      inner[0] = high - ratio * (high - low);
      values[0] = f(inner[0]);
    }
    else
    {
      low = inner[0];
      inner[0] = inner[1];
      values[0] = values[1];
      inner[1] = low + ratio * (high - low);
      values[1] = f(inner[1]);
    }
  }
  return values[0] < values[1] ? inner[0] : inner[1];
}

}

SurfacePointer RevolveTorus(const ElementarySurface& torus, const ParameterRange& range)
{
  const std::array<Vector3, 3>& axes = torus.Frame.Axes;
  // The circle runs from X to Z; a mirrored frame turns the other way round its axis.
  const double sign = Dot(Cross(axes[0], axes[1]), axes[2]) > 0.0 ? 1.0 : -1.0;
  ConicCurve<3> circle;
  circle.Center = Sum(torus.Frame.Origin, Multiply(torus.Radii[0], axes[0]));
  circle.X = axes[0];
  circle.Y = axes[2];
  circle.Radii[0] = circle.Radii[1] = torus.Radii[1];
  std::string problem;
  return GeometricSurface::Make(RevolvedSurface{ GeometricCurve<3>::Make(circle, problem), range,
                                  torus.Frame.Origin, Multiply(sign, axes[2]) },
    problem);
}

AxialProfile::AxialProfile(const GeometricSurface& surface)
  : Surface(surface.GetIf<RevolvedSurface>())
  , IsPeriodic(surface.GetPeriod(1) > 0.0)
  , First(surface.GetDomain(1).Low)
  , Last(surface.GetDomain(1).High)
{
  if (this->IsFinite())
  {
    const auto* spline = this->Surface->Profile->GetIf<SplineCurve<3>>();
    const int count =
      spline ? std::clamp(16 * (static_cast<int>(spline->Basis.Knots.size()) - 1), 128, 1024) : 128;
    double low[2] = { 1e300, 1e300 };
    double high[2] = { -1e300, -1e300 };
    for (int i = 0; i <= count; ++i)
    {
      this->Parameters.push_back(this->First + (this->Last - this->First) * i / count);
      const Point p = this->Evaluate(this->Parameters.back());
      this->Points.push_back(p);
      low[0] = std::min(low[0], p.Height);
      high[0] = std::max(high[0], p.Height);
      high[1] = std::max(high[1], p.Radius);
    }
    this->Extent = std::hypot(high[0] - low[0], high[1]);
  }
}

bool AxialProfile::IsFinite() const
{
  return std::isfinite(this->First) && std::isfinite(this->Last);
}

AxialProfile::Point AxialProfile::Locate(const Vector3& point) const
{
  const Vector3 away = Subtract(point, this->Surface->Origin);
  return { Norm(Cross(away, this->Surface->Axis)), Dot(away, this->Surface->Axis) };
}

bool AxialProfile::MeetsAxis(double t) const
{
  return this->Evaluate(t).Radius <= AxisTolerance * this->Extent;
}

std::vector<double> AxialProfile::FindPoles() const
{
  std::vector<double> poles;
  const double range = this->Last - this->First;
  const int count = static_cast<int>(this->Points.size()) - 1;
  for (int i = this->IsPeriodic ? 0 : 1; i < count; ++i)
  {
    const double here = this->Points[i].Radius;
    const double before = this->Points[i > 0 ? i - 1 : count - 1].Radius;
    const double after = this->Points[i + 1].Radius;
    if (!(here <= before && here <= after))
    {
      continue;
    }
    const double step = range / count;
    const double t = Minimize([this](double x) { return this->Evaluate(x).Radius; },
      this->Parameters[i] - step, this->Parameters[i] + step);
    if (this->MeetsAxis(t))
    {
      const double slack = 1e-9 * range;
      const double inside = t < this->First - slack ? t + range : t > this->Last - slack ? t - range : t;
      poles.push_back(this->IsPeriodic ? std::max(inside, this->First) : t);
    }
  }
  std::sort(poles.begin(), poles.end());
  poles.erase(
    std::unique(poles.begin(), poles.end(), [range](double a, double b) { return b - a <= 1e-6 * range; }),
    poles.end());
  return poles;
}

double AxialProfile::GetDistance(const Point& point, double first, double last) const
{
  constexpr int count = 64;
  const auto measure = [&](double t)
  {
    const Point p = this->Evaluate(t);
    return std::hypot(p.Radius - point.Radius, p.Height - point.Height);
  };
  double minimum = std::numeric_limits<double>::infinity();
  double nearest = first;
  for (int i = 0; i <= count; ++i)
  {
    const double t = first + (last - first) * i / count;
    const double distance = measure(t);
    if (distance < minimum)
    {
      minimum = distance;
      nearest = t;
    }
  }
  const double step = (last - first) / count;
  return std::min(
    minimum, measure(Minimize(measure, std::max(first, nearest - step), std::min(last, nearest + step))));
}
}
