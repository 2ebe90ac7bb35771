#include "smSTEPEntities.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Precision.hxx>
#include <STEPConstruct.hxx>
#include <Standard_Version.hxx>
#include <StepBasic_DerivedUnitElement.hxx>
#include <StepBasic_NamedUnit.hxx>
#include <StepBasic_SiUnitAndMassUnit.hxx>
#include <StepBasic_UncertaintyMeasureWithUnit.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_Shell.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
namespace
{
/// A stated accuracy is at most this fraction of the length of the shortest edge.
constexpr double ShareOfShortest = 0.1;

Handle(TCollection_HAsciiString) ToText(const std::string& text)
{
  return new TCollection_HAsciiString(text.c_str());
}

/// Gives entities the names and numbers of the file that the models were read from.
class EntityLabels
{
public:
  EntityLabels(const Handle(Transfer_FinderProcess) & process, const Handle(StepData_StepModel) & model)
    : Process(process)
    , Model(model)
  {
  }

  void Apply(const ExportTree& tree, const std::vector<BuiltPart>& parts)
  {
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (std::size_t b = 0; b < parts[i].Bodies.size(); ++b)
      {
        const BuiltBody& body = parts[i].Bodies[b];
        vtkTrimmedNURBSModel* model = tree.Parts[i].Bodies[b].Model;
        if (body.Shape.IsNull())
        {
          continue;
        }
        this->Set(body.Shape, model->GetFileId(), model->GetName());
        for (std::size_t f = 0; f < body.Faces.size(); ++f)
        {
          const Face& face = *model->GetFaces()[f];
          if (!body.Faces[f].IsNull())
          {
            this->Set(body.Faces[f], face.FileId, face.Name);
          }
        }
        for (const auto& [edge, source] : body.Edges)
        {
          this->Set(edge, source->FileId, source->Name);
        }
      }
    }
    int next = 1;
    for (int i = 1; i <= this->Model->NbEntities(); ++i)
    {
      const Handle(Standard_Transient) entity = this->Model->Value(i);
      if (this->Numbered.count(entity.get()) == 0)
      {
        while (this->Taken.count(next) > 0)
        {
          ++next;
        }
        this->Model->SetIdentLabel(entity, next++);
      }
    }
  }

private:
  void Set(const TopoDS_Shape& shape, std::int64_t id, const std::string& name)
  {
    const Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(this->Process, shape);
    if (item.IsNull() || this->Model->Number(item) == 0)
    {
      return;
    }
    item->SetName(ToText(name));
    // A longer number does not fit into a label: the entity gets another one.
    if (id > 0 && id <= std::numeric_limits<Standard_Integer>::max() &&
      this->Numbered.count(item.get()) == 0 && this->Taken.insert(static_cast<Standard_Integer>(id)).second)
    {
      this->Numbered.insert(item.get());
      this->Model->SetIdentLabel(item, static_cast<Standard_Integer>(id));
    }
  }

  Handle(Transfer_FinderProcess) Process;
  Handle(StepData_StepModel) Model;
  std::set<Standard_Integer> Taken;
  std::unordered_set<const Standard_Transient*> Numbered;
};

/// Finds the accuracy of each body's entity through the context of the representation that has the body as an
/// item.
class Accuracies
{
public:
  Accuracies(const Handle(Transfer_FinderProcess) & process, const Handle(StepData_StepModel) & model)
    : Process(process)
  {
    for (int i = 1; i <= model->NbEntities(); ++i)
    {
      const auto shape = Handle(StepShape_ShapeRepresentation)::DownCast(model->Value(i));
      for (int k = 1; !shape.IsNull() && !shape->Items().IsNull() && k <= shape->NbItems(); ++k)
      {
        const Handle(StepRepr_RepresentationItem) item = shape->ItemsValue(k);
        this->Contexts[item.get()] = shape->ContextOfItems();
        const auto surfaces = Handle(StepShape_ShellBasedSurfaceModel)::DownCast(item);
        for (int j = 1; !surfaces.IsNull() && j <= surfaces->NbSbsmBoundary(); ++j)
        {
          this->Contexts[surfaces->SbsmBoundaryValue(j).Value().get()] = shape->ContextOfItems();
        }
      }
    }
  }

  void State(const BuiltPart& part)
  {
    double tolerance = 0.0;
    double shortest = 0.0;
    for (const BuiltBody& body : part.Bodies)
    {
      tolerance = std::max(tolerance, body.Tolerance);
      shortest = shortest == 0.0 || body.ShortestEdge == 0.0 ? std::max(shortest, body.ShortestEdge)
                                                             : std::min(shortest, body.ShortestEdge);
    }
    tolerance = std::max(std::min(tolerance, ShareOfShortest * shortest), Precision::Confusion());
    for (const BuiltBody& body : part.Bodies)
    {
      for (const TopAbs_ShapeEnum kind : { TopAbs_SOLID, TopAbs_SHELL })
      {
        for (TopExp_Explorer it(body.Shape, kind); !body.Shape.IsNull() && it.More(); it.Next())
        {
          this->State(it.Current(), tolerance);
        }
      }
    }
  }

private:
  void State(const TopoDS_Shape& shape, double tolerance)
  {
    const auto found = this->Contexts.find(STEPConstruct::FindEntity(this->Process, shape).get());
    const auto context = found == this->Contexts.end()
      ? nullptr
      : Handle(StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx)::DownCast(found->second);
    if (!context.IsNull() && !context->Uncertainty().IsNull() && context->NbUncertainty() > 0)
    {
      context->UncertaintyValue(1)->SetValueComponent(tolerance);
    }
  }

  Handle(Transfer_FinderProcess) Process;
  std::unordered_map<const Standard_Transient*, Handle(StepRepr_RepresentationContext)> Contexts;
};

/// Corrects the units of densities: OpenCASCADE writes g/cm^3 with wrong powers.
void CorrectDensityUnits(const Handle(StepData_StepModel) & model)
{
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const auto element = Handle(StepBasic_DerivedUnitElement)::DownCast(model->Value(i));
    if (!element.IsNull())
    {
      element->SetExponent(element->Unit()->IsKind(STANDARD_TYPE(StepBasic_SiUnitAndMassUnit)) ? 1.0 : -3.0);
    }
  }
}
}

void CompleteEntities(const Handle(Transfer_FinderProcess) & process,
  const Handle(StepData_StepModel) & model, const ExportTree& tree, const std::vector<BuiltPart>& parts)
{
  CorrectDensityUnits(model);
  EntityLabels(process, model).Apply(tree, parts);
  Accuracies accuracies(process, model);
  for (const BuiltPart& part : parts)
  {
    accuracies.State(part);
  }
}

void FillHeader(const Handle(StepData_StepModel) & model, const ExportOptions& options)
{
  APIHeaderSection_MakeHeader header(model);
  header.SetName(ToText(options.FileName));
  header.SetAuthorValue(1, ToText(""));
  header.SetOrganizationValue(1, ToText(""));
  header.SetOriginatingSystem(ToText(options.System));
  header.SetPreprocessorVersion(ToText(options.System + ", Open CASCADE " OCC_VERSION_COMPLETE));
  header.SetAuthorisation(ToText(""));
  header.SetDescriptionValue(1, ToText("Trimmed NURBS solids"));
  header.Apply(model);
}
}
