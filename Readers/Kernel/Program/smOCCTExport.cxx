#include "smOCCTExport.h"

#include "smOCCTExportParts.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smSTEPEntities.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Interface_FloatWriter.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cctype>
#include <map>
#include <ostream>

namespace sm
{
namespace
{
/// Fractions of the progress.
constexpr double BuildingShare = 0.4;
constexpr double TransferShare = 0.8;

/// Sets OpenCASCADE's parameters for writing. The scale of lengths is not set here, but in the document and
/// the model.
void SetForWriting(const std::string& unit)
{
  std::string name;
  for (const char c : unit)
  {
    name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  SetKernelParameter("write.step.unit", name.c_str());
  SetKernelParameter("write.step.schema", "AP214IS");
  SetKernelParameter("write.surfacecurve.mode", "On");
  SetKernelParameter("write.step.assembly", "Auto");
  SetKernelParameter("write.step.product.name", "Part");
}

TCollection_ExtendedString ToExtended(const std::string& text)
{
  return { text.c_str(), true };
}

Handle(TCollection_HAsciiString) ToText(const std::string& text)
{
  return new TCollection_HAsciiString(text.c_str());
}

Quantity_Color ToColor(const Color& rgb)
{
  return { rgb[0], rgb[1], rgb[2], Quantity_TOC_sRGB };
}

/// Makes the XCAF document that OpenCASCADE writes.
class DocumentMaker
{
public:
  DocumentMaker(const ExportTree& tree, const std::vector<BuiltPart>& parts, double unit)
    : Tree(tree)
    , Parts(parts)
    , Unit(unit)
    , Xde(new TDocStd_Document("BinXCAF"))
    , Shapes(XCAFDoc_DocumentTool::ShapeTool(this->Xde->Main()))
    , Colors(XCAFDoc_DocumentTool::ColorTool(this->Xde->Main()))
    , Layers(XCAFDoc_DocumentTool::LayerTool(this->Xde->Main()))
  {
  }

  Handle(TDocStd_Document) Make(std::vector<std::string>& warnings)
  {
    const bool naming = XCAFDoc_ShapeTool::AutoNaming();
    XCAFDoc_ShapeTool::SetAutoNaming(false);
    this->Labels.resize(this->Parts.size());
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      this->AddPart(i, warnings);
    }
    for (const ExportNode& node : this->Tree.Root.Children)
    {
      this->AddAssembly(node);
    }
    this->Shapes->UpdateAssemblies();
    XCAFDoc_ShapeTool::SetAutoNaming(naming);
    return this->Xde;
  }

private:
  void AddPart(std::size_t index, std::vector<std::string>& warnings)
  {
    const ExportPart& from = this->Tree.Parts[index];
    const BuiltPart& part = this->Parts[index];
    if (part.Shape.IsNull())
    {
      return;
    }
    const TDF_Label label = this->Shapes->AddShape(part.Shape, false);
    this->Labels[index] = label;
    TDataStd_Name::Set(label, ToExtended(from.Name));
    if (!from.Layer.empty())
    {
      this->Layers->SetLayer(label, ToExtended(from.Layer));
    }
    for (std::size_t b = 0; b < part.Bodies.size(); ++b)
    {
      this->AddColors(label, part, from.Bodies[b], part.Bodies[b]);
    }
    vtkTrimmedNURBSModel* model = from.Bodies[0].Model;
    if (!model->GetMaterial().empty() || model->GetDensity() > 0.0)
    {
      const std::string wanted = model->GetMaterial().empty() ? "unnamed" : model->GetMaterial();
      const double density = model->GetDensity() > 0.0 ? model->GetDensity() : 0.0;
      const std::string name = this->NameMaterial(wanted, density);
      if (name != wanted && !model->GetMaterial().empty())
      {
        warnings.push_back("\"" + from.Name + "\": its material is saved as \"" + name +
          "\": another part has \"" + wanted + "\" with another density.");
      }
      // OpenCASCADE expects densities in g/cm^3.
      XCAFDoc_DocumentTool::MaterialTool(this->Xde->Main())
        ->SetMaterial(label, ToText(name), ToText(""), 0.001 * density, ToText("density measure"),
          ToText("POSITIVE_RATIO_MEASURE"));
    }
    for (const ExportBody& body : from.Bodies)
    {
      if (body.Model->GetMaterial() != model->GetMaterial() ||
        body.Model->GetDensity() != model->GetDensity())
      {
        warnings.push_back("\"" + from.Name +
          "\": its bodies are of different materials; that of the first is saved for all of them.");
        break;
      }
    }
  }

  /// Returns a name for a material that is unique for its density: OpenCASCADE writes one density for each
  /// name, the first one.
  std::string NameMaterial(const std::string& wanted, double density)
  {
    std::string name = wanted;
    for (int number = 2; this->Densities.emplace(name, density).first->second != density; ++number)
    {
      name = wanted + " (" + std::to_string(number) + ")";
    }
    return name;
  }

  void AddColors(const TDF_Label& label, const BuiltPart& part, const ExportBody& from, const BuiltBody& body)
  {
    if (body.Shape.IsNull())
    {
      return;
    }
    if (from.BodyColor[0] >= 0.0)
    {
      const TDF_Label own =
        body.Shape.IsSame(part.Shape) ? label : this->Shapes->AddSubShape(label, body.Shape);
      this->Colors->SetColor(own, ToColor(from.BodyColor), XCAFDoc_ColorSurf);
    }
    for (std::size_t i = 0; i < body.Faces.size(); ++i)
    {
      if (from.FaceColors[i][0] >= 0.0 && !body.Faces[i].IsNull())
      {
        const TDF_Label own = this->Shapes->AddSubShape(label, body.Faces[i]);
        if (!own.IsNull())
        {
          this->Colors->SetColor(own, ToColor(from.FaceColors[i]), XCAFDoc_ColorSurf);
        }
      }
    }
  }

  /// Returns true if a part below the node has a face that OpenCASCADE accepts.
  bool HasShape(const ExportNode& node) const
  {
    return node.Part >= 0 ? !this->Labels[node.Part].IsNull()
                          : std::any_of(node.Children.begin(), node.Children.end(),
                              [this](const ExportNode& child) { return this->HasShape(child); });
  }

  /// Adds an assembly; returns a null label if none of its parts has a face.
  TDF_Label AddAssembly(const ExportNode& node)
  {
    if (node.Part >= 0)
    {
      return this->Labels[node.Part];
    }
    if (!this->HasShape(node))
    {
      return {};
    }
    const TDF_Label label = this->Shapes->NewShape();
    TDataStd_Name::Set(label, ToExtended(node.Name));
    if (!node.Layer.empty())
    {
      this->Layers->SetLayer(label, ToExtended(node.Layer));
    }
    for (const ExportNode& child : node.Children)
    {
      const TDF_Label product = this->AddAssembly(child);
      if (product.IsNull())
      {
        continue;
      }
      const TDF_Label component =
        this->Shapes->AddComponent(label, product, MakeLocation(child.Place, this->Unit));
      TDataStd_Name::Set(component, ToExtended(child.Name));
      if (child.Part >= 0 && child.InstanceColor[0] >= 0.0)
      {
        this->Colors->SetColor(component, ToColor(child.InstanceColor), XCAFDoc_ColorSurf);
      }
    }
    return label;
  }

  const ExportTree& Tree;
  const std::vector<BuiltPart>& Parts;
  double Unit;
  Handle(TDocStd_Document) Xde;
  Handle(XCAFDoc_ShapeTool) Shapes;
  Handle(XCAFDoc_ColorTool) Colors;
  Handle(XCAFDoc_LayerTool) Layers;
  std::vector<TDF_Label> Labels;
  /// Densities by the names of the materials.
  std::map<std::string, double> Densities;
};

void Write(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress, ExportResult& result)
{
  SetForWriting(options.UnitName);
  const auto ask = [&](double x)
  {
    result.Aborted = result.Aborted || !progress(x);
    return !result.Aborted;
  };
  const std::vector<BuiltPart> parts =
    BuildParts(tree, options.Unit, result.Warnings, [&](double x) { return ask(BuildingShare * x); });
  if (!ask(BuildingShare))
  {
    return;
  }
  for (const BuiltPart& part : parts)
  {
    for (const BuiltBody& body : part.Bodies)
    {
      for (const TopoDS_Face& face : body.Faces)
      {
        result.Faces += face.IsNull() ? 0 : 1;
      }
    }
  }
  if (result.Faces == 0)
  {
    result.Problem = "OpenCASCADE takes none of its faces";
    return;
  }
  const Handle(TDocStd_Document) document = DocumentMaker(tree, parts, options.Unit).Make(result.Warnings);
  STEPCAFControl_Writer writer;
  // The shapes are in the unit of the file already, so document and file must have the same unit, and nothing
  // is scaled. Otherwise OpenCASCADE takes one unit from the settings of the process and, since 7.8, mm for
  // the other one.
  SetMillimetres(document);
  writer.ChangeWriter().Model()->SetWriteLengthUnit(1.0);
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  writer.SetLayerMode(true);
  writer.SetMaterialMode(true);
  writer.SetPropsMode(false);
  writer.SetDimTolMode(false);
  if (!writer.Transfer(document, STEPControl_AsIs))
  {
    result.Problem = "OpenCASCADE makes no STEP entities of it";
    return;
  }
  if (!ask(TransferShare))
  {
    return;
  }
  const Handle(XSControl_WorkSession) session = writer.Writer().WS();
  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(session->Model());
  CompleteEntities(session->TransferWriter()->FinderProcess(), model, tree, parts);
  FillHeader(model, options);
  StepData_StepWriter text(model);
  text.LabelMode() = 1;
  text.FloatWriter().SetFormat("%.16E");
  text.SendModel(Handle(StepData_Protocol)::DownCast(session->Protocol()));
  text.Print(stream);
  ask(1.0);
}

/// Adds the parts below `node` to `compound`.
void AddInstances(const ExportNode& node, const std::vector<BuiltPart>& parts, double unit,
  const BRep_Builder& builder, TopoDS_Compound& compound)
{
  if (node.Part >= 0 && !parts[node.Part].Shape.IsNull())
  {
    builder.Add(compound, parts[node.Part].Shape.Moved(MakeLocation(node.Place, unit)));
  }
  for (const ExportNode& child : node.Children)
  {
    AddInstances(child, parts, unit, builder, compound);
  }
}

/// Runs work(result); the reason for an exception becomes the result's problem.
template <class Work>
ExportResult Guard(const Work& work)
{
  ExportResult result;
  const std::string problem = CatchKernelFailure([&]() { work(result); });
  if (!problem.empty())
  {
    result.Problem = "it failed (" + problem + ")";
  }
  return result;
}
}

ExportResult WriteSTEP(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress)
{
  return Guard([&](ExportResult& result) { Write(tree, options, stream, progress, result); });
}

ExportResult WriteBREP(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress)
{
  return Guard(
    [&](ExportResult& result)
    {
      const std::vector<BuiltPart> parts = BuildParts(tree, options.Unit, result.Warnings,
        [&](double x)
        {
          result.Aborted = result.Aborted || !progress(BuildingShare * x);
          return !result.Aborted;
        });
      if (result.Aborted)
      {
        return;
      }
      const BRep_Builder builder;
      TopoDS_Compound compound;
      builder.MakeCompound(compound);
      AddInstances(tree.Root, parts, options.Unit, builder, compound);
      for (TopExp_Explorer faces(compound, TopAbs_FACE); faces.More(); faces.Next())
      {
        ++result.Faces;
      }
      if (result.Faces == 0)
      {
        result.Problem = "OpenCASCADE takes none of its faces";
        return;
      }
      BRepTools::Write(compound, stream);
      progress(1.0);
    });
}
}
