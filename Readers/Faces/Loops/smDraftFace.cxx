#include "smDraftFace.h"

#include "smFaceDomain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sm
{
namespace
{
/// Returns the squared distance in native (u,v), modulo whole periods; -1 if a pcurve is missing.
double GetGap(const DraftFace& face, const DraftCoedge& from, const DraftCoedge& to)
{
  if (from.Projected || to.Projected)
  {
    return -1.0;
  }
  const auto a = from.GetEndPoint();
  const auto b = to.GetStartPoint();
  double gap = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    double delta = b[d] - a[d];
    if (face.Period[d] > 0.0)
    {
      delta -= std::round(delta / face.Period[d]) * face.Period[d];
    }
    gap += delta * delta;
  }
  return gap;
}

/// Returns the squared distance without the reduction modulo periods, which distinguishes the two sides of a
/// seam.
double GetRawGap(const DraftCoedge& from, const DraftCoedge& to)
{
  if (from.Projected || to.Projected)
  {
    return 0.0;
  }
  const auto a = from.GetEndPoint();
  const auto b = to.GetStartPoint();
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Returns the squared distance between two vertices; infinite if one is missing.
double GetVertexDistance(const DraftCoedge& from, const DraftCoedge& to)
{
  if (!from.End || !to.Start)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Vector3 away = Subtract(from.End->Point, to.Start->Point);
  return Dot(away, away);
}

/// Returns true if the signed jumps of the loop's pcurves by whole periods do not add up to 0, that is, if
/// the loop winds around the surface.
bool Winds(const DraftFace& face, const DraftLoop& loop)
{
  double turns[2] = { 0.0, 0.0 };
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const DraftCoedge& next = loop[(i + 1) % loop.size()];
    if (loop[i].Projected || next.Projected)
    {
      return false;
    }
    const auto end = loop[i].GetEndPoint();
    const auto start = next.GetStartPoint();
    for (int d = 0; d < 2; ++d)
    {
      turns[d] += face.Period[d] > 0.0 ? std::round((end[d] - start[d]) / face.Period[d]) : 0.0;
    }
  }
  return turns[0] != 0.0 || turns[1] != 0.0;
}

bool IsChain(const DraftFace& face, const DraftLoop& loop)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const DraftCoedge& next = loop[(i + 1) % loop.size()];
    // A quarter of a period is far above any tolerance, and far below the jump to the other side of a seam.
    double limit = std::numeric_limits<double>::infinity();
    for (const double period : face.Period)
    {
      limit = period > 0.0 ? std::min(limit, 0.0625 * period * period) : limit;
    }
    if (!Meet(loop[i], next) || GetGap(face, loop[i], next) > limit)
    {
      return false;
    }
  }
  return !Winds(face, loop);
}

/// Returns the unused coedge that follows best: by common vertex, then by distance in (u,v), then by distance
/// in space.
std::size_t FindNext(const DraftLoop& loop, const std::vector<bool>& used, const DraftCoedge& last)
{
  std::size_t best = loop.size();
  bool bestMeets = false;
  double bestDistance = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    if (used[i])
    {
      continue;
    }
    const bool meets = Meet(last, loop[i]);
    const double distance = meets ? GetRawGap(last, loop[i]) : GetVertexDistance(last, loop[i]);
    if (best == loop.size() || (meets && !bestMeets) || (meets == bestMeets && distance < bestDistance))
    {
      best = i;
      bestMeets = meets;
      bestDistance = distance;
    }
  }
  return best;
}

double GetTotalGap(const DraftFace& face, const DraftLoop& loop)
{
  double total = Winds(face, loop) ? 1e20 : 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const DraftCoedge& next = loop[(i + 1) % loop.size()];
    total += Meet(loop[i], next) ? 0.0 : 1e30;
    total += std::max(0.0, GetGap(face, loop[i], next));
  }
  return total;
}

/// Orders the coedges of one wire into one or several chains.
std::vector<DraftLoop> Chain(const DraftLoop& loop)
{
  std::vector<DraftLoop> chains;
  std::vector<bool> used(loop.size(), false);
  for (std::size_t first = 0; first < loop.size(); ++first)
  {
    if (used[first])
    {
      continue;
    }
    DraftLoop chain{ loop[first] };
    used[first] = true;
    while (true)
    {
      const std::size_t next = FindNext(loop, used, chain.back());
      if (next == loop.size())
      {
        break;
      }
      // A closed chain ends here unless a coedge continues from its last vertex.
      if (Meet(chain.back(), chain.front()) && !Meet(chain.back(), loop[next]))
      {
        break;
      }
      chain.push_back(loop[next]);
      used[next] = true;
    }
    chains.push_back(chain);
  }
  return chains;
}

