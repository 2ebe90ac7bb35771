#include "smFootPoint.h"

#include "Geometry/smPlacement.h"
#include "smUnitRoundoff.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace sm
{
namespace
{
/// Largest distance of foot points beyond the border of the domain, relative to its width.
constexpr double Margin = 0.01;

/// Borders of a surface within this distance, in millimetres, are the same.
constexpr double SameBorder = 1e-7;

/// Number of points at which borders are compared.
constexpr int BorderSamples = 12;

/// Returns an angle between 0 and a whole turn.
double GetAngle(double y, double x)
{
  const double angle = x == 0.0 && y == 0.0 ? 0.0 : std::atan2(y, x);
  return angle < -1e-16 ? angle + 2.0 * vtkMath::Pi() : std::max(angle, 0.0);
}

/// Finds foot points on cylinders, cones, spheres and tori in closed form.
class ElementaryFinder : public FootPointFinder
{
public:
  ElementaryFinder(const SurfacePointer& surface, const ElementarySurface& value)
    : FootPointFinder(surface)
    , Value(value)
  {
    if (value.Kind == ElementarySurface::Type::Cone)
    {
      this->Poles.push_back({ 1, -value.Radii[0] / std::sin(value.Angle) });
    }
    else if (value.Kind == ElementarySurface::Type::Sphere)
    {
      this->Poles = { { 1, -0.5 * vtkMath::Pi() }, { 1, 0.5 * vtkMath::Pi() } };
    }
  }

  bool Find(const Vector3& point, const double* guess, double uv[2]) const override
  {
    const Vector3 away = Subtract(point, this->Value.Frame.Origin);
    const double x = Dot(away, this->Value.Frame.Axes[0]);
    const double y = Dot(away, this->Value.Frame.Axes[1]);
    const double z = Dot(away, this->Value.Frame.Axes[2]);
    uv[0] = GetAngle(y, x);
    switch (this->Value.Kind)
    {
      case ElementarySurface::Type::Cylinder:
        uv[1] = z;
        break;
      case ElementarySurface::Type::Cone:
        this->FindOnCone(x, y, z, uv);
        break;
      case ElementarySurface::Type::Sphere:
        uv[1] = std::atan2(z, std::hypot(x, y));
        break;
      default:
        this->FindOnTorus(std::hypot(x, y), z, uv);
    }
    this->Unroll(guess, uv);
    return std::isfinite(uv[0]) && std::isfinite(uv[1]);
  }

private:
  void FindOnCone(double x, double y, double z, double uv[2]) const
  {
    // Behind the apex the radius is negative.
    if (-this->Value.Radii[0] > z * std::tan(this->Value.Angle))
    {
      uv[0] = GetAngle(-y, -x);
    }
    uv[1] = std::sin(this->Value.Angle) * (x * std::cos(uv[0]) + y * std::sin(uv[0]) - this->Value.Radii[0]) +
      std::cos(this->Value.Angle) * z;
  }

  /// A torus that crosses its axis has a circle on either side of it in each half-plane.
  void FindOnTorus(double radius, double z, double uv[2]) const
  {
    const double major = this->Value.Radii[0];
    const double minor = this->Value.Radii[1];
    const auto measure = [&](double r) { return std::abs(std::hypot(r - major, z) - minor); };
    if (minor > major && measure(-radius) < measure(radius))
    {
      radius = -radius;
      uv[0] += uv[0] < vtkMath::Pi() ? vtkMath::Pi() : -vtkMath::Pi();
    }
    uv[1] = GetAngle(z, radius - major);
  }

  const ElementarySurface Value;
};

/// Finds foot points on any other surface, by Newton's method from a guess or from the nearest one of some
/// points.
class NewtonFinder : public FootPointFinder
{
public:
  using FootPointFinder::FootPointFinder;

  bool Find(const Vector3& point, const double* guess, double uv[2]) const override
  {
    double distance = std::numeric_limits<double>::infinity();
    if (guess)
    {
      uv[0] = guess[0];
      uv[1] = guess[1];
      const Vector3 from = this->Surface->Evaluate(uv[0], uv[1]);
      if (this->Solve(point, uv, distance) && distance <= Norm(Subtract(point, from)) + this->Rounding)
      {
        return true;
      }
    }
    double seed[2];
    if (!this->FindSeed(point, seed))
    {
      return false;
    }
    const bool found = this->Solve(point, seed, distance);
    uv[0] = seed[0];
    uv[1] = seed[1];
    this->Unroll(guess, uv);
    return found;
  }

protected:
  /// Finds parameters near the foot point.
  virtual bool FindSeed(const Vector3& point, double uv[2]) const = 0;

  double Rounding = 0.0;
  double Extent = 1.0;

private:
  /// The search continues a little beyond the border of the domain, so that the foot point of an edge there
  /// is a smooth function.
  double GetLow(int d) const { return this->Low[d] - Margin * (this->High[d] - this->Low[d]); }
  double GetHigh(int d) const { return this->High[d] + Margin * (this->High[d] - this->Low[d]); }

  /// Solves by Gauss-Newton and Newton steps, in a range a little larger than the domain. At the end of the
  /// range steps are taken only along it.
  bool Solve(const Vector3& point, double uv[2], double& distance) const
  {
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60; ++i)
    {
      GeometricSurface::Derivatives at;
      this->Surface->Evaluate(uv[0], uv[1], 1, at);
      const Vector3& foot = at[0][0];
      const Vector3 d[2] = { at[1][0], at[0][1] };
      const Vector3 gap = Subtract(point, foot);
      distance = Norm(gap);
      double step[2];
      this->GetStep(gap, d, uv, step);
      const double length = Norm(Sum(Multiply(step[0], d[0]), Multiply(step[1], d[1])));
      const double rounding = 4.0 * UnitRoundoff * (Norm(foot) + Norm(point));
      if (!std::isfinite(length))
      {
        return false;
      }
      // Convergence is quadratic until rounding stops it. If the foot point is on a border, the last step
      // ends there.
      if (length <= rounding || (i > 2 && length <= 1e-6 * (distance + rounding) && length >= 0.5 * last) ||
        (i > 6 && length <= 1e-9 * this->Extent && length >= 0.5 * last))
      {
        return true;
      }
      last = length;
      for (int k = 0; k < 2; ++k)
      {
        uv[k] = std::clamp(uv[k] + step[k], this->GetLow(k), this->GetHigh(k));
      }
    }
    return last <= 1e-9 * this->Extent;
  }

  void GetStep(const Vector3& gap, const Vector3 d[2], const double uv[2], double step[2]) const
  {
    const double a = Dot(d[0], d[0]);
    const double b = Dot(d[0], d[1]);
    const double c = Dot(d[1], d[1]);
    const double f[2] = { Dot(gap, d[0]), Dot(gap, d[1]) };
    const double determinant = a * c - b * b;
    if (determinant > 1e-14 * a * c)
    {
      step[0] = (c * f[0] - b * f[1]) / determinant;
      step[1] = (a * f[1] - b * f[0]) / determinant;
    }
    else
    {
      step[0] = a >= c && a > 0.0 ? f[0] / a : 0.0;
      step[1] = c > a ? f[1] / c : 0.0;
    }
    for (int k = 0; k < 2; ++k)
    {
      const double squares[2] = { a, c };
      if ((uv[k] <= this->GetLow(k) && step[k] < 0.0) || (uv[k] >= this->GetHigh(k) && step[k] > 0.0))
      {
        step[k] = 0.0;
        step[1 - k] = squares[1 - k] > 0.0 ? f[1 - k] / squares[1 - k] : 0.0;
        const double next = uv[1 - k] + step[1 - k];
        if ((uv[1 - k] <= this->GetLow(1 - k) && next < uv[1 - k]) ||
          (uv[1 - k] >= this->GetHigh(1 - k) && next > uv[1 - k]))
        {
          step[1 - k] = 0.0;
        }
        return;
      }
    }
  }
};

/// Finds seeds on a surface with a finite domain from a grid of points.
class GridFinder : public NewtonFinder
{
public:
  explicit GridFinder(const SurfacePointer& surface)
    : NewtonFinder(surface)
  {
    for (int d = 0; d < 2; ++d)
    {
      const ParameterRange& domain = surface->GetDomain(d);
      const int spans = static_cast<int>(this->Knots[d].size()) + 1;
      this->Count[d] = std::clamp(3 * spans, 12, 60);
      this->First[d] = domain.Low;
      this->Step[d] = (domain.High - domain.Low) / this->Count[d];
    }
    Vector3 low{ 1e300, 1e300, 1e300 };
    Vector3 high{ -1e300, -1e300, -1e300 };
    for (int i = 0; i <= this->Count[0]; ++i)
    {
      for (int j = 0; j <= this->Count[1]; ++j)
      {
        const Vector3 p = surface->Evaluate(this->GetParameter(0, i), this->GetParameter(1, j));
        this->Points.push_back(p);
        for (int c = 0; c < 3; ++c)
        {
          low[c] = std::min(low[c], p[c]);
          high[c] = std::max(high[c], p[c]);
        }
      }
    }
    this->Extent = Norm(Subtract(high, low));
    this->Rounding = 1e-12 * std::max({ this->Extent, Norm(low), Norm(high) });
    this->FindPoles();
  }

protected:
  bool FindSeed(const Vector3& point, double uv[2]) const override
  {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < this->Points.size(); ++k)
    {
      const Vector3 away = Subtract(this->Points[k], point);
      const double square = Dot(away, away);
      if (square < best)
      {
        best = square;
        uv[0] = this->GetParameter(0, static_cast<int>(k) / (this->Count[1] + 1));
        uv[1] = this->GetParameter(1, static_cast<int>(k) % (this->Count[1] + 1));
      }
    }
    return std::isfinite(best);
  }

private:
  double GetParameter(int direction, int i) const
  {
    return this->First[direction] + i * this->Step[direction];
  }

  const Vector3& GetGridPoint(int i, int j) const { return this->Points[i * (this->Count[1] + 1) + j]; }

  /// Finds the borders that are one point.
  void FindPoles()
  {
    for (int d = 0; d < 2; ++d)
    {
      for (const int end : { 0, this->Count[d] })
      {
        double widest = 0.0;
        for (int k = 0; k <= this->Count[1 - d]; ++k)
        {
          const Vector3& p = d == 0 ? this->GetGridPoint(end, k) : this->GetGridPoint(k, end);
          const Vector3& q = d == 0 ? this->GetGridPoint(end, 0) : this->GetGridPoint(0, end);
          widest = std::max(widest, Norm(Subtract(p, q)));
        }
        if (this->Period[d] == 0.0 && widest <= 1e-9 * this->Extent)
        {
          this->Poles.push_back({ d, this->GetParameter(d, end) });
        }
      }
    }
  }

  int Count[2];
  double First[2];
  double Step[2];
  std::vector<Vector3> Points;
};

