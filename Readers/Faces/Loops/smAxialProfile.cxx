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

/// Poles are one if they are closer than this, relative to the range of parameters.
constexpr double PoleWidth = 1e-6;

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

/// Finds the zeros of the signed distance of a profile from the axis, which a profile in a plane with the
/// axis has. On a short interval the cubic with the values and slopes of its ends is the distance, except
/// for a multiple of the difference in the middle.
class ZeroFinder
{
public:
  /// `direction` is normal to the axis. Distances of less than `rounding` are zero.
  ZeroFinder(const RevolvedSurface& surface, const Vector3& direction, double rounding, double minWidth)
    : Surface(surface)
    , Direction(direction)
    , Rounding(rounding)
    , MinWidth(minWidth)
  {
  }

  /// Returns a parameter near each zero in the intervals between ascending parameters, in their order; the
  /// same zero may be found several times.
  std::vector<double> Find(const std::vector<double>& ends)
  {
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      // The curve may have a corner at an end: the slope is that inside.
      const double inset = 1e-9 * (ends[i + 1] - ends[i]);
      if (inset > 0.0)
      {
        this->Search(this->Sample(ends[i], inset), this->Sample(ends[i + 1], -inset));
      }
    }
    return std::move(this->Zeros);
  }

private:
  struct Distance
  {
    double Parameter;
    double Value;
    double Slope;
  };

  double GetValue(double t) const
  {
    return Dot(Subtract(this->Surface.Profile->Evaluate(t), this->Surface.Origin), this->Direction);
  }

  Distance Sample(double t, double inset = 0.0) const
  {
    GeometricCurve<3>::Derivatives curve;
    this->Surface.Profile->Evaluate(t + inset, 1, curve);
    return { t, this->GetValue(t), Dot(curve[1], this->Direction) };
  }

  void Search(const Distance& low, const Distance& high)
  {
    const double third = (high.Parameter - low.Parameter) / 3.0;
    const double c[4] = { low.Value, low.Value + third * low.Slope, high.Value - third * high.Slope,
      high.Value };
    const Distance middle = this->Sample(0.5 * (low.Parameter + high.Parameter));
    const double margin =
      this->Rounding + 4.0 * std::abs(middle.Value - 0.125 * (c[0] + 3.0 * (c[1] + c[2]) + c[3]));
    const auto [minimum, maximum] = std::minmax_element(c, c + 4);
    if (!std::isfinite(margin) || *minimum > margin || *maximum < -margin)
    {
      return;
    }
    const double steps[3] = { c[1] - c[0], c[2] - c[1], c[3] - c[2] };
    const auto [minStep, maxStep] = std::minmax_element(steps, steps + 3);
    const bool isMonotonic = *minStep >= margin || *maxStep <= -margin;
    const bool isSmall = 3.0 * third <= this->MinWidth || std::max(-*minimum, *maximum) <= this->Rounding;
    const Distance& nearest = std::abs(low.Value) < std::abs(high.Value) ? low : high;
    if (!isSmall && !isMonotonic)
    {
      this->Search(low, middle);
      this->Search(middle, high);
    }
    else if ((low.Value < 0.0) != (high.Value < 0.0))
    {
      this->Zeros.push_back(this->Bisect(low, high));
    }
    else if (isSmall || std::abs(nearest.Value) <= this->Rounding)
    {
      this->Zeros.push_back(nearest.Parameter);
    }
  }

  double Bisect(const Distance& from, const Distance& to) const
  {
    double low = from.Parameter;
    double high = to.Parameter;
    for (double t = 0.5 * (low + high); low < t && t < high; t = 0.5 * (low + high))
    {
      ((this->GetValue(t) < 0.0) == (from.Value < 0.0) ? low : high) = t;
    }
    return high;
  }

  const RevolvedSurface& Surface;
  const Vector3 Direction;
  const double Rounding;
  const double MinWidth;
  std::vector<double> Zeros;
};
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

