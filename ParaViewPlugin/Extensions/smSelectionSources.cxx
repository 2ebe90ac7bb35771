#include "smSelectionSources.h"

#include "vtkDataAssembly.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSelectionNode.h"

#include <functional>
#include <string>

namespace sm
{
namespace
{
/// The partitioned dataset of a solid in the hierarchy, counted from 1.
std::string GetSelector(vtkIdType solid)
{
  return "/Root/*[@number_of_partitions][" + std::to_string(solid + 1) + "]";
}

vtkSmartPointer<vtkSMSourceProxy> MakeSource(
  vtkSMSessionProxyManager* manager, const char* group, const char* name)
{
  return vtkSmartPointer<vtkSMSourceProxy>::Take(
    vtkSMSourceProxy::SafeDownCast(manager->NewProxy(group, name)));
}

vtkSmartPointer<vtkSMSourceProxy> MakeSelection(vtkSMSourceProxy* source)
{
  source->UpdateVTKObjects();
  return vtkSmartPointer<vtkSMSourceProxy>::Take(
    vtkSMSourceProxy::SafeDownCast(vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(source)));
}

void VisitSources(vtkSMSourceProxy* selection, const std::function<void(vtkSMProxy*)>& visit)
{
  vtkSMProperty* sources = selection ? selection->GetProperty("Input") : nullptr;
  for (unsigned int i = 0; sources && i < vtkSMPropertyHelper(sources).GetNumberOfElements(); ++i)
  {
    if (vtkSMProxy* source = vtkSMPropertyHelper(sources).GetAsProxy(i))
    {
      visit(source);
    }
  }
}

/// The number of the solid of a composite index, which counts the collection, and each partitioned dataset before its only partition;
/// negative for the collection.
vtkIdType GetSolid(vtkIdType compositeIndex)
{
  return compositeIndex > 0 ? (compositeIndex - 1) / 2 : -1;
}

/// The composite index of the only partition of a solid.
vtkIdType GetPartition(vtkIdType solid)
{
  return 2 * solid + 2;
}

void AddMeshes(vtkSMProxy* source, vtkDataAssembly* hierarchy, SelectedMeshes& meshes)
{
  const std::string kind = source->GetXMLName();
  if (kind == "CompositeDataIDSelectionSource")
  {
    // Composite index, process, cell.
    vtkSMPropertyHelper ids(source, "IDs");
    for (unsigned int k = 0; k + 2 < ids.GetNumberOfElements(); k += 3)
    {
      const vtkIdType solid = GetSolid(ids.GetAsIdType(k));
      if (solid >= 0)
      {
        meshes.Cells.emplace_back(solid, ids.GetAsIdType(k + 2));
      }
    }
  }
  else if (kind == "BlockSelectionSource")
  {
    vtkSMPropertyHelper blocks(source, "Blocks");
    for (unsigned int k = 0; k < blocks.GetNumberOfElements(); ++k)
    {
      const vtkIdType solid = GetSolid(blocks.GetAsIdType(k));
      if (solid >= 0)
      {
        meshes.Solids.insert(solid);
      }
    }
  }
  else if (kind == "BlockSelectorsSelectionSource" && hierarchy)
  {
    vtkSMPropertyHelper texts(source, "BlockSelectors");
    std::vector<std::string> selectors;
    for (unsigned int k = 0; k < texts.GetNumberOfElements(); ++k)
    {
      selectors.emplace_back(texts.GetAsString(k));
    }
    // Composite indices.
    for (const unsigned int index : hierarchy->GetDataSetIndices(hierarchy->SelectNodes(selectors)))
    {
      if (index > 0)
      {
        meshes.Solids.insert(GetSolid(index));
      }
    }
  }
}
}

std::vector<vtkIdType> GetSelectedRows(vtkSMSourceProxy* selection)
{
  std::set<vtkIdType> rows;
  VisitSources(selection,
    [&rows](vtkSMProxy* source)
    {
      vtkSMProperty* ids = source->GetProperty("IDs");
      // Pairs of process and index; the table is on one process.
      for (unsigned int k = 1; ids && k < vtkSMPropertyHelper(ids).GetNumberOfElements(); k += 2)
      {
        rows.insert(vtkSMPropertyHelper(ids).GetAsIdType(k));
      }
    });
  return { rows.begin(), rows.end() };
}

SelectedMeshes GetSelectedMeshes(vtkSMSourceProxy* selection, vtkDataAssembly* hierarchy)
{
  SelectedMeshes meshes;
  VisitSources(selection, [&meshes, hierarchy](vtkSMProxy* source) { AddMeshes(source, hierarchy, meshes); });
  return meshes;
}

vtkSmartPointer<vtkSMSourceProxy> MakeRowSelection(
  vtkSMSessionProxyManager* manager, const std::vector<vtkIdType>& rows)
{
  const auto source = MakeSource(manager, "sources", "IDSelectionSource");
  std::vector<vtkIdType> ids;
  for (const vtkIdType row : rows)
  {
    ids.insert(ids.end(), { 0, row }); // process and index
  }
  vtkSMPropertyHelper(source, "FieldType").Set(vtkSelectionNode::ROW);
  vtkSMPropertyHelper(source, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
  return MakeSelection(source);
}

vtkSmartPointer<vtkSMSourceProxy> MakeSolidSelection(
  vtkSMSessionProxyManager* manager, const std::set<vtkIdType>& solids)
{
  const auto source = MakeSource(manager, "sources", "BlockSelectorsSelectionSource");
  vtkSMPropertyHelper selectors(source, "BlockSelectors");
  unsigned int next = 0;
  for (const vtkIdType solid : solids)
  {
    selectors.Set(next++, GetSelector(solid).c_str());
  }
  return MakeSelection(source);
}

vtkSmartPointer<vtkSMSourceProxy> MakeCellSelection(
  vtkSMSessionProxyManager* manager, const std::vector<std::pair<vtkIdType, vtkIdType>>& cells)
{
  const auto source = MakeSource(manager, "sources", "CompositeDataIDSelectionSource");
  std::vector<vtkIdType> ids;
  ids.reserve(3 * cells.size());
  for (const auto& [solid, cell] : cells)
  {
    ids.insert(ids.end(), { GetPartition(solid), 0, cell }); // composite index, process, cell
  }
  vtkSMPropertyHelper(source, "FieldType").Set(vtkSelectionNode::CELL);
  vtkSMPropertyHelper(source, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
  return MakeSelection(source);
}
}
