#include "smOCCTShapeAdder.h"

#include "smOCCTShells.h"

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
int CountFaces(const TopoDS_Shape& shape, TopAbs_ShapeEnum avoided)
{
  int faces = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE, avoided); it.More(); it.Next())
  {
    ++faces;
  }
  return faces;
}

/// Returns true if at least half of the edges of a shell are used twice. A shell that the file declares as
/// a solid is then read as a solid with openings.
bool IsMostlyClosed(const TopoDS_Shape& shell)
{
  TopTools_IndexedDataMapOfShapeListOfShape users;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, users);
  int open = 0;
  for (const TopTools_ListOfShape& faces : users)
  {
    open += faces.Extent() == 1 ? 1 : 0;
  }
  return 2 * open <= users.Extent();
}

}

bool ShapeAdder::IsOpenSolid(const TopoDS_Shape& shell) const
{
  const auto info = this->Result.Table.find(shell.TShape().get());
  return info != this->Result.Table.end() && info->second.OpenSolid;
}

int ShapeAdder::CountSolids(const TopoDS_Shape& shape) const
{
  int solids = 0;
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
  {
    ++solids;
  }
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
  {
    solids += this->IsOpenSolid(it.Current()) ? 1 : 0;
  }
  return solids;
}

void ShapeAdder::Add(const TopoDS_Shape& shape, const PartBody& part, const gp_Trsf& placement,
  const Vector3& color, ProductNode& node)
{
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
  {
    this->AddBody(it.Current(), true, part, placement, color, node);
  }
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
  {
    const bool open = this->IsOpenSolid(it.Current());
    if (open || !this->OnlySolids)
    {
      const bool solid = open && IsMostlyClosed(it.Current());
      if (open)
      {
        const std::string message = "Solid #" +
          std::to_string(this->Result.Table.at(it.Current().TShape().get()).FileId) +
          (solid ? " is not closed." : " is open at most of its edges and is read as a surface.");
        std::vector<std::string>& said = this->Result.Messages;
        if (std::find(said.begin(), said.end(), message) == said.end())
        {
          said.push_back(message);
        }
      }
      for (const TopoDS_Shape& connected : this->GetParts(it.Current()))
      {
        this->AddBody(connected, solid, part, placement, color, node);
      }
    }
    else
    {
      this->Result.FreeFaces += CountFaces(it.Current(), TopAbs_SHAPE);
    }
  }
  if (this->OnlySolids)
  {
    this->Result.FreeFaces += CountFaces(shape, TopAbs_SHELL);
    return;
  }
  TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SHELL);
  if (faces.More())
  {
    TopoDS_Compound& group = this->LooseFaces[shape.TShape().get()];
    if (group.IsNull())
    {
      BRep_Builder builder;
      builder.MakeCompound(group);
      for (; faces.More(); faces.Next())
      {
        builder.Add(group, faces.Current());
      }
    }
    this->AddBody(group, false, part, placement, color, node);
  }
}

/// Returns the bodies of a shell that is not part of a solid. OpenCASCADE's repair divides a shell into
/// connected parts; a shell that was not repaired is divided here.
std::vector<TopoDS_Shape> ShapeAdder::GetParts(const TopoDS_Shape& shell)
{
  if (!IsAsInFile(shell, this->Result.Table))
  {
    return { shell };
  }
  std::vector<TopoDS_Shape>& parts = this->ShellParts[shell.TShape().get()];
  if (parts.empty())
  {
    parts = SplitShell(shell);
    ShapeInfo info = AddShapeInfo(this->Result.Table, shell);
    for (const TopoDS_Shape& part : parts)
    {
      if (!part.IsSame(shell))
      {
        info.Owner = part.TShape();
        this->Result.Table.emplace(part.TShape().get(), info);
      }
      info.LostFaces = 0;
    }
  }
  std::vector<TopoDS_Shape> placed;
  for (const TopoDS_Shape& part : parts)
  {
    placed.push_back(part.Located(shell.Location()).Oriented(shell.Orientation()));
  }
  return placed;
}

void ShapeAdder::AddBody(const TopoDS_Shape& shape, bool solid, const PartBody& part,
  const gp_Trsf& placement, const Vector3& color, ProductNode& node)
{
  const gp_Trsf total = placement * shape.Location().Transformation();
  const double scale = std::abs(total.ScaleFactor());
  const bool scaled = std::abs(scale - 1.0) > 1e-12;
  const auto key = std::make_tuple(
    static_cast<const void*>(shape.TShape().get()), shape.Orientation(), scaled ? scale : 1.0);
  const auto known = this->Known.find(key);
  BodyInstance instance;
  if (known != this->Known.end())
  {
    instance.Body = known->second;
  }
  else
  {
    instance.Body = this->Known[key] = static_cast<int>(this->Result.Bodies.size());
    PartBody body = part;
    body.Shape = shape;
    body.Shape.Location(TopLoc_Location());
    body.Solid = solid;
    if (scaled)
    {
      body.Scale.SetScaleFactor(scale);
      // The volume and area that the file states are those of the unscaled part.
      body.FileVolume *= scale * scale * scale;
      body.FileArea *= scale * scale;
    }
    const auto info = this->Result.Table.find(shape.TShape().get());
    if (info != this->Result.Table.end())
    {
      body.FileId = info->second.FileId;
      body.Name = info->second.Name.empty() ? body.Name : info->second.Name;
      body.Color = info->second.Color[0] >= 0.0 ? info->second.Color : body.Color;
    }
    if (body.Name.empty())
    {
      body.Name = solid ? "Solid" : "Shell";
    }
    this->Result.Bodies.push_back(body);
  }
  instance.Placement = total;
  if (scaled)
  {
    gp_Trsf inverse;
    inverse.SetScaleFactor(1.0 / scale);
    instance.Placement = total * inverse;
  }
  instance.Name = node.Name.empty() ? this->Result.Bodies[instance.Body].Name : node.Name;
  const std::size_t ordinal = node.Instances.size();
  if (ordinal > 0)
  {
    instance.Name += " (" + std::to_string(ordinal + 1) + ")";
  }
  instance.Color = color;
  node.Instances.push_back(static_cast<int>(this->Result.Instances.size()));
  this->Result.Instances.push_back(instance);
}

}
