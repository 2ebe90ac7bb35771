#include "smOCCTAxialProfile.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>

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

Handle(Geom_Curve) GetUntrimmed(Handle(Geom_Curve) curve)
{
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

Handle(Geom_SurfaceOfRevolution) RevolveTorus(const Handle(Geom_ToroidalSurface) & torus)
{
  const gp_Ax3& frame = torus->Position();
  const gp_XYZ center = frame.Location().XYZ() + torus->MajorRadius() * frame.XDirection().XYZ();
  // The circle runs from X to Z; a mirrored frame turns the other way round its axis.
  const gp_Ax2 plane(center, frame.XDirection().Crossed(frame.Direction()), frame.XDirection());
  return new Geom_SurfaceOfRevolution(new Geom_Circle(plane, torus->MinorRadius()),
    gp_Ax1(frame.Location(), frame.Direct() ? frame.Direction() : frame.Direction().Reversed()));
}

AxialProfile::AxialProfile(const Handle(Geom_SurfaceOfRevolution) & surface)
  : Curve(surface->BasisCurve())
  , Axis(surface->Axis())
  , First(this->Curve->FirstParameter())
  , Last(this->Curve->LastParameter())
{
  if (this->IsFinite())
  {
    const Handle(Geom_Curve) basis = GetUntrimmed(this->Curve);
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(basis);
    const int count = spline.IsNull() ? 128 : std::clamp(16 * (spline->NbKnots() - 1), 128, 1024);
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
  return !Precision::IsInfinite(this->First) && !Precision::IsInfinite(this->Last);
}

AxialProfile::Point AxialProfile::Locate(const gp_Pnt& point) const
{
  const gp_Vec away(this->Axis.Location(), point);
  const double height = away.Dot(gp_Vec(this->Axis.Direction()));
  return { away.Crossed(gp_Vec(this->Axis.Direction())).Magnitude(), height };
}

bool AxialProfile::MeetsAxis(double t) const
{
  return this->Evaluate(t).Radius <= AxisTolerance * this->Extent;
}

std::vector<double> AxialProfile::FindPoles() const
{
  std::vector<double> poles;
  const double range = this->Last - this->First;
  const bool isPeriodic = this->Curve->IsPeriodic();
  const int count = static_cast<int>(this->Points.size()) - 1;
  for (int i = isPeriodic ? 0 : 1; i < count; ++i)
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
      poles.push_back(isPeriodic ? std::max(inside, this->First) : t);
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
  double least = std::numeric_limits<double>::infinity();
  double nearest = first;
  for (int i = 0; i <= count; ++i)
  {
    const double t = first + (last - first) * i / count;
    const double distance = measure(t);
    if (distance < least)
    {
      least = distance;
      nearest = t;
    }
  }
  const double step = (last - first) / count;
  return std::min(
    least, measure(Minimize(measure, std::max(first, nearest - step), std::min(last, nearest + step))));
}
}