/// Profile, direction and axis of a swept surface.
struct Sweep
{
  explicit Sweep(const GeometricSurface& surface)
  {
    if (const auto* revolved = surface.GetIf<RevolvedSurface>())
    {
      this->Profile = revolved->Profile;
      this->Direction = revolved->Axis;
      this->Origin = revolved->Origin;
      this->IsRevolved = true;
    }
    else if (const auto* extruded = surface.GetIf<ExtrudedSurface>())
    {
      this->Profile = extruded->Profile;
      this->Direction = extruded->Direction;
    }
  }

  /// Returns the vector from the axis to the point, perpendicular to the axis.
  Vector3 GetRadius(const Vector3& point) const
  {
    const Vector3 difference = Subtract(point, this->Origin);
    return Subtract(difference, Multiply(Dot(difference, this->Direction), this->Direction));
  }

  /// Returns the angle from one point to another one about the axis.
  double GetAngleBetween(const Vector3& from, const Vector3& to) const
  {
    return std::atan2(Dot(Cross(from, to), this->Direction), Dot(from, to));
  }

  CurvePointer<3> Profile;
  Vector3 Direction{};
  Vector3 Origin{};
  bool IsRevolved = false;
};

/// Finds seeds on surfaces of revolution and extrusion, from points of their profile curve; the other
/// coordinate has a closed form.
class SweptFinder : public NewtonFinder
{
public:
  SweptFinder(const SurfacePointer& surface, const Sweep& sweep, const ParameterRange& range)
    : NewtonFinder(surface)
    , Swept(sweep)
  {
    constexpr int count = 128;
    double largest = 0.0;
    for (int i = 0; i <= count; ++i)
    {
      const double t = range.Low + i * (range.High - range.Low) / count;
      this->Profile.push_back({ t, sweep.Profile->Evaluate(t) });
      largest = std::max(largest, Norm(this->Profile.back().second));
      this->Extent = std::max(
        i ? this->Extent : 0.0, Norm(Subtract(this->Profile.back().second, this->Profile[0].second)));
    }
    this->Rounding = 1e-12 * std::max(this->Extent, largest);
    for (const auto& end : { this->Profile.front(), this->Profile.back() })
    {
      if (sweep.IsRevolved && Norm(sweep.GetRadius(end.second)) <= 1e-9 * this->Extent)
      {
        this->Poles.push_back({ 1, end.first });
      }
    }
  }

protected:
  bool FindSeed(const Vector3& point, double uv[2]) const override
  {
    const Vector3 radius = this->Swept.GetRadius(point);
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [t, profile] : this->Profile)
    {
      const Vector3 difference = Subtract(point, profile);
      const double along = Dot(difference, this->Swept.Direction);
      const Vector3 across = Subtract(difference, Multiply(along, this->Swept.Direction));
      const Vector3 from = this->Swept.GetRadius(profile);
      const double square =
        this->Swept.IsRevolved ? along * along + std::pow(Norm(radius) - Norm(from), 2) : Dot(across, across);
      if (square < best)
      {
        best = square;
        uv[0] = this->Swept.IsRevolved ? this->Swept.GetAngleBetween(from, radius) : t;
        uv[1] = this->Swept.IsRevolved ? t : along;
      }
    }
    return std::isfinite(best);
  }

