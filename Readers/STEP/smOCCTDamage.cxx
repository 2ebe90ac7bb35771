#include "smOCCTDamage.h"
#include "smFormat.h"

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_HGraph.hxx>
#include <StepBasic_DerivedUnit.hxx>
#include <StepBasic_DerivedUnitElement.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepGeom_GeometricRepresentationItem.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_MeasureRepresentationItem.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_PropertyDefinitionRepresentation.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedOpenShell.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <StepVisual_FillAreaStyle.hxx>
#include <StepVisual_FillAreaStyleColour.hxx>
#include <StepVisual_StyledItem.hxx>
#include <StepVisual_SurfaceSideStyle.hxx>
#include <StepVisual_SurfaceStyleFillArea.hxx>
#include <StepVisual_SurfaceStyleUsage.hxx>
#include <TCollection_HAsciiString.hxx>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <map>
#include <unordered_set>
#include <utility>

namespace sm
{
namespace
{
using Entity = const Standard_Transient*;

bool IsOneOf(const Standard_Type& type, std::initializer_list<Handle(Standard_Type)> bases)
{
  return std::any_of(
    bases.begin(), bases.end(), [&type](const Handle(Standard_Type) & base) { return type.SubType(base); });
}

/// Returns true for entities that place a part in its assembly; without one of them the assembly is wrong.
bool IsPlacing(const Standard_Type& type)
{
  return IsOneOf(type,
    { STANDARD_TYPE(StepRepr_ItemDefinedTransformation),
      STANDARD_TYPE(StepRepr_ShapeRepresentationRelationship),
      STANDARD_TYPE(StepShape_ContextDependentShapeRepresentation),
      STANDARD_TYPE(StepShape_ShapeDefinitionRepresentation), STANDARD_TYPE(StepRepr_ProductDefinitionShape),
      STANDARD_TYPE(StepRepr_MappedItem), STANDARD_TYPE(StepRepr_RepresentationMap) });
}

/// Returns true for entities that the transfer of shapes examines.
bool IsShapeType(const Standard_Type& type)
{
  return IsOneOf(type,
           { STANDARD_TYPE(StepGeom_GeometricRepresentationItem),
             STANDARD_TYPE(StepShape_TopologicalRepresentationItem),
             STANDARD_TYPE(StepRepr_DefinitionalRepresentation) }) ||
    IsPlacing(type);
}

/// Returns true for failures that do not matter: a name that is not a string, or a value that the parser
/// itself replaced.
bool IsHarmless(const std::string& failure)
{
  return failure.find("not a quoted String") != std::string::npos ||
    failure.find("set to") != std::string::npos || failure.find("Set to") != std::string::npos;
}

/// Returns the first failure that leaves an entity incomplete; empty if there is none.
std::string FindFailure(const Handle(StepData_StepModel) & model, int number)
{
  const Handle(Interface_Check) check = model->Check(number, true);
  for (int i = 1; i <= check->NbFails(); ++i)
  {
    const std::string failure = check->CFail(i, true);
    if (!IsHarmless(failure))
    {
      return failure;
    }
  }
  return {};
}

/// Faces and placements that depend on damaged entities, directly or through others.
struct Damage
{
  std::unordered_set<Entity> Faces;
  /// A damaged entity that is not below a face, so that no face can be removed to avoid it.
  Handle(Standard_Transient) Fatal;
};

Damage FollowUsers(const Interface_Graph& graph, std::vector<Handle(Standard_Transient)> open)
{
  Damage damage;
  std::unordered_set<Entity> seen;
  while (!open.empty())
  {
    const Handle(Standard_Transient) entity = open.back();
    open.pop_back();
    if (!seen.insert(entity.get()).second)
    {
      continue;
    }
    if (entity->IsKind(STANDARD_TYPE(StepShape_Face)))
    {
      damage.Faces.insert(entity.get());
      continue;
    }
    if (entity->IsKind(STANDARD_TYPE(StepShape_ConnectedFaceSet)))
    {
      // Its missing faces are removed from its list, and the shell remains.
      continue;
    }
    if (IsPlacing(*entity->DynamicType()) || entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)))
    {
      damage.Fatal = entity;
    }
    for (Interface_EntityIterator users = graph.Sharings(entity); users.More(); users.Next())
    {
      open.push_back(users.Value());
    }
  }
  return damage;
}

