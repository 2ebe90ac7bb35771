#include "smCompleteLoops.h"

#include "smSeamWay.h"
#include "smSphereAxes.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Parameters closer than this fraction of a period are equal.
constexpr double SameParameter = 1e-6;

class LoopCompleter
{
public:
  explicit LoopCompleter(DraftFace& face)
    : Face(face)
  {
    this->Finder = FootPointFinder::Make(face.Surface);
  }

  std::string Run()
  {
    std::string problem = this->FollowCurves();
    if (problem.empty())
    {
      OrderLoops(this->Face);
      problem = this->JoinLoops();
    }
    if (problem.empty() && !this->Winding.empty())
    {
      problem = this->CloseWindingLoops();
    }
    if (problem.empty() && !this->IsPlaced)
    {
      AlignLoops(this->Face);
    }
    return problem;
  }

  /// Returns true if an edge passes a pole so closely that its trim curve is not exact.
  bool IsDisturbedByPole() const { return this->Disturbed; }

private:
  using Pole = FootPointFinder::Pole;

  /// A loop that winds around a periodic surface.
  struct WindingLoop
  {
    std::size_t Index;
    int Direction;
    double Turns;
  };

  std::string FollowCurves()
  {
    for (DraftLoop& loop : this->Face.Loops)
    {
      for (DraftCoedge& coedge : loop)
      {
        if (!coedge.NeedsFeet)
        {
          continue;
        }
        const EdgeShape& edge = *coedge.Edge;
        const Placement placement = Compose(Invert(this->Face.Location), edge.Location);
        const auto feet = FootCurve::Make(this->Finder, edge.Curve, placement, edge.First, edge.Last);
        if (!feet)
        {
          return this->Finder ? "an edge has no feet on it"
                              : "its surface is closed, or of a kind that has no inverse";
        }
        this->Disturbed = this->Disturbed || feet->IsDisturbedByPole();
        coedge.EdgeDistance = feet->GetDistance();
        coedge.Overhang = feet->GetOverhang();
        coedge.Trim.Curve = feet->GetLine();
        coedge.Trim.Feet = coedge.Trim.Curve ? nullptr : feet;
        coedge.Trim.Residual[0] = feet->GetResidual(0);
        coedge.Trim.Residual[1] = feet->GetResidual(1);
        coedge.NeedsFeet = false;
      }
    }
    return {};
  }

  /// Returns the pole at which a point lies, within the accuracy of a file's numbers; null if there is none.
  const Pole* FindPole(const Point2& uv) const
  {
    if (!this->Finder)
    {
      return nullptr;
    }
    for (const Pole& pole : this->Finder->GetPoles())
    {
      Point2 other = uv;
      other[pole.Direction] = pole.Value;
      const Vector3 here = this->Face.Surface->Evaluate(uv[0], uv[1]);
      if (Norm(Subtract(here, this->Face.Surface->Evaluate(other[0], other[1]))) <= PoleTolerance)
      {
        return &pole;
      }
    }
    return nullptr;
  }

  /// Returns the mean of one coordinate over the ends of a loop's coedges.
  static double GetMean(const DraftLoop& loop, int direction)
  {
    double sum = 0.0;
    for (const DraftCoedge& coedge : loop)
    {
      sum += coedge.GetStartPoint()[direction] + coedge.GetEndPoint()[direction];
    }
    return sum / (2.0 * static_cast<double>(loop.size()));
  }

  /// Makes a straight coedge in (u,v), for an edge that the file does not have.
  DraftCoedge MakeCoedge(const Point2& from, const Point2& to, int number) const
  {
    DraftCoedge coedge;
    coedge.EdgeIndex = -1 - number;
    SetStraight(from, to, coedge.Trim);
    return coedge;
  }

  DraftCoedge MakePole(const Point2& from, const Point2& to, const VertexShape* vertex)
  {
    DraftCoedge coedge = this->MakeCoedge(from, to, this->Face.AddedEdges++);
    coedge.Degenerate = true;
    coedge.Start = coedge.End = vertex;
    return coedge;
  }

