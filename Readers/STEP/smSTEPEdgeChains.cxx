#include "smSTEPEdgeChains.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace sm
{
namespace
{
constexpr int ChainSamples = 17;

/// Vertices and parts are sorted along a direction in which those of a regular part differ.
constexpr Vector3 ChainDirection = { 0.53773, 0.61512, 0.57669 };

Vector3 EvaluateFraction(const STEPEdge& edge, double first, double last, int i)
{
  const double fraction = static_cast<double>(i) / (ChainSamples - 1);
  return edge.Curve->Evaluate((1.0 - fraction) * first + fraction * last);
}

struct ChainEnd
{
  STEPEdgeEnd End;
  Vector3 Point{};
  /// Parameter of an edge that it lies on.
  double Parameter = 0.0;
  double Place = 0.0;
};

/// An edge, and the vertices of others that lie on it.
struct ChainEdge
{
  STEPSingleEdge Source;
  /// Made when a vertex may lie on it.
  std::unique_ptr<STEPEdgeSamples> Samples;
  double Limit = 0.0;
  Vector3 Low{};
  Vector3 High{};
  std::vector<ChainEnd> Junctions;
  std::size_t FirstPart = 0;
  std::size_t NumberOfParts = 0;
  bool IsJoined = true;
};

/// A part of an edge between two neighbouring junctions.
struct ChainPart
{
  std::size_t Edge = 0;
  ChainEnd Ends[2];
  double Limit = 0.0;
  double Place = 0.0;
  std::size_t Partners = 0;
  std::size_t Partner = 0;
  bool IsOpposite = false;
  double Distance = 0.0;
};

class ChainFinder
{
public:
  ChainFinder(const std::vector<STEPSingleEdge>& edges, double precision, STEPEdgeWork& work)
    : Precision(precision)
    , Work(work)
  {
    for (const STEPSingleEdge& edge : edges)
    {
      this->AddEdge(edge);
    }
    std::sort(this->Ends.begin(), this->Ends.end(),
      [](const ChainEnd& a, const ChainEnd& b) { return a.Place < b.Place; });
    for (ChainEdge& edge : this->Edges)
    {
      this->FindJunctions(edge);
      this->Divide(edge);
    }
  }

  void Run(STEPJoinedEdges& joined)
  {
    this->PairParts();
    if (this->Work.IsSpent())
    {
      return;
    }
    this->LeaveIncomplete();
    std::vector<std::size_t> common(this->Parts.size());
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      const ChainPart& part = this->Parts[i];
      if (this->Edges[part.Edge].IsJoined && this->StandsForPartner(i))
      {
        common[i] = common[part.Partner] = joined.Common.size();
        this->AddCommon(part, joined);
      }
    }
    for (const ChainEdge& edge : this->Edges)
    {
      this->AddUses(edge, common, joined);
    }
  }

private:
  void AddEdge(const STEPSingleEdge& single)
  {
    const STEPEdge& source = *single.Edge;
    ChainEdge edge;
    edge.Source = single;
    double length = 0.0;
    double longest = 0.0;
    Vector3 last{};
    for (int i = 0; i < ChainSamples; ++i)
    {
      const Vector3 point = EvaluateFraction(source, source.First, source.Last, i);
      const double chord = i > 0 ? Norm(Subtract(point, last)) : 0.0;
      length += chord;
      longest = std::max(longest, chord);
      for (int c = 0; c < 3; ++c)
      {
        edge.Low[c] = i > 0 ? std::min(edge.Low[c], point[c]) : point[c];
        edge.High[c] = i > 0 ? std::max(edge.High[c], point[c]) : point[c];
      }
      last = point;
    }
    edge.Limit = this->GetLimit(length);
    for (int c = 0; c < 3; ++c)
    {
      edge.Low[c] -= longest + edge.Limit;
      edge.High[c] += longest + edge.Limit;
    }
    this->Edges.push_back(std::move(edge));
    for (const bool isFirst : { true, false })
    {
      this->Ends.push_back(MakeEnd(single, isFirst));
    }
  }

  double GetLimit(double length) const { return std::min(this->Precision, MaxEdgeDistance * length); }

  static ChainEnd MakeEnd(const STEPSingleEdge& single, bool isFirst)
  {
    ChainEnd result;
    result.End = { single.Entity, isFirst };
    result.Point = isFirst ? single.Edge->Start : single.Edge->End;
    result.Parameter = isFirst ? single.Edge->First : single.Edge->Last;
    result.Place = Dot(ChainDirection, result.Point);
    return result;
  }

  static bool IsInside(const Vector3& point, const ChainEdge& edge)
  {
    bool result = true;
    for (int c = 0; c < 3; ++c)
    {
      result = result && point[c] >= edge.Low[c] && point[c] <= edge.High[c];
    }
    return result;
  }

  static bool AreSame(const Vector3& a, const Vector3& b, double limit)
  {
    return Norm(Subtract(a, b)) <= limit;
  }

  const STEPEdgeSamples& GetSamples(ChainEdge& edge) const
  {
    if (!edge.Samples)
    {
      edge.Samples = std::make_unique<STEPEdgeSamples>(*edge.Source.Edge);
    }
    return *edge.Samples;
  }

  /// Finds the vertices of other edges that lie within an edge, each place once, in order.
  void FindJunctions(ChainEdge& edge) const
  {
    const STEPEdge& source = *edge.Source.Edge;
    const double low = Dot(ChainDirection, edge.Low);
    const double high = Dot(ChainDirection, edge.High);
    std::vector<ChainEnd> found;
    for (auto end = std::lower_bound(this->Ends.begin(), this->Ends.end(), low,
           [](const ChainEnd&a, double place) { return a.Place < place; });
         end != this->Ends.end() && end->Place <= high && !this->Work.IsSpent(); ++end)
    {
      this->Work.Take(1);
      if (!IsInside(end->Point, edge) || AreSame(end->Point, source.Start, edge.Limit) ||
        AreSame(end->Point, source.End, edge.Limit))
      {
        continue;
      }
      ChainEnd junction = *end;
      junction.Parameter =
        this->GetSamples(edge).FindFoot(source.First, source.Last, end->Point, edge.Limit, this->Work);
      if (junction.Parameter > source.First && junction.Parameter < source.Last &&
        AreSame(source.Curve->Evaluate(junction.Parameter), end->Point, edge.Limit))
      {
        found.push_back(junction);
      }
    }
    std::stable_sort(found.begin(), found.end(),
      [](const ChainEnd& a, const ChainEnd& b) { return a.Parameter < b.Parameter; });
    for (const ChainEnd& junction : found)
    {
      if (edge.Junctions.empty() || !AreSame(junction.Point, edge.Junctions.back().Point, edge.Limit))
      {
        edge.Junctions.push_back(junction);
      }
    }
  }

  void Divide(ChainEdge& edge)
  {
    edge.FirstPart = this->Parts.size();
    edge.NumberOfParts = edge.Junctions.size() + 1;
    ChainPart part;
    part.Edge = static_cast<std::size_t>(&edge - this->Edges.data());
    part.Ends[1] = MakeEnd(edge.Source, true);
    for (std::size_t i = 0; i < edge.NumberOfParts; ++i)
    {
      part.Ends[0] = part.Ends[1];
      part.Ends[1] = i < edge.Junctions.size() ? edge.Junctions[i] : MakeEnd(edge.Source, false);
      double length = 0.0;
      for (int k = 1; k < ChainSamples; ++k)
      {
        length += Norm(Subtract(this->Evaluate(part, k), this->Evaluate(part, k - 1)));
      }
      part.Limit = this->GetLimit(length);
      part.Place = part.Ends[0].Place + part.Ends[1].Place;
      this->Parts.push_back(part);
    }
  }

  const STEPEdge& GetEdge(const ChainPart& part) const { return *this->Edges[part.Edge].Source.Edge; }

  Vector3 Evaluate(const ChainPart& part, int i) const
  {
    return EvaluateFraction(this->GetEdge(part), part.Ends[0].Parameter, part.Ends[1].Parameter, i);
  }

  STEPEdgePart GetPart(const ChainPart& part)
  {
    return { &this->GetSamples(this->Edges[part.Edge]), part.Ends[0].Parameter, part.Ends[1].Parameter };
  }

  void PairParts()
  {
    std::vector<std::size_t> order(this->Parts.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return this->Parts[a].Place < this->Parts[b].Place; });
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const ChainPart& part = this->Parts[order[i]];
      for (std::size_t k = i + 1;
           k < order.size() && this->Parts[order[k]].Place - part.Place <= 2.0 * part.Limit; ++k)
      {
        this->Connect(order[i], order[k]);
      }
    }
  }

  void Connect(std::size_t first, std::size_t second)
  {
    ChainPart& a = this->Parts[first];
    ChainPart& b = this->Parts[second];
    const double limit = std::min(a.Limit, b.Limit);
    for (const bool isOpposite : { false, true })
    {
      if (a.Edge == b.Edge || (a.Partners > 1 && b.Partners > 1) ||
        !AreSame(a.Ends[0].Point, b.Ends[isOpposite ? 1 : 0].Point, limit) ||
        !AreSame(a.Ends[1].Point, b.Ends[isOpposite ? 0 : 1].Point, limit))
      {
        continue;
      }
      const double distance = BoundEdgeDistance(this->GetPart(a), this->GetPart(b), limit, this->Work);
      if (std::isfinite(distance))
      {
        ++a.Partners;
        ++b.Partners;
        a.Partner = second;
        b.Partner = first;
        a.IsOpposite = b.IsOpposite = isOpposite;
        a.Distance = b.Distance = distance;
        return;
      }
    }
  }

  /// Marks the edges that have a part without a pair, and those that have a pair with such edges.
  void LeaveIncomplete()
  {
    std::vector<std::size_t> left;
    for (const ChainPart& part : this->Parts)
    {
      if (part.Partners != 1 || this->Parts[part.Partner].Partners != 1)
      {
        left.push_back(part.Edge);
      }
    }
    while (!left.empty())
    {
      ChainEdge& edge = this->Edges[left.back()];
      left.pop_back();
      if (!edge.IsJoined)
      {
        continue;
      }
      edge.IsJoined = false;
      for (std::size_t i = edge.FirstPart; i < edge.FirstPart + edge.NumberOfParts; ++i)
      {
        if (this->Parts[i].Partners > 0)
        {
          left.push_back(this->Parts[this->Parts[i].Partner].Edge);
        }
      }
    }
  }

  bool IsWhole(const ChainPart& part) const { return this->Edges[part.Edge].NumberOfParts == 1; }

  /// An edge that was not divided stands for its partner, or else the one that is first in the shell.
  bool StandsForPartner(std::size_t i) const
  {
    const ChainPart& part = this->Parts[i];
    const ChainPart& partner = this->Parts[part.Partner];
    return this->IsWhole(part) != this->IsWhole(partner) ? this->IsWhole(part) : i < part.Partner;
  }

  void AddCommon(const ChainPart& part, STEPJoinedEdges& joined) const
  {
    STEPCommonEdge common;
    common.Edge = this->Edges[part.Edge].Source.Entity;
    common.IsWhole = this->IsWhole(part);
    common.First = part.Ends[0].Parameter;
    common.Last = part.Ends[1].Parameter;
    common.Distance = part.Distance;
    for (int i = 0; i < 2; ++i)
    {
      common.Ends[i] = part.Ends[i].End;
      joined.Vertices.push_back(
        { part.Ends[i].End, this->Parts[part.Partner].Ends[part.IsOpposite ? 1 - i : i].End });
    }
    joined.Common.push_back(common);
  }

  void AddUses(const ChainEdge& edge, const std::vector<std::size_t>& common, STEPJoinedEdges& joined) const
  {
    if (!edge.IsJoined || (edge.NumberOfParts == 1 && this->StandsForPartner(edge.FirstPart)))
    {
      return;
    }
    joined.NumberOfDivided += edge.NumberOfParts > 1 ? 1 : 0;
    std::vector<STEPJoinedEdges::Use>& uses = joined.Edges[edge.Source.Entity];
    for (std::size_t i = edge.FirstPart; i < edge.FirstPart + edge.NumberOfParts; ++i)
    {
      const bool isOwn = this->StandsForPartner(i);
      uses.push_back({ common[i], !isOwn && this->Parts[i].IsOpposite });
    }
  }

  const double Precision;
  STEPEdgeWork& Work;
  std::vector<ChainEdge> Edges;
  std::vector<ChainEnd> Ends;
  std::vector<ChainPart> Parts;
};
}

void AddEdgeChains(
  const std::vector<STEPSingleEdge>& edges, double precision, STEPEdgeWork& work, STEPJoinedEdges& joined)
{
  if (edges.size() > 1)
  {
    ChainFinder(edges, precision, work).Run(joined);
  }
}
}
