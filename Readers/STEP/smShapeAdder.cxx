#include "smShapeAdder.h"

#include "Shapes/smShells.h"
#include "smBodyConversion.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace sm
{
namespace
{
/// Relative difference of a scale from 1 that is rounding.
constexpr double NoScale = 1e-12;

/// Returns true if at least half of the edges of a shell are used twice. A shell that the file declares as
/// a solid is then read as a solid with openings.
bool IsMostlyClosed(const ShellShape& shell)
{
  std::unordered_map<const EdgeShape*, int> uses;
  for (const FaceUse& face : shell.Faces)
  {
    for (const WireShape& wire : face.Face->Wires)
    {
      for (const CoedgeShape& coedge : wire.Coedges)
      {
        ++uses[coedge.Edge.get()];
      }
    }
  }
  const auto open =
    std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second == 1; });
  return 2 * open <= static_cast<std::ptrdiff_t>(uses.size());
}

}

int ShapeAdder::CountSolids(const ShapeGroup& shapes)
{
  const auto open = std::count_if(
    shapes.Shells.begin(), shapes.Shells.end(), [](const ShellUse& use) { return use.Shell->OpenSolid; });
  return static_cast<int>(shapes.Solids.size()) + static_cast<int>(open);
}

void ShapeAdder::Add(const ShapeGroup& shapes, const PartBody& part, const Placement& placement,
  const Vector3& color, ProductNode& node)
{
  for (const SolidUse& use : shapes.Solids)
  {
    this->AddBody({ use.Solid.get(), use.Reversed, MakeBody(use), use.Solid->Data, use.Location }, part,
      placement, color, node);
  }
  for (const ShellUse& use : shapes.Shells)
  {
    const ShellShape& shell = *use.Shell;
    const bool isSolid = shell.OpenSolid && IsMostlyClosed(shell);
    if (this->OnlySolids && !shell.OpenSolid)
    {
      this->Result.FreeFaces += static_cast<int>(shell.Faces.size());
      continue;
    }
    if (shell.OpenSolid)
    {
      const std::string message = "Solid #" + std::to_string(shell.Data.FileId) +
        (isSolid ? " is not closed." : " is open at most of its edges and is read as a surface.");
      std::vector<std::string>& said = this->Result.Messages;
      if (std::find(said.begin(), said.end(), message) == said.end())
      {
        said.push_back(message);
      }
    }
    for (const ShellPointer& connected : this->GetParts(use.Shell))
    {
      BodyShape body = MakeBody(ShellUse{ connected, use.Reversed, {} });
      body.IsSolid = isSolid;
      this->AddBody({ connected.get(), use.Reversed, std::move(body), shell.Data, use.Location }, part,
        placement, color, node);
    }
  }
  if (this->OnlySolids)
  {
    this->Result.FreeFaces += static_cast<int>(shapes.Faces.size());
  }
  else if (!shapes.Faces.empty())
  {
    BodyShape body;
    body.Faces = shapes.Faces;
    this->AddBody(
      { shapes.Faces[0].Face.get(), false, std::move(body), {}, {} }, part, placement, color, node);
  }
}

/// Returns the bodies of a shell that is not part of a solid. A repair divides a shell into connected parts;
/// a shell that was not repaired is divided here.
const std::vector<ShellPointer>& ShapeAdder::GetParts(const ShellPointer& shell)
{
  std::vector<ShellPointer>& parts = this->ShellParts[shell.get()];
  if (parts.empty())
  {
    parts = IsAsInFile(MakeBody(ShellUse{ shell, false, {} })) ? SplitShell(shell)
                                                               : std::vector<ShellPointer>{ shell };
  }
  return parts;
}

void ShapeAdder::AddBody(const Candidate& candidate, const PartBody& part, const Placement& placement,
  const Vector3& color, ProductNode& node)
{
  const Placement total = Compose(placement, candidate.Location);
  const double scale = total.GetScale();
  const bool isScaled = std::abs(scale - 1.0) > NoScale;
  const auto [known, isNew] =
    this->Known.try_emplace(std::make_tuple(candidate.Key, candidate.IsReversed, isScaled ? scale : 1.0),
      static_cast<int>(this->Result.Bodies.size()));
  BodyInstance instance;
  instance.Body = known->second;
  if (isNew)
  {
    PartBody body = part;
    body.Shape = candidate.Shape;
    body.Solid = candidate.Shape.IsSolid;
    if (isScaled)
    {
      body.Scale = MakeScale(scale);
      // The volume and area that the file states are those of the unscaled part.
      body.FileVolume *= scale * scale * scale;
      body.FileArea *= scale * scale;
    }
    body.FileId = candidate.Data.FileId;
    body.Name = candidate.Data.Name.empty() ? body.Name : candidate.Data.Name;
    body.Color = candidate.Data.Color[0] >= 0.0 ? candidate.Data.Color : body.Color;
    if (body.Name.empty())
    {
      body.Name = body.Solid ? "Solid" : "Shell";
    }
    this->Result.Bodies.push_back(std::move(body));
  }
  instance.Place = isScaled ? Compose(total, MakeScale(1.0 / scale)) : total;
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