  /// Returns the change of the coordinate along a pole from one coedge to the next. Its sign follows from the
  /// side of the pole on which the surface lies, because the loop runs counter-clockwise.
  double GetPoleStep(
    const Pole& pole, const DraftLoop& loop, const DraftCoedge& from, const DraftCoedge& to) const
  {
    const int along = 1 - pole.Direction;
    const double period = this->Face.Period[along];
    double step = to.GetStartPoint()[along] - from.GetEndPoint()[along];
    if (period <= 0.0)
    {
      return step;
    }
    const bool isHigh = GetMean(loop, pole.Direction) < pole.Value;
    const double sign = isHigh == (pole.Direction == 1) ? -1.0 : 1.0;
    step -= std::floor(sign * step / period) * sign * period;
    const bool isNothing =
      sign * step < SameParameter * period || sign * step > (1.0 - SameParameter) * period;
    const double rest = step - std::round(step / period) * period;
    return isNothing ? rest + (from.Edge == to.Edge ? sign * period : 0.0) : step;
  }

  std::string JoinLoops()
  {
    for (std::size_t l = 0; l < this->Face.Loops.size(); ++l)
    {
      const std::string problem = this->JoinLoop(l);
      if (!problem.empty())
      {
        return problem;
      }
    }
    return {};
  }

  std::string JoinLoop(std::size_t l)
  {
    if (!this->Finder)
    {
      return {};
    }
    const DraftLoop loop = this->Face.Loops[l];
    DraftLoop joined{ loop[0] };
    double turns[2] = { 0.0, 0.0 };
    for (std::size_t i = 1; i <= loop.size(); ++i)
    {
      const bool isLast = i == loop.size();
      DraftCoedge next = loop[i % loop.size()];
      const DraftCoedge last = joined.back();
      const Point2 end = last.GetEndPoint();
      const Point2 start = isLast ? joined[0].GetStartPoint() : next.GetStartPoint();
      const Pole* pole = last.Degenerate || next.Degenerate ? nullptr : this->FindPole(end);
      pole = pole && this->FindPole(start) == pole ? pole : nullptr;
      Point2 wanted = start;
      for (int d = 0; d < 2; ++d)
      {
        const double period = this->Face.Period[d];
        if (period > 0.0)
        {
          const bool isAlong = pole && pole->Direction == 1 - d;
          const double step = isAlong ? this->GetPoleStep(*pole, loop, last, isLast ? joined[0] : next)
                                      : start[d] - end[d] - std::round((start[d] - end[d]) / period) * period;
          const double shift = std::round((end[d] + step - start[d]) / period) * period;
          wanted[d] = start[d] + shift;
          if (isLast)
          {
            turns[d] = shift / period;
          }
          else
          {
            next.Trim.Shift[d] += shift;
          }
        }
      }
      if (pole && std::abs(wanted[1 - pole->Direction] - end[1 - pole->Direction]) > 0.0)
      {
        joined.push_back(this->MakePole(end, wanted, last.End));
      }
      if (!isLast)
      {
        joined.push_back(next);
      }
    }
    if (turns[0] != 0.0 || turns[1] != 0.0)
    {
      if ((turns[0] != 0.0 && turns[1] != 0.0) || std::abs(turns[0] + turns[1]) != 1.0 ||
        joined.size() != loop.size())
      {
        return "a loop goes round it in a way that is not understood";
      }
      this->Winding.push_back({ l, turns[0] != 0.0 ? 0 : 1, turns[0] + turns[1] });
    }
    this->Face.Loops[l] = std::move(joined);
    return {};
  }

  std::string CloseWindingLoops()
  {
    const int d = this->Winding[0].Direction;
    const WindingLoop* sides[2] = { nullptr, nullptr };
    for (const WindingLoop& winding : this->Winding)
    {
      const WindingLoop*& side = sides[winding.Turns > 0.0 ? 0 : 1];
      if (winding.Direction != d || side)
      {
        return "several loops go round it";
      }
      side = &winding;
    }
    bool isFound = false;
    for (const bool isStraight : { true, false })
    {
      // On a torus a hole may be a period away in either direction.
      if (!isFound && (isStraight || this->Face.Period[1 - d] <= 0.0))
      {
        isFound = sides[0] && sides[1] ? this->JoinSides(*sides[0], *sides[1], isStraight)
                                       : this->JoinToPole(sides[0] ? *sides[0] : *sides[1], isStraight);
      }
    }
    return isFound ? std::string() : "no seam was found for its loops, which go round it";
  }

