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

int CountOpenBorders(const Face& face)
{
  // What is wrong with a surface is said where the face is cut.
  if (!face.Loops.empty() || !face.Surface.Check().empty())
  {
    return 0;
  }
  const NURBSSurface& surface = face.Surface;
  int open = 0;
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
    for (const std::vector<Vector3>& border : { first, last })
    {
      const std::vector<Vector3> pole(border.size(), border.front());
      open += GetLargestDistance(border, pole) <= CoincidenceTolerance * size ? 0 : 1;
    }
  }
  return open;
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
  int borders = 0;
  for (const FacePointer& face : body.Model->GetFaces())
  {
    borders += CountOpenBorders(*face);
  }
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
        " of faces without loops, which no edge joins with other faces, are open: the volume depends on the "
        "origin");
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