private:
  const Sweep Swept;
  std::vector<std::pair<double, Vector3>> Profile;
};

/// Finds seeds on extrusions and revolutions of a line that has no ends: planes, cylinders, cones and
/// hyperboloids.
class RuledFinder : public NewtonFinder
{
public:
  RuledFinder(const SurfacePointer& surface, const Sweep& sweep, const LineCurve<3>& line)
    : NewtonFinder(surface)
    , Swept(sweep)
    , Line(line)
  {
    this->Rounding = 1e-12 * std::max(1.0, Norm(line.Origin));
    if (sweep.IsRevolved)
    {
      const Vector3 slope = sweep.GetRadius(Sum(sweep.Origin, line.Direction));
      const double square = Dot(slope, slope);
      const double nearest = square > 1e-20 ? -Dot(slope, sweep.GetRadius(line.Origin)) / square : 0.0;
      if (square > 1e-20 && Norm(sweep.GetRadius(this->Evaluate(nearest))) <= this->Rounding)
      {
        this->Poles.push_back({ 1, nearest });
      }
    }
  }

  /// Returns false for the revolution of a line that is perpendicular to its axis: it has points twice.
  static bool IsSupported(const Sweep& sweep, const LineCurve<3>& line)
  {
    return !sweep.IsRevolved || std::abs(Dot(sweep.Direction, line.Direction)) >= 1e-3;
  }

protected:
  /// One Newton step from the origin of a plane is exact; the height of a point on a revolution decides about
  /// the place on the line.
  bool FindSeed(const Vector3& point, double uv[2]) const override
  {
    uv[0] = uv[1] = 0.0;
    if (this->Swept.IsRevolved)
    {
      uv[1] = Dot(Subtract(point, this->Line.Origin), this->Swept.Direction) /
        Dot(this->Line.Direction, this->Swept.Direction);
      uv[0] = this->Swept.GetAngleBetween(
        this->Swept.GetRadius(this->Evaluate(uv[1])), this->Swept.GetRadius(point));
    }
    return true;
  }

private:
  Vector3 Evaluate(double t) const { return Sum(this->Line.Origin, Multiply(t, this->Line.Direction)); }

