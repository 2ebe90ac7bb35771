#include "smSolidHighlight.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <set>
#include <string>

namespace sm
{
namespace
{
/// Copies the selection of the table's port to the meshes' port; owned by the proxy that it observes.
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
    const std::set<vtkIdType> rows = GetSelectedRows(filter->GetSelectionInput(this->TablePort));
    // A selection in the view is the user's own; after it was cleared, rows that are still selected are highlighted again.
    if (port == this->MeshesPort && (rows.empty() || filter->GetSelectionInput(this->MeshesPort)))
    {
      return;
    }
    // After a selection in the view ParaView clears the rows; the user's selection has to stay.
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->MeshesPort);
    if (rows.empty() && shown != this->Own)
    {
      return;
    }
    this->Busy = true;
    if (rows.empty())
    {
      filter->CleanSelectionInputs(this->MeshesPort);
    }
    else
    {
      this->Highlight(filter, rows);
    }
    this->Busy = false;
    this->RenderViews(filter);
  }

private:
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
    this->Own = selection;
  }

  void RenderViews(vtkSMSourceProxy* filter) const
  {
    vtkNew<vtkSMProxyIterator> iterator;
    iterator->SetSessionProxyManager(filter->GetSessionProxyManager());
    for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
    {
      auto* view = vtkSMRenderViewProxy::SafeDownCast(iterator->GetProxy());
      if (view && view->FindRepresentation(filter, static_cast<int>(this->MeshesPort)))
      {
        view->StillRender();
      }
    }
  }

  bool Busy = false;
  /// The selection that Highlight() made last.
  vtkWeakPointer<vtkSMSourceProxy> Own;
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
