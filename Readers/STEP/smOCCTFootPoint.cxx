#include "smOCCTFootPoint.h"

#include "smUnitRoundoff.h"

#include <vtkMath.h>

#include <ElSLib.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

namespace sm
{
namespace
{
/// Largest distance of foot points beyond the border of the domain, relative to its width.
constexpr double Margin = 0.01;

/// Largest degree of a spline whose patches are cached as polynomials in powers of the parameters; higher
/// degrees lose too many digits.
constexpr int LargestCachedDegree = 8;

/// Finds foot points on cylinders, cones, spheres and tori in closed form.
class ElementaryFinder : public FootPointFinder
{
public:
  explicit ElementaryFinder(const Handle(Geom_ElementarySurface) & surface)
    : FootPointFinder(surface)
    , Cylinder(Handle(Geom_CylindricalSurface)::DownCast(surface))
    , Cone(Handle(Geom_ConicalSurface)::DownCast(surface))
    , Sphere(Handle(Geom_SphericalSurface)::DownCast(surface))
    , Torus(Handle(Geom_ToroidalSurface)::DownCast(surface))
  {
    if (!this->Cone.IsNull())
    {
      this->Poles.push_back({ 1, -this->Cone->RefRadius() / std::sin(this->Cone->SemiAngle()) });
    }
    else if (!this->Sphere.IsNull())
    {
      this->Poles = { { 1, -0.5 * vtkMath::Pi() }, { 1, 0.5 * vtkMath::Pi() } };
    }
  }

  bool Find(const gp_Pnt& point, const double* guess, double uv[2]) const override
  {
    if (!this->Cylinder.IsNull())
    {
      ElSLib::CylinderParameters(this->Cylinder->Position(), this->Cylinder->Radius(), point, uv[0], uv[1]);
    }
    else if (!this->Cone.IsNull())
    {
      ElSLib::ConeParameters(
        this->Cone->Position(), this->Cone->RefRadius(), this->Cone->SemiAngle(), point, uv[0], uv[1]);
    }
    else if (!this->Sphere.IsNull())
    {
      ElSLib::SphereParameters(this->Sphere->Position(), this->Sphere->Radius(), point, uv[0], uv[1]);
    }
    else
    {
      ElSLib::TorusParameters(
        this->Torus->Position(), this->Torus->MajorRadius(), this->Torus->MinorRadius(), point, uv[0], uv[1]);
    }
    this->Unroll(guess, uv);
    return std::isfinite(uv[0]) && std::isfinite(uv[1]);
  }

private:
  Handle(Geom_CylindricalSurface) Cylinder;
  Handle(Geom_ConicalSurface) Cone;
  Handle(Geom_SphericalSurface) Sphere;
  Handle(Geom_ToroidalSurface) Torus;
};

/// Finds foot points on any other surface, by Newton's method from a guess or from the nearest one of some
/// points.
class NewtonFinder : public FootPointFinder
{
public:
  explicit NewtonFinder(const Handle(Geom_Surface) & surface)
    : FootPointFinder(surface)
  {
    // Only splines that are not periodic and have low degrees are cached: otherwise the cached polynomials
    // differ from the surface beyond the domain, or by rounding.
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
    this->Inaccurate =
      !spline.IsNull() && std::max(spline->UDegree(), spline->VDegree()) > LargestCachedDegree;
    if (!spline.IsNull() && this->Period[0] == 0.0 && this->Period[1] == 0.0 &&
      std::max(spline->UDegree(), spline->VDegree()) <= LargestCachedDegree)
    {
      this->Patches = std::make_unique<GeomAdaptor_Surface>(surface);
    }
  }

