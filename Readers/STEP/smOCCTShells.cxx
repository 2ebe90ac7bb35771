#include "smOCCTShells.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_TShape.hxx>

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace sm
{
namespace
{
/// Returns true if the edge bounds the face that uses it: it is not a pole, and has neither orientation
/// INTERNAL nor EXTERNAL.
bool IsBoundary(const TopoDS_Shape& edge)
{
  return !BRep_Tool::Degenerated(TopoDS::Edge(edge)) &&
    (edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED);
}
}

std::vector<std::size_t> GroupFaces(
  const std::vector<EdgeUse>& uses, std::size_t faceCount, std::size_t edgeCount)
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
  for (const EdgeUse& use : uses)
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

std::vector<TopoDS_Shape> SplitShell(const TopoDS_Shape& shell)
{
  std::vector<TopoDS_Shape> faces;
  for (TopoDS_Iterator it(shell, false, false); it.More(); it.Next())
  {
    faces.push_back(it.Value());
  }
  std::vector<EdgeUse> uses;
  std::unordered_map<const TopoDS_TShape*, std::size_t> edges;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next())
    {
      if (IsBoundary(it.Current()))
      {
        uses.push_back({ i, edges.emplace(it.Current().TShape().get(), edges.size()).first->second, false });
      }
    }
  }
  const std::vector<std::size_t> groups = GroupFaces(uses, faces.size(), edges.size());
  if (std::all_of(groups.begin(), groups.end(), [](std::size_t group) { return group == 0; }))
  {
    return { shell.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD) };
  }
  const BRep_Builder builder;
  std::map<std::size_t, TopoDS_Shell> parts;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    TopoDS_Shell& part = parts[groups[i]];
    if (part.IsNull())
    {
      builder.MakeShell(part);
    }
    builder.Add(part, faces[i]);
  }
  std::vector<TopoDS_Shape> result;
  for (const auto& [group, part] : parts)
  {
    result.push_back(part);
  }
  return result;
}
}
