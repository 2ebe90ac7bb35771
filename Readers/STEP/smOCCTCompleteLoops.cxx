#include "smOCCTCompleteLoops.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Point2 = std::array<double, 2>;

/// Segments that stand for a coedge's trim.
constexpr int Samples = 8;

/// Parameters closer than that part of a period are the same.
constexpr double SameParameter = 1e-6;

class LoopCompleter
{
public:
  explicit LoopCompleter(DraftFace& face)
    : Face(face)
  {
    if (Handle(Geom_Plane)::DownCast(face.Surface).IsNull())
    {
      this->Finder = FootPointFinder::Make(face.Surface);
    }
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
    if (problem.empty())
    {
      AlignLoops(this->Face);
    }
    return problem;
  }

private:
  using Pole = FootPointFinder::Pole;

  /// A loop that goes round the surface.
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
        TopLoc_Location location;
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(coedge.Edge, location, first, last);
        const gp_Trsf placement = this->Face.Location.Inverted() * location.Transformation();
        const auto feet = FootCurve::Make(this->Finder, curve, placement, first, last);
        if (!feet)
        {
          return this->Finder ? "an edge has no feet on it"
                              : "its surface is closed, or of a kind that has no inverse";
        }
        if (feet->LeavesDomain())
        {
          return "an edge leads beyond its surface";
        }
        coedge.EdgeDistance = feet->GetDistance();
        coedge.Trim.Curve = feet->GetLine();
        coedge.Trim.Feet = coedge.Trim.Curve.IsNull() ? feet : nullptr;
        coedge.NeedsFeet = false;
      }
    }
    return {};
  }

  /// The pole at which a point is, within the accuracy of a file's numbers; null for none.
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
      const gp_Pnt here = this->Face.Surface->Value(uv[0], uv[1]);
      if (here.Distance(this->Face.Surface->Value(other[0], other[1])) <= PoleTolerance)
      {
        return &pole;
      }
    }
    return nullptr;
  }

  /// Mean of one coordinate over the ends of a loop's coedges.
  static double GetMean(const DraftLoop& loop, int direction)
  {
    double sum = 0.0;
    for (const DraftCoedge& coedge : loop)
    {
      sum += coedge.GetStartPoint()[direction] + coedge.GetEndPoint()[direction];
    }
    return sum / (2.0 * static_cast<double>(loop.size()));
  }

  /// A straight coedge in (u,v), of an edge that the file does not have.
  DraftCoedge MakeCoedge(const Point2& from, const Point2& to, int number) const
  {
    DraftCoedge coedge;
    coedge.EdgeIndex = -1 - number;
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    coedge.Trim.Curve =
      new Geom2d_Line(gp_Pnt2d(from[0], from[1]), gp_Dir2d(to[0] - from[0], to[1] - from[1]));
    coedge.Trim.Last = length;
    return coedge;
  }

  DraftCoedge MakePole(const Point2& from, const Point2& to, const TopoDS_Vertex& vertex)
  {
    DraftCoedge coedge = this->MakeCoedge(from, to, this->Face.AddedEdges++);
    coedge.Degenerate = true;
    coedge.Start = coedge.End = vertex;
    return coedge;
  }

  /// By how much the coordinate along a pole changes there: the loop runs counter-clockwise, so the surface's side of the pole
  /// tells the sign.
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
    return isNothing ? rest + (from.Edge.IsSame(to.Edge) ? sign * period : 0.0) : step;
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
    const bool isFound = sides[0] && sides[1] ? this->JoinSides(*sides[0], *sides[1])
                                              : this->JoinToPole(sides[0] ? *sides[0] : *sides[1]);
    return isFound ? std::string() : "no seam was found for its loops, which go round it";
  }

  /// The same loop beginning with another coedge.
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

  /// The seam from a to b, forward, and a period away backward.
  std::pair<DraftCoedge, DraftCoedge> MakeSeam(
    const Point2& a, const Point2& b, int direction, double period, const DraftCoedge& from)
  {
    DraftCoedge there = this->MakeCoedge(a, b, this->Face.AddedEdges++);
    there.Start = from.Start;
    DraftCoedge back = there;
    back.Reversed = true;
    back.Start = {};
    back.End = from.Start;
    back.Trim.Shift[direction] = period;
    return { there, back };
  }

  bool JoinSides(const WindingLoop& plus, const WindingLoop& minus)
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
          // The face lies to the left of the loop, less than a period wide.
          const double sign = d == 0 ? 1.0 : -1.0;
          const double width = sign * (start[1 - d] - end[1 - d]) / across;
          Move(b, 1 - d, sign * (1.0 - std::ceil(width)) * across);
        }
        const Point2 target = b[0].GetStartPoint();
        if (!this->IsFree(end, target, d))
        {
          continue;
        }
        auto [there, back] = this->MakeSeam(end, target, d, -period, a[0]);
        there.End = back.Start = b[0].Start;
        DraftLoop joined = a;
        joined.push_back(there);
        joined.insert(joined.end(), b.begin(), b.end());
        joined.push_back(back);
        this->Replace(plus, &minus, std::move(joined));
        return true;
      }
    }
    return false;
  }

  bool JoinToPole(const WindingLoop& winding)
  {
    const int d = winding.Direction;
    const double period = winding.Turns * this->Face.Period[d];
    const double mean = GetMean(this->Face.Loops[winding.Index], 1 - d);
    // Left of the loop, as for two loops.
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
      if (!this->IsFree(end, top, d))
      {
        continue;
      }
      auto [there, back] = this->MakeSeam(end, top, d, -period, loop[0]);
      Point2 before = top;
      before[d] -= period;
      const DraftCoedge pole = this->MakePole(top, before, TopoDS_Vertex());
      loop.push_back(there);
      loop.push_back(pole);
      loop.push_back(back);
      this->Replace(winding, nullptr, std::move(loop));
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

  /// No loop crosses the line, whatever its period.
  bool IsFree(const Point2& a, const Point2& b, int direction) const
  {
    const double period = this->Face.Period[direction];
    for (const DraftLoop& loop : this->Face.Loops)
    {
      for (const DraftCoedge& coedge : loop)
      {
        Point2 last{};
        for (int i = 0; i <= Samples; ++i)
        {
          const double x = static_cast<double>(i) / Samples;
          const Point2 p = coedge.Trim.Evaluate((1.0 - x) * coedge.Trim.First + x * coedge.Trim.Last);
          for (double k = -2.0; i > 0 && k <= 2.0; ++k)
          {
            Point2 from = last;
            Point2 to = p;
            from[direction] += k * period;
            to[direction] += k * period;
            if (Cross(a, b, from, to))
            {
              return false;
            }
          }
          last = p;
        }
      }
    }
    return true;
  }

  /// Twice the signed area of a triangle, relative to its size.
  static double GetSide(const Point2& a, const Point2& b, const Point2& p)
  {
    const double area = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    const double size = std::hypot(b[0] - a[0], b[1] - a[1]) * std::hypot(p[0] - a[0], p[1] - a[1]);
    return size > 0.0 ? area / size : 0.0;
  }

  /// The segment from c to d crosses that from a to b inside the latter; a point on it counts as left of it.
  static bool Cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
  {
    constexpr double least = 1e-9;
    const double start = GetSide(c, d, a);
    const double end = GetSide(c, d, b);
    return (GetSide(a, b, c) > -least) != (GetSide(a, b, d) > -least) &&
      ((start > least && end < -least) || (start < -least && end > least));
  }

  /// mm.
  static constexpr double PoleTolerance = 1e-6;

  DraftFace& Face;
  std::shared_ptr<const FootPointFinder> Finder;
  std::vector<WindingLoop> Winding;
};
}

std::string CompleteLoops(DraftFace& face)
{
  return LoopCompleter(face).Run();
}
}
