#include "smFaceInspection.h"

#include "Geometry/smCurveFoot.h"
#include "Geometry/smPlacement.h"
#include "smCompleteLoops.h"
#include "smNaturalBoundary.h"
#include "smReverseEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
/// Number of segments that approximate a coedge's trim curve.
constexpr int Samples = 8;

/// If an edge is farther from its surface than this, relative to the face's size, its foot points are not
/// meaningful.
constexpr double MaxShare = 0.02;

/// Returns the distance of a point from an edge.
double GetDistance(const EdgeShape& edge, const Vector3& point)
{
  const Vector3 own = Invert(edge.Location).MapPoint(point);
  double t = FindCurveParameter<3>(*edge.Curve, own);
  const double period = edge.Curve->GetPeriod();
  t -= period > 0.0 ? std::floor((t - edge.First) / period) * period : 0.0;
  double distance = std::numeric_limits<double>::infinity();
  for (const double x : { std::clamp(t, edge.First, edge.Last), edge.First, edge.Last })
  {
    distance = std::min(distance, Norm(Subtract(edge.Curve->Evaluate(x), own)));
  }
  return distance;
}

/// Loops as points in (u,v), in the direction of the loops, and the box of their edges in space.
struct SampledLoops
{
  std::vector<std::vector<Point2>> Loops;
  Vector3 Low{ 1e300, 1e300, 1e300 };
  Vector3 High{ -1e300, -1e300, -1e300 };
};

/// Samples a coedge and sets its EdgeDistance. A trim curve of the file may be parametrised differently from
/// its edge: if points at equal parameter are farther apart than `tolerance`, the distance from the nearest
/// point of the edge's curve is used.
void SampleCoedge(const DraftFace& face, double tolerance, DraftCoedge& coedge, SampledLoops& result)
{
  const ElementarySurface* plane = FindElementary(*face.Surface, ElementarySurface::Type::Plane);
  const EdgeShape* edge = coedge.Edge && !coedge.Degenerate && coedge.Edge->Curve ? coedge.Edge : nullptr;
  const Placement toSurface = Invert(face.Location);
  for (int i = 0; i <= Samples; ++i)
  {
    const double x = static_cast<double>(coedge.Reversed ? Samples - i : i) / Samples;
    const Vector3 point = edge ? toSurface.MapPoint(edge->EvaluateAt(x)) : Vector3{};
    Point2 uv{};
    if (coedge.Projected)
    {
      const Vector3 away = Subtract(point, plane->Frame.Origin);
      uv = { Dot(away, plane->Frame.Axes[0]), Dot(away, plane->Frame.Axes[1]) };
    }
    else
    {
      uv = coedge.Trim.Evaluate((1.0 - x) * coedge.Trim.First + x * coedge.Trim.Last);
    }
    result.Loops.back().push_back(uv);
    if (!edge)
    {
      continue;
    }
    const Vector3 foot = face.Surface->Evaluate(uv[0], uv[1]);
    double distance = Norm(Subtract(foot, point));
    if (distance > tolerance && !coedge.Projected && !coedge.Trim.Feet)
    {
      distance = std::min(distance, GetDistance(*edge, face.Location.MapPoint(foot)));
    }
    coedge.EdgeDistance = distance <= coedge.EdgeDistance ? coedge.EdgeDistance : distance;
    for (int c = 0; c < 3; ++c)
    {
      result.Low[c] = std::min(result.Low[c], point[c]);
      result.High[c] = std::max(result.High[c], point[c]);
    }
  }
}

/// Returns the largest distance in space between the end of a coedge and the start of the next one.
double GetMaxGap(const DraftFace& face, const std::vector<Point2>& points)
{
  double gap = 0.0;
  for (std::size_t i = Samples; i < points.size(); i += Samples + 1)
  {
    const Point2& a = points[i];
    const Point2& b = points[(i + 1) % points.size()];
    const double own = Norm(Subtract(face.Surface->Evaluate(a[0], a[1]), face.Surface->Evaluate(b[0], b[1])));
    gap = own <= gap ? gap : own;
  }
  return gap;
}

double GetArea(const std::vector<Point2>& points)
{
  double area = 0.0;
  const Point2& o = points[0];
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    const Point2& a = points[i];
    const Point2& b = points[i + 1];
    area += 0.5 * ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]));
  }
  return area;
}

/// Returns the contribution of a loop to the integral of r . (Su x Sv) / 3, by Green's theorem from u =
/// `base` on.
double GetConeVolume(
  const DraftFace& face, const std::vector<Point2>& points, double area, double base, const Vector3& origin)
{
  GeometricSurface::Derivatives at;
  const auto flux = [&](double u, double v)
  {
    face.Surface->Evaluate(u, v, 1, at);
    return Dot(Subtract(at[0][0], origin), Cross(at[1][0], at[0][1])) / 3.0;
  };
  if (FindElementary(*face.Surface, ElementarySurface::Type::Plane))
  {
    return area * flux(0.0, 0.0);
  }
  double volume = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2& a = points[i];
    const Point2& b = points[(i + 1) % points.size()];
    const double width = 0.5 * (a[0] + b[0]) - base;
    const double v = 0.5 * (a[1] + b[1]);
    if (a[1] != b[1])
    {
      // Gauss rule with four points.
      for (const auto& [x, w] :
        { std::make_pair(0.0694318442, 0.1739274226), std::make_pair(0.3300094782, 0.3260725774),
          std::make_pair(0.6699905218, 0.3260725774), std::make_pair(0.9305681558, 0.1739274226) })
      {
        volume += (b[1] - a[1]) * width * w * flux(base + x * width, v);
      }
    }
  }
  return volume;
}