  const Sweep Swept;
  const LineCurve<3> Line;
};

/// Returns the interior knots; of a periodic direction also those of one more period on both sides.
std::vector<double> CopyKnots(const SplineBasis& basis, double period)
{
  std::vector<double> knots;
  for (const double shift : { -period, 0.0, period })
  {
    for (std::size_t i = period > 0.0 ? 0 : 1; i + 1 < basis.Knots.size(); ++i)
    {
      knots.push_back(basis.Knots[i] + shift);
    }
    if (period == 0.0)
    {
      break;
    }
  }
  return knots;
}

/// Returns true if two opposite borders of a surface are the same curve.
bool IsClosed(const GeometricSurface& surface, int direction)
{
  const ParameterRange& across = surface.GetDomain(direction);
  ParameterRange along = surface.GetDomain(1 - direction);
  if (!std::isfinite(across.Low) || !std::isfinite(across.High))
  {
    return false;
  }
  // The other direction of an extrusion has no ends.
  along = std::isfinite(along.Low) && std::isfinite(along.High) ? along : ParameterRange{ 0.0, 1.0 };
  for (int i = 0; i <= BorderSamples; ++i)
  {
    const double x = along.Low + i * (along.High - along.Low) / BorderSamples;
    const Vector3 low = direction == 0 ? surface.Evaluate(across.Low, x) : surface.Evaluate(x, across.Low);
    const Vector3 high = direction == 0 ? surface.Evaluate(across.High, x) : surface.Evaluate(x, across.High);
    if (!(Norm(Subtract(low, high)) <= SameBorder))
    {
      return false;
    }
  }
  return true;
}
}