  /// Returns the same loop, beginning with coedge `first`.
  DraftLoop Rotate(const WindingLoop& winding, std::size_t first) const
  {
    const DraftLoop& loop = this->Face.Loops[winding.Index];
    DraftLoop result(loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    for (std::size_t i = 0; i < first; ++i)
    {
      result.push_back(loop[i]);
      result.back().Trim.Shift[winding.Direction] += winding.Turns * this->Face.Period[winding.Direction];
    }
    return result;
  }

  static void Move(DraftLoop& loop, int direction, double by)
  {
    for (DraftCoedge& coedge : loop)
    {
      coedge.Trim.Shift[direction] += by;
    }
  }

  /// Makes a seam between two vertices along straight lines: its forward coedges, and its backward ones a
  /// period away.
  std::pair<DraftLoop, DraftLoop> MakeSeam(const std::vector<Point2>& path, int direction, double period,
    const VertexShape* from, const VertexShape* to)
  {
    DraftLoop there;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      there.push_back(this->MakeCoedge(path[i], path[i + 1], this->Face.AddedEdges++));
    }
    there.front().Start = from;
    there.back().End = to;
    DraftLoop back(there.rbegin(), there.rend());
    for (DraftCoedge& coedge : back)
    {
      coedge.Reversed = true;
      std::swap(coedge.Start, coedge.End);
      coedge.Trim.Shift[direction] = period;
    }
    return { there, back };
  }

  /// Moves the other loops by whole periods between a seam that is not straight and its copy.
  void PlaceHoles(const std::vector<Point2>& way, int direction, double period, std::size_t joined)
  {
    const int along = 1 - direction;
    const double width = this->Face.Period[direction];
    for (std::size_t l = 0; l < this->Face.Loops.size(); ++l)
    {
      const Point2 p = this->Face.Loops[l][0].GetStartPoint();
      std::size_t i = 1;
      while (i + 2 < way.size() && (way[i][along] < p[along]) == (way[0][along] < way[i][along]))
      {
        ++i;
      }
      const double x =
        std::clamp((p[along] - way[i - 1][along]) / (way[i][along] - way[i - 1][along]), 0.0, 1.0);
      const double seam = (1.0 - x) * way[i - 1][direction] + x * way[i][direction];
      if (l != joined)
      {
        Move(this->Face.Loops[l], direction,
          -std::floor((p[direction] - std::min(seam, seam - period)) / width) * width);
      }
    }
    this->IsPlaced = true;
  }

  bool JoinSides(const WindingLoop& plus, const WindingLoop& minus, bool isStraight)
  {
    const int d = plus.Direction;
    const double period = this->Face.Period[d];
    const double across = this->Face.Period[1 - d];
    for (std::size_t i = 0; i < this->Face.Loops[plus.Index].size(); ++i)
    {
      const DraftLoop a = this->Rotate(plus, i);
      for (std::size_t k = 0; k < this->Face.Loops[minus.Index].size(); ++k)
      {
        DraftLoop b = this->Rotate(minus, k);
        const Point2 end = a.back().GetEndPoint();
        const Point2 start = b[0].GetStartPoint();
        Move(b, d, std::round((end[d] - start[d]) / period) * period);
        if (across > 0.0)
        {
          // The face lies to the left of the loop and is less than a period wide.
          const double sign = d == 0 ? 1.0 : -1.0;
          const double width = sign * (start[1 - d] - end[1 - d]) / across;
          Move(b, 1 - d, sign * (1.0 - std::ceil(width)) * across);
        }
        const std::vector<Point2> way = FindSeamWay(this->Face, end, b[0].GetStartPoint(), d, isStraight);
        if (way.empty())
        {
          continue;
        }
        const auto [there, back] = this->MakeSeam(way, d, -period, a[0].Start, b[0].Start);
        DraftLoop joined = a;
        joined.insert(joined.end(), there.begin(), there.end());
        joined.insert(joined.end(), b.begin(), b.end());
        joined.insert(joined.end(), back.begin(), back.end());
        this->Replace(plus, &minus, std::move(joined));
        if (!isStraight)
        {
          this->PlaceHoles(way, d, period, plus.Index - (minus.Index < plus.Index ? 1 : 0));
        }
        return true;
      }
    }
    return false;
  }

