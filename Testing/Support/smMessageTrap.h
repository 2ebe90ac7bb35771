/**
 * @file smMessageTrap.h
 * @brief Errors and warnings of an object, collected instead of printed
 */
#ifndef smMessageTrap_h
#define smMessageTrap_h

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkWeakPointer.h>

#include <string>

namespace smtest
{
/// Collects what an object reports instead of letting it print.
class MessageTrap
{
public:
  explicit MessageTrap(vtkObject* object)
    : Object(object)
  {
    this->Callback->SetClientData(this);
    this->Callback->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* trap = static_cast<MessageTrap*>(self);
        (event == vtkCommand::ErrorEvent ? trap->Errors : trap->Warnings) +=
          text ? static_cast<const char*>(text) : "?";
        ++(event == vtkCommand::ErrorEvent ? trap->NumberOfErrors : trap->NumberOfWarnings);
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Callback);
    object->AddObserver(vtkCommand::WarningEvent, this->Callback);
  }
  ~MessageTrap()
  {
    if (this->Object)
    {
      this->Object->RemoveObserver(this->Callback);
    }
  }
  MessageTrap(const MessageTrap&) = delete;
  MessageTrap& operator=(const MessageTrap&) = delete;
  std::string Errors;
  std::string Warnings;
  int NumberOfErrors = 0;
  int NumberOfWarnings = 0;

private:
  vtkNew<vtkCallbackCommand> Callback;
  vtkWeakPointer<vtkObject> Object;
};
}

#endif
