#include "smSelectionSources.h"

#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSelectionNode.h"

#include <iterator>
#include <string>

namespace sm
{
namespace
{
/// Returns selectors of partitioned datasets in the hierarchy, one for each range of consecutive solids,
/// because ParaView searches the whole tree for each selector.
std::vector<std::string> GetSelectors(const std::set<vtkIdType>& solids)
{
  std::vector<std::string> selectors;
  for (auto first = solids.begin(); first != solids.end();)
  {
    vtkIdType last = *first;
    auto next = std::next(first);
    for (; next != solids.end() && *next == last + 1; ++next)
    {
      last = *next;
    }
    // Positions count from 1.
    selectors.push_back("/Root/*[@number_of_partitions][position()>=" + std::to_string(*first + 1) +
      " and position()<=" + std::to_string(last + 1) + "]");
    first = next;
  }
  return selectors;
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

/// Returns the number of the solid with a composite index. Composite indices count the collection, and each
/// partitioned dataset followed by its only partition. Negative for the collection.
vtkIdType GetSolid(vtkIdType compositeIndex)
{
  return compositeIndex > 0 ? (compositeIndex - 1) / 2 : -1;
}

/// Returns the composite index of the only partition of a solid.
vtkIdType GetPartition(vtkIdType solid)
{
  return 2 * solid + 2;
}

bool IsSet(vtkSMProxy* source, const char* property)
{
  return source->GetProperty(property) && vtkSMPropertyHelper(source, property).GetAsInt() != 0;
}

/// Returns false for a selection of points, and for sources with further conditions on the elements.
bool SelectsElements(vtkSMProxy* source, int fieldType)
{
  return source->GetProperty("FieldType") &&
    vtkSMPropertyHelper(source, "FieldType").GetAsInt() == fieldType && !IsSet(source, "InsideOut") &&
    !IsSet(source, "ContainingCells") && !IsSet(source, "NumberOfLayers");
}

/// Finds the blocks of selectors; returns false for a tree that the data do not have.
bool ReadSelectors(vtkSMProxy* source, vtkPVDataInformation* data, SelectionSet& set)
{
  vtkSMPropertyHelper texts(source, "BlockSelectors");
  std::vector<std::string> selectors;
  for (unsigned int k = 0; k < texts.GetNumberOfElements(); ++k)
  {
    selectors.emplace_back(texts.GetAsString(k));
  }
  const std::string hierarchy = vtkDataAssemblyUtilities::HierarchyName();
  const std::string name = source->GetProperty("BlockSelectorsAssemblyName")
    ? vtkSMPropertyHelper(source, "BlockSelectorsAssemblyName").GetAsString()
    : hierarchy;
  const bool isHierarchy = name == hierarchy;
  vtkDataAssembly* tree = isHierarchy ? data->GetHierarchy() : data->GetDataAssembly(name.c_str());
  if (!tree)
  {
    return false;
  }
  for (const unsigned int index : tree->GetDataSetIndices(tree->SelectNodes(selectors)))
  {
    // The hierarchy has composite indices, another tree the numbers of partitioned datasets.
    const vtkIdType solid = isHierarchy ? GetSolid(index) : static_cast<vtkIdType>(index);
    if (solid >= 0)
    {
      set.Blocks.insert(solid);
    }
  }
  return true;
}

/// Reads rows of a table, or cells and blocks of meshes; `data` is null for a table. Returns false for other
/// sources.
bool ReadSource(vtkSMProxy* source, vtkPVDataInformation* data, SelectionSet& set)
{
  const std::string kind = source->GetXMLName();
  if (!data && kind == "IDSelectionSource" && SelectsElements(source, vtkSelectionNode::ROW))
  {
    // Pairs of process and row; the table is on one process.
    vtkSMPropertyHelper ids(source, "IDs");
    for (unsigned int k = 1; k < ids.GetNumberOfElements(); k += 2)
    {
      set.Elements[0].push_back(ids.GetAsIdType(k));
    }
    return true;
  }
  if (data && kind == "CompositeDataIDSelectionSource" && SelectsElements(source, vtkSelectionNode::CELL))
  {
    // Composite index, process, cell.
    vtkSMPropertyHelper ids(source, "IDs");
    for (unsigned int k = 0; k + 2 < ids.GetNumberOfElements(); k += 3)
    {
      set.Elements[GetSolid(ids.GetAsIdType(k))].push_back(ids.GetAsIdType(k + 2));
    }
    return true;
  }
  if (data && kind == "BlockSelectionSource" && SelectsElements(source, vtkSelectionNode::CELL))
  {
    vtkSMPropertyHelper blocks(source, "Blocks");
    for (unsigned int k = 0; k < blocks.GetNumberOfElements(); ++k)
    {
      const vtkIdType solid = GetSolid(blocks.GetAsIdType(k));
      if (solid < 0)
      {
        return false;
      }
      set.Blocks.insert(solid);
    }
    return true;
  }
  return data && kind == "BlockSelectorsSelectionSource" && SelectsElements(source, vtkSelectionNode::CELL) &&
    ReadSelectors(source, data, set);
}

std::optional<SelectionTerms> ReadSelection(vtkSMSourceProxy* selection, vtkPVDataInformation* data)
{
  SelectionTerms terms;
  if (!selection)
  {
    return terms;
  }
  if (!selection->GetProperty("Expression") || !selection->GetProperty("SelectionNames"))
  {
    return {};
  }
  vtkSMPropertyHelper sources(selection, "Input");
  vtkSMPropertyHelper names(selection, "SelectionNames");
  const char* expression = vtkSMPropertyHelper(selection, "Expression").GetAsString();
  terms.Expression = expression ? expression : "";
  terms.IsInverse = IsSet(selection, "InsideOut");
  const unsigned int count = sources.GetNumberOfElements();
  if (!terms.Expression.empty() && names.GetNumberOfElements() != count)
  {
    return {};
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    SelectionSet set;
    set.Name = terms.Expression.empty() ? "s" + std::to_string(i) : names.GetAsString(i);
    vtkSMProxy* source = sources.GetAsProxy(i);
    if (!source || !ReadSource(source, data, set))
    {
      return {};
    }
    terms.Sets.push_back(set);
  }
  return IsValid(terms) ? std::optional<SelectionTerms>(terms) : std::nullopt;
}

vtkSmartPointer<vtkSMSourceProxy> MakeSolidSelection(
  vtkSMSessionProxyManager* manager, const std::set<vtkIdType>& solids)
{
  const auto source = MakeSource(manager, "sources", "BlockSelectorsSelectionSource");
  vtkSMStringVectorProperty::SafeDownCast(source->GetProperty("BlockSelectors"))
    ->SetElements(GetSelectors(solids));
  return MakeSelection(source);
}

/// With one condition for each solid, the time of ParaView's extraction would grow with the cube of their
/// number.
vtkSmartPointer<vtkSMSourceProxy> MakeCellSelection(
  vtkSMSessionProxyManager* manager, const std::map<vtkIdType, std::vector<vtkIdType>>& cellsOfSolids)
{
  const auto source = MakeSource(manager, "sources", "CompositeDataIDSelectionSource");
  std::vector<vtkIdType> ids;
  for (const auto& [solid, cells] : cellsOfSolids)
  {
    for (const vtkIdType cell : cells)
    {
      ids.insert(ids.end(), { GetPartition(solid), 0, cell }); // composite index, process, cell
    }
  }
  vtkSMPropertyHelper(source, "FieldType").Set(vtkSelectionNode::CELL);
  vtkSMPropertyHelper(source, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
  return MakeSelection(source);
}
}

std::optional<SelectionTerms> ReadRowSelection(vtkSMSourceProxy* selection)
{
  return ReadSelection(selection, nullptr);
}

std::optional<SelectionTerms> ReadMeshSelection(vtkSMSourceProxy* selection, vtkPVDataInformation* data)
{
  return ReadSelection(selection, data);
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

vtkSmartPointer<vtkSMSourceProxy> MakeMeshSelection(vtkSMSessionProxyManager* manager,
  const std::set<vtkIdType>& solids, const std::map<vtkIdType, std::vector<vtkIdType>>& cells)
{
  if (cells.empty())
  {
    return MakeSolidSelection(manager, solids);
  }
  auto selection = MakeCellSelection(manager, cells);
  if (!solids.empty())
  {
    vtkSMSelectionHelper::AddSelection(MakeSolidSelection(manager, solids), selection);
  }
  return selection;
}
}