/// Returns true for the shape of an aspect whose first item is an unresolved reference: the transfer asks for
/// its type.
bool IsBrokenAspect(const Handle(StepRepr_PropertyDefinitionRepresentation) & shape)
{
  const Handle(StepRepr_PropertyDefinition) definition = shape->Definition().PropertyDefinition();
  const Handle(StepRepr_Representation) items = shape->UsedRepresentation();
  return !definition.IsNull() && definition->Definition().ProductDefinition().IsNull() && !items.IsNull() &&
    !items->Items().IsNull() && items->NbItems() > 0 && items->ItemsValue(1).IsNull();
}

/// Returns true for a validation property with an unresolved reference. Real files have unresolved references
/// in other properties, too, which the transfer does not examine.
bool IsBrokenValidation(const Handle(StepRepr_PropertyDefinitionRepresentation) & property)
{
  if (property->IsKind(STANDARD_TYPE(StepShape_ShapeDefinitionRepresentation)))
  {
    return IsBrokenAspect(property);
  }
  const Handle(StepRepr_PropertyDefinition) definition = property->Definition().PropertyDefinition();
  const Handle(TCollection_HAsciiString) name =
    definition.IsNull() ? Handle(TCollection_HAsciiString)() : definition->Name();
  if (!name.IsNull() && name->String().Search("validation") < 0)
  {
    return false;
  }
  const Handle(StepRepr_Representation) values = property->UsedRepresentation();
  if (values.IsNull() || values->Items().IsNull())
  {
    return true;
  }
  for (int i = 1; i <= values->NbItems(); ++i)
  {
    if (values->ItemsValue(i).IsNull())
    {
      return true;
    }
  }
  return false;
}

std::string Number(const Handle(StepData_StepModel) & model, const Handle(Standard_Transient) & entity)
{
  return "#" + std::to_string(model->IdentLabel(entity));
}
}

bool HasFaceList(Handle(StepShape_ConnectedFaceSet) shell)
{
  constexpr int most = 100;
  for (int turns = 0; turns < most && !shell.IsNull(); ++turns)
  {
    const auto closed = Handle(StepShape_OrientedClosedShell)::DownCast(shell);
    const auto open = Handle(StepShape_OrientedOpenShell)::DownCast(shell);
    if (closed.IsNull() && open.IsNull())
    {
      return !shell->CfsFaces().IsNull();
    }
    shell = nullptr;
    if (!closed.IsNull())
    {
      shell = closed->ClosedShellElement();
    }
    else
    {
      shell = open->OpenShellElement();
    }
  }
  return false;
}

