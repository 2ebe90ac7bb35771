#include "smOCCTShells.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ToroidalSurface.hxx>
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

void ReverseTurnedTori(const TopoDS_Shape& shell)
{
  std::vector<TopoDS_Shape> faces;
  std::vector<bool> isTorus;
  for (TopoDS_Iterator it(shell, false, false); it.More(); it.Next())
  {
    TopLoc_Location location;
    faces.push_back(it.Value());
    isTorus.push_back(it.Value().ShapeType() == TopAbs_FACE &&
      !Handle(Geom_ToroidalSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(it.Value()), location))
         .IsNull());
  }
  if (std::none_of(isTorus.begin(), isTorus.end(), [](bool is) { return is; }))
  {
    return;
  }
  struct Use
  {
    std::size_t Face;
    TopAbs_Orientation Orientation;
  };
  std::unordered_map<const TopoDS_TShape*, std::vector<Use>> uses;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next())
    {
      if (IsBoundary(it.Current()))
      {
        uses[it.Current().TShape().get()].push_back({ i, it.Current().Orientation() });
      }
    }
  }
  std::vector<int> alike(faces.size(), 0);
  std::vector<int> shared(faces.size(), 0);
  for (const auto& [edge, pair] : uses)
  {
    if (pair.size() == 2 && pair[0].Face != pair[1].Face)
    {
      for (const Use& use : pair)
      {
        ++shared[use.Face];
        alike[use.Face] += pair[0].Orientation == pair[1].Orientation ? 1 : 0;
      }
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (isTorus[i] && shared[i] > 0 && alike[i] == shared[i])
    {
      faces[i].Reverse();
      any = true;
    }
  }
  if (!any)
  {
    return;
  }
  const BRep_Builder builder;
  TopoDS_Shape plain = shell.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  const bool wasFree = plain.Free();
  const bool wasClosed = plain.Closed();
  plain.Free(true);
  for (TopoDS_Iterator it(plain, false, false); it.More(); it.Initialize(plain, false, false))
  {
    builder.Remove(plain, it.Value());
  }
  for (const TopoDS_Shape& face : faces)
  {
    builder.Add(plain, face);
  }
  plain.Closed(wasClosed);
  plain.Free(wasFree);
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
