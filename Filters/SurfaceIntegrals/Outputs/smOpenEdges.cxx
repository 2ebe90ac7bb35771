#include "smOpenEdges.h"

#include "smBodyIntegrals.h"
#include "smFormat.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
constexpr double CoincidenceTolerance = 1e-9;
/// Borders are the same curve if their lengths, centres and vector areas differ by no more than this,
/// relative to their length.
constexpr double JoinTolerance = 1e-3;
/// Largest distance of the chords of a border from it, relative to its extent, and maximum number of halvings
/// of a span to reach it.
constexpr double ChordTolerance = 1e-5;
constexpr int MaxHalvings = 16;
/// Number of a border's points whose distance from the other one is measured.
constexpr std::size_t MaxMeasured = 32;
/// Borders that are so far apart, in units of u times size and distance from the origin, coincide except for
/// rounding.
constexpr double CoincidenceRoundings = 64.0;

/// Returns parameters that determine a rational curve of the surface's degree in this direction: two borders
/// that coincide there coincide.
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

double GetMaxDistance(const std::vector<Vector3>& points, const std::vector<Vector3>& others)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    largest = std::max(largest, Norm(Subtract(points[i], others[i])));
  }
  return largest;
}

/// A border of a face without loops, in the direction in which the face lies left of it: quantities of the
/// curve that do not depend on its parameters, nor on where a closed one begins.
struct Border
{
  double Length = 0.0;
  /// Mean of its points, and half the integral of x cross dx about it.
  Vector3 Center{};
  Vector3 Area{};
  bool IsJoined = false;
  const NURBSSurface* Surface = nullptr;
  int Direction = 0;
  double At = 0.0;
  /// Parameters of its points, which increase, and the points.
  std::vector<std::pair<double, Vector3>> Points;

  /// The largest parameter relative to the range of parameters, by which rounding of a parameter moves a
  /// point.
  double GetParameterRatio() const
  {
    const double first = this->Points.front().first;
    const double last = this->Points.back().first;
    return std::max(std::abs(first), std::abs(last)) / (last - first);
  }
  Vector3 Evaluate(double along) const
  {
    Vector3 point;
    this->Surface->Evaluate(
      this->Direction == 0 ? along : this->At, this->Direction == 0 ? this->At : along, point.data());
    return point;
  }
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
  {
    this->Result.Surface = &surface;
    this->Result.Direction = direction;
    this->Result.At = at;
  }

  Border Follow(bool backwards)
  {
    const std::vector<double> breaks = this->Result.Surface->GetSpanBreaks(this->Result.Direction);
    this->Origin = this->Result.Evaluate(breaks.front());
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      const Vector3 from = this->Result.Evaluate(breaks[k]);
      const Vector3 to = this->Result.Evaluate(breaks[k + 1]);
      const Vector3 between = this->Result.Evaluate(0.5 * (breaks[k] + breaks[k + 1]));
      this->Extent = std::max(Norm(Subtract(to, from)), Norm(Subtract(between, from)));
      this->AddSpan(breaks[k], from, breaks[k + 1], to, 0);
    }
    // The points were taken relative to the first one.
    const Vector3 end = this->Result.Evaluate(breaks.back());
    this->Result.Points.emplace_back(breaks.back(), end);
    const Vector3 last = Subtract(end, this->Origin);
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
  void AddSpan(double start, const Vector3& from, double end, const Vector3& to, int depth)
  {
    const double middle = 0.5 * (start + end);
    const Vector3 between = this->Result.Evaluate(middle);
    // Two halvings at least, since a curve may cross its chord in the middle.
    const double twice = Norm(Cross(Subtract(to, from), Subtract(between, from)));
    const double chord = Norm(Subtract(to, from));
    const bool isFlat = depth >= 2 && twice <= ChordTolerance * this->Extent * chord && chord > 0.0;
    if (isFlat || depth == MaxHalvings)
    {
      this->Result.Points.emplace_back(start, from);
      this->Result.Points.emplace_back(middle, between);
      this->Result.AddChord(Subtract(from, this->Origin), Subtract(between, this->Origin));
      this->Result.AddChord(Subtract(between, this->Origin), Subtract(to, this->Origin));
      return;
    }
    this->AddSpan(start, from, middle, between, depth + 1);
    this->AddSpan(middle, between, end, to, depth + 1);
  }

  Vector3 Origin{};
  /// Extent of the span.
  double Extent = 0.0;
  Border Result;
};

