#include "vtkSMSolidMomentsSourceProxy.h"

#include "smEscapeKey.h"
#include "smLivePlane.h"
#include "smPlotSeries.h"
#include "smSolidHighlight.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkComputeContext.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVProgressHandler.h"
#include "vtkPVSession.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPTools.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSurfaceIntegralBase.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

vtkStandardNewMacro(vtkSMSolidMomentsSourceProxy);

namespace
{
/// ParaView ignores reports of progress that follow another one within an interval, 0.1 s by default. This is
/// the shortest interval that it accepts.
constexpr double ShortInterval = 0.01;

/// Lets an algorithm run on all cores; owned by the algorithm. ParaView's VTK runs loops on one thread unless
/// the environment names a backend. Several ranks share the cores themselves.
class ThreadsCommand : public vtkCommand
{
public:
  static ThreadsCommand* New() { return new ThreadsCommand; }
  vtkTypeMacro(ThreadsCommand, vtkCommand);

  void Execute(vtkObject*, unsigned long event, void*) override
  {
    vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
    if (event == vtkCommand::StartEvent && !std::getenv("VTK_SMP_BACKEND_IN_USE") &&
      !(ranks && ranks->GetNumberOfProcesses() > 1))
    {
      const char* backend = vtkSMPTools::GetBackend();
      this->Backend = backend ? backend : "";
      vtkSMPTools::SetBackend("STDThread");
    }
    else if (event == vtkCommand::EndEvent && !this->Backend.empty())
    {
      vtkSMPTools::SetBackend(this->Backend.c_str());
      this->Backend.clear();
    }
  }

private:
  /// The backend that VTK has between runs.
  std::string Backend;
};

/// Makes ParaView show the report that shaders are compiled, the only one for some seconds; owned by the
/// compute context.
class CompileCommand : public vtkCommand
{
public:
  static CompileCommand* New() { return new CompileCommand; }
  vtkTypeMacro(CompileCommand, vtkCommand);

  vtkWeakPointer<vtkPVProgressHandler> Handler;

  void Execute(vtkObject*, unsigned long event, void*) override
  {
    if (!this->Handler)
    {
      return;
    }
    if (event == vtkComputeContext::COMPILE_EVENT)
    {
      this->Interval = std::max(this->Interval, this->Handler->GetProgressInterval());
      this->Handler->SetProgressInterval(ShortInterval);
      std::this_thread::sleep_for(std::chrono::duration<double>(1.1 * ShortInterval));
    }
    else if (this->Interval > 0.0)
    {
      this->Handler->SetProgressInterval(this->Interval);
    }
  }

private:
  double Interval = 0.0;
};

/// Listens for Esc while an algorithm runs; owned by the algorithm.
class EscapeCommand : public vtkCommand
{
public:
  static EscapeCommand* New() { return new EscapeCommand; }
  vtkTypeMacro(EscapeCommand, vtkCommand);

  std::string Label;

  void Execute(vtkObject* caller, unsigned long event, void*) override
  {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (!algorithm)
    {
      return;
    }
    if (event == vtkCommand::StartEvent)
    {
      this->HasListened = false;
    }
    else if (event == vtkCommand::EndEvent)
    {
      this->Key.reset();
      algorithm->SetProgressText(this->Label.c_str());
      // VTK 9.2 leaves the flag set, and the next run would end at once. The executive sets the time of the
      // data after this event.
      if (algorithm->GetAbortExecute())
      {
        algorithm->SetAbortExecute(0);
      }
    }
    else if (this->Key)
    {
      if (this->Key->WasPressed())
      {
        algorithm->SetAbortExecute(1);
      }
    }
    else if (!this->HasListened)
    {
      // At the first report, since ParaView redraws the text only when the percentage changes. Listen() takes
      // about a millisecond.
      this->HasListened = true;
      this->Key = sm::EscapeKey::Listen();
      if (this->Key)
      {
        algorithm->SetProgressText((this->Label + ", Esc stops it").c_str());
      }
    }
  }

private:
  bool HasListened = false;
  std::unique_ptr<sm::EscapeKey> Key;
};
}

vtkSMSolidMomentsSourceProxy::vtkSMSolidMomentsSourceProxy() = default;
vtkSMSolidMomentsSourceProxy::~vtkSMSolidMomentsSourceProxy() = default;

void vtkSMSolidMomentsSourceProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMSolidMomentsSourceProxy::TakeFirstName()
{
  vtkPVXMLElement* second =
    this->GetHints() ? this->GetHints()->FindNestedElementByName("SecondNameOf") : nullptr;
  vtkSMProxy* named = second
    ? this->GetSessionProxyManager()->GetPrototypeProxy(this->GetXMLGroup(), second->GetAttribute("name"))
    : nullptr;
  // A prototype has no location: it keeps the name by which the menu finds the filter.
  if (named && this->GetLocation() != 0)
  {
    this->SetXMLName(named->GetXMLName());
    this->SetXMLLabel(named->GetXMLLabel());
    this->SetHints(named->GetHints());
  }
}

void vtkSMSolidMomentsSourceProxy::CreateVTKObjects()
{
  const bool first = !this->ObjectsCreated;
  if (first)
  {
    this->TakeFirstName();
  }
  this->Superclass::CreateVTKObjects();
  if (!first || !this->ObjectsCreated)
  {
    return;
  }
  if (this->GetHints() && this->GetHints()->FindNestedElementByName("HighlightRows"))
  {
    sm::HighlightSelectedEntities(this);
    sm::ChoosePlotSeries();
  }
  if (this->GetHints() && this->GetHints()->FindNestedElementByName("LivePlane"))
  {
    sm::FollowPlane(this, vtkAlgorithm::SafeDownCast(this->GetClientSideObject()));
  }
  // The text of the status bar, also for a run on a server; the default is the name of the class. ParaView
  // asks readers that only the first rank has whether they read a file: the others do not know these.
  if (this->GetLocation() & vtkPVSession::DATA_SERVER)
  {
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetProgressText" << this->GetXMLLabel()
           << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
  // Not null in the built-in session only.
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(this->GetClientSideObject()))
  {
    vtkNew<ThreadsCommand> threads;
    algorithm->AddObserver(vtkCommand::StartEvent, threads);
    algorithm->AddObserver(vtkCommand::EndEvent, threads);
    vtkNew<EscapeCommand> command;
    command->Label = this->GetXMLLabel();
    for (const unsigned long event :
      { vtkCommand::StartEvent, vtkCommand::EndEvent, vtkCommand::ProgressEvent })
    {
      // A higher priority than ParaView's own observer, which reads the text.
      algorithm->AddObserver(event, command, 1.0f);
    }
    auto* filter = vtkSurfaceIntegralBase::SafeDownCast(algorithm);
    if (filter && this->GetSession())
    {
      vtkNew<CompileCommand> compiling;
      compiling->Handler = this->GetSession()->GetProgressHandler();
      filter->GetComputeContext()->AddObserver(vtkComputeContext::COMPILE_EVENT, compiling);
      filter->AddObserver(vtkCommand::EndEvent, compiling);
    }
  }
}
