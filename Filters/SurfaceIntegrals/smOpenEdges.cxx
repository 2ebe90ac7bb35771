#include "smOpenEdges.h"

#include "smBodyIntegrals.h"
#include "smFormat.h"
#include "smVector.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace sm
{
namespace
{
constexpr double CoincidenceTolerance = 1e-9;
/// Ends of borders this close together, relative to all of them, are one point.
constexpr double JoinTolerance = 1e-6;

/// Returns parameters that determine a rational curve of the surface's degree in this direction: two borders that coincide there coincide.
std::vector<double> MakeSamples(const NURBSSurface& surface, int direction)
{
  const std::vector<double> breaks = surface.GetSpanBreaks(direction);
  const int count = 2 * surface.Degree[direction] + 1;
  std::vector<double> samples;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    for (int i = 0; i < count; ++i)
    {
      samples.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * i / (count - 1));
    }
  }
  return samples;
}

/// Points of the border where the parameter of the other direction is `at`.
std::vector<Vector3> EvaluateBorder(const NURBSSurface& surface, int direction, double at)
{
  std::vector<Vector3> points;
  for (const double along : MakeSamples(surface, direction))
  {
    Vector3 point;
    surface.Evaluate(direction == 0 ? along : at, direction == 0 ? at : along, point.data());
    points.push_back(point);
  }
  return points;
}

double GetLargestDistance(const std::vector<Vector3>& points, const std::vector<Vector3>& others)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    largest = std::max(largest, Norm(Subtract(points[i], others[i])));
  }
  return largest;
}

/// A border of a face without loops, in the direction in which the face lies left of it.
struct Border
{
  Vector3 Start, End;
  bool IsJoined = false;
};

/// Adds the borders of a face without loops at which it neither closes by itself nor ends in a point.
void AddBorders(const Face& face, std::vector<Border>& borders)
{
  // What is wrong with a surface is said where the face is cut.
  if (!face.Loops.empty() || !face.Surface.Check().empty())
  {
    return;
  }
  const NURBSSurface& surface = face.Surface;
  for (int direction = 0; direction < 2; ++direction)
  {
    const int other = 1 - direction;
    const std::vector<Vector3> first = EvaluateBorder(surface, direction, surface.GetDomainStart(other));
    const std::vector<Vector3> last = EvaluateBorder(surface, direction, surface.GetDomainEnd(other));
    const double across = GetLargestDistance(first, last);
    const std::vector<Vector3> middle =
      EvaluateBorder(surface, direction, 0.5 * (surface.GetDomainStart(other) + surface.GetDomainEnd(other)));
    const double size = std::max({ across, GetLargestDistance(middle, first),
      GetLargestDistance(middle, std::vector<Vector3>(middle.size(), middle.front())) });
    if (across <= CoincidenceTolerance * size)
    {
      continue;
    }
    for (const bool isLast : { false, true })
    {
      const std::vector<Vector3>& points = isLast ? last : first;
      const std::vector<Vector3> pole(points.size(), points.front());
      if (GetLargestDistance(points, pole) > CoincidenceTolerance * size)
      {
        // Counter-clockwise: s = 0 and r = 1 are passed backwards.
        const bool isBackwards = (isLast == (direction == 0)) != face.Reversed;
        borders.push_back({ isBackwards ? points.back() : points.front(),
          isBackwards ? points.front() : points.back(), false });
      }
    }
  }
}

/// Returns the number of borders that no other one joins: one with the same ends in the opposite direction.
int CountOpenBorders(const vtkTrimmedNURBSModel& model)
{
  std::vector<Border> borders;
  for (const FacePointer& face : model.GetFaces())
  {
    AddBorders(*face, borders);
  }
  double size = 0.0;
  for (const Border& border : borders)
  {
    size = std::max({ size, Norm(Subtract(border.Start, borders.front().Start)),
      Norm(Subtract(border.End, borders.front().Start)) });
  }
  const double tolerance = JoinTolerance * size;
  const auto getPlace = [](const Border& border) { return border.Start[0] + border.End[0]; };
  std::sort(borders.begin(), borders.end(),
    [&](const Border& a, const Border& b) { return getPlace(a) < getPlace(b); });
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    for (std::size_t j = i + 1; !borders[i].IsJoined && j < borders.size() &&
         getPlace(borders[j]) - getPlace(borders[i]) <= 2.0 * tolerance;
         ++j)
    {
      if (!borders[j].IsJoined && Norm(Subtract(borders[i].Start, borders[j].End)) <= tolerance &&
        Norm(Subtract(borders[i].End, borders[j].Start)) <= tolerance)
      {
        borders[i].IsJoined = borders[j].IsJoined = true;
      }
    }
  }
  return static_cast<int>(
    std::count_if(borders.begin(), borders.end(), [](const Border& border) { return !border.IsJoined; }));
}
}

std::string ListIds(const std::vector<int>& ids)
{
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 5); ++i)
  {
    list += (i > 0 ? ", #" : "#") + std::to_string(ids[i]);
  }
  return list + (ids.size() > 5 ? ", ..." : "");
}

void CountOpenEdges(BodyIntegrals& body)
{
  // The signed uses of an edge add up to 0 at a seam or a 2+2 non-manifold edge, but not at a border.
  std::unordered_map<const Edge*, int> uses;
  for (const FacePointer& face : body.Model->GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (!coedge.Use->Degenerate)
        {
          uses[coedge.Use.get()] += face->Reversed == coedge.Reversed ? 1 : -1;
        }
      }
    }
  }
  const int borders = CountOpenBorders(*body.Model);
  std::vector<int> open;
  for (const auto& [edge, sum] : uses)
  {
    if (sum != 0)
    {
      open.push_back(edge->FileId);
    }
  }
  body.OpenEdges = static_cast<int>(open.size()) + borders;
  if (body.OpenEdges == 0)
  {
    if (!body.IsSolid())
    {
      body.Messages.push_back("a closed shell that the file does not call a solid; its volume is given");
    }
    return;
  }
  if (!body.IsSolid())
  {
    body.Flag(Status::Open, "a surface, not a solid: it has an area and no volume");
    return;
  }
  if (borders > 0)
  {
    body.Flag(Status::Open,
      FormatCount(borders, "border", "borders") +
        " of faces without loops, which neither edges nor ends join with other faces, are open: the volume "
        "depends on the origin");
  }
  if (open.empty())
  {
    return;
  }
  std::sort(open.begin(), open.end());
  body.Flag(Status::Open,
    FormatCount(open.size(), "edge is", "edges are") + " not shared by two faces (" + ListIds(open) +
      "): the volume depends on the origin, see the closure residual");
}
}
