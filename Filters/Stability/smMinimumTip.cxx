#include "Detail/smMinimumTip.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
constexpr double HalfPi = 1.5707963267948966;
// Largest number of directions evaluated at one corner. Ranges that are left then enter with their current
// bounds.
constexpr int MaximumDirections = 20000;

/// A function of the direction, its derivative, and a bound of its rounding and of the centre's error.
struct DirectionValue
{
  double Value;
  double Slope;
  double Error;
};

/// Lowers the enclosure to the minimum of a function inside a range of directions, of which the ends are
/// included already. `curvature` bounds the second derivative: where the slope at the middle is larger than
/// it can change by, the minimum is at an end; elsewhere Taylor's formula bounds the function, which is
/// nowhere below `floor`.
template <typename Function>
void SearchDirections(
  double from, double to, double curvature, double floor, const Function& evaluate, double (&minimum)[2])
{
  std::vector<std::pair<double, double>> ranges{ { 0.5 * (from + to), 0.5 * (to - from) } };
  for (int count = 0; !ranges.empty(); ++count)
  {
    const auto [middle, half] = ranges.back();
    ranges.pop_back();
    const DirectionValue at = evaluate(middle);
    const double variation = curvature * half;
    if (std::abs(at.Slope) > 1.001 * variation)
    {
      continue;
    }
    minimum[1] = std::min(minimum[1], at.Value + at.Error);
    const double low = std::max(floor, at.Value - at.Error - (std::abs(at.Slope) + 0.5 * variation) * half);
    if (low >= minimum[0])
    {
      continue;
    }
    if (variation * half <= 0.1 * at.Error || count > MaximumDirections)
    {
      minimum[0] = low;
      continue;
    }
    ranges.emplace_back(middle - 0.5 * half, 0.5 * half);
    ranges.emplace_back(middle + 0.5 * half, 0.5 * half);
  }
}

/// Returns the angle from one normal to the next, counter-clockwise; 2 pi for a polygon with one corner.
double GetTurn(double from, double to, std::size_t count)
{
  const double circle = 4.0 * HalfPi;
  const double turn = to < from ? to - from + circle : to - from;
  // The angle between sides of nearly the same direction may be negative by rounding.
  const bool isNone = turn == 0.0 || turn > circle - 1e-9;
  return isNone ? (count > 1 ? 0.0 : circle) : turn;
}

/// Tipping over one corner of the polygon, as a function of the direction.
struct CornerTip
{
  const TipCase& Body;
  /// Vector from the projected centre to the corner.
  Point2 Offset;
  double Bound;

  struct Direction
  {
    double M, MSlope, Lean, LeanSlope;
  };
  Direction Resolve(double angle) const
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const std::array<double, 3>& up = this->Body.Up;
    return { this->Offset[0] * c + this->Offset[1] * s, this->Offset[1] * c - this->Offset[0] * s,
      -(up[0] * c + up[1] * s), up[0] * s - up[1] * c };
  }
  double GetReach() const { return std::hypot(this->Offset[0], this->Offset[1]); }
  double GetLean() const { return std::hypot(this->Body.Up[0], this->Body.Up[1]); }
  /// Returns the smallest m in a range of directions, below 0 where it is not known: a sine that is positive
  /// at both ends, less than pi apart, is nowhere less in between.
  double GetMinimumM(double from, double to) const
  {
    return to - from < 3.0 ? std::min(this->Resolve(from).M, this->Resolve(to).M) - this->Bound : -1.0;
  }
  /// On level ground angle and rise grow with m, and are smallest at the ends of the range.
  bool IsMinimumAtEnds(double from, double to) const
  {
    return this->GetLean() == 0.0 && this->GetMinimumM(from, to) > 0.0;
  }
  /// Lower bounds of the angle and of the rise in a range, which do not depend on derivatives.
  double GetAngleFloor(double from, double to) const
  {
    const double m = this->GetMinimumM(from, to);
    return m > 0.0 ? std::atan2(m, this->Body.Height + this->Bound) -
        std::atan2(this->GetLean(), this->Body.Up[2]) - 16.0 * UnitRoundoff
                   : -2.0 * HalfPi;
  }
  double GetRiseFloor(double from, double to) const
  {
    const double angle = this->GetAngleFloor(from, to);
    const double half = std::sin(0.5 * angle);
    return angle > 0.0 ? (2.0 - 64.0 * UnitRoundoff) * this->Body.Up[2] *
        std::hypot(this->GetMinimumM(from, to), this->Body.Height - this->Bound) * half * half
                       : 0.0;
  }
  /// Returns a bound of the angle's error, valid in every direction.
  double GetAngleError() const { return HalfPi * this->Bound / this->Body.Height + 8.0 * UnitRoundoff; }

  /// atan(x) has derivatives of at most 1 and 0.65; the lengths are relative to the heights.
  double GetAngleCurvature() const
  {
    const double m = this->GetReach() / this->Body.Height;
    const double lean = this->GetLean() / this->Body.Up[2];
    return m + 0.65 * m * m + lean + 0.65 * lean * lean;
  }
  DirectionValue EvaluateAngle(double angle) const
  {
    const auto [m, mSlope, lean, leanSlope] = this->Resolve(angle);
    const double z = this->Body.Height;
    const double uh = this->Body.Up[2];
    return { ComputeTip(m, z, lean, uh, this->Bound).Angle,
      z * mSlope / (m * m + z * z) - uh * leanSlope / (lean * lean + uh * uh), this->GetAngleError() };
  }

  /// The rise is u d - lean m - uh z with u = hypot(lean, uh) and d = hypot(m, z), as long as the angle is
  /// positive.
  double GetRiseCurvature() const
  {
    const double m = this->GetReach();
    const double z = this->Body.Height;
    const double lean = this->GetLean();
    return m * m / z + m + 6.0 * lean * m + (lean * lean / this->Body.Up[2] + lean) * std::hypot(m, z);
  }
  DirectionValue EvaluateRise(double angle) const
  {
    const auto [m, mSlope, lean, leanSlope] = this->Resolve(angle);
    const double z = this->Body.Height;
    const double uh = this->Body.Up[2];
    const double d = std::hypot(m, z);
    const double u = std::hypot(lean, uh);
    const double slope = u * m * mSlope / d + d * lean * leanSlope / u - leanSlope * m - lean * mSlope;
    const double maximum = std::hypot(this->GetReach(), z);
    const double error = this->GetAngleError();
    return { ComputeTip(m, z, lean, uh, this->Bound).Rise, slope,
      2.0 * this->Bound + (maximum + this->Bound) * (error + 0.5 * error * error) +
        16.0 * UnitRoundoff * maximum };
  }
};
}