/// Distance of a point from the border between two parameters, by the golden section.
double GetDistance(const Border& border, double low, double high, const Vector3& point)
{
  constexpr double golden = 0.6180339887498949;
  const auto measure = [&](double along) { return Norm(Subtract(border.Evaluate(along), point)); };
  double inner[2] = { high - golden * (high - low), low + golden * (high - low) };
  double distance[2] = { measure(inner[0]), measure(inner[1]) };
  for (int i = 0; i < 64; ++i)
  {
    const int nearer = distance[0] <= distance[1] ? 0 : 1;
    (nearer == 0 ? high : low) = inner[1 - nearer];
    inner[1 - nearer] = inner[nearer];
    distance[1 - nearer] = distance[nearer];
    inner[nearer] = nearer == 0 ? high - golden * (high - low) : low + golden * (high - low);
    distance[nearer] = measure(inner[nearer]);
  }
  return std::min(distance[0], distance[1]);
}

/// Largest distance of points of a border from another one.
double GetGap(const Border& from, const Border& to)
{
  double gap = 0.0;
  const std::size_t last = to.Points.size() - 1;
  const std::size_t step = from.Points.size() / MaxMeasured + 1;
  for (std::size_t i = 0; i < from.Points.size(); i += step)
  {
    const Vector3& point = from.Points[i].second;
    const auto nearest = std::min_element(to.Points.begin(), to.Points.end(),
      [&point](const auto& a, const auto& b)
      { return Norm(Subtract(a.second, point)) < Norm(Subtract(b.second, point)); });
    const auto at = static_cast<std::size_t>(nearest - to.Points.begin());
    double distance = Norm(Subtract(nearest->second, point));
    // Near the ends of a closed border both are near.
    for (const std::size_t k : { at > 0 ? at - 1 : last - 1, at < last ? at : std::size_t(0) })
    {
      distance = std::min(distance, GetDistance(to, to.Points[k].first, to.Points[k + 1].first, point));
    }
    gap = std::max(gap, distance);
  }
  return gap;
}

/// Returns 0 for a gap that is no more than rounding.
double IgnoreRounding(double gap, double size, const Vector3& at)
{
  return gap > CoincidenceRoundings * UnitRoundoff * (size + Norm(at)) ? gap : 0.0;
}

/// Adds the borders of a face without loops at which it neither closes by itself nor ends in a point. Raises
/// `gap` to the distance by which it closes by itself.
void AddBorders(const Face& face, std::vector<Border>& borders, double& gap)
{
  // What is wrong with a surface is reported where the face is cut.
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
    const double across = GetMaxDistance(first, last);
    const std::vector<Vector3> middle =
      EvaluateBorder(surface, direction, 0.5 * (surface.GetDomainStart(other) + surface.GetDomainEnd(other)));
    const double size = std::max({ across, GetMaxDistance(middle, first),
      GetMaxDistance(middle, std::vector<Vector3>(middle.size(), middle.front())) });
    if (across <= CoincidenceTolerance * size)
    {
      gap = std::max(gap, IgnoreRounding(across, size, first.front()));
      continue;
    }
    for (const bool isLast : { false, true })
    {
      const std::vector<Vector3>& points = isLast ? last : first;
      const std::vector<Vector3> pole(points.size(), points.front());
      if (GetMaxDistance(points, pole) > CoincidenceTolerance * size)
      {
        // Counter-clockwise: s = 0 and r = 1 are passed backwards.
        const bool isBackwards = (isLast == (direction == 0)) != face.Reversed;
        const double at = isLast ? surface.GetDomainEnd(other) : surface.GetDomainStart(other);
        borders.push_back(BorderWalk(surface, direction, at).Follow(isBackwards));
      }
    }
  }
}

/// Returns the number of borders that no other one joins: the same curve in the opposite direction. Sets
/// `gap` to the largest distance of those that are joined.
int CountOpenBorders(const vtkTrimmedNURBSModel& model, double& gap)
{
  std::vector<Border> borders;
  gap = 0.0;
  for (const FacePointer& face : model.GetFaces())
  {
    AddBorders(*face, borders, gap);
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
        const double own = std::max(GetGap(borders[i], borders[j]), GetGap(borders[j], borders[i]));
        const double size =
          borders[i].Length * (1.0 + borders[i].GetParameterRatio() + borders[j].GetParameterRatio());
        gap = std::max(gap, IgnoreRounding(own, size, borders[i].Center));
      }
    }
  }
  return static_cast<int>(
    std::count_if(borders.begin(), borders.end(), [](const Border& border) { return !border.IsJoined; }));
}
}

std::string ListIds(const std::vector<std::int64_t>& ids)
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
  double gap = 0.0;
  const int borders = CountOpenBorders(*body.Model, gap);
  std::vector<std::int64_t> open;
  for (const auto& [edge, sum] : uses)
  {
    if (sum != 0)
    {
      open.push_back(edge->FileId);
    }
  }
  body.OpenEdges = static_cast<int>(open.size()) + borders;
  if (gap > 0.0 && body.IsSolid())
  {
    body.Flag(Status::Suspect,
      "borders of faces without loops are up to " + FormatBound(gap) +
        " apart: no edge closes the gap between them, which no bound includes");
  }
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
