#include "smSolidHighlight.h"

#include "smSelectionSources.h"
#include "vtkSelectedPlacesInformation.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace sm
{
namespace
{
using Places = vtkSelectedPlacesInformation;

constexpr unsigned int SummaryPort = 2;
constexpr Places::Port Tables[] = { Places::SolidsPort, Places::FacesPort, Places::EdgesPort };

/// Copies selections between the tables' ports and the meshes' port; owned by the proxy that it observes.
class HighlightCommand : public vtkCommand
{
public:
  static HighlightCommand* New() { return new HighlightCommand; }
  vtkTypeMacro(HighlightCommand, vtkCommand);

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    auto* filter = vtkSMSourceProxy::SafeDownCast(caller);
    if (filter && event == vtkCommand::UpdateDataEvent)
    {
      this->DescribeAgain(filter);
      return;
    }
    const unsigned int port =
      data ? *static_cast<unsigned int*>(data) : static_cast<unsigned int>(Places::SolidsPort);
    const bool isTable = std::find(std::begin(Tables), std::end(Tables), port) != std::end(Tables);
    if (!filter || this->Busy || (port != Places::MeshesPort && !isTable))
    {
      return;
    }
    this->Busy = true;
    const bool isChanged =
      isTable ? this->FollowRows(filter, static_cast<Places::Port>(port)) : this->FollowMeshes(filter);
    this->Busy = false;
    if (isChanged)
    {
      this->RenderViews(filter);
    }
  }

private:
  /// True for a selection on a port that this object made.
  bool IsOwn(vtkSMSourceProxy* selection, unsigned int port) const
  {
    const auto found = this->Own.find(port);
    return selection && found != this->Own.end() && found->second == selection;
  }

  void Select(vtkSMSourceProxy* filter, unsigned int port, vtkSMSourceProxy* selection)
  {
    filter->SetSelectionInput(port, selection, 0);
    this->Own[port] = selection;
  }

  void Clear(vtkSMSourceProxy* filter, unsigned int port)
  {
    if (this->IsOwn(filter->GetSelectionInput(port), port))
    {
      filter->CleanSelectionInputs(port);
    }
  }

  /// The rows of a table have changed. Returns whether anything else has.
  bool FollowRows(vtkSMSourceProxy* filter, Places::Port table)
  {
    const std::vector<vtkIdType> rows = GetSelectedRows(filter->GetSelectionInput(table));
    vtkSMSourceProxy* shown = filter->GetSelectionInput(Places::MeshesPort);
    vtkNew<Places> places;
    if (!rows.empty())
    {
      places->SelectRows(table, rows);
      filter->GatherInformation(places);
    }
    if (!places->GetText().empty())
    {
      for (const Places::Port other : Tables)
      {
        if (other != table)
        {
          this->Clear(filter, other);
        }
      }
      this->Shown = table;
      this->Show(filter, *places);
      return true;
    }
    if (shown && !this->IsOwn(shown, Places::MeshesPort))
    {
      // After a selection in a view ParaView clears the rows; those of the user's selection come back.
      return this->FollowMeshes(filter);
    }
    if (this->Shown != table)
    {
      return false;
    }
    this->Show(filter, *places);
    return true;
  }

  /// Highlights what the rows of a table stand for, and says what it is.
  void Show(vtkSMSourceProxy* filter, Places& places)
  {
    vtkSMSessionProxyManager* manager = filter->GetSessionProxyManager();
    if (!places.GetFaceCells().empty())
    {
      this->Select(filter, Places::MeshesPort, MakeCellSelection(manager, places.GetFaceCells()));
    }
    else if (!places.GetSolids().empty())
    {
      this->Select(filter, Places::MeshesPort, MakeSolidSelection(manager, places.GetSolids()));
    }
    else
    {
      filter->CleanSelectionInputs(Places::MeshesPort);
    }
    Describe(filter, places);
  }

  /// The user has selected or cleared something in a view, or another tool has. Returns whether anything else has changed.
  bool FollowMeshes(vtkSMSourceProxy* filter)
  {
    vtkSMSourceProxy* shown = filter->GetSelectionInput(Places::MeshesPort);
    if (this->IsOwn(shown, Places::MeshesPort))
    {
      return false;
    }
    vtkNew<Places> places;
    if (shown)
    {
      if (!GatherMeshes(filter, *places))
      {
        return false;
      }
      std::set<vtkIdType> solids = places->GetSolids();
      for (const auto& faces : places->GetFaces())
      {
        solids.insert(faces.first);
      }
      this->SelectRows(filter, Places::SolidsPort, { solids.begin(), solids.end() });
      this->SelectRows(filter, Places::FacesPort, places->GetFaceRows());
      this->SelectRows(filter, Places::EdgesPort, {});
      Describe(filter, *places);
      return true;
    }
    // Rows that the user has selected are highlighted again.
    for (const Places::Port table : Tables)
    {
      vtkSMSourceProxy* selected = filter->GetSelectionInput(table);
      if (selected && !this->IsOwn(selected, table))
      {
        return this->FollowRows(filter, table);
      }
    }
    for (const Places::Port table : Tables)
    {
      this->Clear(filter, table);
    }
    Describe(filter, *places);
    return true;
  }

  /// Returns false for a selection by other means than blocks and cells.
  static bool GatherMeshes(vtkSMSourceProxy* filter, Places& places)
  {
    const SelectedMeshes meshes = GetSelectedMeshes(filter->GetSelectionInput(Places::MeshesPort),
      filter->GetOutputPort(Places::MeshesPort)->GetDataInformation()->GetHierarchy());
    if (meshes.IsEmpty())
    {
      return false;
    }
    places.SelectMeshes(meshes.Solids, meshes.Cells);
    filter->GatherInformation(&places);
    return true;
  }

  /// After a run: what is selected has other figures.
  void DescribeAgain(vtkSMSourceProxy* filter)
  {
    vtkNew<Places> places;
    vtkSMSourceProxy* shown = filter->GetSelectionInput(Places::MeshesPort);
    if (shown && !this->IsOwn(shown, Places::MeshesPort))
    {
      if (GatherMeshes(filter, *places))
      {
        Describe(filter, *places);
      }
      return;
    }
    const std::vector<vtkIdType> rows = GetSelectedRows(filter->GetSelectionInput(this->Shown));
    if (!rows.empty())
    {
      places->SelectRows(this->Shown, rows);
      filter->GatherInformation(places);
      Describe(filter, *places);
    }
  }

  void SelectRows(vtkSMSourceProxy* filter, Places::Port table, const std::vector<vtkIdType>& rows)
  {
    if (rows.empty())
    {
      filter->CleanSelectionInputs(table);
    }
    else
    {
      this->Select(filter, table, MakeRowSelection(filter->GetSessionProxyManager(), rows));
    }
  }

  static void VisitViews(vtkSMSourceProxy* filter, const std::function<void(vtkSMViewProxy*)>& visit)
  {
    vtkNew<vtkSMProxyIterator> iterator;
    iterator->SetSessionProxyManager(filter->GetSessionProxyManager());
    for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
    {
      if (auto* view = vtkSMViewProxy::SafeDownCast(iterator->GetProxy()))
      {
        visit(view);
      }
    }
  }

  /// Gives the summaries the text of what is selected, and the meshes the lines of edges.
  static void Describe(vtkSMSourceProxy* filter, Places& places)
  {
    std::vector<double> lines;
    for (const std::array<double, 4>& point : places.GetLines())
    {
      lines.insert(lines.end(), point.begin(), point.end());
    }
    VisitViews(filter,
      [filter, &places, &lines](vtkSMViewProxy* view)
      {
        vtkSMProxy* summary = view->FindRepresentation(filter, SummaryPort);
        if (summary && summary->GetProperty("SelectedText"))
        {
          vtkSMPropertyHelper(summary, "SelectedText").Set(places.GetText().c_str());
          summary->UpdateVTKObjects();
        }
        vtkSMProxy* meshes = view->FindRepresentation(filter, Places::MeshesPort);
        if (meshes && meshes->GetProperty("SelectedEdges"))
        {
          vtkSMPropertyHelper edges(meshes, "SelectedEdges");
          edges.SetNumberOfElements(0);
          edges.Set(lines.data(), static_cast<unsigned int>(lines.size()));
          meshes->UpdateVTKObjects();
        }
      });
  }

  static void RenderViews(vtkSMSourceProxy* filter)
  {
    VisitViews(filter,
      [filter](vtkSMViewProxy* view)
      {
        const auto shows = [view, filter](unsigned int port)
        { return view->FindRepresentation(filter, static_cast<int>(port)) != nullptr; };
        if (shows(Places::MeshesPort) || shows(SummaryPort) ||
          std::any_of(std::begin(Tables), std::end(Tables), shows))
        {
          view->StillRender();
        }
      });
  }

  bool Busy = false;
  /// The table whose rows were highlighted last.
  Places::Port Shown = Places::SolidsPort;
  /// The selections that this object made last, by their ports.
  std::map<unsigned int, vtkWeakPointer<vtkSMSourceProxy>> Own;
};
}

void HighlightSelectedPlaces(vtkSMSourceProxy* filter)
{
  vtkNew<HighlightCommand> command;
  filter->AddObserver(vtkCommand::SelectionChangedEvent, command);
  filter->AddObserver(vtkCommand::UpdateDataEvent, command);
}
}
