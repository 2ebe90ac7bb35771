#include "smLivePlane.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkTimerLog.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>

namespace sm
{
namespace
{
/// Longest run that a filter does during a drag with the setting WhereFast, in seconds. After a longer run a
/// drag tries one more if the run was not longer than MaxTrial. The first run prepares data that later
/// runs have: up to MaxFirst it counts as fast.
constexpr double MaxRun = 0.1;
constexpr double MaxTrial = 0.5;
constexpr double MaxFirst = 5.0;

/// The planes that ParaView's window shows: 5.11 has the second, others the first.
constexpr const char* PlaneNames[] = { "ImplicitPlaneWidgetRepresentation",
  "DisplaySizedImplicitPlaneWidgetRepresentation" };

enum Setting
{
  Never = 0,
  WhereFast = 1
};

/// Measures the runs of an algorithm; owned by it.
class ClockCommand : public vtkCommand
{
public:
  static ClockCommand* New() { return new ClockCommand; }
  vtkTypeMacro(ClockCommand, vtkCommand);

  std::shared_ptr<double> Seconds;

  void Execute(vtkObject*, unsigned long event, void*) override
  {
    const double now = vtkTimerLog::GetUniversalTime();
    if (event == vtkCommand::StartEvent)
    {
      this->Start = now;
    }
    else
    {
      const double seconds = now - this->Start;
      *this->Seconds = this->IsFirst && seconds < MaxFirst ? std::min(seconds, MaxRun) : seconds;
      this->IsFirst = false;
    }
  }

private:
  double Start = 0.0;
  bool IsFirst = true;
};

/// The measured seconds of the last runs, by filter.
std::map<vtkSMProxy*, std::shared_ptr<double>>& GetClocks()
{
  static std::map<vtkSMProxy*, std::shared_ptr<double>> clocks;
  return clocks;
}

/// Forgets the clock of a filter that is deleted.
class ForgetCommand : public vtkCommand
{
public:
  static ForgetCommand* New() { return new ForgetCommand; }
  vtkTypeMacro(ForgetCommand, vtkCommand);
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    GetClocks().erase(static_cast<vtkSMProxy*>(caller));
  }
};

/// Returns the active source if its plane is followed, and its last run was fast enough where that counts;
/// else null.
vtkSMSourceProxy* FindFilter(vtkSMSessionProxyManager* manager, bool isAnySpeed)
{
  vtkSMProxySelectionModel* model = manager ? manager->GetSelectionModel("ActiveSources") : nullptr;
  vtkSMProxy* active = model ? model->GetCurrentProxy() : nullptr;
  auto* port = vtkSMOutputPort::SafeDownCast(active);
  auto* filter = port ? port->GetSourceProxy() : vtkSMSourceProxy::SafeDownCast(active);
  vtkPVXMLElement* hints = filter ? filter->GetHints() : nullptr;
  if (!hints || !hints->FindNestedElementByName("LivePlane") || !filter->GetProperty("LivePlane"))
  {
    return nullptr;
  }
  const int setting = vtkSMPropertyHelper(filter, "LivePlane").GetAsInt();
  if (setting != WhereFast || isAnySpeed)
  {
    return setting == Never ? nullptr : filter;
  }
  const auto clock = GetClocks().find(filter);
  if (clock == GetClocks().end() || !(*clock->second < MaxTrial))
  {
    return nullptr;
  }
  return filter;
}

/// Copies three numbers; returns true if they changed.
bool Copy(vtkSMProxy* from, const char* fromName, vtkSMProxy* to, const char* toName)
{
  double before[3];
  double now[3];
  vtkSMPropertyHelper(to, toName).Get(before, 3);
  vtkSMPropertyHelper(from, fromName).Get(now, 3);
  vtkSMPropertyHelper(to, toName).Set(now, 3);
  return !std::equal(now, now + 3, before);
}

void RenderViews(vtkSMSourceProxy* filter)
{
  vtkNew<vtkSMProxyIterator> iterator;
  iterator->SetSessionProxyManager(filter->GetSessionProxyManager());
  for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
  {
    auto* view = vtkSMViewProxy::SafeDownCast(iterator->GetProxy());
    for (unsigned int port = 0; view && port < filter->GetNumberOfOutputPorts(); ++port)
    {
      if (view->FindRepresentation(filter, static_cast<int>(port)))
      {
        view->StillRender();
        break;
      }
    }
  }
}

/// Moves the plane of the active filter with the plane in the view; owned by the proxy of the latter.
class DragCommand : public vtkCommand
{
public:
  static DragCommand* New() { return new DragCommand; }
  vtkTypeMacro(DragCommand, vtkCommand);

