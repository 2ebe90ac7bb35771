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
bool IsBoundary(const TopoDS_Shape& edge)
{
  return !BRep_Tool::Degenerated(TopoDS::Edge(edge)) &&
    (edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED);
}

std::vector<std::size_t> GroupFaces(const std::vector<TopoDS_Shape>& faces)
{
  std::vector<std::size_t> group(faces.size());
  std::iota(group.begin(), group.end(), std::size_t{ 0 });
  const auto find = [&group](std::size_t i)
  {
    while (group[i] != i)
    {
      i = group[i] = group[group[i]];
    }
    return i;
  };
  std::unordered_map<const TopoDS_TShape*, std::size_t> firstFaces;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next())
    {
      if (IsBoundary(it.Current()))
      {
        const std::size_t a = find(firstFaces.emplace(it.Current().TShape().get(), i).first->second);
        const std::size_t b = find(i);
        group[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
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
  const std::vector<std::size_t> groups = GroupFaces(faces);
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
