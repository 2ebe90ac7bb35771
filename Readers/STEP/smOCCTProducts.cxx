#include "smOCCTProducts.h"

#include "smOCCTShapeAdder.h"
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
    , Shapes(document)
  {
  }

  void Build()
  {
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(this->Xde->Main());
    TDF_LabelSequence roots;
    shapes->GetFreeShapes(roots);
    for (const TDF_Label& label : roots)
    {
      this->Shapes.Announce(XCAFDoc_ShapeTool::GetShape(label));
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
      const bool single = this->Shapes.CountSolids(XCAFDoc_ShapeTool::GetShape(product)) == 1;
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
    this->Shapes.Add(shape, this->DescribePart(product, inherited), placement, inherited.Color, node);
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
    if (this->Shapes.CountSolids(XCAFDoc_ShapeTool::GetShape(product)) > 1)
    {
      part.FileVolume = part.FileArea = Nothing;
    }
    return part;
  }

  Document& Result;
  const Handle(TDocStd_Document) & Xde;
  ShapeAdder Shapes;
};
}

void AddProducts(const Handle(TDocStd_Document) & xde, Document& document)
{
  TreeBuilder(document, xde).Build();
}
}
