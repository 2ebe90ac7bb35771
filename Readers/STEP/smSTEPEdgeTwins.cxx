#include "smSTEPEdgeTwins.h"

#include "smFormat.h"
#include "smSTEPEdgeChains.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Returns the largest distance of their points; infinite if it is above the limit.
double MeasureDistance(const SampledEdge& a, const SampledEdge& b, bool isOpposite)
{
  const double limit = std::min(a.Limit, b.Limit);
  double result = 0.0;
  for (std::size_t i = 0; i < TwinSamples; ++i)
  {
    const Vector3& other = b.Points[isOpposite ? TwinSamples - 1 - i : i];
    const double distance = Norm(Subtract(a.Points[i], other));
    if (!(distance <= limit))
    {
      return std::numeric_limits<double>::infinity();
    }
    result = std::max(result, distance);
  }
  return result;
}

void Connect(SampledEdge& a, SampledEdge& b)
{
  for (const bool isOpposite : { false, true })
  {
    const double distance = MeasureDistance(a, b, isOpposite);
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
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    for (std::size_t k = i + 1; k < samples.size() && samples[k].Place - samples[i].Place <= samples[i].Limit;
         ++k)
    {
      Connect(samples[i], samples[k]);
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
  AddEdgeChains(others, precision, result);
  return result;
}

std::string DescribeJoinedEdges(std::uint64_t body, const STEPJoinedEdges& joined)
{
  double distance = 0.0;
  for (const STEPCommonEdge& common : joined.Common)
  {
    distance = std::max(distance, common.Distance);
  }
  std::string result = "Solid #" + std::to_string(body) +
    " of the file: " + std::to_string(joined.Common.size()) +
    " pairs of edges lie on each other and were joined, since the file has edges of their own for adjacent "
    "faces";
  if (joined.NumberOfDivided > 0)
  {
    result += "; " + FormatCount(joined.NumberOfDivided, "edge that lies", "edges that lie") +
      " on several others were divided at their ends";
  }
  return result + ". Joined edges are up to " + FormatBound(distance) + " mm apart.";
}
}