  bool JoinToPole(const WindingLoop& winding, bool isStraight)
  {
    const int d = winding.Direction;
    const double period = winding.Turns * this->Face.Period[d];
    const double mean = GetMean(this->Face.Loops[winding.Index], 1 - d);
    // The pole is on the left of the loop, as the second loop is for two loops.
    const bool isHigh = (winding.Turns > 0.0) == (d == 0);
    const Pole* target = nullptr;
    for (const Pole& pole : this->Finder->GetPoles())
    {
      target = pole.Direction == 1 - d && (pole.Value > mean) == isHigh ? &pole : target;
    }
    for (std::size_t i = 0; target && i < this->Face.Loops[winding.Index].size(); ++i)
    {
      DraftLoop loop = this->Rotate(winding, i);
      const Point2 end = loop.back().GetEndPoint();
      Point2 top = end;
      top[1 - d] = target->Value;
      const std::vector<Point2> way = FindSeamWay(this->Face, end, top, d, isStraight);
      if (way.empty())
      {
        continue;
      }
      const auto [there, back] = this->MakeSeam(way, d, -period, loop[0].Start, nullptr);
      Point2 before = top;
      before[d] -= period;
      const DraftCoedge pole = this->MakePole(top, before, nullptr);
      loop.insert(loop.end(), there.begin(), there.end());
      loop.push_back(pole);
      loop.insert(loop.end(), back.begin(), back.end());
      this->Replace(winding, nullptr, std::move(loop));
      if (!isStraight)
      {
        this->PlaceHoles(way, d, period, winding.Index);
      }
      return true;
    }
    return false;
  }

  void Replace(const WindingLoop& winding, const WindingLoop* other, DraftLoop joined)
  {
    this->Face.Loops[winding.Index] = std::move(joined);
    if (other)
    {
      this->Face.Loops.erase(this->Face.Loops.begin() + static_cast<std::ptrdiff_t>(other->Index));
    }
  }

  /// Tolerance of a pole in mm.
  static constexpr double PoleTolerance = 1e-6;

  DraftFace& Face;
  std::shared_ptr<const FootPointFinder> Finder;
  std::vector<WindingLoop> Winding;
  /// True if the loops have been moved into one period.
  bool IsPlaced = false;
  bool Disturbed = false;
};

bool HasStoredTrims(const DraftFace& face)
{
  for (const DraftLoop& loop : face.Loops)
  {
    for (const DraftCoedge& coedge : loop)
    {
      if (!coedge.NeedsFeet)
      {
        return true;
      }
    }
  }
  return false;
}
}

std::string CompleteLoops(DraftFace& face)
{
  const ElementarySurface* const found = FindElementary(*face.Surface, ElementarySurface::Type::Sphere);
  if (!found || HasStoredTrims(face))
  {
    return LoopCompleter(face).Run();
  }
  // The poles of a sphere can be chosen freely. The foot point of an edge that passes a pole is not a smooth
  // function of the parameter, and a hole that contains no pole is the only loop of a face that is larger
  // than half the sphere.
  const ElementarySurface sphere = *found;
  DraftFace before = face;
  DraftFace second;
  bool hasSecond = false;
  std::string first;
  std::vector<Vector3> axes{ sphere.Frame.Axes[2] };
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    face = before;
    face.Surface = i == 0 ? before.Surface : TurnSphere(sphere, axes[i]);
    LoopCompleter completer(face);
    const std::string problem = completer.Run();
    if (problem.empty() && !HasOnlyHoles(face))
    {
      if (!completer.IsDisturbedByPole())
      {
        return problem;
      }
      second = hasSecond ? second : face;
      hasSecond = true;
    }
    if (i == 0)
    {
      first = problem;
      before.HasReversedSphere = problem.empty() && HasOnlyHoles(face);
      const std::vector<Vector3> others = ListSphereAxes(before, sphere);
      axes.insert(axes.end(), others.begin(), others.end());
    }
  }
  face = hasSecond ? second : before;
  if (hasSecond)
  {
    return {};
  }
  if (first.empty())
  {
    // The inspection finds what is wrong.
    return LoopCompleter(face).Run();
  }
  return first;
}
}
