#include "smOCCTProducts.h"

#include "smOCCTShells.h"
#include "smOCCTTable.h"

#include <BRep_Builder.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace sm
{
namespace
{
class TreeBuilder
{
public:
  explicit TreeBuilder(Document& document, const Handle(TDocStd_Document) & xde)
    : Result(document)
    , Xde(xde)
  {
  }

  void Build()
  {
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(this->Xde->Main());
    TDF_LabelSequence roots;
    shapes->GetFreeShapes(roots);
    for (const TDF_Label& label : roots)
    {
      this->OnlySolids = this->OnlySolids || this->CountSolids(XCAFDoc_ShapeTool::GetShape(label)) > 0;
    }
    for (const TDF_Label& label : roots)
    {
      this->Result.Root.Children.push_back(this->Visit(label, gp_Trsf(), Inherited()));
    }
  }

private:
  static constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();

  /// Attributes that an occurrence inherits from the assemblies above it.
  struct Inherited
  {
    Vector3 Color{ -1.0, -1.0, -1.0 };
    double Volume = Nothing;
    double Area = Nothing;
    std::string Material;
  };

  static int CountFaces(const TopoDS_Shape& shape, TopAbs_ShapeEnum avoided)
  {
    int faces = 0;
    for (TopExp_Explorer it(shape, TopAbs_FACE, avoided); it.More(); it.Next())
    {
      ++faces;
    }
    return faces;
  }

  bool IsOpenSolid(const TopoDS_Shape& shell) const
  {
    const auto info = this->Result.Table.find(shell.TShape().get());
    return info != this->Result.Table.end() && info->second.OpenSolid;
  }

  /// Returns true if at least half of the edges of a shell are used twice. A shell that the file declares as
  /// a solid is then read as a solid with openings.
  static bool IsMostlyClosed(const TopoDS_Shape& shell)
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

  int CountSolids(const TopoDS_Shape& shape) const
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

  /// Makes the node of a product or of one occurrence of it (`label`); `parent` is the placement of the
  /// assembly.
  ProductNode Visit(const TDF_Label& label, const gp_Trsf& parent, Inherited inherited)
  {
    TDF_Label product = label;
    gp_Trsf placement = parent;
    ProductNode node;
    if (XCAFDoc_ShapeTool::GetReferredShape(label, product))
    {
      placement = parent * XCAFDoc_ShapeTool::GetLocation(label).Transformation();
      const Vector3 own = GetLabelColor(this->Xde, label);
      inherited.Color = own[0] >= 0.0 ? own : inherited.Color;
    }
    node.Name = GetLabelName(product);
    node.Name = node.Name.empty() ? GetLabelName(label) : node.Name;
    node.Layer = GetLabelLayer(this->Xde, product);
    if (XCAFDoc_ShapeTool::IsAssembly(product))
    {
      // Some CAD systems attach the validation properties and the material of a part with one solid to its
      // product.
      const bool single = CountSolids(XCAFDoc_ShapeTool::GetShape(product)) == 1;
      inherited.Volume = single ? inherited.Volume : Nothing;
      inherited.Area = single ? inherited.Area : Nothing;
      if (single)
      {
        GetLabelProperties(product, inherited.Volume, inherited.Area);
      }
      const std::string material = GetLabelMaterial(product);
      inherited.Material = material.empty() ? inherited.Material : material;
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(product, components);
      for (const TDF_Label& component : components)
      {
        node.Children.push_back(this->Visit(component, placement, inherited));
      }
      return node;
    }
    this->AddPart(product, placement, inherited, node);
    return node;
  }

  void AddPart(
    const TDF_Label& product, const gp_Trsf& placement, const Inherited& inherited, ProductNode& node)
  {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    if (shape.IsNull())
    {
      return;
    }
    const PartBody part = this->DescribePart(product, inherited);
    const Vector3& color = inherited.Color;
    int bodies = 0;
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
    {
      this->AddBody(it.Current(), true, part, placement, color, node, bodies++);
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
          this->AddBody(connected, solid, part, placement, color, node, bodies++);
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
      this->AddBody(group, false, part, placement, color, node, bodies++);
    }
  }

  /// Returns the bodies of a shell that is not part of a solid. OpenCASCADE's repair divides a shell into
  /// connected parts; a shell that was not repaired is divided here.
  std::vector<TopoDS_Shape> GetParts(const TopoDS_Shape& shell)
  {
    if (!IsAsInFile(shell, this->Result.Table))
    {
      return { shell };
    }
    std::vector<TopoDS_Shape>& parts = this->ShellParts[shell.TShape().get()];
    if (parts.empty())
    {
      parts = SplitShell(shell);
      ShapeInfo info = this->Result.Table[shell.TShape().get()];
      for (const TopoDS_Shape& part : parts)
      {
        this->Result.Table.emplace(part.TShape().get(), info);
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

  PartBody DescribePart(const TDF_Label& product, const Inherited& inherited) const
  {
    PartBody part;
    part.Name = GetLabelName(product);
    part.Color = GetLabelColor(this->Xde, product);
    part.FileVolume = inherited.Volume;
    part.FileArea = inherited.Area;
    part.Material = GetLabelMaterial(product);
    part.Material = part.Material.empty() ? inherited.Material : part.Material;
    GetLabelProperties(product, part.FileVolume, part.FileArea);
    // A validation property of a part with several bodies is their sum, not that of one body.
    if (CountSolids(XCAFDoc_ShapeTool::GetShape(product)) > 1)
    {
      part.FileVolume = part.FileArea = Nothing;
    }
    return part;
  }

  void AddBody(const TopoDS_Shape& shape, bool solid, const PartBody& part, const gp_Trsf& placement,
    const Vector3& color, ProductNode& node, int ordinal)
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
        body.Misplaced = info->second.Misplaced;
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
    if (ordinal > 0)
    {
      instance.Name += " (" + std::to_string(ordinal + 1) + ")";
    }
    instance.Color = color;
    node.Instances.push_back(static_cast<int>(this->Result.Instances.size()));
    this->Result.Instances.push_back(instance);
  }

  Document& Result;
  const Handle(TDocStd_Document) & Xde;
  /// True if the file has solids; faces outside of them are then counted but not read.
  bool OnlySolids = false;
  std::map<std::tuple<const void*, TopAbs_Orientation, double>, int> Known;
  std::map<const void*, TopoDS_Compound> LooseFaces;
  std::map<const void*, std::vector<TopoDS_Shape>> ShellParts;
};
}

void AddProducts(const Handle(TDocStd_Document) & xde, Document& document)
{
  TreeBuilder(document, xde).Build();
}
}