/// Returns the sum of the squared distances in (u,v) between the ends of the coedges, without the reduction
/// modulo periods.
double GetTotalRawGap(const DraftLoop& loop)
{
  double total = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    total += GetRawGap(loop[i], loop[(i + 1) % loop.size()]);
  }
  return total;
}

/// Returns true if both uses of a seam have the same place in (u,v): foot points do not distinguish them.
bool HasSharedPlace(const DraftLoop& loop, double limit)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      const auto a = loop[i].GetStartPoint();
      const auto b = loop[k].GetEndPoint();
      if (loop[i].EdgeIndex == loop[k].EdgeIndex &&
        (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) <= limit)
      {
        return true;
      }
    }
  }
  return false;
}

/// Brings the coedges of a loop that all meet at one vertex, as those round a whole torus, into the order in
/// which they are continuous in (u,v) as they are: continued by periods, another order may run round the rest
/// of the plane. Returns false if there is no such order.
bool OrderAtOneVertex(const DraftFace& face, DraftLoop& loop)
{
  double limit = 0.0;
  for (const double period : face.Period)
  {
    limit = std::max(limit, 1e-6 * period);
  }
  limit *= limit;
  const bool isOneVertex = std::all_of(loop.begin(), loop.end(),
    [&loop](const DraftCoedge& coedge) { return Meet(coedge, coedge) && Meet(coedge, loop[0]); });
  if (loop.size() < 3 || !isOneVertex || !(GetTotalRawGap(loop) > limit) || HasSharedPlace(loop, limit))
  {
    return false;
  }
  std::vector<DraftLoop> chains = Chain(loop);
  if (chains.size() != 1 || !(GetTotalRawGap(chains[0]) <= limit))
  {
    return false;
  }
  loop = std::move(chains[0]);
  return true;
}

void MoveLoop(DraftLoop& loop, int direction, double by)
{
  for (DraftCoedge& coedge : loop)
  {
    coedge.Trim.Shift[direction] += by;
  }
}

NativeBox GetBox(const DraftLoop& loop)
{
  NativeBox box{ { 1e300, 1e300 }, { -1e300, -1e300 } };
  for (const DraftCoedge& coedge : loop)
  {
    for (const auto& p : { coedge.GetStartPoint(), coedge.GetEndPoint() })
    {
      for (int d = 0; d < 2; ++d)
      {
        box.Low[d] = std::min(box.Low[d], p[d]);
        box.High[d] = std::max(box.High[d], p[d]);
      }
    }
  }
  return box;
}

/// Takes the trim curve of a use of an edge; returns false if it has none.
bool TakeTrim(const CoedgeShape& use, NativeTrim& trim)
{
  trim.Curve = use.Trim;
  trim.First = use.First;
  trim.Last = use.Last;
  return use.Trim != nullptr;
}

/// Sets the trim curve of a coedge. Returns a sentence with the reason if there is none, else an empty
/// string.
std::string SetTrim(const DraftFace& face, const CoedgeShape& use, MissingTrim missing, DraftCoedge& coedge)
{
  // A trim curve that cannot be moved into the domain passes a pole, where a curve of the surface continues
  // on the other side.
  const bool isUsable = TakeTrim(use, coedge.Trim) &&
    (MoveIntoDomain(face, *use.Edge, coedge.Trim) || missing == MissingTrim::None);
  if (!isUsable)
  {
    coedge.Trim = NativeTrim();
    if (use.Edge->Curve && FindElementary(*face.Surface, ElementarySurface::Type::Plane))
    {
      coedge.Projected = true;
    }
    else if (use.Edge->Curve && missing == MissingTrim::Feet)
    {
      coedge.NeedsFeet = true;
      coedge.Trim.First = use.Edge->First;
      coedge.Trim.Last = use.Edge->Last;
    }
    else
    {
      return "An edge has no curve in the face's parameters and none could be made; it is left out.";
    }
  }
  return coedge.Projected || coedge.Trim.Last > coedge.Trim.First
    ? std::string()
    : "An edge has an empty parameter range on this face; it is left out.";
}