  bool Find(const gp_Pnt& point, const double* guess, double uv[2]) const override
  {
    std::unique_lock<std::mutex> lock(this->Mutex, std::defer_lock);
    if (this->Patches)
    {
      lock.lock();
    }
    double distance = std::numeric_limits<double>::infinity();
    if (guess)
    {
      uv[0] = guess[0];
      uv[1] = guess[1];
      const gp_Pnt from = this->GetPoint(uv[0], uv[1]);
      if (this->Solve(point, uv, distance) && distance <= point.Distance(from) + this->Rounding)
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
  virtual bool FindSeed(const gp_Pnt& point, double uv[2]) const = 0;

  gp_Pnt GetPoint(double u, double v) const
  {
    return this->Patches ? this->Patches->Value(u, v) : this->Surface->Value(u, v);
  }

  double Rounding = 0.0;

private:
  void GetDerivatives(double u, double v, gp_Pnt& point, gp_Vec& du, gp_Vec& dv) const
  {
    if (this->Patches)
    {
      this->Patches->D1(u, v, point, du, dv);
    }
    else
    {
      this->Surface->D1(u, v, point, du, dv);
    }
  }

  /// The search continues a little beyond the border of the domain, so that the foot point of an edge there
  /// is a smooth function.
  double GetLow(int d) const { return this->Low[d] - Margin * (this->High[d] - this->Low[d]); }
  double GetHigh(int d) const { return this->High[d] + Margin * (this->High[d] - this->Low[d]); }

  /// Solves by Gauss-Newton and Newton steps, in a range a little larger than the domain. At the end of the
  /// range steps are taken only along it.
  bool Solve(const gp_Pnt& point, double uv[2], double& distance) const
  {
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60; ++i)
    {
      gp_Pnt foot;
      gp_Vec d[2];
      this->GetDerivatives(uv[0], uv[1], foot, d[0], d[1]);
      const gp_Vec gap(foot, point);
      distance = gap.Magnitude();
      double step[2];
      this->GetStep(gap, d, uv, step);
      const double length = (step[0] * d[0] + step[1] * d[1]).Magnitude();
      const double rounding = 4.0 * UnitRoundoff * (foot.XYZ().Modulus() + point.XYZ().Modulus());
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

  void GetStep(const gp_Vec& gap, const gp_Vec d[2], const double uv[2], double step[2]) const
  {
    const double a = d[0].SquareMagnitude();
    const double b = d[0].Dot(d[1]);
    const double c = d[1].SquareMagnitude();
    const double f[2] = { gap.Dot(d[0]), gap.Dot(d[1]) };
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

  /// The surface with cached polynomials of the last patch, guarded by the mutex; null if they are not used.
  std::unique_ptr<GeomAdaptor_Surface> Patches;
  mutable std::mutex Mutex;

protected:
  double Extent = 1.0;
};

/// Finds seeds on a surface with a finite domain from a grid of points.
class GridFinder : public NewtonFinder
{
public:
  explicit GridFinder(const Handle(Geom_Surface) & surface)
    : NewtonFinder(surface)
  {
    double bounds[4];
    surface->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
    for (int d = 0; d < 2; ++d)
    {
      const int spans = static_cast<int>(this->Knots[d].size()) + 1;
      this->Count[d] = std::clamp(3 * spans, 12, 60);
      this->First[d] = bounds[2 * d];
      this->Step[d] = (bounds[2 * d + 1] - bounds[2 * d]) / this->Count[d];
    }
    gp_XYZ low(1e300, 1e300, 1e300);
    gp_XYZ high(-1e300, -1e300, -1e300);
    for (int i = 0; i <= this->Count[0]; ++i)
    {
      for (int j = 0; j <= this->Count[1]; ++j)
      {
        const gp_Pnt p = this->GetPoint(this->GetParameter(0, i), this->GetParameter(1, j));
        this->Points.push_back(p);
        for (int c = 1; c <= 3; ++c)
        {
          low.SetCoord(c, std::min(low.Coord(c), p.Coord(c)));
          high.SetCoord(c, std::max(high.Coord(c), p.Coord(c)));
        }
      }
    }
    this->Extent = (high - low).Modulus();
    this->Rounding = 1e-12 * std::max({ this->Extent, low.Modulus(), high.Modulus() });
    this->FindPoles();
  }

protected:
  bool FindSeed(const gp_Pnt& point, double uv[2]) const override
  {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < this->Points.size(); ++k)
    {
      const double square = this->Points[k].SquareDistance(point);
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

  const gp_Pnt& GetGridPoint(int i, int j) const { return this->Points[i * (this->Count[1] + 1) + j]; }

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
          const gp_Pnt& p = d == 0 ? this->GetGridPoint(end, k) : this->GetGridPoint(k, end);
          const gp_Pnt& q = d == 0 ? this->GetGridPoint(end, 0) : this->GetGridPoint(0, end);
          widest = std::max(widest, p.Distance(q));
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
  std::vector<gp_Pnt> Points;
};

/// Finds seeds on surfaces of revolution and extrusion, from points of their profile curve; the other
/// coordinate has a closed form.
class SweptFinder : public NewtonFinder
{
public:
  SweptFinder(const Handle(Geom_SweptSurface) & surface, double first, double last)
    : NewtonFinder(surface)
    , Revolution(Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
    , Direction(surface->Direction().XYZ())
  {
    constexpr int count = 128;
    double largest = 0.0;
    for (int i = 0; i <= count; ++i)
    {
      const double t = first + i * (last - first) / count;
      this->Profile.push_back({ t, surface->BasisCurve()->Value(t).XYZ() });
      largest = std::max(largest, this->Profile.back().second.Modulus());
      this->Extent =
        std::max(i ? this->Extent : 0.0, (this->Profile.back().second - this->Profile[0].second).Modulus());
    }
    this->Rounding = 1e-12 * std::max(this->Extent, largest);
    if (!this->Revolution.IsNull())
    {
      this->Origin = this->Revolution->Axis().Location().XYZ();
      for (const auto& end : { this->Profile.front(), this->Profile.back() })
      {
        if (this->GetRadius(end.second).Modulus() <= 1e-9 * this->Extent)
        {
          this->Poles.push_back({ 1, end.first });
        }
      }
    }
  }

protected:
  bool FindSeed(const gp_Pnt& point, double uv[2]) const override
  {
    const gp_XYZ radius = this->GetRadius(point.XYZ());
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [t, profile] : this->Profile)
    {
      const gp_XYZ difference = point.XYZ() - profile;
      const double along = difference.Dot(this->Direction);
      double square = (difference - along * this->Direction).SquareModulus();
      if (!this->Revolution.IsNull())
      {
        square = along * along + std::pow(radius.Modulus() - this->GetRadius(profile).Modulus(), 2);
      }
      if (square < best)
      {
        best = square;
        uv[0] = t;
        uv[1] = along;
        if (!this->Revolution.IsNull())
        {
          const gp_XYZ from = this->GetRadius(profile);
          uv[0] = std::atan2(from.Crossed(radius).Dot(this->Direction), from.Dot(radius));
          uv[1] = t;
        }
      }
    }
    return std::isfinite(best);
  }

private:
  /// Returns the vector from the axis to the point, perpendicular to the axis.
  gp_XYZ GetRadius(const gp_XYZ& point) const
  {
    const gp_XYZ difference = point - this->Origin;
    return difference - difference.Dot(this->Direction) * this->Direction;
  }

  Handle(Geom_SurfaceOfRevolution) Revolution;
  gp_XYZ Direction;
  gp_XYZ Origin;
  std::vector<std::pair<double, gp_XYZ>> Profile;
};

/// Finds seeds on extrusions and revolutions of a line that has no ends: planes, cylinders, cones and
/// hyperboloids.
class RuledFinder : public NewtonFinder
{
public:
  RuledFinder(const Handle(Geom_SweptSurface) & surface, const gp_Lin& line)
    : NewtonFinder(surface)
    , Revolution(Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
    , Start(line.Location().XYZ())
    , Along(line.Direction().XYZ())
  {
    this->Rounding = 1e-12 * std::max(1.0, this->Start.Modulus());
    if (!this->Revolution.IsNull())
    {
      this->Origin = this->Revolution->Axis().Location().XYZ();
      this->Axis = this->Revolution->Axis().Direction().XYZ();
      const gp_XYZ slope = this->GetRadius(this->Origin + this->Along);
      const double square = slope.SquareModulus();
      const double nearest = square > 1e-20 ? -slope.Dot(this->GetRadius(this->Start)) / square : 0.0;
      if (square > 1e-20 && this->GetRadius(this->Start + nearest * this->Along).Modulus() <= this->Rounding)
      {
        this->Poles.push_back({ 1, nearest });
      }
    }
  }

  /// Returns false for the revolution of a line that is perpendicular to its axis: it has points twice.
  static bool IsSupported(const Handle(Geom_SweptSurface) & surface, const gp_Lin& line)
  {
    const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
    return revolution.IsNull() ||
      std::abs(revolution->Axis().Direction().XYZ().Dot(line.Direction().XYZ())) >= 1e-3;
  }

protected:
  /// One Newton step from the origin of a plane is exact; the height of a point on a revolution decides about
  /// the place on the line.
  bool FindSeed(const gp_Pnt& point, double uv[2]) const override
  {
    uv[0] = uv[1] = 0.0;
    if (!this->Revolution.IsNull())
    {
      uv[1] = (point.XYZ() - this->Start).Dot(this->Axis) / this->Along.Dot(this->Axis);
      const gp_XYZ from = this->GetRadius(this->Start + uv[1] * this->Along);
      const gp_XYZ to = this->GetRadius(point.XYZ());
      uv[0] = std::atan2(from.Crossed(to).Dot(this->Axis), from.Dot(to));
    }
    return true;
  }

private:
  /// Returns the vector from the axis to the point, perpendicular to the axis.
  gp_XYZ GetRadius(const gp_XYZ& point) const
  {
    const gp_XYZ difference = point - this->Origin;
    return difference - difference.Dot(this->Axis) * this->Axis;
  }

  Handle(Geom_SurfaceOfRevolution) Revolution;
  gp_XYZ Start;
  gp_XYZ Along;
  gp_XYZ Origin;
  gp_XYZ Axis;
};

/// Returns the interior knots; of a periodic direction also those of one more period on both sides.
template <class GetKnot>
std::vector<double> CopyKnots(int count, double period, const GetKnot& knot)
{
  std::vector<double> knots;
  for (const double shift : { -period, 0.0, period })
  {
    for (int i = period > 0.0 ? 1 : 2; i < count; ++i)
    {
      knots.push_back(knot(i) + shift);
    }
    if (period == 0.0)
    {
      break;
    }
  }
  return knots;
}
}

FootPointFinder::FootPointFinder(const Handle(Geom_Surface) & surface)
  : Surface(surface)
{
  double bounds[4];
  surface->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  this->Period[0] = surface->IsUPeriodic() ? surface->UPeriod() : 0.0;
  this->Period[1] = surface->IsVPeriodic() ? surface->VPeriod() : 0.0;
  for (int d = 0; d < 2; ++d)
  {
    const bool isOpen = this->Period[d] > 0.0;
    this->Low[d] = isOpen ? -std::numeric_limits<double>::infinity() : bounds[2 * d];
    this->High[d] = isOpen ? std::numeric_limits<double>::infinity() : bounds[2 * d + 1];
  }
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
  {
    this->Knots[0] =
      CopyKnots(spline->NbUKnots(), this->Period[0], [&spline](int i) { return spline->UKnot(i); });
    this->Knots[1] =
      CopyKnots(spline->NbVKnots(), this->Period[1], [&spline](int i) { return spline->VKnot(i); });
  }
}

std::shared_ptr<const FootPointFinder> FootPointFinder::Make(const Handle(Geom_Surface) & surface)
{
  if (surface->IsKind(STANDARD_TYPE(Geom_CylindricalSurface)) ||
    surface->IsKind(STANDARD_TYPE(Geom_ConicalSurface)) ||
    surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface)) ||
    surface->IsKind(STANDARD_TYPE(Geom_ToroidalSurface)))
  {
    return std::make_shared<ElementaryFinder>(Handle(Geom_ElementarySurface)::DownCast(surface));
  }
  // A point on the seam of a closed surface that is not periodic has two foot points, which cannot be
  // distinguished by position.
  if ((surface->IsUClosed() && !surface->IsUPeriodic()) || (surface->IsVClosed() && !surface->IsVPeriodic()))
  {
    return nullptr;
  }
  if (const auto swept = Handle(Geom_SweptSurface)::DownCast(surface))
  {
    const auto line = Handle(Geom_Line)::DownCast(swept->BasisCurve());
    if (!line.IsNull())
    {
      return RuledFinder::IsSupported(swept, line->Lin()) ? std::make_shared<RuledFinder>(swept, line->Lin())
                                                          : nullptr;
    }
    const double first = swept->BasisCurve()->FirstParameter();
    const double last = swept->BasisCurve()->LastParameter();
    return Precision::IsInfinite(first) || Precision::IsInfinite(last)
      ? nullptr
      : std::make_shared<SweptFinder>(swept, first, last);
  }
  double bounds[4];
  surface->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  const bool isFinite =
    std::none_of(std::begin(bounds), std::end(bounds), [](double b) { return Precision::IsInfinite(b); });
  return isFinite ? std::make_shared<GridFinder>(surface) : nullptr;
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
