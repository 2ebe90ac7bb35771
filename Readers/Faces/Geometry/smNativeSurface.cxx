#include "smNativeSurface.h"

#include "smNativeFit.h"
#include "smPlacement.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr double FullTurn = 2.0 * vtkMath::Pi();
/// Allowed distance of control points from those of the elementary surface, in roundings of the largest
/// coordinate: those of the conversion, of a placement and of a unit.
constexpr double AllowedRoundings = 64.0;
/// Relative to the radius: lengths that may be 0 for an approximation that is fitted afterwards.
constexpr double Negligible = 1e-3;

/// Returns the arcs of a direction; Count 0 if the knots are not those of arcs.
NativeParameter FindArcs(const NURBSSurface& surface, int direction)
{
  const std::vector<double>& knots = surface.Knots[direction];
  NativeParameter arcs;
  const int count = (surface.NumberOfControlPoints[direction] - 1) / 2;
  if (surface.Degree[direction] != 2 || surface.NumberOfControlPoints[direction] != 2 * count + 1 ||
    static_cast<int>(knots.size()) != 2 * count + 4 || knots.front() != 0.0 || knots.back() != count)
  {
    return arcs;
  }
  for (int k = 0; k <= 2 * count + 1; ++k)
  {
    if (knots[k + 1] != k / 2)
    {
      return arcs;
    }
  }
  // The weights of an arc are 1, cos(half its angle), 1.
  const std::size_t stride = direction == 0 ? 1 : surface.NumberOfControlPoints[0];
  const double weight = surface.ControlPoints[stride][3] / surface.ControlPoints[0][3];
  if (!(weight > 0.5) || !(weight < 1.0))
  {
    return arcs;
  }
  // Of a small angle the sine of a quarter has the digits that its cosine is without.
  arcs.Width = 4.0 * std::asin(std::sqrt(0.5 * (1.0 - weight)));
  arcs.IsCircular = true;
  arcs.Count = count;
  return arcs;
}

/// Returns the centre of the circle of an arc with homogeneous points a, b (in the middle) and c, and half
/// the angle `half`.
template <std::size_t Dimension>
std::array<double, Dimension> FindCenter(const std::array<double, Dimension>& a,
  const std::array<double, Dimension>& b, const std::array<double, Dimension>& c, double half)
{
  // Of M, the middle of the chord, and T, the intersection of the tangents: M - C = cos^2(half) (T - C).
  const double cosine = std::cos(half);
  const double sine = std::sin(half);
  std::array<double, Dimension> center;
  for (std::size_t i = 0; i < Dimension; ++i)
  {
    center[i] = (0.5 * (a[i] + c[i]) - cosine * cosine * b[i]) / (sine * sine);
  }
  return center;
}

class Finder
{
public:
  explicit Finder(const NURBSSurface& surface)
    : From(surface)
  {
    for (const std::array<double, 4>& h : surface.ControlPoints)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Allowed = std::max(this->Allowed, std::abs(h[c] / h[3]));
      }
    }
    this->Allowed *= AllowedRoundings * UnitRoundoff;
    // Coordinates of the file may be larger than those that are relative to the body.
    this->Allowed += *std::max_element(surface.Rounding.begin(), surface.Rounding.end());
  }

  bool Find()
  {
    return this->From.Degree[0] == 1 && this->From.Degree[1] == 1 ? this->FindPlane()
                                                                  : this->FindRevolution();
  }

  NativeSurface Result;