/// Returns the reason why the edges do not lie on the surface; empty if they do, up to gaps that ribbons may
/// close.
std::string FindWideGap(const DraftFace& face, double tolerance, double largestGap)
{
  for (const DraftLoop& loop : face.Loops)
  {
    for (const DraftCoedge& coedge : loop)
    {
      if (!(coedge.EdgeDistance <= std::max(tolerance, largestGap)))
      {
        return "an edge lies off it";
      }
      if (!(coedge.Overhang <= largestGap))
      {
        return "an edge leads beyond its surface";
      }
    }
  }
  return {};
}

/// Returns true if a loop is narrower in space than the allowed gaps, so that its orientation cannot be
/// determined.
bool IsSliver(const DraftFace& face, const std::vector<Point2>& points, double area, double tolerance)
{
  double length = 0.0;
  Vector3 last = face.Surface->Evaluate(points.back()[0], points.back()[1]);
  double speed = 0.0;
  for (const Point2& p : points)
  {
    GeometricSurface::Derivatives at;
    face.Surface->Evaluate(p[0], p[1], 1, at);
    speed = std::max(speed, Norm(Cross(at[1][0], at[0][1])));
    length += Norm(Subtract(at[0][0], last));
    last = at[0][0];
  }
  return std::abs(area) * speed <= 0.5 * tolerance * length;
}

NativeBox GetBox(const std::vector<Point2>& points)
{
  NativeBox box{ { 1e300, 1e300 }, { -1e300, -1e300 } };
  for (const Point2& p : points)
  {
    for (int d = 0; d < 2; ++d)
    {
      box.Low[d] = std::min(box.Low[d], p[d]);
      box.High[d] = std::max(box.High[d], p[d]);
    }
  }
  return box;
}

/// Inspects completed loops. `isOutside` is set to true if the largest one is a hole.
FaceInspection InspectLoops(
  DraftFace& face, const Vector3& origin, double tolerance, double largestGap, bool& isOutside)
{
  FaceInspection result;
  SampledLoops sampled;
  for (DraftLoop& loop : face.Loops)
  {
    sampled.Loops.emplace_back();
    for (DraftCoedge& coedge : loop)
    {
      SampleCoedge(face, tolerance, coedge, sampled);
    }
  }
  const double size = Norm(Subtract(sampled.High, sampled.Low));
  result.Problem = FindWideGap(face, tolerance, std::min(largestGap, MaxShare * size));
  if (!result.Problem.empty())
  {
    return result;
  }
  std::vector<double> areas;
  std::vector<NativeBox> boxes;
  std::size_t largest = 0;
  for (const std::vector<Point2>& points : sampled.Loops)
  {
    if (!(GetMaxGap(face, points) <= tolerance))
    {
      result.Problem = "a loop does not close";
      return result;
    }
    areas.push_back(GetArea(points));
    boxes.push_back(GetBox(points));
    largest = std::abs(areas.back()) > std::abs(areas[largest]) ? areas.size() - 1 : largest;
    result.ConeVolume += GetConeVolume(face, points, areas.back(), boxes[0].Low[0], origin);
  }
  if (face.ReversedEdges > 0 && areas[largest] < 0.0)
  {
    ReverseLoop(face);
    areas[largest] = -areas[largest];
    result.ConeVolume = -result.ConeVolume;
  }
  isOutside = !(areas[largest] > 0.0) && !IsSliver(face, sampled.Loops[largest], areas[largest], tolerance);
  if (isOutside)
  {
    result.Problem = "its outer loop runs the wrong way";
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    bool isInside = i != largest && areas[i] > 0.0;
    for (int d = 0; d < 2; ++d)
    {
      const double middle = 0.5 * (boxes[i].Low[d] + boxes[i].High[d]);
      isInside = isInside && middle > boxes[largest].Low[d] && middle < boxes[largest].High[d];
    }
    if (isInside)
    {
      result.Problem = "a hole runs the wrong way";
    }
  }
  return result;
}
}

FaceInspection InspectFace(DraftFace& face, const Vector3& origin, double tolerance, double largestGap)
{
  FaceInspection result;
  ReverseEdges(face);
  result.Problem = face.Defects > 0 ? "one of its edges cannot be used"
    : face.Loops.empty()            ? "it has no loops"
                                    : CompleteLoops(face);
  if (!result.Problem.empty())
  {
    return result;
  }
  bool isOutside = false;
  result = InspectLoops(face, origin, tolerance, largestGap, isOutside);
  // The standard has the face on the left of its loops: on a closed surface a hole can be the only loop.
  const bool isHole = isOutside && !HasSeam(face) && IsOnClosedSurface(face);
  if (isHole && AddNaturalBoundary(face))
  {
    result = InspectLoops(face, origin, tolerance, largestGap, isOutside);
  }
  result.Outside = isHole;
  return result;
}
}
