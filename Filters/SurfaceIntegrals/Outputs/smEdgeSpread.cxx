#include "smEdgeSpread.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
namespace
{
/// A point of a boundary is in a plane if it is so near to it, relative to its distance from the edge or the
/// tolerance.
constexpr double PlaneTolerance = 1e-6;
constexpr int MaxSteps = 20;
/// Differences of coordinates within so many u of them are roundings.
constexpr double CoordinateRoundings = 16.0;
/// Weight of the first and last point of the rule of four of the points of two such rules on the halves of
/// [0,1], exact for polynomials of degree 3.
constexpr double OuterWeight = 0.20696685170880647;
/// Largest error of a rule relative to its value, as far as so many halvings of an interval lead.
constexpr double RuleTolerance = 0.02;
constexpr int MaxHalvings = 5;
/// Cosine of the largest angle between a surface and its edge at which sections are curves across the edge.
constexpr double MinCosine = 0.5;
/// Nodes and weights of the Gauss rule of three points on [0,1].
constexpr double GaussNodes[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
constexpr double GaussWeights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };

/// A vector in a plane normal to the edge.
struct Planar
{
  double X = 0.0;
  double Y = 0.0;
};

double Wedge(const Planar& a, const Planar& b)
{
  return a.X * b.Y - a.Y * b.X;
}

double Length(const Planar& a)
{
  return std::hypot(a.X, a.Y);
}

Planar Minus(const Planar& a, const Planar& b)
{
  return { a.X - b.X, a.Y - b.Y };
}

Vector3 Combine(double a, const Vector3& x, double b, const Vector3& y)
{
  return { a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2] };
}

/// Returns the second derivative of a polynomial curve, with its point and derivative.
Vector3 EvaluateBend(const EdgeCurve& curve, double t, Vector3& point, Vector3& derivative)
{
  const int piece = curve.FindPiece(t);
  const double width = curve.Breaks[piece + 1] - curve.Breaks[piece];
  const BernsteinPiece<3> source = curve.GetPiece(piece);
  point = curve.Evaluate(t, &derivative);
  if (source.Degree < 2)
  {
    return { 0.0, 0.0, 0.0 };
  }
  std::array<double, 3> differences[MaximumDegree + 1];
  for (int i = 0; i < source.Degree; ++i)
  {
    differences[i] = Subtract(source.Coefficients[i + 1], source.Coefficients[i]);
  }
  std::array<double, 3> bend;
  BernsteinPiece<3>{ differences, source.Degree - 1 }.Evaluate((t - curve.Breaks[piece]) / width, &bend);
  const double scale = source.Degree / (width * width);
  return { scale * bend[0], scale * bend[1], scale * bend[2] };
}

/// A plane normal to the edge's curve C: coordinates in it have their origin at C.
struct NormalPlane
{
  double Parameter = 0.0;
  Vector3 Point;
  Vector3 Velocity;
  Vector3 Tangent;
  double Speed = 0.0;
  double Curvature = 0.0;
  Vector3 First;
  Vector3 Second;

  NormalPlane(const EdgeCurve& curve, double parameter)
    : Parameter(parameter)
  {
    const Vector3 bend = EvaluateBend(curve, parameter, this->Point, this->Velocity);
    this->Speed = Norm(this->Velocity);
    if (!(this->Speed > 0.0))
    {
      return;
    }
    this->Tangent = Normalized(this->Velocity);
    this->Curvature = Norm(Cross(this->Tangent, bend)) / (this->Speed * this->Speed);
    int smallest = 0;
    for (int d = 1; d < 3; ++d)
    {
      smallest = std::abs(this->Tangent[d]) < std::abs(this->Tangent[smallest]) ? d : smallest;
    }
    Vector3 axis{};
    axis[smallest] = 1.0;
    this->First = Normalized(Cross(this->Tangent, axis));
    this->Second = Cross(this->Tangent, this->First);
  }
  Planar Project(const Vector3& v) const { return { Dot(v, this->First), Dot(v, this->Second) }; }
};

