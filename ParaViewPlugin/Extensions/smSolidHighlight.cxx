#include "smSolidHighlight.h"

#include "vtkFaceRowsInformation.h"
#include "vtkNURBSDataSet.h"

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

#include <map>
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
  /// Negative without a table of faces.
  int FacesPort = -1;

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    auto* filter = vtkSMSourceProxy::SafeDownCast(caller);
    const unsigned int port = data ? *static_cast<unsigned int*>(data) : this->TablePort;
    const bool isFaces = static_cast<int>(port) == this->FacesPort;
    if (!filter || this->Busy || (port != this->TablePort && port != this->MeshesPort && !isFaces))
    {
      return;
    }
    this->Busy = true;
    const bool isChanged = isFaces ? this->FollowFaces(filter)
      : port == this->TablePort    ? this->FollowRows(filter)
                                   : this->FollowMeshes(filter);
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
    if (shown && shown == this->OwnFaces)
    {
      return false;
    }
    if (shown && shown != this->OwnMeshes)
    {
      // After a selection in a view ParaView clears the rows; those of the user's selection come back.
      return this->SelectRows(filter, FindSolids(filter, this->MeshesPort));
    }
    filter->CleanSelectionInputs(this->MeshesPort);
    return shown != nullptr;
  }

  /// The rows of faces have changed. Returns whether anything else has.
  bool FollowFaces(vtkSMSourceProxy* filter)
  {
    const std::set<vtkIdType> rows =
      GetSelectedRows(filter->GetSelectionInput(static_cast<unsigned int>(this->FacesPort)));
    vtkNew<vtkFaceRowsInformation> information;
    information->SetPortNumber(this->FacesPort);
    information->SetRows({ rows.begin(), rows.end() });
    if (!rows.empty())
    {
      filter->GatherInformation(information);
    }
    if (!information->GetFaces().empty())
    {
      this->HighlightFaces(filter, information->GetFaces());
      return true;
    }
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->MeshesPort);
    if (shown && shown == this->OwnFaces)
    {
      filter->CleanSelectionInputs(this->MeshesPort);
      return true;
    }
    return false;
  }

  /// The user has selected or cleared something in a view, or another tool has. Returns whether anything else has changed.
  bool FollowMeshes(vtkSMSourceProxy* filter)
  {
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->MeshesPort);
    if (shown)
    {
      return shown != this->OwnMeshes && shown != this->OwnFaces &&
        this->SelectRows(filter, FindSolids(filter, this->MeshesPort));
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

  /// The partitioned dataset of a solid in the hierarchy, counted from 1.
  static std::string GetSelector(vtkIdType solid)
  {
    return "/Root/*[@number_of_partitions][" + std::to_string(solid + 1) + "]";
  }

  /// Selects the cells of faces: those that are in the block of the solid and have the index of the face.
  void HighlightFaces(vtkSMSourceProxy* filter, const std::map<int, std::set<int>>& facesOfSolids)
  {
    vtkSMSessionProxyManager* manager = filter->GetSessionProxyManager();
    const auto make = [manager](const char* group, const char* name)
    {
      return vtkSmartPointer<vtkSMSourceProxy>::Take(
        vtkSMSourceProxy::SafeDownCast(manager->NewProxy(group, name)));
    };
    const auto selection = make("filters", "AppendSelections");
    unsigned int next = 0;
    std::string expression;
    const auto append = [&](vtkSMSourceProxy* source)
    {
      const std::string name = "S" + std::to_string(next);
      source->UpdateVTKObjects();
      vtkSMPropertyHelper(selection, "Input").Add(source);
      vtkSMPropertyHelper(selection, "SelectionNames").Set(next++, name.c_str());
      return name;
    };
    for (const auto& [solid, faces] : facesOfSolids)
    {
      const auto block = make("sources", "BlockSelectorsSelectionSource");
      vtkSMPropertyHelper(block, "FieldType").Set(vtkSelectionNode::CELL);
      vtkSMPropertyHelper(block, "BlockSelectors").Set(0, GetSelector(solid).c_str());
      const auto values = make("sources", "ThresholdSelectionSource");
      vtkSMPropertyHelper(values, "FieldType").Set(vtkSelectionNode::CELL);
      vtkSMPropertyHelper(values, "ArrayName").Set(vtkNURBSDataSet::FaceIndexArrayName());
      std::vector<double> ranges;
      for (const int face : faces)
      {
        ranges.insert(ranges.end(), 2, face);
      }
      vtkSMPropertyHelper(values, "Thresholds").Set(ranges.data(), static_cast<unsigned int>(ranges.size()));
      expression += (expression.empty() ? "(" : "|(") + append(block) + "&";
      expression += append(values) + ")";
    }
    vtkSMPropertyHelper(selection, "Expression").Set(expression.c_str());
    selection->UpdateVTKObjects();
    filter->SetSelectionInput(this->MeshesPort, selection, 0);
    this->OwnFaces = selection;
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
      selectors.Set(next++, GetSelector(row).c_str());
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
          view->FindRepresentation(filter, static_cast<int>(this->TablePort)) ||
          (this->FacesPort >= 0 && view->FindRepresentation(filter, this->FacesPort))))
      {
        view->StillRender();
      }
    }
  }

  bool Busy = false;
  /// The selections that Highlight(), HighlightFaces() and SelectRows() made last.
  vtkWeakPointer<vtkSMSourceProxy> OwnMeshes;
  vtkWeakPointer<vtkSMSourceProxy> OwnFaces;
  vtkWeakPointer<vtkSMSourceProxy> OwnRows;
};
}

void HighlightSolidsOfRows(
  vtkSMSourceProxy* filter, unsigned int tablePort, unsigned int meshesPort, int facesPort)
{
  vtkNew<HighlightCommand> command;
  command->TablePort = tablePort;
  command->MeshesPort = meshesPort;
  command->FacesPort = facesPort;
  filter->AddObserver(vtkCommand::SelectionChangedEvent, command);
}
}