  void Execute(vtkObject* caller, unsigned long event, void*) override
  {
    auto* plane = vtkSMProxy::SafeDownCast(caller);
    if (event == vtkCommand::StartInteractionEvent)
    {
      this->IsSlow = false;
      return;
    }
    // A drag that was followed up to a slow run is followed to its end, so that results belong to the plane.
    const bool isEnd = event == vtkCommand::EndInteractionEvent;
    if (this->Busy || isEnd != this->IsSlow)
    {
      return;
    }
    vtkSMSourceProxy* filter = plane ? FindFilter(plane->GetSessionProxyManager(), isEnd) : nullptr;
    if (!filter)
    {
      return;
    }
    const bool isMoved = Copy(plane, "Origin", filter, "Point");
    if (!Copy(plane, "Normal", filter, "Normal") && !isMoved)
    {
      return;
    }
    this->Busy = true;
    filter->UpdateVTKObjects();
    filter->UpdatePipeline();
    const auto clock = GetClocks().find(filter);
    this->IsSlow = vtkSMPropertyHelper(filter, "LivePlane").GetAsInt() == WhereFast &&
      clock != GetClocks().end() && *clock->second > MaxRun;
    RenderViews(filter);
    this->Busy = false;
  }

private:
  bool Busy = false;
  /// True for the rest of a drag after a run that took too long.
  bool IsSlow = false;
};

/// Finds the planes of a view after each drawing; owned by the view.
class ViewCommand : public vtkCommand
{
public:
  static ViewCommand* New() { return new ViewCommand; }
  vtkTypeMacro(ViewCommand, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* view = vtkSMProxy::SafeDownCast(caller);
    vtkSMProperty* hidden = view ? view->GetProperty("HiddenRepresentations") : nullptr;
    if (!hidden)
    {
      return;
    }
    vtkSMPropertyHelper widgets(hidden);
    for (unsigned int i = 0; i < widgets.GetNumberOfElements(); ++i)
    {
      vtkSMProxy* widget = widgets.GetAsProxy(i);
      const char* name = widget ? widget->GetXMLName() : nullptr;
      if (!name ||
        std::none_of(std::begin(PlaneNames), std::end(PlaneNames),
          [name](const char* plane) { return std::strcmp(name, plane) == 0; }))
      {
        continue;
      }
      vtkWeakPointer<vtkSMProxy>& known = this->Known[widget];
      if (known != widget)
      {
        known = widget;
        vtkNew<DragCommand> command;
        widget->AddObserver(vtkCommand::StartInteractionEvent, command);
        widget->AddObserver(vtkCommand::InteractionEvent, command);
        widget->AddObserver(vtkCommand::EndInteractionEvent, command);
      }
    }
  }

private:
  std::map<vtkSMProxy*, vtkWeakPointer<vtkSMProxy>> Known;
};

/// Observes views, also those that are made later; owned by the session's proxy manager.
class SessionCommand : public vtkCommand
{
public:
  static SessionCommand* New() { return new SessionCommand; }
  vtkTypeMacro(SessionCommand, vtkCommand);

  static void Observe(vtkSMProxy* view)
  {
    vtkNew<ViewCommand> command;
    view->AddObserver(vtkCommand::EndEvent, command);
  }

  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const auto* info = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    if (info && info->Proxy && info->GroupName && std::strcmp(info->GroupName, "views") == 0)
    {
      Observe(info->Proxy);
    }
  }
};
}

void FollowPlane(vtkSMSourceProxy* filter, vtkAlgorithm* algorithm)
{
  if (algorithm)
  {
    const auto seconds = std::make_shared<double>(MaxTrial);
    GetClocks()[filter] = seconds;
    vtkNew<ClockCommand> clock;
    clock->Seconds = seconds;
    algorithm->AddObserver(vtkCommand::StartEvent, clock);
    algorithm->AddObserver(vtkCommand::EndEvent, clock);
    vtkNew<ForgetCommand> forget;
    filter->AddObserver(vtkCommand::DeleteEvent, forget);
  }
  static vtkWeakPointer<vtkSMSessionProxyManager> observed;
  vtkSMSessionProxyManager* manager = filter->GetSessionProxyManager();
  if (!manager || observed == manager)
  {
    return;
  }
  observed = manager;
  vtkNew<SessionCommand> command;
  manager->AddObserver(vtkCommand::RegisterEvent, command);
  vtkNew<vtkSMProxyIterator> iterator;
  iterator->SetSessionProxyManager(manager);
  for (iterator->Begin("views"); !iterator->IsAtEnd(); iterator->Next())
  {
    SessionCommand::Observe(iterator->GetProxy());
  }
}
}