private:
  std::array<double, 4> GetPole(int i, int j) const
  {
    return this->From.ControlPoints[i + static_cast<std::size_t>(j) * this->From.NumberOfControlPoints[0]];
  }
  Vector3 GetPoint(int i, int j) const
  {
    const std::array<double, 4> h = this->GetPole(i, j);
    return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
  }
  bool IsNear(double a, double b) const { return std::abs(a - b) <= this->Allowed; }

  bool FindPlane()
  {
    if (this->From.NumberOfControlPoints[0] != 2 || this->From.NumberOfControlPoints[1] != 2 ||
      this->From.Rational)
    {
      return false;
    }
    const Vector3 origin = this->GetPoint(0, 0);
    const Vector3 u = Subtract(this->GetPoint(1, 0), origin);
    const Vector3 v = Subtract(this->GetPoint(0, 1), origin);
    const Vector3 corner = Subtract(this->GetPoint(1, 1), origin);
    const Vector3 normal = Cross(u, v);
    if (!(Norm(normal) > 1e-6 * Norm(u) * Norm(v)))
    {
      return false;
    }
    for (int c = 0; c < 3; ++c)
    {
      if (!this->IsNear(corner[c], u[c] + v[c]))
      {
        return false;
      }
    }
    GeometricFrame& frame = this->Result.Surface.Frame;
    frame.Origin = origin;
    frame.Axes[0] = Normalized(u);
    frame.Axes[2] = Normalized(normal);
    frame.Axes[1] = Cross(frame.Axes[2], frame.Axes[0]);
    const double width[2] = { this->From.GetDomainEnd(0) - this->From.GetDomainStart(0),
      this->From.GetDomainEnd(1) - this->From.GetDomainStart(1) };
    const double start[2] = { this->From.GetDomainStart(0), this->From.GetDomainStart(1) };
    for (int i = 0; i < 2; ++i)
    {
      this->Result.Linear[i][0] = i == 0 ? Norm(u) / width[0] : 0.0;
      this->Result.Linear[i][1] = Dot(v, frame.Axes[i]) / width[1];
      // Of a rectangle the sides are parallel to the axes.
      if (i == 0 && std::abs(Dot(v, frame.Axes[0])) <= this->Allowed)
      {
        this->Result.Linear[0][1] = 0.0;
      }
      this->Result.Start[i] = -this->Result.Linear[i][0] * start[0] - this->Result.Linear[i][1] * start[1];
    }
    return true;
  }

  bool FindRevolution()
  {
    NativeParameter& arcs = this->Result.Parameters[0];
    arcs = FindArcs(this->From, 0);
    if (!arcs.IsCircular)
    {
      return false;
    }
    if (std::abs(arcs.Count * arcs.Width - FullTurn) < 1e-9)
    {
      arcs.Width = FullTurn / arcs.Count;
    }
    if (this->From.Degree[1] == 1 && this->FindFrame() && this->FindCylinder())
    {
      return true;
    }
    if (this->FindFrame() && this->FindProfile(Kinds::Exact) && this->HasAllPoles())
    {
      return true;
    }
    // Small arcs determine neither axis nor kind to rounding.
    const NativeParameter before = arcs;
    for (const Kinds kinds : { Kinds::Sphere, Kinds::Other })
    {
      this->Result = NativeSurface();
      arcs = before;
      this->Profile.clear();
      if (this->FindFrame() && this->FindProfile(kinds))
      {
        FitNative(this->From, this->Result);
        this->Profile =
          MakeProfile(this->Result, { this->From.GetDomainStart(1), this->From.GetDomainEnd(1) });
        this->IsFitted = true;
        if (this->IsValid() && this->HasAllPoles())
        {
          return true;
        }
      }
    }
    return false;
  }

  /// Kinds that are looked for: those that control points show to rounding, or approximations.
  enum class Kinds
  {
    Exact,
    Sphere,
    Other
  };

  /// Returns false for parameters of a fit that no surface has.
  bool IsValid() const
  {
    const ElementarySurface& surface = this->Result.Surface;
    const bool isRound = this->Result.Parameters[1].IsCircular;
    const double quarter = 0.25 * FullTurn;
    const double ends[2] = { this->Result.Start[1],
      this->Result.Start[1] +
        this->Result.Linear[1][1] * this->Result.Parameters[1].Count * this->Result.Parameters[1].Width };
    const bool isSphere = surface.Kind == ElementarySurface::Type::Sphere;
    const bool isTorus = surface.Kind == ElementarySurface::Type::Torus;
    return surface.Radii[0] > 0.0 && (!isTorus || surface.Radii[1] > 0.0) &&
      (isRound || (surface.Angle > 0.0 && surface.Angle < quarter)) &&
      (!isSphere || (std::abs(ends[0]) <= quarter && std::abs(ends[1]) <= quarter));
  }

  /// Finds the axis by the circle of the largest radius.
  bool FindFrame()
  {
    const double half = 0.5 * this->Result.Parameters[0].Width;
    double largest = 0.0;
    GeometricFrame& frame = this->Result.Surface.Frame;
    for (int j = 0; j < this->From.NumberOfControlPoints[1]; ++j)
    {
      const Vector3 start = this->GetPoint(0, j);
      const Vector3 middle = this->GetPoint(1, j);
      const Vector3 center = FindCenter(start, middle, this->GetPoint(2, j), half);
      const Vector3 x = Subtract(start, center);
      const Vector3 tangent = Subtract(middle, start);
      if (Norm(x) > largest && Norm(tangent) > 0.0)
      {
        largest = Norm(x);
        frame.Origin = center;
        frame.Axes[0] = Normalized(x);
        frame.Axes[2] = Normalized(Cross(frame.Axes[0], tangent));
      }
    }
    frame.Axes[1] = Cross(frame.Axes[2], frame.Axes[0]);
    frame.Axes[0] = Cross(frame.Axes[1], frame.Axes[2]);
    return largest > this->Allowed;
  }

  /// Finds a cylinder: the axis of a long one by its lines, since that of a small or short arc has few
  /// digits.
  bool FindCylinder()
  {
    if (this->From.NumberOfControlPoints[1] != 2)
    {
      return false;
    }
    ElementarySurface& surface = this->Result.Surface;
    GeometricFrame& frame = surface.Frame;
    const double half = 0.5 * this->Result.Parameters[0].Width;
    const Vector3 start = this->GetPoint(0, 0);
    const Vector3 line = Subtract(this->GetPoint(0, 1), start);
    const Vector3 chord = Subtract(this->GetPoint(2, 0), start);
    const double length = Norm(line);
    const double radius = 0.5 * Norm(chord) / std::sin(half);
    if (!(length > this->Allowed) || !(radius > this->Allowed))
    {
      return false;
    }
    // An arc determines the tilt of its plane by its extents along the axes x and y.
    const double extents[2] = { radius * (1.0 - std::cos(2.0 * half)), radius * std::sin(2.0 * half) };
    const double way = std::copysign(1.0, Dot(line, frame.Axes[2]));
    const Vector3 change = Subtract(Multiply(way / length, line), frame.Axes[2]);
    Vector3 z = frame.Axes[2];
    for (int d = 0; d < 2; ++d)
    {
      z = length > extents[d] ? Sum(z, Multiply(Dot(change, frame.Axes[d]), frame.Axes[d])) : z;
    }
    frame.Axes[2] = Normalized(z);
    // The centre is on the perpendicular bisector of the chord.
    const Vector3 outwards = Normalized(Cross(chord, frame.Axes[2]));
    const Vector3 toStart = Subtract(Multiply(radius * std::cos(half), outwards), Multiply(0.5, chord));
    frame.Axes[1] = Normalized(Cross(frame.Axes[2], toStart));
    frame.Axes[0] = Cross(frame.Axes[1], frame.Axes[2]);
    frame.Origin = Subtract(start, Multiply(radius, frame.Axes[0]));
    surface.Kind = ElementarySurface::Type::Cylinder;
    surface.Radii[0] = radius;
    this->Profile = { { radius, 0.0, 1.0 }, { radius, way * length, 1.0 } };
    const double slope = way * length / (this->From.GetDomainEnd(1) - this->From.GetDomainStart(1));
    this->Result.Linear[1][1] = slope;
    this->Result.Start[1] = -slope * this->From.GetDomainStart(1);
    if (this->HasAllPoles())
    {
      return true;
    }
    this->Profile.clear();
    this->Result.Start[1] = 0.0;
    return false;
  }

  /// Finds the kind of the surface by its profile, the poles of the first column.
  bool FindProfile(Kinds kinds)
  {
    const GeometricFrame& frame = this->Result.Surface.Frame;
    for (int j = 0; j < this->From.NumberOfControlPoints[1]; ++j)
    {
      const Vector3 from = Subtract(this->GetPoint(0, j), frame.Origin);
      const double weight = this->GetPole(0, j)[3];
      this->Profile.push_back(
        { weight * Dot(from, frame.Axes[0]), weight * Dot(from, frame.Axes[2]), weight });
    }
    return this->From.Degree[1] == 1 ? kinds != Kinds::Sphere && this->FindStraightProfile()
                                     : this->FindCircularProfile(kinds);
  }

  bool FindStraightProfile()
  {
    if (this->Profile.size() != 2 || this->Profile[0].Weight != 1.0 || this->Profile[1].Weight != 1.0)
    {
      return false;
    }
    ElementarySurface& surface = this->Result.Surface;
    const double rise = this->Profile[1].Height - this->Profile[0].Height;
    double growth = this->Profile[1].Radius - this->Profile[0].Radius;
    const double width = this->From.GetDomainEnd(1) - this->From.GetDomainStart(1);
    // The wider end is the origin of the height.
    const int wide = growth > this->Allowed ? 1 : 0;
    const ProfilePole base = this->Profile[wide];
    surface.Radii[0] = base.Radius;
    if (std::abs(growth) <= this->Allowed)
    {
      surface.Kind = ElementarySurface::Type::Cylinder;
      growth = 0.0;
    }
    else
    {
      surface.Kind = ElementarySurface::Type::Cone;
      surface.Angle = std::atan2(std::abs(growth), std::abs(rise));
    }
    // A flat ring is not a cone.
    if (!(std::abs(rise) > 1e-9 * std::abs(growth)) || !(std::abs(rise) > this->Allowed) ||
      !(this->Profile[1 - wide].Radius >= -this->Allowed))
    {
      return false;
    }
    Vector3& origin = surface.Frame.Origin;
    origin = Sum(origin, Multiply(base.Height, surface.Frame.Axes[2]));
    // Along the axis, which a cone must have where its radius increases.
    double slope = std::hypot(growth, rise) / width * (rise < 0.0 ? -1.0 : 1.0);
    if (growth * rise < 0.0)
    {
      this->ReverseAxis();
      slope = -slope;
    }
    this->Result.Linear[1][1] = slope;
    this->Result.Start[1] = -slope * (wide == 1 ? this->From.GetDomainEnd(1) : this->From.GetDomainStart(1));
    for (ProfilePole& pole : this->Profile)
    {
      pole.Height -= base.Height;
      pole.Radius = surface.Kind == ElementarySurface::Type::Cylinder ? surface.Radii[0] : pole.Radius;
    }
    return true;
  }

  /// Reverses z, and with it the direction of the angle.
  void ReverseAxis()
  {
    GeometricFrame& frame = this->Result.Surface.Frame;
    const double turn = this->Result.Parameters[0].Count * this->Result.Parameters[0].Width;
    // The angle is 0 at the end of the domain, so that all angles remain in a turn from 0.
    const double c = turn == FullTurn ? 1.0 : std::cos(turn);
    const double s = turn == FullTurn ? 0.0 : std::sin(turn);
    frame.Axes[0] = Sum(Multiply(c, frame.Axes[0]), Multiply(s, frame.Axes[1]));
    frame.Axes[2] = Multiply(-1.0, frame.Axes[2]);
    frame.Axes[1] = Cross(frame.Axes[2], frame.Axes[0]);
    this->Result.Linear[0][0] = -1.0;
    this->Result.Start[0] = turn;
  }

  bool FindCircularProfile(Kinds kinds)
  {
    NativeParameter& arcs = this->Result.Parameters[1];
    arcs = FindArcs(this->From, 1);
    if (!arcs.IsCircular)
    {
      return false;
    }
    const auto get = [this](int j) -> std::array<double, 2>
    {
      const ProfilePole& p = this->Profile[j];
      return { p.Radius / p.Weight, p.Height / p.Weight };
    };
    std::array<double, 2> center = FindCenter(get(0), get(1), get(2), 0.5 * arcs.Width);
    if (kinds != Kinds::Sphere && center[0] < -this->Allowed)
    {
      // The part of a torus beyond its axis: radii are negative in the frame from the centre of the circle.
      GeometricFrame& frame = this->Result.Surface.Frame;
      frame.Axes[0] = Multiply(-1.0, frame.Axes[0]);
      frame.Axes[1] = Multiply(-1.0, frame.Axes[1]);
      center[0] = -center[0];
      for (ProfilePole& pole : this->Profile)
      {
        pole.Radius = -pole.Radius;
      }
    }
    const std::array<double, 2> from{ get(0)[0] - center[0], get(0)[1] - center[1] };
    const std::array<double, 2> to{ get(1)[0] - center[0], get(1)[1] - center[1] };
    const double radius = std::hypot(from[0], from[1]);
    const double way = from[0] * to[1] - from[1] * to[0] < 0.0 ? -1.0 : 1.0;
    ElementarySurface& surface = this->Result.Surface;
    const bool isSphere = kinds == Kinds::Exact
      ? std::abs(center[0]) <= this->Allowed
      : kinds == Kinds::Sphere && std::abs(center[0]) <= Negligible * radius;
    // OpenCASCADE has no torus whose radii are equal.
    if (!isSphere && (kinds == Kinds::Sphere || !(std::abs(center[0] / radius - 1.0) > 1e-4)))
    {
      return false;
    }
    double start = std::atan2(from[1], from[0]);
    double turn = arcs.Count * arcs.Width;
    if (isSphere)
    {
      surface.Kind = ElementarySurface::Type::Sphere;
      surface.Radii[0] = radius;
      // Latitudes end at the poles, also where rounding would be beyond them.
      const double quarter = 0.25 * FullTurn;
      const auto snap = [quarter](double angle)
      { return std::abs(std::abs(angle) - quarter) < 1e-9 ? std::copysign(quarter, angle) : angle; };
      const double end = snap(start + way * turn);
      start = snap(start);
      if (std::abs(start) > quarter || std::abs(end) > quarter)
      {
        return false;
      }
      turn = std::abs(end - start);
    }
    else
    {
      surface.Kind = ElementarySurface::Type::Torus;
      surface.Radii[0] = center[0];
      surface.Radii[1] = radius;
      turn = std::abs(turn - FullTurn) < 1e-9 ? FullTurn : turn;
      if (turn > FullTurn)
      {
        return false;
      }
    }
    arcs.Width = turn / arcs.Count;
    surface.Frame.Origin = Sum(surface.Frame.Origin, Multiply(center[1], surface.Frame.Axes[2]));
    this->Result.Linear[1][1] = way;
    this->Result.Start[1] = start;
    for (std::size_t j = 0; j < this->Profile.size(); ++j)
    {
      const double angle = start + way * 0.5 * arcs.Width * static_cast<double>(j);
      ProfilePole& pole = this->Profile[j];
      const double weight = j % 2 ? std::cos(0.5 * arcs.Width) : 1.0;
      if (std::abs(pole.Weight - weight) > AllowedRoundings * UnitRoundoff)
      {
        return false;
      }
      pole = { weight * (isSphere ? 0.0 : center[0]) + radius * std::cos(angle), radius * std::sin(angle),
        weight };
    }
    return true;
  }

  /// Returns true if every control point is that of the profile on the arcs.
  bool HasAllPoles() const
  {
    const GeometricFrame& frame = this->Result.Surface.Frame;
    const NativeParameter& arcs = this->Result.Parameters[0];
    // The heights of a profile that was found are along the axis before it was reversed.
    const double axial = !this->IsFitted && this->Result.Linear[0][0] < 0.0 ? -1.0 : 1.0;
    for (int j = 0; j < this->From.NumberOfControlPoints[1]; ++j)
    {
      const ProfilePole& p = this->Profile[j];
      for (int i = 0; i <= 2 * arcs.Count; ++i)
      {
        const double angle = this->Result.Start[0] + this->Result.Linear[0][0] * 0.5 * arcs.Width * i;
        const double weight = i % 2 ? std::cos(0.5 * arcs.Width) : 1.0;
        const std::array<double, 4> h = this->GetPole(i, j);
        if (std::abs(h[3] - weight * p.Weight) > AllowedRoundings * UnitRoundoff)
        {
          return false;
        }
        for (int c = 0; c < 3; ++c)
        {
          const double expected =
            weight * (p.Weight * frame.Origin[c] + axial * p.Height * frame.Axes[2][c]) +
            p.Radius * (std::cos(angle) * frame.Axes[0][c] + std::sin(angle) * frame.Axes[1][c]);
          if (!this->IsNear(h[c], expected))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  const NURBSSurface& From;
  double Allowed = 0.0;
  std::vector<ProfilePole> Profile;
  bool IsFitted = false;
};
}

double NativeParameter::Evaluate(double parameter) const
{
  if (!this->IsCircular)
  {
    return parameter;
  }
  const double arc = std::clamp(std::floor(parameter), 0.0, this->Count - 1.0);
  const double s = 2.0 * (parameter - arc) - 1.0;
  // Ends and middles of arcs are exact.
  const double inside =
    std::abs(s) == 1.0 ? 0.5 * s * this->Width : 2.0 * std::atan(s * std::tan(0.25 * this->Width));
  return (arc + 0.5) * this->Width + inside;
}

std::array<double, 2> NativeSurface::Map(double u, double v) const
{
  const double x = this->Parameters[0].Evaluate(u);
  const double y = this->Parameters[1].Evaluate(v);
  return { this->Start[0] + this->Linear[0][0] * x + this->Linear[0][1] * y,
    this->Start[1] + this->Linear[1][0] * x + this->Linear[1][1] * y };
}

std::optional<NativeSurface> FindNativeSurface(const NURBSSurface& surface)
{
  Finder finder(surface);
  return surface.Check().empty() && finder.Find() ? std::optional(finder.Result) : std::nullopt;
}
}
