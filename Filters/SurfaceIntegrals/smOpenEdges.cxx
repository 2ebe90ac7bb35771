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
/// Borders are the same curve if their lengths, centres and vector areas differ by no more than this, relative to their length.
constexpr double JoinTolerance = 1e-3;
/// Largest distance of the chords of a border from it, relative to its extent, and most halvings of a span to reach it.
constexpr double ChordTolerance = 1e-5;
constexpr int MostHalvings = 16;

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

/// A border of a face without loops, in the direction in which the face lies left of it: quantities of the curve that do not depend on its
/// parameters, nor on where a closed one begins.
struct Border
{
  double Length = 0.0;
  /// Mean of its points, and half the integral of x cross dx about it.
  Vector3 Center{};
  Vector3 Area{};
  bool IsJoined = false;

  void AddChord(const Vector3& a, const Vector3& b)
  {
    const double length = Norm(Subtract(b, a));
    const Vector3 twice = Cross(a, b);
    for (int c = 0; c < 3; ++c)
    {
      this->Center[c] += length * 0.5 * (a[c] + b[c]);
      this->Area[c] += 0.5 * twice[c];
    }
    this->Length += length;
  }
  bool IsOpposite(const Border& other) const
  {
    const double tolerance = JoinTolerance * this->Length;
    Vector3 sum{};
    for (int c = 0; c < 3; ++c)
    {
      sum[c] = this->Area[c] + other.Area[c];
    }
    return std::abs(this->Length - other.Length) <= tolerance &&
      Norm(Subtract(this->Center, other.Center)) <= tolerance && Norm(sum) <= tolerance * this->Length;
  }
};

/// Follows a border by chords.
class BorderWalk
{
public:
  BorderWalk(const NURBSSurface& surface, int direction, double at)
    : Surface(surface)
    , Direction(direction)
    , At(at)
  {
  }

  Border Follow(bool backwards)
  {
    const std::vector<double> breaks = this->Surface.GetSpanBreaks(this->Direction);
    this->Origin = this->Evaluate(breaks.front());
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      const Vector3 from = this->Evaluate(breaks[k]);
      const Vector3 to = this->Evaluate(breaks[k + 1]);
      const Vector3 between = this->Evaluate(0.5 * (breaks[k] + breaks[k + 1]));
      this->Extent = std::max(Norm(Subtract(to, from)), Norm(Subtract(between, from)));
      this->AddSpan(breaks[k], from, breaks[k + 1], to, 0);
    }
    // The points were taken relative to the first one.
    const Vector3 last = Subtract(this->Evaluate(breaks.back()), this->Origin);
    for (double& c : this->Result.Center)
    {
      c /= this->Result.Length;
    }
    const Vector3 moved = Cross(this->Result.Center, last);
    for (int c = 0; c < 3; ++c)
    {
      this->Result.Area[c] = (backwards ? -1.0 : 1.0) * (this->Result.Area[c] - 0.5 * moved[c]);
      this->Result.Center[c] += this->Origin[c];
    }
    return this->Result;
  }

private:
  Vector3 Evaluate(double along) const
  {
    Vector3 point;
    const bool isU = this->Direction == 0;
    this->Surface.Evaluate(isU ? along : this->At, isU ? this->At : along, point.data());
    return point;
  }

  void AddSpan(double start, const Vector3& from, double end, const Vector3& to, int depth)
  {
    const double middle = 0.5 * (start + end);
    const Vector3 between = this->Evaluate(middle);
    // Two halvings at least, since a curve may cross its chord in the middle.
    const double twice = Norm(Cross(Subtract(to, from), Subtract(between, from)));
    const double chord = Norm(Subtract(to, from));
    const bool isFlat = depth >= 2 && twice <= ChordTolerance * this->Extent * chord && chord > 0.0;
    if (isFlat || depth == MostHalvings)
    {
      this->Result.AddChord(Subtract(from, this->Origin), Subtract(between, this->Origin));
      this->Result.AddChord(Subtract(between, this->Origin), Subtract(to, this->Origin));
      return;
    }
    this->AddSpan(start, from, middle, between, depth + 1);
    this->AddSpan(middle, between, end, to, depth + 1);
  }

  const NURBSSurface& Surface;
  int Direction;
  double At;
  Vector3 Origin{};
  /// Of the span.
  double Extent = 0.0;
  Border Result;
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
        const double at = isLast ? surface.GetDomainEnd(other) : surface.GetDomainStart(other);
        borders.push_back(BorderWalk(surface, direction, at).Follow(isBackwards));
      }
    }
  }
}

/// Returns the number of borders that no other one joins: the same curve in the opposite direction.
int CountOpenBorders(const vtkTrimmedNURBSModel& model)
{
  std::vector<Border> borders;
  for (const FacePointer& face : model.GetFaces())
  {
    AddBorders(*face, borders);
  }
  std::sort(
    borders.begin(), borders.end(), [](const Border& a, const Border& b) { return a.Length < b.Length; });
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    const double longest = (1.0 + JoinTolerance) * borders[i].Length;
    for (std::size_t j = i + 1; !borders[i].IsJoined && j < borders.size() && borders[j].Length <= longest;
         ++j)
    {
      if (!borders[j].IsJoined && borders[i].IsOpposite(borders[j]))
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
        " of faces without loops, which coincide with no border of another one, are open: the volume "
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