/// The boundary of a face in a plane normal to the edge, and the section of the face's surface there: a curve
/// y(x) over its tangent at the boundary's point, with |y''| <= Bend.
struct Section
{
  /// The boundary's point, relative to the edge's.
  Planar Gap;
  /// The unit tangent, and the range of x that a closing may use; the boundary's point has x = 0.
  Planar Along;
  double Low = 0.0;
  double High = 0.0;
  double Bend = 0.0;
  /// Factor of areas of the surface over those of their projections to the plane of tangents.
  double Slope = 1.0;
  /// Signed volume by the lag of the boundary's parameter behind the edge's, per unit of parameter: what
  /// ribbons between equal parameters and those in normal planes differ by.
  double Lean = 0.0;
  double Sign = 1.0;

  double GetReach() const { return Length(this->Gap) + std::max(std::abs(this->Low), std::abs(this->High)); }
  /// Returns the integral of |x - s| |s - p| / 2 over s from 0 to x: times Bend it bounds what the section's
  /// curvature adds to the area that a segment from the section to a point with coordinate p sweeps.
  static double IntegrateKernel(double x, double p)
  {
    const double whole = x * x * x / 12.0 - p * x * x / 4.0;
    const double rest = (x - p) * (x - p) * (x - p) / 12.0;
    const bool isBetween = p * x > 0.0 && std::abs(p) < std::abs(x);
    return isBetween ? std::abs(whole - rest) + std::abs(rest) : std::abs(whole);
  }
  double GetBendArea(const Planar& from) const
  {
    const Planar offset = Minus(from, this->Gap);
    const double p = offset.X * this->Along.X + offset.Y * this->Along.Y;
    return this->Bend * std::max(IntegrateKernel(this->Low, p), IntegrateKernel(this->High, p));
  }
  /// Returns the signed area per x that a segment from `from` to the section sweeps.
  double GetRate(const Planar& from) const
  {
    return 0.5 * this->Sign * Wedge(Minus(this->Gap, from), this->Along);
  }
};

/// Follows the boundary of a face from plane to plane.
class SectionFinder
{
public:
  enum class Outcome
  {
    Found,
    BeyondEnd,
    NotFound
  };

  SectionFinder(const EdgeCurve& curve, const EdgeUse& use, double tolerance)
    : Curve(curve)
    , Use(use)
    , Tolerance(tolerance)
    , Surface(use.Source->Surface)
  {
  }

  /// Finds the point of the boundary in the plane by Newton's method. If `step` is not 0, it measures the
  /// curvature of the surface across the edge, by at least that step; else that of the last time counts.
  Outcome Find(const NormalPlane& plane, double step, Section& section)
  {
    const TrimCurve& trim = this->Use.Boundary->Curve;
    const double low = trim.GetStart();
    const double high = trim.GetEnd();
    double t = std::min(std::max(plane.Parameter + this->Lag, low), high);
    for (int i = 0; i < MaxSteps; ++i)
    {
      this->Evaluate(t);
      const Vector3 gap = Subtract(this->Point, plane.Point);
      const double along = Dot(gap, plane.Tangent);
      const double speed = Dot(this->Velocity, plane.Tangent);
      const double rounding = CoordinateRoundings * UnitRoundoff * (Norm(plane.Point) + Norm(this->Point)) +
        PlaneTolerance * this->Tolerance;
      if (std::abs(along) <= PlaneTolerance * Norm(gap) + rounding)
      {
        this->Lag = t - plane.Parameter;
        return this->Describe(plane, gap, speed, step, section) ? Outcome::Found : Outcome::NotFound;
      }
      if (!(speed > MinCosine * Norm(this->Velocity)))
      {
        return Outcome::NotFound;
      }
      const double next = t - along / speed;
      if ((t == low && next < low) || (t == high && next > high))
      {
        return Outcome::BeyondEnd;
      }
      t = std::min(std::max(next, low), high);
    }
    return Outcome::NotFound;
  }