Tip ComputeTip(double m, double z, double uv, double uh, double bound)
{
  const double d = std::hypot(m, z);
  const double u = std::hypot(uv, uh);
  Tip tip;
  tip.Angle = std::atan2(m, z) - std::atan2(uv, uh);
  // The angle under which a ball is seen is asin(bound / d).
  tip.AngleBound = bound < d ? HalfPi * bound / d + 8.0 * UnitRoundoff : 2.0 * HalfPi;
  const double half = std::sin(0.5 * tip.Angle);
  tip.Rise = tip.Angle > 0.0 ? 2.0 * u * d * half * half : 0.0;
  tip.RiseBound = u *
      (2.0 * bound * half * half +
        (d + bound) *
          (std::abs(std::sin(tip.Angle)) * tip.AngleBound + 0.5 * tip.AngleBound * tip.AngleBound)) +
    16.0 * UnitRoundoff * std::abs(tip.Rise);
  if (tip.Angle + tip.AngleBound <= 0.0)
  {
    tip.RiseBound = 0.0;
  }
  return tip;
}

void IncludeCorners(const SupportPolygon& polygon, const TipCase& body, double bound, MinimumTip& minimum)
{
  // Corner i belongs to the directions between the outward normals of the sides before and after it. Any
  // point of the polygon gives a lower bound of m(d), so that the rounding of the normals does no harm as
  // long as the ranges leave no gap.
  const std::vector<Point2>& corners = polygon.Corners;
  const std::size_t count = corners.size();
  if (count == 1)
  {
    // Over a single point the centre can move without rising.
    minimum.Rise[1] = 0.0;
  }
  std::vector<double> normals(std::max<std::size_t>(count, 1), 0.0);
  for (std::size_t i = 0; i < count && count > 1; ++i)
  {
    const Point2& from = corners[i];
    const Point2& to = corners[(i + 1) % count];
    normals[i] = std::atan2(from[0] - to[0], to[1] - from[1]);
  }
  for (const bool rise : { false, true })
  {
    if (rise && !(minimum.Angle[0] > 0.0))
    {
      // The centre may be beyond the polygon, where tipping needs no rise.
      minimum.Rise[0] = 0.0;
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const CornerTip corner{ body, { corners[i][0] - body.Center[0], corners[i][1] - body.Center[1] },
        bound };
      const double from = normals[(i + count - 1) % count];
      const double to = from + GetTurn(from, normals[i], count);
      if (corner.IsMinimumAtEnds(from, to))
      {
        continue;
      }
      if (rise)
      {
        SearchDirections(
          from, to, corner.GetRiseCurvature(), corner.GetRiseFloor(from, to),
          [&](double a) { return corner.EvaluateRise(a); }, minimum.Rise);
      }
      else
      {
        SearchDirections(
          from, to, corner.GetAngleCurvature(), corner.GetAngleFloor(from, to),
          [&](double a) { return corner.EvaluateAngle(a); }, minimum.Angle);
      }
    }
  }
}
}
