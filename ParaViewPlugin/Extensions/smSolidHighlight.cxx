#include "smSolidHighlight.h"

#include "vtkCommand.h"
#include "vtkDataAssembly.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMOutputPort.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <set>
#include <string>
#include <vector>

namespace sm
{
namespace
{
/// Copies selections between the table's port and the meshes' port; owned by the proxy that it observes.
class HighlightCommand : public vtkCommand
{
public:
  static HighlightCommand* New() { return new HighlightCommand; }
  vtkTypeMacro(HighlightCommand, vtkCommand);

  unsigned int TablePort = 1;
  unsigned int MeshesPort = 5;

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    auto* filter = vtkSMSourceProxy::SafeDownCast(caller);
    const unsigned int port = data ? *static_cast<unsigned int*>(data) : this->TablePort;
    if (!filter || this->Busy || (port != this->TablePort && port != this->MeshesPort))
    {
      return;
    }
    this->Busy = true;
    const bool isChanged = port == this->TablePort ? this->FollowRows(filter) : this->FollowMeshes(filter);
    this->Busy = false;
    if (isChanged)
    {
      this->RenderViews(filter);
    }
  }

private:
  /// The rows have changed. Returns whether anything else has.
  bool FollowRows(vtkSMSourceProxy* filter)
  {
    const std::set<vtkIdType> rows = GetSelectedRows(filter->GetSelectionInput(this->TablePort));
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->MeshesPort);
    if (!rows.empty())
    {
      this->Highlight(filter, rows);
      return true;
    }
    if (shown && shown != this->OwnMeshes)
    {
      // After a selection in a view ParaView clears the rows; those of the user's selection come back.
      return this->SelectRows(filter, FindSolids(filter, this->MeshesPort));
    }
    filter->CleanSelectionInputs(this->MeshesPort);
    return shown != nullptr;
  }

