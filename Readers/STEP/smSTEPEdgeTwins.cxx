#include "smSTEPEdgeTwins.h"

#include "smFormat.h"
#include "smSTEPEdgeChains.h"
#include "smSTEPEdgeDistance.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr std::size_t TwinSamples = 5;

/// Middles are sorted along a direction in which those of a regular part differ.
constexpr Vector3 TwinDirection = { 0.53773, 0.61512, 0.57669 };

struct SampledEdge
{
  Part21File::Index Edge = Part21File::None;
  const STEPEdge* Source = nullptr;
  /// Place in the list of edges.
  std::size_t Order = 0;
  std::array<Vector3, TwinSamples> Points{};
  double Limit = 0.0;
  /// Place of the middle along TwinDirection.
  double Place = 0.0;
  /// Number of edges that lie on this one, and the last of them.
  std::size_t Partners = 0;
  const SampledEdge* Partner = nullptr;
  bool IsOpposite = false;
  double Distance = 0.0;

  bool IsPaired() const { return this->Partners == 1 && this->Partner->Partners == 1; }
};

SampledEdge SampleEdge(Part21File::Index entity, const STEPEdge& edge, double precision)
{
  SampledEdge result;
  result.Edge = entity;
  result.Source = &edge;
  double length = 0.0;
  for (std::size_t i = 0; i < TwinSamples; ++i)
  {
    const double fraction = static_cast<double>(i) / (TwinSamples - 1);
    result.Points[i] = edge.Curve->Evaluate((1.0 - fraction) * edge.First + fraction * edge.Last);
    length += i > 0 ? Norm(Subtract(result.Points[i], result.Points[i - 1])) : 0.0;
  }
  result.Limit = std::min(precision, MaxEdgeDistance * length);
  result.Place = Dot(TwinDirection, result.Points[TwinSamples / 2]);
  return result;
}

/// Returns true if their points are closer than the limit.
bool HasSamePoints(const SampledEdge& a, const SampledEdge& b, bool isOpposite, double limit)
{
  bool result = true;
  for (std::size_t i = 0; i < TwinSamples; ++i)
  {
    const Vector3& other = b.Points[isOpposite ? TwinSamples - 1 - i : i];
    result = result && Norm(Subtract(a.Points[i], other)) <= limit;
  }
  return result;
}

/// Counts the edges that lie on each other, as far as it matters: an edge on two others is in no pair.
void Connect(SampledEdge& a, SampledEdge& b, STEPEdgeWork& work)
{
  const double limit = std::min(a.Limit, b.Limit);
  for (const bool isOpposite : { false, true })
  {
    if ((a.Partners > 1 && b.Partners > 1) || !HasSamePoints(a, b, isOpposite, limit))
    {
      continue;
    }
    const STEPEdgeSamples samples[] = { STEPEdgeSamples(*a.Source), STEPEdgeSamples(*b.Source) };
    const double distance = BoundEdgeDistance({ &samples[0], a.Source->First, a.Source->Last },
      { &samples[1], b.Source->First, b.Source->Last }, limit, work);
    if (std::isfinite(distance))
    {
      ++a.Partners;
      ++b.Partners;
      a.Partner = &b;
      b.Partner = &a;
      a.IsOpposite = b.IsOpposite = isOpposite;
      a.Distance = b.Distance = distance;
      return;
    }
  }
}

void AddPair(const SampledEdge& first, const SampledEdge& second, STEPJoinedEdges& joined)
{
  joined.Edges[second.Edge] = { { joined.Common.size(), second.IsOpposite } };
  STEPCommonEdge common;
  common.Edge = first.Edge;
  common.Distance = second.Distance;
  joined.Common.push_back(common);
  for (const bool isFirst : { true, false })
  {
    joined.Vertices.push_back({ { second.Edge, isFirst }, { first.Edge, isFirst != second.IsOpposite } });
  }
}
}

STEPJoinedEdges JoinEdges(const std::vector<Part21File::Index>& edges, STEPEdges& table, double precision)
{
  std::unordered_map<Part21File::Index, int> uses;
  for (const Part21File::Index entity : edges)
  {
    ++uses[entity];
  }
  std::vector<SampledEdge> samples;
  for (const Part21File::Index entity : edges)
  {
    const STEPEdge* edge = uses[entity] == 1 ? table.GetEdge(entity) : nullptr;
    if (edge)
    {
      samples.push_back(SampleEdge(entity, *edge, precision));
      samples.back().Order = samples.size();
    }
  }
  std::sort(samples.begin(), samples.end(),
    [](const SampledEdge& a, const SampledEdge& b)
    { return a.Place != b.Place ? a.Place < b.Place : a.Order < b.Order; });
  STEPEdgeWork work(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    for (std::size_t k = i + 1; k < samples.size() && samples[k].Place - samples[i].Place <= samples[i].Limit;
         ++k)
    {
      Connect(samples[i], samples[k], work);
    }
  }
  STEPJoinedEdges result;
  std::vector<STEPSingleEdge> others;
  for (const SampledEdge& sample : samples)
  {
    if (!sample.IsPaired())
    {
      others.push_back({ sample.Edge, sample.Order, table.GetEdge(sample.Edge) });
    }
    else if (sample.Partner->Order < sample.Order)
    {
      AddPair(*sample.Partner, sample, result);
    }
  }
  std::sort(others.begin(), others.end(), [](const auto& a, const auto& b) { return a.Order < b.Order; });
  AddEdgeChains(others, precision, work, result);
  return result;
}

std::string DescribeJoinedEdges(std::uint64_t body, const STEPJoinedEdges& joined)
{
  double distance = 0.0;
  for (const STEPCommonEdge& common : joined.Common)
  {
    distance = std::max(distance, common.Distance);
  }
  const bool hasParts = joined.NumberOfDivided > 0;
  std::string result = "Solid #" + std::to_string(body) + " of the file: " +
    FormatCount(joined.Common.size(), hasParts ? "pair of edges or their parts" : "pair of edges",
      hasParts ? "pairs of edges or their parts" : "pairs of edges") +
    " lie on each other and were joined, since the file has edges of their own for adjacent faces";
  if (hasParts)
  {
    result += "; " +
      FormatCount(joined.NumberOfDivided, "edge that lies on several others was divided at their ends",
        "edges that lie on several others were divided at their ends");
  }
  return result + ". Joined edges are up to " + FormatBound(distance) + " mm apart.";
}
}