  /// Returns the distance of the points with equal parameters.
  double GetDistance(const NormalPlane& plane)
  {
    this->Evaluate(plane.Parameter);
    return Norm(Subtract(this->Point, plane.Point));
  }

private:
  void Evaluate(double t)
  {
    std::array<double, 2> slope;
    this->Parameters = this->Use.Boundary->Curve.Evaluate(t, &slope);
    this->Surface.Evaluate(this->Parameters[0], this->Parameters[1], this->Point.data(),
      this->Derivatives[0].data(), this->Derivatives[1].data());
    this->Velocity = Combine(slope[0], this->Derivatives[0], slope[1], this->Derivatives[1]);
  }

  /// Returns false if the section is not a curve across the edge.
  bool Describe(
    const NormalPlane& plane, const Vector3& gap, double speed, double smallestStep, Section& section)
  {
    const Vector3 cross = Cross(this->Derivatives[0], this->Derivatives[1]);
    const double size = Norm(cross);
    if (!(size > 0.0))
    {
      return false;
    }
    const Vector3 normal{ cross[0] / size, cross[1] / size, cross[2] / size };
    const Vector3 across = Cross(normal, plane.Tangent);
    const double cosine = Norm(across);
    if (!(cosine > MinCosine))
    {
      return false;
    }
    const Vector3 unit{ across[0] / cosine, across[1] / cosine, across[2] / cosine };
    // What is within the rounding of coordinates is part of the numerical bound.
    const double rounding = CoordinateRoundings * UnitRoundoff * (Norm(plane.Point) + Norm(this->Point));
    const double distance = Norm(gap) > rounding ? Norm(gap) : 0.0;
    const double range = std::max(distance, this->Tolerance);
    section.Sign = this->Use.GetSign();
    section.Gap = distance > 0.0 ? plane.Project(gap) : Planar{};
    section.Along = plane.Project(unit);
    section.Slope = 1.0 / cosine;
    const double foot = -(section.Gap.X * section.Along.X + section.Gap.Y * section.Along.Y);
    section.Low = foot - range;
    section.High = foot + range;
    if (smallestStep > 0.0)
    {
      const double step = std::max({ -section.Low, section.High, smallestStep });
      this->MeasureBend(unit, normal, cross, step);
    }
    section.Bend = this->Bend / (cosine * cosine * cosine);
    section.Lean = distance > 0.0 ? this->GetLean(plane, speed) : 0.0;
    return true;
  }

  /// Measures the surface's curvature in a direction at the last point, by the second difference of points
  /// that are `step` apart: its mean over them with the weights of a hat.
  void MeasureBend(const Vector3& unit, const Vector3& normal, const Vector3& cross, double step)
  {
    const double squared = Dot(cross, cross);
    const double du = Dot(Cross(unit, this->Derivatives[1]), cross) / squared;
    const double dv = Dot(Cross(this->Derivatives[0], unit), cross) / squared;
    double sum = 0.0;
    for (const double way : { -step, step })
    {
      Vector3 side;
      this->Surface.Evaluate(this->Parameters[0] + way * du, this->Parameters[1] + way * dv, side.data());
      sum += Dot(Subtract(side, this->Point), normal);
    }
    const double rounding = CoordinateRoundings * UnitRoundoff * Norm(this->Point);
    // NaN goes through, here and below: the spread is not known then.
    this->Bend = std::abs(sum) <= rounding ? 0.0 : std::abs(sum) / (step * step);
  }

  double GetLean(const NormalPlane& plane, double speed) const
  {
    if (this->Lag == 0.0 || !(speed > 0.0))
    {
      return 0.0;
    }
    double sum = 0.0;
    for (const double node : { GaussNodes[0], GaussNodes[1], GaussNodes[2] })
    {
      Vector3 velocity;
      const Vector3 point = this->Curve.Evaluate(plane.Parameter + node * this->Lag, &velocity);
      sum += std::abs(Dot(Cross(Subtract(point, this->Point), velocity), this->Velocity)) / 3.0;
    }
    return std::abs(this->Lag) * sum / 6.0 * plane.Speed / speed;
  }

  const EdgeCurve& Curve;
  const EdgeUse& Use;
  double Tolerance;
  NURBSSurface::Walker Surface;
  /// Parameter of the last point on the boundary, less that of its plane.
  double Lag = 0.0;
  double Bend = 0.0;
  Point2 Parameters{};
  Vector3 Point;
  Vector3 Velocity;
  Vector3 Derivatives[2];
};

