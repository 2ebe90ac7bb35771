#include "smOCCTTable.h"

#include "smOCCTDamage.h"

#include <Quantity_Color.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_Area.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_Material.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFDoc_Volume.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>
#include <unordered_set>

namespace sm
{
namespace
{
std::string ToUTF8(const TCollection_ExtendedString& text)
{
  std::string result(text.LengthOfCString() + 1, '\0');
  Standard_PCharacter bytes = &result[0];
  result.resize(text.ToUTF8CString(bytes));
  return result;
}

/// Returns the kind of shape that the entity describes; TopAbs_SHAPE for kinds that are not needed.
TopAbs_ShapeEnum GetKind(const Handle(Standard_Transient) & entity)
{
  if (entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface)))
  {
    return TopAbs_FACE;
  }
  if (entity->IsKind(STANDARD_TYPE(StepShape_EdgeCurve)))
  {
    return TopAbs_EDGE;
  }
  if (entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)))
  {
    return TopAbs_SOLID;
  }
  if (entity->IsKind(STANDARD_TYPE(StepShape_ShellBasedSurfaceModel)))
  {
    return TopAbs_SHELL;
  }
  return TopAbs_SHAPE;
}

void AddEntity(const Handle(Standard_Transient) & entity, const Handle(StepData_StepModel) & model,
  const TopoDS_Shape& shape, ShapeTable& table)
{
  const TopAbs_ShapeEnum kind = GetKind(entity);
  if (kind == TopAbs_SHAPE || shape.IsNull())
  {
    return;
  }
  // The number in the file, or the index in the model if OpenCASCADE does not keep it.
  int id = model->IdentLabel(entity);
  id = id > 0 ? id : model->Number(entity);
  std::string name;
  const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
  if (!item.IsNull() && !item->Name().IsNull())
  {
    name = item->Name()->ToCString();
    name = name == "NONE" ? "" : name;
  }
  const bool open = kind == TopAbs_SOLID && !TopExp_Explorer(shape, TopAbs_SOLID).More();
  for (TopExp_Explorer it(shape, open ? TopAbs_SHELL : kind); it.More(); it.Next())
  {
    table[it.Current().TShape().get()].OpenSolid |= open;
    ShapeInfo& info = table[it.Current().TShape().get()];
    if (info.FileId == 0)
    {
      info.FileId = id;
      info.Name = name;
      if (kind == TopAbs_FACE)
      {
        info.OwnSurface =
          FindFileSurface(Handle(StepShape_FaceSurface)::DownCast(entity), TopoDS::Face(it.Current()));
      }
    }
  }
}

bool IsBounded(const Handle(StepShape_Face) & face)
{
  for (int i = 1; !face.IsNull() && !face->Bounds().IsNull() && i <= face->NbBounds(); ++i)
  {
    const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
    if (!bound.IsNull() && bound->Bound()->IsKind(STANDARD_TYPE(StepShape_EdgeLoop)))
    {
      return true;
    }
  }
  return false;
}

/// Records faces that the kernel's transfer lost without an error.
void AddLosses(const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape, const LostFaces& lost,
  ShapeTable& table)
{
  if (shape.IsNull())
  {
    return;
  }
  if (shape.ShapeType() == TopAbs_FACE && IsBounded(Handle(StepShape_Face)::DownCast(entity)))
  {
    table[shape.TShape().get()].Bounded = true;
  }
  const auto set = Handle(StepShape_ConnectedFaceSet)::DownCast(entity);
  if (!HasFaceList(set) || shape.ShapeType() != TopAbs_SHELL)
  {
    return;
  }
  const auto dropped = lost.find(entity.get());
  int faces = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
  {
    ++faces;
  }
  table[shape.TShape().get()].LostFaces =
    std::max(0, set->NbCfsFaces() - faces) + (dropped == lost.end() ? 0 : dropped->second);
}

void AddLabel(
  const Handle(TDocStd_Document) & document, const TDF_Label& label, bool named, ShapeTable& table)
{
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
  if (shape.IsNull())
  {
    return;
  }
  const Vector3 color = GetLabelColor(document, label);
  const std::string name = named ? GetLabelName(label) : std::string();
  if (color[0] >= 0.0 || !name.empty())
  {
    ShapeInfo& info = table[shape.TShape().get()];
    info.Color = color[0] >= 0.0 ? color : info.Color;
    info.Name = info.Name.empty() ? name : info.Name;
  }
}
}

