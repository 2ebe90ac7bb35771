#include "smSolidHighlight.h"

#include "smSelectionSources.h"
#include "vtkSelectedEntitiesInformation.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sm
{
namespace
{
using Entities = vtkSelectedEntitiesInformation;

constexpr unsigned int SummaryPort = 2;
constexpr Entities::Port Tables[] = { Entities::SolidsPort, Entities::FacesPort, Entities::EdgesPort };

SelectionTerms MakeRowTerms(const std::vector<vtkIdType>& rows)
{
  SelectionTerms terms;
  terms.Sets.resize(1);
  terms.Sets[0].Name = "rows";
  terms.Sets[0].Elements[0] = rows;
  return terms;
}

/// Returns the port whose meshes show what is selected in the tables: Clipped where there is one, else
/// Bodies.
Entities::Port GetShownPort(vtkSMSourceProxy* filter)
{
  return filter->GetHints() && filter->GetHints()->FindNestedElementByName("HighlightClipped")
    ? Entities::ClippedPort
    : Entities::MeshesPort;
}

/// Draws a view again after its next drawing; owned by the view.
class DrawAgainCommand : public vtkCommand
{
public:
  static DrawAgainCommand* New() { return new DrawAgainCommand; }
  vtkTypeMacro(DrawAgainCommand, vtkCommand);

  vtkWeakPointer<vtkSMSourceProxy> Filter;
  Entities::Port Port = Entities::MeshesPort;

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    const vtkSmartPointer<vtkSMSourceProxy> filter = this->Filter.GetPointer();
    caller->RemoveObserver(this); // deletes this object
    auto* view = vtkSMViewProxy::SafeDownCast(caller);
    vtkSMSourceProxy* highlighted = filter ? filter->GetSelectionOutput(this->Port) : nullptr;
    if (view && highlighted)
    {
      highlighted->MarkDirty(highlighted);
      view->StillRender();
    }
  }
};

/// Copies selections between the tables' ports and the meshes' port; owned by the proxy that it observes.
class HighlightCommand : public vtkCommand
{
public:
  static HighlightCommand* New() { return new HighlightCommand; }
  vtkTypeMacro(HighlightCommand, vtkCommand);

  /// The port of meshes with the user's pick, or with what is highlighted for rows.
  Entities::Port PickedPort = Entities::MeshesPort;

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    auto* filter = vtkSMSourceProxy::SafeDownCast(caller);
    if (!filter || this->Busy)
    {
      return;
    }
    if (event == vtkCommand::UpdateDataEvent)
    {
      this->Busy = true;
      this->FollowRun(filter);
      this->Busy = false;
      return;
    }
    const unsigned int port =
      data ? *static_cast<unsigned int*>(data) : static_cast<unsigned int>(Entities::SolidsPort);
    const bool isTable = std::find(std::begin(Tables), std::end(Tables), port) != std::end(Tables);
    const auto changed = static_cast<Entities::Port>(port);
    if (!isTable && (!IsPickable(filter, changed) || !this->TakePickedPort(filter, changed)))
    {
      return;
    }
    this->Busy = true;
    const bool isChanged = isTable ? this->FollowRows(filter, changed) : this->FollowMeshes(filter);
    this->Busy = false;
    if (isChanged)
    {
      this->RenderViews(filter);
    }
  }

private:
  /// Returns true if this object made the selection on a port.
  bool IsOwn(vtkSMSourceProxy* selection, unsigned int port) const
  {
    const auto found = this->Own.find(port);
    return selection && found != this->Own.end() && found->second == selection;
  }

  static bool IsPickable(vtkSMSourceProxy* filter, Entities::Port port)
  {
    return port == Entities::MeshesPort || port == GetShownPort(filter);
  }

  /// Makes the port of meshes whose selection has changed the one with the user's pick. Returns false if
  /// nothing is selected there and the pick is on the other port.
  bool TakePickedPort(vtkSMSourceProxy* filter, Entities::Port port)
  {
    if (port != this->PickedPort)
    {
      vtkSMSourceProxy* selection = filter->GetSelectionInput(port);
      if (!selection || this->IsOwn(selection, port))
      {
        return false;
      }
      this->Busy = true;
      filter->CleanSelectionInputs(this->PickedPort);
      this->Busy = false;
      this->PickedPort = port;
      this->Picked = Pick();
    }
    return true;
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

  /// Handles a changed selection of a table's rows. Returns true if the highlighting changed.
  bool FollowRows(vtkSMSourceProxy* filter, Entities::Port table)
  {
    const std::optional<SelectionTerms> rows = ReadRowSelection(filter->GetSelectionInput(table));
    if (!rows)
    {
      return false;
    }
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->PickedPort);
    vtkNew<Entities> entities;
    if (!rows->Sets.empty())
    {
      entities->Select(table, *rows, GetShownPort(filter));
      filter->GatherInformation(entities);
    }
    if (!entities->GetText().empty())
    {
      for (const Entities::Port other : Tables)
      {
        if (other != table)
        {
          this->Clear(filter, other);
        }
      }
      this->Shown = table;
      this->Show(filter, *entities);
      return true;
    }
    if (shown && !this->IsOwn(shown, this->PickedPort))
    {
      // After a selection in a view ParaView clears the rows; those that belong to the user's selection are
      // selected again.
      return this->FollowMeshes(filter);
    }
    if (this->Shown != table)
    {
      return false;
    }
    this->Show(filter, *entities);
    return true;
  }

  /// Highlights the solids, faces or edges of the selected rows of a table, and describes them in the
  /// summary.
  void Show(vtkSMSourceProxy* filter, Entities& entities)
  {
    const Entities::Highlight& highlight = entities.GetHighlight();
    const Entities::Port shown = GetShownPort(filter);
    if (this->PickedPort != shown || highlight == Entities::Highlight())
    {
      filter->CleanSelectionInputs(this->PickedPort);
      this->PickedPort = shown;
    }
    if (!(highlight == Entities::Highlight()))
    {
      this->Select(filter, shown,
        MakeMeshSelection(filter->GetSessionProxyManager(), highlight.Solids, highlight.Cells));
    }
    this->Highlighted = highlight;
    Describe(filter, entities);
  }

  /// Handles a selection in a view that was changed by the user or by another tool. Returns true if rows or
  /// highlighting changed.
  bool FollowMeshes(vtkSMSourceProxy* filter)
  {
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->PickedPort);
    if (this->IsOwn(shown, this->PickedPort))
    {
      return false;
    }
    vtkNew<Entities> entities;
    if (shown)
    {
      entities->SetBefore(this->Picked.Solids, this->Picked.Faces);
      if (!this->GatherMeshes(filter, *entities))
      {
        return false;
      }
      this->Picked.Remember(*entities);
      // ParaView clears the rows after each change of this selection, which leads here again.
      if (shown != this->Whole)
      {
        this->ShowWholeFaces(filter, *entities);
      }
      std::set<vtkIdType> solids = entities->GetSolids();
      for (const auto& faces : entities->GetFaces())
      {
        solids.insert(faces.first);
      }
      this->SelectRows(filter, Entities::SolidsPort, { solids.begin(), solids.end() });
      this->SelectRows(filter, Entities::FacesPort, entities->GetFaceRows());
      this->SelectRows(filter, Entities::EdgesPort, {});
      Describe(filter, *entities);
      return true;
    }
    // If the user has selected rows, these are highlighted again.
    for (const Entities::Port table : Tables)
    {
      vtkSMSourceProxy* selected = filter->GetSelectionInput(table);
      if (selected && !this->IsOwn(selected, table))
      {
        return this->FollowRows(filter, table);
      }
    }
    for (const Entities::Port table : Tables)
    {
      this->Clear(filter, table);
    }
    this->Picked = Pick();
    Describe(filter, *entities);
    return true;
  }

  /// Replaces picked cells by all cells of their faces. The new selection counts as the user's.
  void ShowWholeFaces(vtkSMSourceProxy* filter, Entities& entities)
  {
    const Entities::Highlight& highlight = entities.GetHighlight();
    // Where there are too many cells, those that were picked stay.
    if (!entities.GetFaces().empty() && !(highlight == Entities::Highlight()))
    {
      const auto whole =
        MakeMeshSelection(filter->GetSessionProxyManager(), highlight.Solids, highlight.Cells);
      this->Whole = whole;
      filter->SetSelectionInput(this->PickedPort, whole, 0);
    }
    else if (entities.GetFaces().empty() && entities.GetSolids().empty())
    {
      filter->CleanSelectionInputs(this->PickedPort);
    }
  }

  /// Returns false for a selection whose cells and blocks are not known.
  bool GatherMeshes(vtkSMSourceProxy* filter, Entities& entities) const
  {
    const std::optional<SelectionTerms> terms = ReadMeshSelection(filter->GetSelectionInput(this->PickedPort),
      filter->GetOutputPort(this->PickedPort)->GetDataInformation());
    if (terms)
    {
      entities.Select(this->PickedPort, *terms);
      filter->GatherInformation(&entities);
    }
    return terms.has_value();
  }

  /// Updates the selection after a run: figures may have changed, and faces may have other cells.
  void FollowRun(vtkSMSourceProxy* filter)
  {
    vtkSMSourceProxy* shown = filter->GetSelectionInput(this->PickedPort);
    if (shown && !this->IsOwn(shown, this->PickedPort))
    {
      this->RenewPick(filter);
      return;
    }
    const std::optional<SelectionTerms> rows = ReadRowSelection(filter->GetSelectionInput(this->Shown));
    if (!rows || rows->Sets.empty())
    {
      return;
    }
    vtkNew<Entities> entities;
    entities->Select(this->Shown, *rows, GetShownPort(filter));
    filter->GatherInformation(entities);
    if (entities->GetHighlight() == this->Highlighted)
    {
      Describe(filter, *entities);
    }
    else
    {
      this->Show(filter, *entities);
      this->DrawAgain(filter);
    }
  }

  /// Updates the cells that the user has picked, which may belong to other faces now: selects the same faces
  /// by their new cells, or nothing if the rows belong to other solids now.
  void RenewPick(vtkSMSourceProxy* filter)
  {
    vtkNew<Entities> now;
    if (!this->GatherMeshes(filter, *now))
    {
      return;
    }
    if (!this->Picked.IsSame(*now))
    {
      vtkNew<Entities> before;
      before->Select(Entities::FacesPort, MakeRowTerms(this->Picked.FaceRows), this->PickedPort);
      filter->GatherInformation(before);
      Entities::Highlight highlight = before->GetHighlight();
      highlight.Solids.insert(this->Picked.Solids.begin(), this->Picked.Solids.end());
      filter->SetSelectionInput(this->PickedPort,
        MakeMeshSelection(filter->GetSessionProxyManager(), highlight.Solids, highlight.Cells), 0);
      if (!this->GatherMeshes(filter, *now) || now->GetSolidIds() != this->Picked.SolidIds)
      {
        filter->CleanSelectionInputs(this->PickedPort);
        for (const Entities::Port table : Tables)
        {
          this->Clear(filter, table);
        }
        now->Select(this->PickedPort, {});
        filter->GatherInformation(now);
      }
      this->Picked.Remember(*now);
      this->DrawAgain(filter);
    }
    Describe(filter, *now);
  }

  /// Draws the views again: a drawing that runs the filter uses the highlighting of before the run and then
  /// counts as up to date.
  void DrawAgain(vtkSMSourceProxy* filter) const
  {
    VisitViews(filter,
      [filter, port = this->PickedPort](vtkSMViewProxy* view)
      {
        if (view->FindRepresentation(filter, port))
        {
          vtkNew<DrawAgainCommand> command;
          command->Filter = filter;
          command->Port = port;
          view->AddObserver(vtkCommand::EndEvent, command);
        }
      });
  }

  void SelectRows(vtkSMSourceProxy* filter, Entities::Port table, const std::vector<vtkIdType>& rows)
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

  /// Sets the text of the selection in the summaries, and the lines of selected edges in the representations
  /// of the meshes.
  static void Describe(vtkSMSourceProxy* filter, Entities& entities)
  {
    VisitViews(filter,
      [filter, &entities](vtkSMViewProxy* view)
      {
        vtkSMProxy* summary = view->FindRepresentation(filter, SummaryPort);
        if (summary && summary->GetProperty("SelectedText"))
        {
          vtkSMPropertyHelper(summary, "SelectedText").Set(entities.GetText().c_str());
          summary->UpdateVTKObjects();
        }
        vtkSMProxy* meshes = view->FindRepresentation(filter, GetShownPort(filter));
        if (meshes && meshes->GetProperty("SelectedEdges"))
        {
          vtkSMPropertyHelper(meshes, "SelectedEdges").Set(entities.GetEdgeLines().c_str());
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
        if (shows(Entities::MeshesPort) || shows(GetShownPort(filter)) || shows(SummaryPort) ||
          std::any_of(std::begin(Tables), std::end(Tables), shows))
        {
          view->StillRender();
        }
      });
  }

  /// The elements that the user picked in a view, by the last information from the server.
  struct Pick
  {
    std::set<vtkIdType> Solids;
    std::map<vtkIdType, std::set<vtkIdType>> Faces;
    std::vector<vtkIdType> FaceRows;
    std::vector<std::string> SolidIds;

    void Remember(const Entities& entities)
    {
      *this = { entities.GetSolids(), entities.GetFaces(), entities.GetFaceRows(), entities.GetSolidIds() };
    }
    bool IsSame(const Entities& entities) const
    {
      return this->Solids == entities.GetSolids() && this->Faces == entities.GetFaces() &&
        this->SolidIds == entities.GetSolidIds();
    }
  };

  bool Busy = false;
  /// The table whose rows were highlighted last.
  Entities::Port Shown = Entities::SolidsPort;
  /// The elements that are highlighted for these rows in the views.
  Entities::Highlight Highlighted;
  Pick Picked;
  /// The selection that ShowWholeFaces() made last.
  vtkWeakPointer<vtkSMSourceProxy> Whole;
  /// The selections that this object made last, by their ports.
  std::map<unsigned int, vtkWeakPointer<vtkSMSourceProxy>> Own;
};
}

void HighlightSelectedEntities(vtkSMSourceProxy* filter)
{
  vtkNew<HighlightCommand> command;
  command->PickedPort = GetShownPort(filter);
  filter->AddObserver(vtkCommand::SelectionChangedEvent, command);
  filter->AddObserver(vtkCommand::UpdateDataEvent, command);
}
}
