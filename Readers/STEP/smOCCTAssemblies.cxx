#include "smOCCTAssemblies.h"

#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_ShapeRepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_Transformation.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <TColStd_HArray1OfListOfInteger.hxx>
#include <TColStd_ListOfInteger.hxx>

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace sm
{
namespace
{
/// Lists up to this length are not shortened.
constexpr int ShortList = 64;

using Relationship = StepRepr_ShapeRepresentationRelationshipWithTransformation;
using ItemSet = std::unordered_set<const StepRepr_RepresentationItem*>;

void ShortenSharings(const Interface_InterfaceModel& model, TColStd_HArray1OfListOfInteger& sharings)
{
  // Returns true if the entity only places instances and is needed for nothing else.
  const auto isPlacement = [&](int entity)
  {
    if (model.Value(entity)->DynamicType() != STANDARD_TYPE(Relationship))
    {
      return false;
    }
    const TColStd_ListOfInteger& users = sharings.Value(entity);
    for (TColStd_ListOfInteger::Iterator user(users); user.More(); user.Next())
    {
      if (!model.Value(user.Value())->IsKind(STANDARD_TYPE(StepShape_ContextDependentShapeRepresentation)))
      {
        return false;
      }
    }
    return !users.IsEmpty();
  };
  for (int i = sharings.Lower(); i <= sharings.Upper() && i <= model.NbEntities(); ++i)
  {
    const TColStd_ListOfInteger& users = sharings.Value(i);
    if (users.Extent() <= ShortList || !model.Value(i)->IsKind(STANDARD_TYPE(StepRepr_Representation)))
    {
      continue;
    }
    int last = 0;
    for (TColStd_ListOfInteger::Iterator user(users); user.More(); user.Next())
    {
      last = isPlacement(user.Value()) ? user.Value() : last;
    }
    TColStd_ListOfInteger kept;
    for (TColStd_ListOfInteger::Iterator user(users); user.More(); user.Next())
    {
      if (user.Value() == last || !isPlacement(user.Value()))
      {
        kept.Append(user.Value());
      }
    }
    sharings.ChangeValue(i) = kept;
  }
}

int CountItems(const Handle(StepRepr_Representation) & representation)
{
  return representation.IsNull() || representation->Items().IsNull() ? 0 : representation->NbItems();
}

/// The items of representations, each listed once.
class ItemSets
{
public:
  bool Contains(
    const Handle(StepRepr_Representation) & representation, const Handle(StepRepr_RepresentationItem) & item)
  {
    const auto [set, isNew] = this->Sets.try_emplace(representation.get());
    for (int i = 1; isNew && i <= CountItems(representation); ++i)
    {
      set->second.insert(representation->ItemsValue(i).get());
    }
    return set->second.count(item.get()) > 0;
  }

private:
  std::unordered_map<const StepRepr_Representation*, ItemSet> Sets;
};

/// Returns the placement that the relationship gives an instance, if origin and target are not interchanged.
Handle(StepGeom_Axis2Placement3d) FindTarget(const Handle(Relationship) & relationship, ItemSets& items)
{
  const Handle(StepRepr_ItemDefinedTransformation) transformation =
    relationship->TransformationOperator().ItemDefinedTransformation();
  if (transformation.IsNull())
  {
    return nullptr;
  }
  const auto origin = Handle(StepGeom_Axis2Placement3d)::DownCast(transformation->TransformItem1());
  const auto target = Handle(StepGeom_Axis2Placement3d)::DownCast(transformation->TransformItem2());
  const bool isInOrder = !origin.IsNull() && !target.IsNull() && origin != target &&
    items.Contains(relationship->Rep1(), origin) && items.Contains(relationship->Rep2(), target) &&
    !items.Contains(relationship->Rep1(), target);
  return isInOrder ? target : nullptr;
}

void ShortenItems(const ModelEntities& entities)
{
  ItemSets items;
  std::unordered_map<const StepRepr_Representation*, ItemSet> targets;
  std::vector<Handle(StepRepr_Representation)> assemblies;
  // Placements that the transfer must find: all origins, and both placements of a relationship in which they
  // are interchanged.
  ItemSet sought;
  const auto visit = [&](const Handle(Relationship) & relationship)
  {
    const Handle(StepRepr_ItemDefinedTransformation) transformation =
      relationship->TransformationOperator().ItemDefinedTransformation();
    const Handle(StepGeom_Axis2Placement3d) target = FindTarget(relationship, items);
    if (!transformation.IsNull())
    {
      sought.insert(transformation->TransformItem1().get());
      if (target.IsNull())
      {
        sought.insert(transformation->TransformItem2().get());
      }
    }
    if (relationship->Rep1().IsNull() || CountItems(relationship->Rep2()) <= ShortList)
    {
      return;
    }
    const auto [own, isNew] = targets.try_emplace(relationship->Rep2().get());
    if (isNew)
    {
      assemblies.push_back(relationship->Rep2());
    }
    if (!target.IsNull())
    {
      own->second.insert(target.get());
    }
  };
  entities.ForEach<Relationship>(visit);
  for (const Handle(StepRepr_Representation) & assembly : assemblies)
  {
    const ItemSet& own = targets[assembly.get()];
    std::vector<Handle(StepRepr_RepresentationItem)> kept;
    for (int i = 1; i <= assembly->NbItems(); ++i)
    {
      const StepRepr_RepresentationItem* item = assembly->ItemsValue(i).get();
      if (own.count(item) == 0 || sought.count(item) > 0)
      {
        kept.push_back(assembly->ItemsValue(i));
      }
    }
    // OpenCASCADE does not accept an empty list.
    if (!kept.empty())
    {
      const Handle(StepRepr_HArray1OfRepresentationItem) list =
        new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(kept.size()));
      for (std::size_t i = 0; i < kept.size(); ++i)
      {
        list->SetValue(static_cast<int>(i) + 1, kept[i]);
      }
      assembly->SetItems(list);
    }
  }
}
}

void ShortenAssemblies(const Handle(XSControl_WorkSession) & session, const ModelEntities& entities)
{
  // For a file without entities OpenCASCADE makes no graph.
  if (!session->ComputeGraph())
  {
    return;
  }
  const Interface_Graph& graph = session->Graph();
  const Handle(TColStd_HArray1OfListOfInteger) sharings = graph.SharingTable();
  if (!graph.Model().IsNull() && !sharings.IsNull())
  {
    ShortenSharings(*graph.Model(), *sharings);
    ShortenItems(entities);
  }
}
}