std::vector<double> AxialProfile::FindZeros() const
{
  const GeometricCurve<3>& curve = *this->Surface->Profile;
  const auto widest = std::max_element(this->Points.begin(), this->Points.end(),
    [](const Point& a, const Point& b) { return a.Radius < b.Radius; });
  const Vector3 point = curve.Evaluate(this->Parameters[widest - this->Points.begin()]);
  const Vector3 away = Subtract(point, this->Surface->Origin);
  const Vector3 direction = Subtract(away, Multiply(Dot(away, this->Surface->Axis), this->Surface->Axis));
  std::vector<double> zeros;
  if (curve.GetMaxOrder() < 1 || !(Norm(direction) > 0.0))
  {
    return zeros;
  }
  const double range = this->Last - this->First;
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() *
    (this->Extent + Norm(point) + Norm(this->Surface->Origin));
  std::vector<double> ends = curve.GetBreaks(this->First, this->Last);
  ends.insert(ends.end(), this->Parameters.begin(), this->Parameters.end());
  std::sort(ends.begin(), ends.end());
  // Returns true if two zeros are one pole: the profile does not leave the axis between them.
  const auto isSame = [&](double a, double b)
  {
    const double t = Minimize([this](double x) { return -this->Evaluate(x).Radius; }, a, b);
    const double radius = std::max(this->Evaluate(t).Radius, this->Evaluate(0.5 * (a + b)).Radius);
    return radius <= (b - a <= PoleWidth * range ? AxisTolerance * this->Extent : rounding);
  };
  for (const double t :
    ZeroFinder(*this->Surface, Normalized(direction), rounding, 0.1 * PoleWidth * range).Find(ends))
  {
    const bool isEnd = !this->IsPeriodic && (isSame(this->First, t) || isSame(t, this->Last));
    if (this->MeetsAxis(t) && !isEnd && (zeros.empty() || !isSame(zeros.back(), t)))
    {
      zeros.push_back(t);
    }
  }
  if (this->IsPeriodic && zeros.size() > 1 && isSame(zeros.back(), zeros.front() + range))
  {
    zeros.pop_back();
  }
  return zeros;
}

std::vector<double> AxialProfile::FindPoles() const
{
  std::vector<double> poles;
  const std::vector<double> zeros = this->FindZeros();
  std::vector<bool> isPole(zeros.size(), true);
  const double range = this->Last - this->First;
  const int count = static_cast<int>(this->Points.size()) - 1;
  for (int i = this->IsPeriodic ? 0 : 1; i < count; ++i)
  {
    const double here = this->Points[i].Radius;
    const double before = this->Points[i > 0 ? i - 1 : count - 1].Radius;
    const double after = this->Points[i + 1].Radius;
    const double step = range / count;
    const auto isInside = [&](double t)
    {
      const double offset = std::abs(t - this->Parameters[i]);
      return std::min(offset, this->IsPeriodic ? range - offset : offset) <= step;
    };
    if (!(here <= before && here <= after) || std::count_if(zeros.begin(), zeros.end(), isInside) > 1)
    {
      continue;
    }
    const double t = Minimize([this](double x) { return this->Evaluate(x).Radius; },
      this->Parameters[i] - step, this->Parameters[i] + step);
    if (this->MeetsAxis(t))
    {
      const double slack = 1e-9 * range;
      const double inside = t < this->First - slack ? t + range : t > this->Last - slack ? t - range : t;
      poles.push_back(this->IsPeriodic ? std::max(inside, this->First) : t);
      for (std::size_t k = 0; k < zeros.size(); ++k)
      {
        isPole[k] = isPole[k] && !isInside(zeros[k]);
      }
    }
  }
  std::sort(poles.begin(), poles.end());
  poles.erase(std::unique(poles.begin(), poles.end(),
                [range](double a, double b) { return b - a <= PoleWidth * range; }),
    poles.end());
  for (std::size_t k = 0; k < zeros.size(); ++k)
  {
    if (isPole[k])
    {
      poles.push_back(zeros[k]);
    }
  }
  std::sort(poles.begin(), poles.end());
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
