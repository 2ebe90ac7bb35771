#include "smOCCTFaceInspection.h"

#include "smOCCTCompleteLoops.h"

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_Plane.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
using Point2 = std::array<double, 2>;

/// Segments that stand for a coedge's trim.
constexpr int Samples = 8;

/// A loop as points in (u,v), in its direction. Edges that are projected get their EdgeDistance.
std::vector<Point2> SampleLoop(const DraftFace& face, DraftLoop& loop)
{
  std::vector<Point2> points;
  const auto plane = Handle(Geom_Plane)::DownCast(face.Surface);
  for (DraftCoedge& coedge : loop)
  {
    TopLoc_Location location;
    double first = coedge.Trim.First;
    double last = coedge.Trim.Last;
    Handle(Geom_Curve) curve;
    gp_Trsf placement;
    if (coedge.Projected)
    {
      curve = BRep_Tool::Curve(coedge.Edge, location, first, last);
      placement = face.Location.Inverted() * location.Transformation();
    }
    for (int i = 0; i <= Samples; ++i)
    {
      const double x = static_cast<double>(coedge.Reversed ? Samples - i : i) / Samples;
      const double t = (1.0 - x) * first + x * last;
      Point2 uv{};
      if (coedge.Projected)
      {
        const gp_Pnt point = curve->Value(t).Transformed(placement);
        coedge.EdgeDistance = std::max(coedge.EdgeDistance, plane->Pln().Distance(point));
        ElSLib::Parameters(plane->Pln(), point, uv[0], uv[1]);
      }
      else
      {
        uv = coedge.Trim.Evaluate(t);
      }
      points.push_back(uv);
    }
  }
  return points;
}

/// Largest distance in space between the end of a coedge and the start of the next.
double GetLargestGap(const DraftFace& face, const std::vector<Point2>& points)
{
  double gap = 0.0;
  for (std::size_t i = Samples; i < points.size(); i += Samples + 1)
  {
    const Point2& a = points[i];
    const Point2& b = points[(i + 1) % points.size()];
    const double own = face.Surface->Value(a[0], a[1]).Distance(face.Surface->Value(b[0], b[1]));
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

/// Share of a loop in the integral of r . (Su x Sv) / 3, by Green's theorem from u = `base` on.
double GetConeVolume(
  const DraftFace& face, const std::vector<Point2>& points, double area, double base, const gp_Pnt& origin)
{
  gp_Pnt p;
  gp_Vec du;
  gp_Vec dv;
  const auto flux = [&](double u, double v)
  {
    face.Surface->D1(u, v, p, du, dv);
    return gp_Vec(origin, p).Dot(du.Crossed(dv)) / 3.0;
  };
  if (!Handle(Geom_Plane)::DownCast(face.Surface).IsNull())
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
      // Four points of Gauss.
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
}

FaceInspection InspectFace(DraftFace& face, const gp_Pnt& origin, double tolerance)
{
  FaceInspection result;
  result.Problem = face.Defects > 0 ? "one of its edges cannot be used"
    : face.Loops.empty()            ? "it has no loops"
                                    : CompleteLoops(face);
  if (!result.Problem.empty())
  {
    return result;
  }
  std::vector<double> areas;
  std::vector<NativeBox> boxes;
  std::size_t largest = 0;
  for (DraftLoop& loop : face.Loops)
  {
    const std::vector<Point2> points = SampleLoop(face, loop);
    const bool isOnSurface = std::all_of(
      loop.begin(), loop.end(), [tolerance](const DraftCoedge& c) { return c.EdgeDistance <= tolerance; });
    if (!isOnSurface)
    {
      result.Problem = "an edge lies beside it";
      return result;
    }
    if (!(GetLargestGap(face, points) <= tolerance))
    {
      result.Problem = "a loop does not close";
      return result;
    }
    areas.push_back(GetArea(points));
    boxes.push_back(GetBox(points));
    largest = std::abs(areas.back()) > std::abs(areas[largest]) ? areas.size() - 1 : largest;
    result.ConeVolume += GetConeVolume(face, points, areas.back(), boxes[0].Low[0], origin);
  }
  if (!(areas[largest] > 0.0))
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
