#include "smCoincidentFaces.h"

#include "smBodyScales.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace sm
{
namespace
{
/// Largest volume between two faces that lie on each other, relative to their area times the size of the
/// body, besides the bounds of their integrals; and the largest such bound that decides.
constexpr double MaxDistance = 1e-9;
constexpr double MaxBound = 1e-6;
/// Largest number of faces with the same edges that are compared, and of pairs that are reported.
constexpr std::size_t MaxFaces = 16;
constexpr int MaxPairs = 5;

std::vector<std::uint64_t> GetEdges(const Face& face)
{
  std::vector<std::uint64_t> edges;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      edges.push_back(coedge.Use->Id);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::uint64_t GetHash(const Face& face)
{
  std::uint64_t hash = 0;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      const std::uint64_t mixed = coedge.Use->Id * 0x9e3779b97f4a7c15ull;
      hash += mixed ^ (mixed >> 29);
    }
  }
  return hash;
}

/// Returns the edge of a face that the body uses most often, and how often.
std::pair<const Edge*, int> FindMostUsed(const vtkTrimmedNURBSModel& model, const Face& face)
{
  std::unordered_map<const Edge*, int> uses;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      uses[coedge.Use.get()] = 0;
    }
  }
  for (const FacePointer& other : model.GetFaces())
  {
    for (const Loop& loop : other->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        const auto use = uses.find(coedge.Use.get());
        if (use != uses.end())
        {
          ++use->second;
        }
      }
    }
  }
  std::pair<const Edge*, int> maximum{ nullptr, 0 };
  for (const auto& [edge, count] : uses)
  {
    const bool isBefore = maximum.first && count == maximum.second && edge->Id < maximum.first->Id;
    maximum = count > maximum.second || isBefore ? std::make_pair(edge, count) : maximum;
  }
  return maximum;
}
}

void FlagCoincidentFaces(BodyIntegrals& body, int volume, int area)
{
  const std::vector<FacePointer>& faces = body.Model->GetFaces();
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> groups;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (!faces[f]->Loops.empty() && (*body.Faces)[f].Error.empty())
    {
      groups[GetHash(*faces[f])].push_back(f);
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const double size = GetRadius(*body.Model);
  const auto encloseNothing = [&](std::size_t a, std::size_t b)
  {
    const FaceIntegrals& first = (*body.Faces)[a];
    const FaceIntegrals& second = (*body.Faces)[b];
    const double sum =
      first.Face[volume] + first.Closing[volume] + second.Face[volume] + second.Closing[volume];
    const double bound = first.GetBound(volume) + second.GetBound(volume);
    const double scale = size * (first.Face[area] + second.Face[area]);
    return std::abs(sum) <= bound + MaxDistance * scale && bound <= MaxBound * scale;
  };
  for (const auto& [hash, group] : groups)
  {
    const std::size_t count = std::min(group.size(), MaxFaces);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t j = i + 1; j < count; ++j)
      {
        if (encloseNothing(group[i], group[j]) && GetEdges(*faces[group[i]]) == GetEdges(*faces[group[j]]))
        {
          pairs.emplace_back(group[i], group[j]);
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t k = 0; k < pairs.size() && k < MaxPairs; ++k)
  {
    const auto [a, b] = pairs[k];
    const auto [edge, uses] = FindMostUsed(*body.Model, *faces[a]);
    body.Flag(Status::Suspect,
      "faces #" + std::to_string(faces[a]->FileId) + " and #" + std::to_string(faces[b]->FileId) +
        " lie on each other with opposite sides: both areas count, and no volume" +
        (uses > 2 ? "; edge #" + std::to_string(edge->FileId) + " is used " + std::to_string(uses) + " times"
                  : ""));
    body.FaceDefects.push_back({ { a, b }, "two faces lie on each other", true });
  }
}
}
