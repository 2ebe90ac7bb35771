#include "vtkSMSolidMomentsSourceProxy.h"

#include "smEscapeKey.h"
#include "smSolidHighlight.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"

#include <memory>
#include <string>

vtkStandardNewMacro(vtkSMSolidMomentsSourceProxy);

namespace
{
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
      // VTK 9.2 leaves the flag set, and the next run would end at once. The executive sets the time of the data after this event.
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
      // At the first report, since ParaView redraws the text only when the percentage changes. Listen() takes about a millisecond.
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

void vtkSMSolidMomentsSourceProxy::CreateVTKObjects()
{
  const bool first = !this->ObjectsCreated;
  this->Superclass::CreateVTKObjects();
  if (!first || !this->ObjectsCreated)
  {
    return;
  }
  vtkPVXMLElement* hint =
    this->GetHints() ? this->GetHints()->FindNestedElementByName("HighlightRows") : nullptr;
  int table = 0;
  int meshes = 0;
  if (hint && hint->GetScalarAttribute("table", &table) && hint->GetScalarAttribute("meshes", &meshes))
  {
    sm::HighlightSolidsOfRows(this, static_cast<unsigned int>(table), static_cast<unsigned int>(meshes));
  }
  // The text of the status bar, also for a run on a server; the default is the name of the class.
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetProgressText" << this->GetXMLLabel()
         << vtkClientServerStream::End;
  this->ExecuteStream(stream);
  // Not null in the built-in session only.
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(this->GetClientSideObject()))
  {
    vtkNew<EscapeCommand> command;
    command->Label = this->GetXMLLabel();
    for (const unsigned long event :
      { vtkCommand::StartEvent, vtkCommand::EndEvent, vtkCommand::ProgressEvent })
    {
      // A higher priority than ParaView's own observer, which reads the text.
      algorithm->AddObserver(event, command, 1.0f);
    }
  }
}
