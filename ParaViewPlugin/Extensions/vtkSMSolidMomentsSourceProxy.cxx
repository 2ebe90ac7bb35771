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
      this->Asked = false;
    }
    else if (event == vtkCommand::EndEvent)
    {
      this->Key.reset();
      algorithm->SetProgressText(this->Label.c_str());
      // VTK 9.2 leaves it set, and every later run would end at once, too. The executive takes the time of its data after this.
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
    else if (!this->Asked)
    {
      // At once: ParaView draws the text again only when the percentage changes. It costs about a millisecond.
      this->Asked = true;
      this->Key = sm::EscapeKey::Listen();
      if (this->Key)
      {
        algorithm->SetProgressText((this->Label + ", Esc stops it").c_str());
      }
    }
  }

private:
  bool Asked = false;
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
  // What the status bar says, also of a run on a server: else it would be the name of the class.
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetProgressText" << this->GetXMLLabel()
         << vtkClientServerStream::End;
  this->ExecuteStream(stream);
  // There is one in the built-in session only.
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(this->GetClientSideObject()))
  {
    vtkNew<EscapeCommand> command;
    command->Label = this->GetXMLLabel();
    for (const unsigned long event :
      { vtkCommand::StartEvent, vtkCommand::EndEvent, vtkCommand::ProgressEvent })
    {
      // Before ParaView's own observer, which passes the text on.
      algorithm->AddObserver(event, command, 1.0f);
    }
  }
}
