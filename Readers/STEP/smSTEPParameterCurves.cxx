#include "smSTEPParameterCurves.h"

#include "Geometry/smCurveFoot.h"
#include "Geometry/smGeometryTransform.h"
#include "smFirstOfSeveral.h"
#include "smFormat.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Parameter curves may lie this far away from their edges, relative to the size of all: the default of
/// vtkSurfaceIntegralBase::SetGapLimit().
constexpr double GapLimit = 1e-3;

/// Up to this distance, relative to the size of all, a parameter curve may be a rough approximation; of 23
/// real files with parameter curves one has such that are 2e-3 away, and none has larger ones.
constexpr double ApproximationLimit = 1e-2;

/// Parameter curves may be moved by this many whole periods.
constexpr int MaxTurns = 2;

/// A parameter curve on its surface, searched for its point that is closest to another one.
class CurveSearch
{
public:
  CurveSearch(const STEPParameterCurve& stated, const CurvePointer<2>& curve, const ParameterRange& range)
    : Stated(stated)
    , Curve(*curve)
    , Range(range)
    , IsSphere(IsKind(ElementarySurface::Type::Sphere))
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Period[d] = stated.Surface->GetPeriod(d);
    }
    // Beyond a pole the formula continues on the other side.
    this->Period[1] = this->IsSphere ? this->Period[0] : this->Period[1];
  }

  /// Returns the distance of a point from the point at the same parameter or, if that is above `limit`, of
  /// its foot on the surface from the whole curve. A point that is farther than that from the surface has a
  /// gap there, which is reported elsewhere, and no distance.
  double GetDistance(const Vector3& point, double t, double limit) const
  {
    const bool isInside = t >= this->Range.Low && t <= this->Range.High;
    double least =
      isInside ? Norm(Subtract(this->Evaluate(t), point)) : std::numeric_limits<double>::infinity();
    std::array<double, 2> uv{};
    if (least <= limit || !this->FindFoot(point, uv))
    {
      return least <= limit ? least : 0.0;
    }
    const Vector3 foot = this->Stated.Surface->Evaluate(uv[0], uv[1]);
    if (Norm(Subtract(foot, point)) > limit)
    {
      return 0.0;
    }
    const int turns[2] = { this->Period[0] > 0.0 ? MaxTurns : 0, this->Period[1] > 0.0 ? MaxTurns : 0 };
    for (int i = -turns[0]; i <= turns[0]; ++i)
    {
      for (int k = -turns[1]; k <= turns[1]; ++k)
      {
        this->Approach({ uv[0] + i * this->Period[0], uv[1] + k * this->Period[1] }, foot, least);
        if (this->IsSphere)
        {
          this->Approach(
            { uv[0] + (i + 0.5) * this->Period[0], (k + 0.5) * this->Period[1] - uv[1] }, foot, least);
        }
      }
    }
    return least;
  }

private:
  bool IsKind(ElementarySurface::Type kind) const
  {
    const auto* elementary = this->Stated.Surface->GetIf<ElementarySurface>();
    return elementary && elementary->Kind == kind;
  }

  bool FindFoot(const Vector3& point, std::array<double, 2>& uv) const
  {
    if (IsKind(ElementarySurface::Type::Plane))
    {
      const GeometricFrame& frame = this->Stated.Surface->GetIf<ElementarySurface>()->Frame;
      const Vector3 away = Subtract(point, frame.Origin);
      uv = { Dot(away, frame.Axes[0]), Dot(away, frame.Axes[1]) };
      return true;
    }
    return this->Stated.Finder && this->Stated.Finder->Find(point, nullptr, uv.data());
  }

  Vector3 Evaluate(double t) const
  {
    const std::array<double, 2> uv = this->Curve.Evaluate(t);
    return this->Stated.Surface->Evaluate(uv[0], uv[1]);
  }

  /// Lowers `least` to the distance of `foot` from the curve near its point that is closest to `uv` in the
  /// parameters, where a unit of u may be longer than one of v.
  void Approach(const std::array<double, 2>& uv, const Vector3& foot, double& least) const
  {
    double nearest = FindCurveParameter<2>(this->Curve, uv);
    if (!std::isfinite(nearest))
    {
      return;
    }
    // The foot on a conic is stated between -pi and pi, the range of the curve may begin anywhere.
    const double period = this->Curve.GetPeriod();
    if (period > 0.0)
    {
      nearest -= std::floor((nearest - this->Range.Low) / period) * period;
      const double before = this->Range.Low + period - nearest;
      nearest = before < nearest - this->Range.High ? this->Range.Low : nearest;
    }
    const double start = std::clamp(nearest, this->Range.Low, this->Range.High);
    const double width = this->Range.High - this->Range.Low;
    const double reach = 0.125 * (std::isfinite(width) ? width : std::abs(start));
    constexpr double ratio = 0.6180339887498949;
    constexpr int steps = 40;
    const auto measure = [&](double t) { return Norm(Subtract(this->Evaluate(t), foot)); };
    double low = std::max(this->Range.Low, start - reach);
    double high = std::min(this->Range.High, start + reach);
    least = std::min({ least, measure(start), measure(low), measure(high) });
    for (int i = 0; i < steps; ++i)
    {
      const double inner[2] = { high - ratio * (high - low), low + ratio * (high - low) };
      const double distance[2] = { measure(inner[0]), measure(inner[1]) };
      least = std::min({ least, distance[0], distance[1] });
      (distance[0] < distance[1] ? high : low) = distance[0] < distance[1] ? inner[1] : inner[0];
    }
  }

  const STEPParameterCurve& Stated;
  const GeometricCurve<2>& Curve;
  ParameterRange Range;
  bool IsSphere;
  double Period[2];
};