/// Returns the sample of a plane per unit of the edge's parameter, and the area.
SpreadSample AddUpSections(const NormalPlane& plane, const std::vector<Section>& sections, double& area)
{
  SpreadSample sample;
  sample.Position = plane.Point;
  Planar sum;
  for (const Section& section : sections)
  {
    sum.X += section.Sign * section.Gap.X;
    sum.Y += section.Sign * section.Gap.Y;
    sample.Reach = std::max(sample.Reach, section.GetReach());
  }
  // For a fixed point of the common curve every boundary moves by itself. What is swept is linear in that
  // point, and is largest at a corner of the hull.
  double trims = 0.0;
  double edges = 0.0;
  for (std::size_t corner = 0; corner <= sections.size(); ++corner)
  {
    const Planar point = corner == 0 ? Planar{} : sections[corner - 1].Gap;
    double added = 0.5 * Wedge(sum, point);
    double removed = -added;
    double swept = 0.0;
    double turned = 0.0;
    for (const Section& section : sections)
    {
      const double rate = section.GetRate(point);
      const double bend = section.GetBendArea(point);
      added += std::max(rate * section.Low, rate * section.High) + bend;
      removed += std::max(-rate * section.Low, -rate * section.High) + bend;
      swept += std::abs(rate) * std::max(std::abs(section.Low), std::abs(section.High)) + bend;
      turned += 0.5 * std::abs(Wedge(section.Gap, point));
    }
    sample.Added = std::max(sample.Added, added);
    sample.Removed = std::max(sample.Removed, removed);
    trims = std::max(trims, swept);
    edges = std::max(edges, turned);
  }
  sample.Swept = trims + edges;
  area = 0.0;
  double lean = 0.0;
  for (const Section& section : sections)
  {
    const double range = std::max(std::abs(section.Low), std::abs(section.High));
    area += range * section.Slope * std::hypot(1.0, section.Bend * range);
    lean += section.Lean;
  }
  // Planes normal to a curve are nearer to each other inside its bends, farther outside.
  const double bent = plane.Curvature * sample.Reach;
  const double more = bent * sample.Swept;
  area *= plane.Speed * (1.0 + bent);
  sample.Added = plane.Speed * (sample.Added + more) + lean;
  sample.Removed = plane.Speed * (sample.Removed + more) + lean;
  sample.Swept = plane.Speed * (1.0 + bent) * sample.Swept + lean;
  return sample;
}

/// Measures one edge.
class EdgeMeasurement
{
public:
  EdgeMeasurement(const Edge& edge, const std::vector<EdgeUse>& uses, double tolerance, double negligible)
    : Curve(edge.Curve)
    , Tolerance(tolerance)
    , Negligible(negligible)
    , Sections(uses.size())
  {
    this->Finders.reserve(uses.size());
    this->Breaks = edge.Curve.Breaks;
    for (const EdgeUse& use : uses)
    {
      this->Finders.emplace_back(edge.Curve, use, tolerance);
      const std::vector<double>& breaks = use.Boundary->Curve.Breaks;
      this->Breaks.insert(this->Breaks.end(), breaks.begin(), breaks.end());
    }
    std::sort(this->Breaks.begin(), this->Breaks.end());
  }

