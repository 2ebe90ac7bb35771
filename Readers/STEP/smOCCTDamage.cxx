#include "smOCCTDamage.h"

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_HGraph.hxx>
#include <StepGeom_GeometricRepresentationItem.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>

#include <unordered_set>

namespace sm
{
namespace
{
using Entity = const Standard_Transient*;

/// Entities that the transfer of shapes follows.
bool IsShapeEntity(const Handle(Standard_Transient) & entity)
{
  return entity->IsKind(STANDARD_TYPE(StepGeom_GeometricRepresentationItem)) ||
    entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem)) ||
    entity->IsKind(STANDARD_TYPE(StepRepr_DefinitionalRepresentation)) ||
    entity->IsKind(STANDARD_TYPE(StepRepr_ItemDefinedTransformation));
}

/// A name that is no string, or a value that the parser itself replaced, does no harm.
bool IsHarmless(const std::string& failure)
{
  return failure.find("not a quoted String") != std::string::npos ||
    failure.find("set to") != std::string::npos || failure.find("Set to") != std::string::npos;
}

/// The first failure that leaves an entity incomplete; empty when there is none.
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

/// What all users of the damaged entities, and theirs in turn, come to.
struct Damage
{
  std::unordered_set<Entity> Faces;
  /// An entity above all faces: nothing can be left out.
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
      // Its missing faces are taken out of the list; it stays.
      continue;
    }
    if (entity->IsKind(STANDARD_TYPE(StepRepr_ItemDefinedTransformation)) ||
      entity->IsKind(STANDARD_TYPE(StepRepr_MappedItem)) ||
      entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationMap)) ||
      entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)))
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

std::string Number(const Handle(StepData_StepModel) & model, const Handle(Standard_Transient) & entity)
{
  return "#" + std::to_string(model->IdentLabel(entity));
}
}

std::string DropDamagedFaces(const Handle(XSControl_WorkSession) & session,
  const Handle(StepData_StepModel) & model, std::vector<std::string>& messages)
{
  std::vector<Handle(Standard_Transient)> damaged;
  std::string first;
  for (int i = 1; !model.IsNull() && i <= model->NbEntities(); ++i)
  {
    const std::string failure = IsShapeEntity(model->Value(i)) ? FindFailure(model, i) : std::string();
    if (!failure.empty())
    {
      damaged.push_back(model->Value(i));
      first = first.empty() ? Number(model, model->Value(i)) + " (" + failure + ")" : first;
    }
  }
  if (damaged.empty())
  {
    return {};
  }
  session->ComputeGraph(true);
  const Damage damage = FollowUsers(session->HGraph()->Graph(), damaged);
  const std::string count = std::to_string(damaged.size()) + " of its entities are damaged, first " + first;
  if (!damage.Fatal.IsNull())
  {
    return count + "; entity " + Number(model, damage.Fatal) +
      " cannot be read without them: export it again";
  }
  std::string dropped;
  int faces = 0;
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(model->Value(i));
    if (shell.IsNull() || shell->CfsFaces().IsNull())
    {
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
    messages.push_back(
      count + ". " + std::to_string(faces) + " faces that need them are left out:" + dropped + ".");
    session->ComputeGraph(true);
  }
  return {};
}
}
