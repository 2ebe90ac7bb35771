#include "smOCCTDocument.h"

#include "smLengthUnits.h"
#include "smOCCTCompatibility.h"
#include "smOCCTDamage.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTModel.h"
#include "smOCCTRepair.h"
#include "smOCCTShells.h"
#include "smOCCTTable.h"
#include "smPart21File.h"
#include "smSTEPReconciliation.h"
#include "smSTEPTessellations.h"

#include <BRep_Builder.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <tuple>
#include <unordered_map>

namespace sm
{
namespace
{
/// Share of the progress that parsing takes; the rest is the transfer.
constexpr double ParsingShare = 0.3;

/// Instances of bodies and sub-assemblies that are read; each becomes a node of the tree, a body's a leaf with points of its own.
constexpr CensusCount MostInstances = 100000;

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

  /// A shell that the file calls a solid is read as a solid with holes when at least half of its edges are closed.
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

  /// `label` is a product or one occurrence of it; `parent` is where the occurrence's assembly stands.
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
      // Some systems attach the validation properties and the material of their only solid to the product above it.
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

  /// The bodies of a shell beside solids: OpenCASCADE's repairs part what is not connected, and what it has not repaired is parted here.
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
    // A validation property of a part with several bodies is their sum and belongs to none of them.
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
        // The volume and area that the file states hold for the unscaled part.
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
  /// The file has solids: faces outside them are counted and kept apart.
  bool OnlySolids = false;
  std::map<std::tuple<const void*, TopAbs_Orientation, double>, int> Known;
  std::map<const void*, TopoDS_Compound> LooseFaces;
  std::map<const void*, std::vector<TopoDS_Shape>> ShellParts;
};

void Configure(STEPCAFControl_Reader& reader)
{
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetMatMode(true);
  reader.SetPropsMode(true);
  reader.SetGDTMode(false);
  reader.SetViewMode(false);
  reader.SetSHUOMode(false);
}

/// Reads the entities of the file, whose text is also in `text`. False, with document.Problem, when OpenCASCADE cannot.
bool Parse(const std::string& fileName, const FileCheck& check, const Part21File& text,
  STEPCAFControl_Reader& reader, Document& document)
{
  // Where OpenCASCADE knows these entities, the session tells it to skip them.
  const std::string reduced = KernelReadsTessellations ? std::string() : RemoveTessellations(text);
  // The file is opened here: OpenCASCADE takes its name for UTF-8, and a name may be any bytes.
  std::istringstream reducedStream(reduced);
  std::ifstream fileStream(fileName, std::ios::binary);
  fileStream.seekg(static_cast<std::streamoff>(check.JunkBytes));
  std::istream& stream = reduced.empty() ? static_cast<std::istream&>(fileStream) : reducedStream;
  const IFSelect_ReturnStatus status = reader.ChangeReader().ReadStream(fileName.c_str(), stream);
  if (status != IFSelect_RetDone)
  {
    document.Problem = std::string("OpenCASCADE cannot parse it") +
      (check.Truncated ? "; it ends in the middle: copy or export it again" : "; export it again");
    return false;
  }
  return true;
}

/// Turns off the attributes whose entities are damaged: OpenCASCADE would crash on them.
void SkipDamagedAttributes(
  const Handle(StepData_StepModel) & model, STEPCAFControl_Reader& reader, Document& document)
{
  const Attributes damaged = FindDamagedAttributes(model);
  if (damaged.Colors)
  {
    reader.SetColorMode(false);
    document.Messages.push_back("Entities of its colours are damaged: colours were not read.");
  }
  if (damaged.Properties)
  {
    reader.SetPropsMode(false);
    reader.SetMatMode(false);
    document.Messages.push_back(
      "Entities of its properties are damaged: volumes and materials it states were not read.");
  }
}

/// Sets the status after the transfer, by the bodies that it made.
void Conclude(const Handle(StepData_StepModel) & model, Document& document)
{
  if (!document.Bodies.empty())
  {
    document.Status = ReadStatus::Ok;
  }
  else if (HasGeometry(model))
  {
    document.Problem =
      "it has faces, but OpenCASCADE makes no shape of them: its product structure or its geometry "
      "is malformed; export it again";
  }
  else
  {
    document.Status = ReadStatus::Empty;
    document.Problem =
      "it has no solid, shell or face; export the part as a boundary representation (AP203, AP214 "
      "or AP242)";
  }
}

/// The text of the file, and what it declares.
struct DeclaredContent
{
  Part21File Text;
  STEPCensus Census;
  std::unordered_map<std::uint64_t, std::string> Perils;

  DeclaredContent(const std::string& fileName, Document& document)
  {
    if (!this->Text.Read(fileName))
    {
      document.Defects.push_back("What the file declares could not be checked: its text could not be read.");
    }
    this->Census = TakeSTEPCensus(this->Text);
    for (const CensusProblem& peril : this->Census.Perils)
    {
      this->Perils.emplace(
        peril.Id, std::string(GetName(peril.Defect)) + (*peril.Place ? ", " : "") + peril.Place);
    }
  }

  /// An oriented edge that is part of itself: OpenCASCADE ends on it already when it has parsed the file. Empty when there is none.
  std::string FindCycle() const
  {
    for (const CensusProblem& peril : this->Census.Perils)
    {
      const std::uint32_t type = this->Text.GetType(this->Text.Find(peril.Id));
      if (peril.Defect == CensusDefect::CyclicReference && this->Text.GetTypeNames()[type] == "ORIENTED_EDGE")
      {
        return "its entity #" + std::to_string(peril.Id) + " is part of itself (cyclic reference to #" +
          std::to_string(peril.Other) + "); export it again";
      }
    }
    return {};
  }