double GetMaxDistance(
  const STEPParameterCurve& stated, const CurvePointer<2>& curve, const ParameterRange& range, double limit)
{
  const CurveSearch search(stated, curve, range);
  double largest = 0.0;
  for (std::size_t i = 0; i < stated.Points.size(); ++i)
  {
    largest = std::max(largest, search.GetDistance(stated.Points[i], stated.Parameters[i], limit));
  }
  return largest;
}

/// Returns the curve as it is if its angles are radians; null if there are none.
CurvePointer<2> TakeRadians(const STEPParameterCurve& stated, ParameterScale& own)
{
  using Type = ElementarySurface::Type;
  const auto* elementary = stated.Surface->GetIf<ElementarySurface>();
  if (!elementary || elementary->Kind == Type::Plane || stated.Angle == 1.0)
  {
    return nullptr;
  }
  const bool isBoth = elementary->Kind == Type::Sphere || elementary->Kind == Type::Torus;
  AffineTransform<2> transform;
  transform.Linear[0][0] = 1.0 / stated.Angle;
  transform.Linear[1][1] = isBoth ? 1.0 / stated.Angle : 1.0;
  std::string problem;
  return TransformCurve<2>(stated.Curve.Value, transform, own, problem);
}

double Measure(const STEPParameterCurve& stated, double limit)
{
  double distance = GetMaxDistance(stated, stated.Curve.Value, stated.Curve.Range, limit);
  ParameterScale own;
  const CurvePointer<2> other = distance > limit ? TakeRadians(stated, own) : nullptr;
  if (other)
  {
    STEPParameterCurve radians = stated;
    for (double& t : radians.Parameters)
    {
      t = own(t);
    }
    const ParameterRange range{ own(stated.Curve.Range.Low), own(stated.Curve.Range.High) };
    distance = std::min(distance, GetMaxDistance(radians, other, range, limit));
  }
  return distance;
}
}

double STEPParameterCurve::GetDistance() const
{
  double largest = 0.0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const std::array<double, 2> uv = this->Curve.Value->Evaluate(this->Parameters[i]);
    largest = std::max(largest, Norm(Subtract(this->Surface->Evaluate(uv[0], uv[1]), this->Points[i])));
  }
  return largest;
}

void ReportParameterCurves(const std::vector<STEPParameterCurve>& curves, double size,
  std::vector<std::string>& messages, std::vector<std::string>& defects)
{
  FirstOfSeveral contradictory;
  FirstOfSeveral rough;
  for (const STEPParameterCurve& curve : curves)
  {
    const bool isExamined =
      curve.Surface->GetIf<ElementarySurface>() || curve.Surface->GetIf<SplineSurface>();
    const double distance = isExamined ? Measure(curve, GapLimit * size) : 0.0;
    if (!(distance > GapLimit * size))
    {
      continue;
    }
    (curve.IsPreferred && distance > ApproximationLimit * size ? contradictory : rough)
      .Add(
        [&]()
        {
          return "Edge #" + std::to_string(curve.Edge) + " of the file: its parameter curve #" +
            std::to_string(curve.Id) + " lies " + FormatDistance(distance) + " mm from its curve #" +
            std::to_string(curve.SpaceCurve) +
            (curve.IsPreferred ? ", which is taken, although the file prefers the parameter curve."
                               : ", which is taken.");
        });
  }
  contradictory.Report(defects);
  rough.Report(messages);
}
}
