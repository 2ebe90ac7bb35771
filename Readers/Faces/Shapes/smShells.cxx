#include "smShells.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace sm
{
std::vector<std::size_t> GroupFaces(
  const std::vector<EdgeOfFace>& uses, std::size_t faceCount, std::size_t edgeCount)
{
  std::vector<std::size_t> group(faceCount);
  std::iota(group.begin(), group.end(), std::size_t{ 0 });
  const auto find = [&group](std::size_t i)
  {
    while (group[i] != i)
    {
      i = group[i] = group[group[i]];
    }
    return i;
  };
  std::vector<std::size_t> firstFaces(edgeCount, faceCount);
  for (const EdgeOfFace& use : uses)
  {
    std::size_t& first = firstFaces[use.Edge];
    first = first == faceCount ? use.Face : first;
    const std::size_t a = find(first);
    const std::size_t b = find(use.Face);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < faceCount; ++i)
  {
    group[i] = find(i);
  }
  return group;
}

std::vector<ShellPointer> SplitShell(const ShellPointer& shell)
{
  const std::vector<FaceUse>& faces = shell->Faces;
  std::vector<EdgeOfFace> uses;
  EdgeIndex edges;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (const WireShape& wire : faces[i].Face->Wires)
    {
      for (const CoedgeShape& use : wire.Coedges)
      {
        if (!use.Edge->Degenerate)
        {
          uses.push_back({ i, static_cast<std::size_t>(edges.Add(use.Edge.get())), false });
        }
      }
    }
  }
  const std::vector<std::size_t> groups = GroupFaces(uses, faces.size(), edges.GetSize());
  if (std::all_of(groups.begin(), groups.end(), [](std::size_t group) { return group == 0; }))
  {
    return { shell };
  }
  std::map<std::size_t, ShellPointer> parts;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    ShellPointer& part = parts[groups[i]];
    if (!part)
    {
      part = std::make_shared<ShellShape>(*shell);
      part->Faces.clear();
      // What is lost is reported once.
      part->LostFaces = parts.size() == 1 ? shell->LostFaces : 0;
    }
    part->Faces.push_back(faces[i]);
  }
  std::vector<ShellPointer> result;
  for (const auto& [group, part] : parts)
  {
    result.push_back(part);
  }
  return result;
}
}