  /// Why OpenCASCADE cannot follow the entity; empty when it can.
  std::string GetPeril(int id) const
  {
    const auto found = id > 0 ? this->Perils.find(static_cast<std::uint64_t>(id)) : this->Perils.end();
    return found != this->Perils.end() ? found->second : std::string();
  }

  /// True if a body depends on the entity, its place in the product or its unit.
  bool Matters(int id) const
  {
    const Part21File::Index index =
      id > 0 ? this->Text.Find(static_cast<std::uint64_t>(id)) : Part21File::None;
    return index == Part21File::None || this->Census.Uses[index] != 0;
  }
};

/// Transfers all shapes of the file; false when `progress` said to stop.
bool Transfer(STEPCAFControl_Reader& reader, Handle(TDocStd_Document) & xde, RepairMode repair,
  const ProgressCallback& progress, Document& document)
{
  const Handle(KernelProgress) indicator =
    new KernelProgress([&progress](double x) { return progress(ParsingShare + (1.0 - ParsingShare) * x); });
  RepairLog log;
  {
    const auto label = [&reader](const TopoDS_Shape& shape)
    { return GetShapeLabel(reader.Reader().WS(), shape); };
    const std::unique_ptr<RepairOnNeed> selective =
      repair == RepairMode::OnNeed ? std::make_unique<RepairOnNeed>(log, label) : nullptr;
    reader.Transfer(xde, indicator->Start());
  }
  indicator->Rethrow();
  for (const auto& [shape, face] : log.SoundFaces)
  {
    document.Table[shape].AsInFile = face;
  }
  if (log.RepairedBodies > 0)
  {
    document.Messages.push_back(Describe(log));
  }
  return progress(1.0);
}

void Read(const std::string& fileName, const FileCheck& check, RepairMode repair,
  const ProgressCallback& progress, Document& document)
{
  const DeclaredContent declared(fileName, document);
  const CensusCount instances = CountDeclaredInstances(declared.Census);
  if (instances > MostInstances)
  {
    document.Problem = "it declares " +
      (instances == CensusMaximum ? "more than 10^19" : std::to_string(instances)) +
      " instances of bodies and sub-assemblies, and at most " + std::to_string(MostInstances) +
      " are read; export its sub-assemblies one by one";
    return;
  }
  document.Problem = declared.FindCycle();
  if (!document.Problem.empty())
  {
    return;
  }
  const KernelSession kernel;
  STEPCAFControl_Reader reader;
  Configure(reader);
  if (!Parse(fileName, check, declared.Text, reader, document))
  {
    return;
  }
  if (!progress(ParsingShare))
  {
    document.Status = ReadStatus::Aborted;
    return;
  }
  const Handle(StepData_StepModel) model =
    Handle(StepData_StepModel)::DownCast(reader.Reader().WS()->Model());
  document.FileUnit = ReadLengthUnit(reader.ChangeReader(), model, document.Messages);
  const double factor = GetUnitInMillimetres(document.FileUnit);
  document.FileUnitInMillimetres = factor > 0.0 ? factor : 1.0;
  const std::vector<Handle(Standard_Transient)> operators = CheckOperators(model, document.Messages);
  LostFaces lost;
  document.Problem = DropDamagedFaces(
    reader.Reader().WS(), model, [&declared](int id) { return declared.Matters(id); },
    [&declared](int id) { return declared.GetPeril(id); }, document.Messages, lost);
  if (!document.Problem.empty())
  {
    return;
  }
  SkipDamagedAttributes(model, reader, document);
  Handle(TDocStd_Document) xde = new TDocStd_Document("BinXCAF");
  SetMillimetres(xde);
  if (!Transfer(reader, xde, repair, progress, document))
  {
    document.Status = ReadStatus::Aborted;
    return;
  }
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  FillTable(session, xde, lost, document.Table);
  const bool found = operators.empty() || MarkMisplaced(session, operators, document.Table);
  TreeBuilder(document, xde).Build();
  for (PartBody& body : document.Bodies)
  {
    body.Misplaced = body.Misplaced || !found;
  }
  Reconcile(declared.Census, document);
  Conclude(model, document);
}
}

Document ReadDocument(const std::string& fileName, RepairMode repair, const ProgressCallback& progress)
{
  Document document;
  const FileCheck check = CheckFile(fileName);
  if (!check.Readable)
  {
    document.Problem = check.Problem;
    return document;
  }
  if (check.JunkBytes > 0)
  {
    document.Messages.push_back(std::to_string(check.JunkBytes) +
      " bytes before \"ISO-10303-21;\" do not belong to a STEP file and were skipped.");
  }
  if (check.Truncated)
  {
    document.Messages.push_back("The file does not end with END-ISO-10303-21: part of it may be missing.");
  }
  const std::string failure = CatchFailure([&]() { Read(fileName, check, repair, progress, document); });
  if (!failure.empty())
  {
    document.Status = ReadStatus::Unreadable;
    document.Problem = "it could not be read (" + failure + "); export it again";
  }
  if (document.FreeFaces > 0)
  {
    document.Messages.push_back(std::to_string(document.FreeFaces) +
      " faces lie in the file beside its solids; they belong to no body and are left out.");
  }
  return document;
}
}
