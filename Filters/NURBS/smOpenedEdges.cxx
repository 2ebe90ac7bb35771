#include "smModelEdit.h"
#include "smNetChange.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
namespace
{
// Parameters of a coedge where gaps are measured, at least; spread over the pieces of its curves, one in each at least.
constexpr std::size_t Samples = 32;
// Relative to the size of the body: rounding of what is compared, many times over.
constexpr double OpeningTolerance = 1e-12;
constexpr int FootSteps = 3;

/// Distance of a point from a curve near parameter t, by Newton's method for the foot point; never more than at t itself.
double GetDistance(const EdgeCurve& curve, double t, const double point[3])
{
  double least = std::numeric_limits<double>::max();
  for (int step = 0; step <= FootSteps; ++step)
  {
    EdgeCurve::Point tangent;
    const EdgeCurve::Point foot = curve.Evaluate(t, &tangent);
    const double off[3] = { point[0] - foot[0], point[1] - foot[1], point[2] - foot[2] };
    const double distance = std::hypot(off[0], off[1], off[2]);
    if (!(distance < least))
    {
      return std::isnan(distance) ? distance : least;
    }
    least = distance;
    const double speed = tangent[0] * tangent[0] + tangent[1] * tangent[1] + tangent[2] * tangent[2];
    if (!(speed > 0.0))
    {
      break;
    }
    const double dot = off[0] * tangent[0] + off[1] * tangent[1] + off[2] * tangent[2];
    t = std::clamp(t + dot / speed, curve.GetStart(), curve.GetEnd());
  }
  return least;
}

double MeasureGap(const Face& face, const Coedge& coedge)
{
  const EdgeCurve& curve = coedge.Use->Curve;
  if (curve.GetNumberOfPieces() < 1 || coedge.Curve.GetNumberOfPieces() < 1)
  {
    return 0.0;
  }
  std::vector<double> breaks = coedge.Curve.Breaks;
  breaks.insert(breaks.end(), curve.Breaks.begin(), curve.Breaks.end());
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  const std::size_t each = Samples / std::max<std::size_t>(breaks.size() - 1, 1) + 1;
  double gap = 0.0;
  for (std::size_t i = 0; i < breaks.size(); ++i)
  {
    // A break, then the piece from there to the next: at the breaks alone a fitted curve looks better than it is.
    const double width = i + 1 < breaks.size() ? breaks[i + 1] - breaks[i] : 0.0;
    for (std::size_t k = 0; k <= (width > 0.0 ? each : 0); ++k)
    {
      const double t = breaks[i] + width * (k == 0 ? 0.0 : (k - 0.5) / each);
      const TrimCurve::Point uv = coedge.Curve.Evaluate(t);
      double position[3];
      face.Surface.Evaluate(uv[0], uv[1], position);
      const double distance = GetDistance(curve, t, position);
      gap = std::isnan(gap) || distance <= gap ? gap : distance;
    }
  }
  return gap;
}

std::vector<OpenedEdge> CompareFace(const Face& before, const Face& after, int index, double tolerance)
{
  std::vector<OpenedEdge> opened;
  // Only where all of them are valid.
  const bool measurable = before.Surface.Check().empty() && after.Surface.Check().empty();
  for (std::size_t l = 0; measurable && l < after.Loops.size(); ++l)
  {
    const std::vector<Coedge>& coedges = after.Loops[l].Coedges;
    const std::vector<Coedge> none;
    const std::vector<Coedge>& old = l < before.Loops.size() ? before.Loops[l].Coedges : none;
    for (std::size_t c = 0; c < coedges.size(); ++c)
    {
      const double gap = MeasureGap(after, coedges[c]);
      if (gap <= tolerance)
      {
        continue;
      }
      // A loop that became another has no past: all of its gap is new.
      const double past = old.size() == coedges.size() ? MeasureGap(before, old[c]) : 0.0;
      if (!(gap <= past + tolerance))
      {
        opened.push_back({ coedges[c].Use, index, static_cast<int>(l), static_cast<int>(c), past, gap });
      }
    }
  }
  return opened;
}

/// Signed sum of the uses of every edge that is no point.
std::unordered_map<const Edge*, int> CountUses(
  vtkTrimmedNURBSModel* model, std::vector<std::shared_ptr<const Edge>>& edges)
{
  std::unordered_map<const Edge*, int> uses;
  for (const FacePointer& face : model->GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (!coedge.Use->Degenerate)
        {
          const auto [place, isNew] = uses.emplace(coedge.Use.get(), 0);
          place->second += coedge.Reversed == face->Reversed ? 1 : -1;
          if (isNew)
          {
            edges.push_back(coedge.Use);
          }
        }
      }
    }
  }
  return uses;
}
}

std::vector<OpenedEdge> FindOpenedEdges(vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after)
{
  std::vector<OpenedEdge> opened;
  const std::size_t count = std::min(before->GetFaces().size(), after->GetFaces().size());
  const double tolerance = OpeningTolerance * GetBodySize(before);
  std::vector<std::vector<OpenedEdge>> found(count);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const FacePointer& old = before->GetFaces()[f];
        const FacePointer& now = after->GetFaces()[f];
        if (old != now)
        {
          found[f] = CompareFace(*old, *now, static_cast<int>(f), tolerance);
        }
      }
    });
  for (const std::vector<OpenedEdge>& face : found)
  {
    opened.insert(opened.end(), face.begin(), face.end());
  }
  std::vector<std::shared_ptr<const Edge>> oldEdges;
  std::vector<std::shared_ptr<const Edge>> edges;
  const std::unordered_map<const Edge*, int> oldUses = CountUses(before, oldEdges);
  for (const auto& [edge, sum] : CountUses(after, edges))
  {
    const auto old = oldUses.find(edge);
    if (sum != 0 && old != oldUses.end() && old->second == 0)
    {
      const auto owner = std::find_if(
        edges.begin(), edges.end(), [e = edge](const auto& pointer) { return pointer.get() == e; });
      opened.push_back({ *owner, -1, 0, 0, 0.0, std::numeric_limits<double>::infinity() });
    }
  }
  // The widest first, what is no number among them; in the order of the edges' ids, where these are equal, for the map has none.
  const auto width = [](const OpenedEdge& edge)
  { return std::isnan(edge.Gap) ? std::numeric_limits<double>::infinity() : edge.Gap; };
  std::sort(opened.begin(), opened.end(),
    [&width](const OpenedEdge& a, const OpenedEdge& b)
    {
      return width(a) != width(b)      ? width(a) > width(b)
        : a.Source->Id != b.Source->Id ? a.Source->Id < b.Source->Id
                                       : a.Face < b.Face;
    });
  return opened;
}
}