FootPointFinder::FootPointFinder(const SurfacePointer& surface)
  : Surface(surface)
{
  const auto* spline = surface->GetIf<SplineSurface>();
  for (int d = 0; d < 2; ++d)
  {
    const ParameterRange& domain = surface->GetDomain(d);
    this->Period[d] = surface->GetPeriod(d);
    const bool isOpen = this->Period[d] > 0.0;
    this->Low[d] = isOpen ? -std::numeric_limits<double>::infinity() : domain.Low;
    this->High[d] = isOpen ? std::numeric_limits<double>::infinity() : domain.High;
    if (spline)
    {
      this->Knots[d] = CopyKnots(spline->Basis[d], this->Period[d]);
    }
  }
}

std::shared_ptr<const FootPointFinder> FootPointFinder::Make(const SurfacePointer& surface, bool allowSeams)
{
  const auto* elementary = surface->GetIf<ElementarySurface>();
  if (elementary && elementary->Kind == ElementarySurface::Type::Plane)
  {
    return nullptr;
  }
  if (elementary)
  {
    return std::make_shared<ElementaryFinder>(surface, *elementary);
  }
  for (int d = 0; d < 2 && !allowSeams; ++d)
  {
    if (surface->GetPeriod(d) <= 0.0 && IsClosed(*surface, d))
    {
      return nullptr;
    }
  }
  const Sweep sweep(*surface);
  const auto* line = sweep.Profile ? sweep.Profile->GetIf<LineCurve<3>>() : nullptr;
  const ParameterRange& range = surface->GetDomain(sweep.IsRevolved ? 1 : 0);
  const bool isFinite = std::isfinite(range.Low) && std::isfinite(range.High);
  if (line && !isFinite)
  {
    return RuledFinder::IsSupported(sweep, *line) ? std::make_shared<RuledFinder>(surface, sweep, *line)
                                                  : nullptr;
  }
  if (sweep.Profile)
  {
    return isFinite ? std::make_shared<SweptFinder>(surface, sweep, range) : nullptr;
  }
  const ParameterRange& other = surface->GetDomain(1);
  return isFinite && std::isfinite(other.Low) && std::isfinite(other.High)
    ? std::make_shared<GridFinder>(surface)
    : nullptr;
}

void FootPointFinder::Unroll(const double* guess, double uv[2]) const
{
  for (int d = 0; guess && d < 2; ++d)
  {
    if (this->Period[d] > 0.0)
    {
      uv[d] += std::round((guess[d] - uv[d]) / this->Period[d]) * this->Period[d];
    }
  }
}

double FootPointFinder::SnapToBorder(int direction, double value, double slack) const
{
  for (const double border : { this->Low[direction], this->High[direction] })
  {
    value = std::abs(value - border) <= slack ? border : value;
  }
  for (const Pole& pole : this->Poles)
  {
    value = pole.Direction == direction && std::abs(value - pole.Value) <= slack ? pole.Value : value;
  }
  return value;
}
}