  /// The user has selected or cleared something in a view, or another tool has. Returns whether anything else has changed.
  bool FollowMeshes(vtkSMSourceProxy* filter)
  {
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->MeshesPort);
    if (shown)
    {
      return shown != this->OwnMeshes && this->SelectRows(filter, FindSolids(filter, this->MeshesPort));
    }
    vtkSMSourceProxy* selected = filter->GetSelectionInput(this->TablePort);
    if (selected && selected == this->OwnRows)
    {
      filter->CleanSelectionInputs(this->TablePort);
      return true;
    }
    const std::set<vtkIdType> rows = GetSelectedRows(selected);
    if (!rows.empty())
    {
      this->Highlight(filter, rows);
    }
    return !rows.empty();
  }

  static std::set<vtkIdType> GetSelectedRows(vtkSMSourceProxy* selection)
  {
    std::set<vtkIdType> rows;
    vtkSMProperty* sources = selection ? selection->GetProperty("Input") : nullptr;
    for (unsigned int i = 0; sources && i < vtkSMPropertyHelper(sources).GetNumberOfElements(); ++i)
    {
      vtkSMProxy* source = vtkSMPropertyHelper(sources).GetAsProxy(i);
      vtkSMProperty* ids = source ? source->GetProperty("IDs") : nullptr;
      // Pairs of process and index; the table is on one process.
      for (unsigned int k = 1; ids && k < vtkSMPropertyHelper(ids).GetNumberOfElements(); k += 2)
      {
        rows.insert(vtkSMPropertyHelper(ids).GetAsIdType(k));
      }
    }
    return rows;
  }

  void Highlight(vtkSMSourceProxy* filter, const std::set<vtkIdType>& rows)
  {
    vtkSMSessionProxyManager* manager = filter->GetSessionProxyManager();
    const auto source = vtkSmartPointer<vtkSMSourceProxy>::Take(
      vtkSMSourceProxy::SafeDownCast(manager->NewProxy("sources", "BlockSelectorsSelectionSource")));
    vtkSMPropertyHelper selectors(source, "BlockSelectors");
    unsigned int next = 0;
    for (const vtkIdType row : rows)
    {
      // The partitioned datasets of the hierarchy, counted from 1.
      selectors.Set(next++, ("/Root/*[@number_of_partitions][" + std::to_string(row + 1) + "]").c_str());
    }
    source->UpdateVTKObjects();
    const auto selection = vtkSmartPointer<vtkSMSourceProxy>::Take(
      vtkSMSourceProxy::SafeDownCast(vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(source)));
    filter->SetSelectionInput(this->MeshesPort, selection, 0);
    this->OwnMeshes = selection;
  }

  /// The numbers of the solids of which the user has selected blocks or cells on a port; empty for other kinds of selections.
  static std::set<vtkIdType> FindSolids(vtkSMSourceProxy* filter, unsigned int port)
  {
    std::set<vtkIdType> solids;
    vtkSMProperty* sources = filter->GetSelectionInput(port)->GetProperty("Input");
    vtkDataAssembly* hierarchy =
      filter->GetOutputPort(port)->GetDataInformation()->GetHierarchy(); // of partitioned datasets
    for (unsigned int i = 0; sources && i < vtkSMPropertyHelper(sources).GetNumberOfElements(); ++i)
    {
      vtkSMProxy* source = vtkSMPropertyHelper(sources).GetAsProxy(i);
      const std::string kind = source ? source->GetXMLName() : "";
      // The composite index counts the collection, and each partitioned dataset before its only partition.
      const auto add = [&solids](vtkIdType index)
      {
        if (index > 0)
        {
          solids.insert((index - 1) / 2);
        }
      };
      const auto addIndices = [&add, source](const char* name, unsigned int step)
      {
        vtkSMPropertyHelper ids(source, name);
        for (unsigned int k = 0; k < ids.GetNumberOfElements(); k += step)
        {
          add(ids.GetAsIdType(k));
        }
      };
      if (kind == "CompositeDataIDSelectionSource")
      {
        addIndices("IDs", 3);
      }
      else if (kind == "BlockSelectionSource")
      {
        addIndices("Blocks", 1);
      }
      else if (kind == "BlockSelectorsSelectionSource" && hierarchy)
      {
        vtkSMPropertyHelper texts(source, "BlockSelectors");
        std::vector<std::string> selectors;
        for (unsigned int k = 0; k < texts.GetNumberOfElements(); ++k)
        {
          selectors.emplace_back(texts.GetAsString(k));
        }
        for (const unsigned int index : hierarchy->GetDataSetIndices(hierarchy->SelectNodes(selectors)))
        {
          add(index);
        }
      }
    }
    return solids;
  }

  /// Selects rows of the table, and says whether there are any.
  bool SelectRows(vtkSMSourceProxy* filter, const std::set<vtkIdType>& rows)
  {
    if (rows.empty())
    {
      return false;
    }
    vtkSMSessionProxyManager* manager = filter->GetSessionProxyManager();
    const auto source = vtkSmartPointer<vtkSMSourceProxy>::Take(
      vtkSMSourceProxy::SafeDownCast(manager->NewProxy("sources", "IDSelectionSource")));
    std::vector<vtkIdType> ids;
    for (const vtkIdType row : rows)
    {
      ids.insert(ids.end(), { 0, row }); // process and index
    }
    vtkSMPropertyHelper(source, "FieldType").Set(vtkSelectionNode::ROW);
    vtkSMPropertyHelper(source, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
    source->UpdateVTKObjects();
    const auto selection = vtkSmartPointer<vtkSMSourceProxy>::Take(
      vtkSMSourceProxy::SafeDownCast(vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(source)));
    filter->SetSelectionInput(this->TablePort, selection, 0);
    this->OwnRows = selection;
    return true;
  }

  void RenderViews(vtkSMSourceProxy* filter) const
  {
    vtkNew<vtkSMProxyIterator> iterator;
    iterator->SetSessionProxyManager(filter->GetSessionProxyManager());
    for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
    {
      auto* view = vtkSMViewProxy::SafeDownCast(iterator->GetProxy());
      if (view &&
        (view->FindRepresentation(filter, static_cast<int>(this->MeshesPort)) ||
          view->FindRepresentation(filter, static_cast<int>(this->TablePort))))
      {
        view->StillRender();
      }
    }
  }

  bool Busy = false;
  /// The selections that Highlight() and SelectRows() made last.
  vtkWeakPointer<vtkSMSourceProxy> OwnMeshes;
  vtkWeakPointer<vtkSMSourceProxy> OwnRows;
};
}

void HighlightSolidsOfRows(vtkSMSourceProxy* filter, unsigned int tablePort, unsigned int meshesPort)
{
  vtkNew<HighlightCommand> command;
  command->TablePort = tablePort;
  command->MeshesPort = meshesPort;
  filter->AddObserver(vtkCommand::SelectionChangedEvent, command);
}
}