std::string DropDamagedFaces(const Handle(XSControl_WorkSession) & session, const ModelEntities& entities,
  const EntityFilter& matters, const EntityPeril& peril, std::vector<std::string>& messages, LostFaces& lost)
{
  const Handle(StepData_StepModel)& model = entities.GetModel();
  std::map<int, std::string> failures;
  for (const auto& [type, positions] : entities.GetLists())
  {
    if (!IsShapeType(*type))
    {
      continue;
    }
    // OpenCASCADE transfers all geometry, including geometry that no body uses, but no annotations.
    const bool isAnnotation = std::strncmp(type->Name(), "StepVisual_", 11) == 0;
    const bool isPlacing = IsPlacing(*type);
    for (const int i : positions)
    {
      std::string failure = peril ? peril(model->IdentLabel(model->Value(i)), isPlacing) : std::string();
      failure = failure.empty() ? FindFailure(model, i) : failure;
      if (!failure.empty() && !(isAnnotation && !matters(model->IdentLabel(model->Value(i)))))
      {
        failures.emplace(i, std::move(failure));
      }
    }
  }
  if (failures.empty())
  {
    return {};
  }
  std::vector<Handle(Standard_Transient)> damaged;
  for (const auto& [number, failure] : failures)
  {
    damaged.push_back(model->Value(number));
  }
  session->ComputeGraph(true);
  const Damage damage = FollowUsers(session->HGraph()->Graph(), damaged);
  const std::string count = std::to_string(damaged.size()) + " of its entities are damaged, first " +
    Number(model, damaged.front()) + " (" + failures.begin()->second + ")";
  if (!damage.Fatal.IsNull())
  {
    return count + "; entity " + Number(model, damage.Fatal) +
      " cannot be read without them: export it again";
  }
  std::string dropped;
  int faces = 0;
  for (const int i : entities.Find({ STANDARD_TYPE(StepShape_ConnectedFaceSet) }))
  {
    const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(model->Value(i));
    if (!HasFaceList(shell))
    {
      const bool isOriented = shell->IsKind(STANDARD_TYPE(StepShape_OrientedClosedShell)) ||
        shell->IsKind(STANDARD_TYPE(StepShape_OrientedOpenShell));
      if (isOriented && matters(model->IdentLabel(shell)))
      {
        return count + "; the oriented shell " + Number(model, shell) + " has no shell: export it again";
      }
      continue;
    }
    std::vector<Handle(StepShape_Face)> kept;
    for (int k = 1; k <= shell->NbCfsFaces(); ++k)
    {
      const Handle(StepShape_Face) face = shell->CfsFacesValue(k);
      if (!face.IsNull() && damage.Faces.count(face.get()) == 0)
      {
        kept.push_back(face);
        continue;
      }
      ++faces;
      dropped += face.IsNull() ? " (unknown)" : " " + Number(model, face);
    }
    if (kept.empty())
    {
      return count + "; no face of shell " + Number(model, shell) + " is left: export it again";
    }
    if (static_cast<int>(kept.size()) < shell->NbCfsFaces())
    {
      lost[shell.get()] = shell->NbCfsFaces() - static_cast<int>(kept.size());
      const Handle(StepShape_HArray1OfFace) list =
        new StepShape_HArray1OfFace(1, static_cast<int>(kept.size()));
      for (std::size_t k = 0; k < kept.size(); ++k)
      {
        list->SetValue(static_cast<int>(k) + 1, kept[k]);
      }
      shell->SetCfsFaces(list);
    }
  }
  if (faces > 0)
  {
    messages.push_back(count + ". " +
      FormatCount(faces, "face that needs them is left out:", "faces that need them are left out:") +
      dropped + ".");
    session->ComputeGraph(true);
  }
  return {};
}

Attributes FindDamagedAttributes(const ModelEntities& entities)
{
  const auto isFailed = [&entities](int i) { return !FindFailure(entities.GetModel(), i).empty(); };
  const std::vector<int> styles =
    entities.Find({ STANDARD_TYPE(StepVisual_SurfaceSideStyle), STANDARD_TYPE(StepVisual_FillAreaStyleColour),
      STANDARD_TYPE(StepVisual_FillAreaStyle), STANDARD_TYPE(StepVisual_SurfaceStyleFillArea),
      STANDARD_TYPE(StepVisual_SurfaceStyleUsage), STANDARD_TYPE(StepVisual_StyledItem) });
  const std::vector<int> units = entities.Find(
    { STANDARD_TYPE(StepRepr_MeasureRepresentationItem), STANDARD_TYPE(StepBasic_MeasureWithUnit),
      STANDARD_TYPE(StepBasic_DerivedUnit), STANDARD_TYPE(StepBasic_DerivedUnitElement) });
  Attributes damaged;
  damaged.Colors = std::any_of(styles.begin(), styles.end(), isFailed);
  damaged.Properties = std::any_of(units.begin(), units.end(), isFailed);
  entities.ForEach<StepRepr_PropertyDefinitionRepresentation>(
    [&](const Handle(StepRepr_PropertyDefinitionRepresentation) & property)
    { damaged.Properties = damaged.Properties || IsBrokenValidation(property); });
  return damaged;
}
}