  std::shared_ptr<const EdgeSpread> Run()
  {
    auto result = std::make_shared<EdgeSpread>();
    const double low = this->Curve.GetStart();
    const double high = this->Curve.GetEnd();
    const double smallest = 1e-9 * (high - low);
    double start = low;
    for (const double end : this->Breaks)
    {
      if (end - start > smallest && end <= high)
      {
        this->AddInterval(start, end, 0, *result);
        start = end;
      }
    }
    return result;
  }

private:
  /// Integrates by two Gauss rules of three points. Twice their difference from the rule of the four outer
  /// points counts as their error; the interval is halved while that is not small.
  void AddInterval(double start, double end, int depth, EdgeSpread& result)
  {
    const std::size_t first = result.Samples.size();
    double coarse[4] = { 0.0, 0.0, 0.0, 0.0 };
    double fine[4] = { 0.0, 0.0, 0.0, 0.0 };
    const double width = 0.5 * (end - start);
    for (const double from : { start, start + width })
    {
      for (const int node : { 1, 0, 2 })
      {
        double area = 0.0;
        const bool isOuter = (node == 0) == (from == start);
        const NormalPlane plane(this->Curve, from + width * GaussNodes[node]);
        SpreadSample sample = this->Measure(plane, node == 1 ? 1e-3 * width * plane.Speed : 0.0, area);
        const double values[4] = { sample.Added, sample.Removed, sample.Swept, area };
        for (int i = 0; i < 4; ++i)
        {
          fine[i] += width * GaussWeights[node] * values[i];
          coarse[i] +=
            node == 1 ? 0.0 : 2.0 * width * (isOuter ? OuterWeight : 0.5 - OuterWeight) * values[i];
        }
        sample.Added *= width * GaussWeights[node];
        sample.Removed *= width * GaussWeights[node];
        sample.Swept *= width * GaussWeights[node];
        if (!(sample.Swept <= 0.0))
        {
          result.Samples.push_back(sample);
        }
      }
    }
    double errors[4];
    bool isFine = depth == MaxHalvings || !(fine[2] > this->Negligible);
    for (int i = 0; i < 4; ++i)
    {
      errors[i] = fine[i] <= 0.0 ? 0.0 : 2.0 * std::abs(fine[i] - coarse[i]) / fine[i];
    }
    isFine =
      isFine || (errors[0] <= RuleTolerance && errors[1] <= RuleTolerance && errors[3] <= RuleTolerance);
    if (!isFine)
    {
      result.Samples.resize(first);
      this->AddInterval(start, start + width, depth + 1, result);
      this->AddInterval(start + width, end, depth + 1, result);
      return;
    }
    for (std::size_t i = first; i < result.Samples.size(); ++i)
    {
      result.Samples[i].Added *= 1.0 + errors[0];
      result.Samples[i].Removed *= 1.0 + errors[1];
      result.Samples[i].Swept *= 1.0 + errors[2];
    }
    result.Area += (1.0 + errors[3]) * fine[3];
  }

  SpreadSample Measure(const NormalPlane& plane, double step, double& area)
  {
    SpreadSample none;
    none.Position = plane.Point;
    if (!(plane.Speed > 0.0))
    {
      return none;
    }
    bool isComplete = true;
    for (std::size_t i = 0; i < this->Finders.size(); ++i)
    {
      this->Sections[i] = Section();
      const SectionFinder::Outcome outcome = this->Finders[i].Find(plane, step, this->Sections[i]);
      if (outcome == SectionFinder::Outcome::BeyondEnd)
      {
        return none;
      }
      isComplete = isComplete && outcome == SectionFinder::Outcome::Found;
    }
    return isComplete ? AddUpSections(plane, this->Sections, area) : this->MeasureRoughly(plane, area);
  }

  /// Counts all points within the range of every boundary, where some boundary has no point in the plane.
  SpreadSample MeasureRoughly(const NormalPlane& plane, double& area)
  {
    SpreadSample sample;
    sample.Position = plane.Point;
    area = 0.0;
    for (SectionFinder& finder : this->Finders)
    {
      const double distance = finder.GetDistance(plane);
      const double reach = distance + std::max(distance, this->Tolerance);
      sample.Reach = std::max(sample.Reach, reach);
      sample.Swept += plane.Speed * 4.0 * reach * reach;
      area += plane.Speed * 2.0 * reach;
    }
    sample.Added = sample.Removed = sample.Swept;
    return sample;
  }

  const EdgeCurve& Curve;
  double Tolerance;
  double Negligible;
  std::vector<SectionFinder> Finders;
  std::vector<Section> Sections;
  std::vector<double> Breaks;
};
}

double EdgeUse::GetSign() const
{
  return this->Source->Reversed == this->Boundary->Reversed ? 1.0 : -1.0;
}

std::shared_ptr<const EdgeSpread> MeasureEdge(
  const Edge& edge, const std::vector<EdgeUse>& uses, double tolerance, double negligible)
{
  return EdgeMeasurement(edge, uses, tolerance, negligible).Run();
}
}