/// Appends the loop of a wire to `face`.
void AddLoop(const WireShape& wire, MissingTrim missing, DraftFace& face, EdgeIndex& edges)
{
  DraftLoop loop;
  bool isPole = false;
  int dropped = 0;
  for (const CoedgeShape& use : wire.Coedges)
  {
    DraftCoedge coedge;
    coedge.Edge = use.Edge.get();
    coedge.Reversed = use.Reversed;
    coedge.Degenerate = use.Edge->Degenerate;
    if (coedge.Degenerate && missing == MissingTrim::Feet && !use.Trim)
    {
      // CompleteLoops() adds poles itself.
      isPole = true;
      continue;
    }
    coedge.Start = (use.Reversed ? use.Edge->End : use.Edge->Start).get();
    coedge.End = (use.Reversed ? use.Edge->Start : use.Edge->End).get();
    const std::string problem = SetTrim(face, use, missing, coedge);
    if (!problem.empty())
    {
      face.Messages.push_back(problem);
      ++dropped;
      continue;
    }
    coedge.EdgeIndex = edges.Add(coedge.Edge);
    loop.push_back(coedge);
  }
  if (wire.Reversed)
  {
    std::reverse(loop.begin(), loop.end());
  }
  if (loop.empty() && dropped == 0 && !isPole)
  {
    face.Messages.push_back("A loop has no edges; it is left out.");
    ++dropped;
  }
  face.Defects += dropped;
  if (!loop.empty())
  {
    face.Loops.push_back(loop);
  }
}
}

void SetStraight(const Point2& from, const Point2& to, NativeTrim& trim)
{
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  std::string problem;
  trim.Curve = GeometricCurve<2>::Make(
    LineCurve<2>{ from, { (to[0] - from[0]) / length, (to[1] - from[1]) / length } }, problem);
  trim.First = 0.0;
  trim.Last = length;
}

bool Meet(const DraftCoedge& from, const DraftCoedge& to)
{
  return from.End && from.End == to.Start;
}

DraftFace CollectFace(const FaceShape& source, bool isReversed, EdgeIndex& edges, MissingTrim missing)
{
  DraftFace face;
  face.Reversed = isReversed;
  face.AsInFile = missing == MissingTrim::Feet;
  face.Source = &source;
  if (!source.Surface)
  {
    throw std::runtime_error("it has no surface");
  }
  face.Location = source.Location;
  FindFaceDomain(face);
  for (const WireShape& wire : source.Wires)
  {
    AddLoop(wire, missing, face, edges);
  }
  if (!source.Wires.empty() && face.Loops.empty())
  {
    throw std::runtime_error("none of its edges can be carried over");
  }
  return face;
}

void OrderLoops(DraftFace& face)
{
  std::vector<DraftLoop> ordered;
  for (DraftLoop& loop : face.Loops)
  {
    if (OrderAtOneVertex(face, loop) || IsChain(face, loop))
    {
      ordered.push_back(std::move(loop));
      continue;
    }
    std::vector<DraftLoop> chains = Chain(loop);
    double total = 0.0;
    for (const DraftLoop& chain : chains)
    {
      total += GetTotalGap(face, chain);
    }
    if (total < GetTotalGap(face, loop))
    {
      ordered.insert(ordered.end(), chains.begin(), chains.end());
    }
    else
    {
      ordered.push_back(std::move(loop));
    }
  }
  face.Loops = std::move(ordered);
}

void ShiftLoops(DraftFace& face)
{
  if (face.Loops.empty() || (face.Period[0] <= 0.0 && face.Period[1] <= 0.0))
  {
    return;
  }
  for (DraftLoop& loop : face.Loops)
  {
    for (std::size_t i = 1; i <= loop.size(); ++i)
    {
      const auto end = loop[i - 1].GetEndPoint();
      const auto start = loop[i % loop.size()].GetStartPoint();
      for (int d = 0; d < 2; ++d)
      {
        const double turns = face.Period[d] > 0.0 ? std::round((end[d] - start[d]) / face.Period[d]) : 0.0;
        if (turns == 0.0)
        {
          continue;
        }
        if (i < loop.size())
        {
          loop[i].Trim.Shift[d] += turns * face.Period[d];
        }
        else
        {
          face.Messages.push_back(
            "A loop goes round the surface without a seam; its face is not bounded in (u,v).");
          ++face.Defects;
        }
      }
    }
  }
  AlignLoops(face);
}

void AlignLoops(DraftFace& face)
{
  std::size_t widest = 0;
  std::vector<NativeBox> boxes;
  for (const DraftLoop& loop : face.Loops)
  {
    boxes.push_back(face.Period[0] > 0.0 || face.Period[1] > 0.0 ? GetBox(loop) : NativeBox());
  }
  for (int d = 0; d < 2; ++d)
  {
    if (face.Period[d] <= 0.0)
    {
      continue;
    }
    for (std::size_t i = 1; i < boxes.size(); ++i)
    {
      if (boxes[i].High[d] - boxes[i].Low[d] > boxes[widest].High[d] - boxes[widest].Low[d])
      {
        widest = i;
      }
    }
    const double middle = 0.5 * (boxes[widest].Low[d] + boxes[widest].High[d]);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      const double own = 0.5 * (boxes[i].Low[d] + boxes[i].High[d]);
      const double turns = std::round((middle - own) / face.Period[d]);
      if (turns != 0.0)
      {
        MoveLoop(face.Loops[i], d, turns * face.Period[d]);
      }
    }
  }
}
}
