#include "smOCCTExportParts.h"

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Mat.hxx>
#include <gp_Quaternion.hxx>
#include <gp_Trsf.hxx>

namespace sm
{
namespace
{
/// kernel = unit * own * (stored + origin)
AffineMap MakeMap(const ExportBody& body, double unit)
{
  AffineMap map;
  const double* origin = body.Model->GetOrigin();
  for (int i = 0; i < 3; ++i)
  {
    map.Translation[i] = body.Own[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      map.Linear[i][j] = unit * body.Own[4 * i + j];
      map.Translation[i] += body.Own[4 * i + j] * origin[j];
    }
    map.Translation[i] *= unit;
  }
  return map;
}
}

std::vector<BuiltPart> BuildParts(
  const ExportTree& tree, double unit, std::vector<std::string>& warnings, const ProgressCallback& progress)
{
  std::vector<BuiltPart> parts;
  for (const ExportPart& from : tree.Parts)
  {
    if (!progress(static_cast<double>(parts.size()) / tree.Parts.size()))
    {
      break;
    }
    BuiltPart part;
    int shapes = 0;
    for (const ExportBody& body : from.Bodies)
    {
      part.Bodies.push_back(BuildBody(body.Model, MakeMap(body, unit)));
      for (const std::string& warning : part.Bodies.back().Warnings)
      {
        warnings.push_back("\"" + from.Name + "\": " + warning);
      }
      if (!part.Bodies.back().Shape.IsNull())
      {
        part.Shape = part.Bodies.back().Shape;
        ++shapes;
      }
    }
    if (shapes > 1)
    {
      const BRep_Builder builder;
      TopoDS_Compound compound;
      builder.MakeCompound(compound);
      for (const BuiltBody& body : part.Bodies)
      {
        if (!body.Shape.IsNull())
        {
          builder.Add(compound, body.Shape);
        }
      }
      part.Shape = compound;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

TopLoc_Location MakeLocation(const MatrixRows& placement, double unit)
{
  if (placement == IdentityPlacement)
  {
    return {};
  }
  gp_Mat rotation;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      rotation(i + 1, j + 1) = placement[4 * i + j];
    }
  }
  // The rotation is set by a quaternion, so that its scale is exactly 1, which OpenCASCADE requires of
  // locations.
  gp_Trsf trsf;
  trsf.SetRotation(gp_Quaternion(rotation));
  trsf.SetTranslationPart(gp_Vec(unit * placement[3], unit * placement[7], unit * placement[11]));
  return trsf;
}
}