void FillTable(const Handle(XSControl_WorkSession) & session, const Handle(TDocStd_Document) & document,
  const LostFaces& lost, ShapeTable& table)
{
  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(session->Model());
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  for (int i = 1; !model.IsNull() && i <= process->NbMapped(); ++i)
  {
    const Handle(Transfer_Binder) binder = process->MapItem(i);
    if (!binder.IsNull())
    {
      const TopoDS_Shape shape = TransferBRep::ShapeResult(binder);
      AddEntity(process->Mapped(i), model, shape, table);
      AddLosses(process->Mapped(i), shape, lost, table);
    }
  }
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence labels;
  shapes->GetShapes(labels);
  for (const TDF_Label& label : labels)
  {
    if (!XCAFDoc_ShapeTool::IsAssembly(label) && !XCAFDoc_ShapeTool::IsReference(label))
    {
      AddLabel(document, label, false, table);
      TDF_LabelSequence parts;
      XCAFDoc_ShapeTool::GetSubShapes(label, parts);
      for (const TDF_Label& part : parts)
      {
        AddLabel(document, part, true, table);
      }
    }
  }
}

std::string GetShapeLabel(const Handle(XSControl_WorkSession) & session, const TopoDS_Shape& shape)
{
  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(session->Model());
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  for (int i = 1; !process.IsNull() && i <= process->NbMapped(); ++i)
  {
    const Handle(Transfer_Binder) binder = process->MapItem(i);
    if (!binder.IsNull() && TransferBRep::ShapeResult(binder).IsSame(shape))
    {
      return (shape.ShapeType() == TopAbs_FACE ? "face #" : "shell #") +
        std::to_string(model->IdentLabel(process->Mapped(i)));
    }
  }
  return "a shape";
}

bool MarkMisplaced(const Handle(XSControl_WorkSession) & session,
  const std::vector<Handle(Standard_Transient)>& operators, ShapeTable& table)
{
  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(session->Model());
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  std::unordered_set<const Standard_Transient*> open;
  for (const Handle(Standard_Transient) & item : operators)
  {
    open.insert(item.get());
  }
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(i));
    if (item.IsNull() || open.count(item->MappingTarget().get()) == 0)
    {
      continue;
    }
    const Handle(Transfer_Binder) binder = process->Find(item);
    const TopoDS_Shape shape = binder.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(binder);
    bool any = false;
    for (const TopAbs_ShapeEnum kind : { TopAbs_SOLID, TopAbs_SHELL })
    {
      for (TopExp_Explorer it(shape, kind); it.More(); it.Next())
      {
        table[it.Current().TShape().get()].Misplaced = any = true;
      }
    }
    if (any)
    {
      open.erase(item->MappingTarget().get());
    }
  }
  return open.empty();
}

std::string GetLabelName(const TDF_Label& label)
{
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name))
  {
    return {};
  }
  const std::string text = ToUTF8(name->Get());
  // OpenCASCADE names shapes without a name in the file after their type, or after the label to which they
  // refer.
  static const char* const made[] = { "COMPOUND", "COMPSOLID", "SOLID", "SHELL", "FACE", "NONE", "ASSEMBLY" };
  for (const char* word : made)
  {
    if (text == word)
    {
      return {};
    }
  }
  return text.compare(0, 2, "=>") == 0 ? std::string() : text;
}

std::string GetLabelLayer(const Handle(TDocStd_Document) & document, const TDF_Label& label)
{
  Handle(TColStd_HSequenceOfExtendedString) layers;
  if (!XCAFDoc_DocumentTool::LayerTool(document->Main())->GetLayers(label, layers) || layers.IsNull() ||
    layers->IsEmpty())
  {
    return {};
  }
  return ToUTF8(layers->First());
}

Vector3 GetLabelColor(const Handle(TDocStd_Document) & document, const TDF_Label& label)
{
  Vector3 rgb{ -1.0, -1.0, -1.0 };
  const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  Quantity_Color color;
  if (colors->GetColor(label, XCAFDoc_ColorSurf, color) || colors->GetColor(label, XCAFDoc_ColorGen, color))
  {
    color.Values(rgb[0], rgb[1], rgb[2], Quantity_TOC_sRGB);
  }
  return rgb;
}

std::string GetLabelMaterial(const TDF_Label& label)
{
  Handle(TDataStd_TreeNode) node;
  Handle(XCAFDoc_Material) material;
  if (!label.FindAttribute(XCAFDoc::MaterialRefGUID(), node) || !node->HasFather() ||
    !node->Father()->Label().FindAttribute(XCAFDoc_Material::GetID(), material) ||
    material->GetName().IsNull())
  {
    return {};
  }
  return material->GetName()->ToCString();
}

void GetLabelProperties(const TDF_Label& label, double& volume, double& area)
{
  double value = 0.0;
  if (XCAFDoc_Volume::Get(label, value))
  {
    volume = value;
  }
  if (XCAFDoc_Area::Get(label, value))
  {
    area = value;
  }
}
}
