#include "smSTEPEdgeTwins.h"

#include <algorithm>
#include <array>

namespace sm
{
namespace
{
constexpr std::size_t TwinSamples = 5;

/// Largest distance of a pair, relative to its length.
constexpr double TwinLimit = 1e-4;

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
  result.Limit = std::min(precision, TwinLimit * length);
  result.Place = Dot(TwinDirection, result.Points[TwinSamples / 2]);
  return result;
}

bool LieOnEachOther(const SampledEdge& a, const SampledEdge& b, bool isOpposite)
{
  const double limit = std::min(a.Limit, b.Limit);
  for (std::size_t i = 0; i < TwinSamples; ++i)
  {
    if (!(Norm(Subtract(a.Points[i], b.Points[isOpposite ? TwinSamples - 1 - i : i])) <= limit))
    {
      return false;
    }
  }
  return true;
}

void Connect(SampledEdge& a, SampledEdge& b)
{
  for (const bool isOpposite : { false, true })
  {
    if (LieOnEachOther(a, b, isOpposite))
    {
      ++a.Partners;
      ++b.Partners;
      a.Partner = &b;
      b.Partner = &a;
      a.IsOpposite = b.IsOpposite = isOpposite;
      return;
    }
  }
}
}

std::unordered_map<Part21File::Index, STEPEdgeTwin> FindEdgeTwins(
  const std::vector<Part21File::Index>& edges, STEPEdges& table, double precision)
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
  std::unordered_map<Part21File::Index, STEPEdgeTwin> result;
  for (const SampledEdge& sample : samples)
  {
    const SampledEdge* first = sample.Partner;
    if (sample.Partners == 1 && first->Partners == 1 && first->Order < sample.Order)
    {
      result.emplace(sample.Edge, STEPEdgeTwin{ first->Edge, sample.IsOpposite });
    }
  }
  return result;
}
}
