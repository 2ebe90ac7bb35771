#include "smEdgeGaps.h"

#include "smFormat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace sm
{
namespace
{
constexpr double RoundingGap = 1e-12;
}

bool IsWider(const EdgeGap& a, const EdgeGap& b)
{
  return !std::isnan(a.MaxGap) && (std::isnan(b.MaxGap) || a.MaxGap > b.MaxGap);
}

std::vector<EdgeGap> CollectEdgeGaps(
  const vtkTrimmedNURBSModel& model, const std::vector<FaceIntegrals>* faces)
{
  std::vector<EdgeGap> edges;
  std::vector<int> measured;
  std::unordered_map<const Edge*, std::size_t> places;
  const std::vector<FacePointer>& sources = model.GetFaces();
  for (std::size_t f = 0; f < sources.size(); ++f)
  {
    const Face& face = *sources[f];
    // A ribbon whose width is rounding is not integrated, so its coedge has no row: its gap counts as 0.
    const bool isMeasured = faces && (*faces)[f].Error.empty() && !(*faces)[f].Skipped;
    // Index of the edge of every coedge; `none` for a pole.
    std::vector<std::vector<std::size_t>> placeOf(face.Loops.size());
    const std::size_t none = std::numeric_limits<std::size_t>::max();
    for (std::size_t l = 0; l < face.Loops.size(); ++l)
    {
      for (const Coedge& coedge : face.Loops[l].Coedges)
      {
        if (coedge.Use->Degenerate)
        {
          placeOf[l].push_back(none);
          continue;
        }
        const auto [entry, isNew] = places.emplace(coedge.Use.get(), edges.size());
        if (isNew)
        {
          edges.emplace_back();
          edges.back().Source = coedge.Use.get();
          edges.back().Index = static_cast<int>(edges.size()) - 1;
          measured.push_back(0);
        }
        placeOf[l].push_back(entry->second);
        ++edges[entry->second].Uses;
        measured[entry->second] += isMeasured ? 1 : 0;
        edges[entry->second].SignedUses += face.Reversed == coedge.Reversed ? 1 : -1;
      }
    }
    if (!faces)
    {
      continue;
    }
    for (const CoedgeGap& gap : (*faces)[f].Gaps)
    {
      if (gap.Loop < 0 || gap.Loop >= static_cast<int>(placeOf.size()) || gap.Coedge < 0 ||
        gap.Coedge >= static_cast<int>(placeOf[gap.Loop].size()) || placeOf[gap.Loop][gap.Coedge] == none)
      {
        continue;
      }
      const std::size_t place = placeOf[gap.Loop][gap.Coedge];
      EdgeGap& edge = edges[place];
      edge.GapSquared += gap.GapSquared;
      edge.GapArea += gap.GapArea;
      edge.MaxGap = GetLargerGap(edge.MaxGap, gap.MaxGap);
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (measured[i] < edges[i].Uses)
    {
      edges[i].GapSquared = edges[i].GapArea = edges[i].MaxGap = std::numeric_limits<double>::quiet_NaN();
    }
  }
  std::stable_sort(edges.begin(), edges.end(), IsWider);
  return edges;
}

std::string DescribeWorstEdge(const std::vector<EdgeGap>& edges, double size, const std::string& unit)
{
  if (edges.empty() || !(edges.front().MaxGap > RoundingGap * size))
  {
    return {};
  }
  const EdgeGap& worst = edges.front();
  const Edge& edge = *worst.Source;
  const bool beyondTolerance = worst.MaxGap > edge.Tolerance;
  if (!beyondTolerance && !(worst.MaxGap > LargeGap * size))
  {
    return {};
  }
  const std::string name =
    (edge.FileId > 0 ? "edge #" + std::to_string(edge.FileId) : std::string("an edge")) +
    (edge.Name.empty() ? std::string() : " \"" + edge.Name + "\"");
  const auto format = [&unit](double length) { return FormatDigits(length, 2) + " " + unit; };
  return "the widest gap between a face and its edge is " + format(worst.MaxGap) + ", at " + name +
    (beyondTolerance ? ", whose tolerance in the file is " + format(edge.Tolerance) : std::string());
}
}
