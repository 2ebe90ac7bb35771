/**
 * @file smWindowWatch.h
 * @brief Listens to a render window: when its GL resources end, and what it complains about; not installed
 */
#ifndef smWindowWatch_h
#define smWindowWatch_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextureObject.h"

#include <functional>
#include <string>

namespace sm
{
/// Learns that a window releases its graphics resources, with the window's context current. VTK's own way
/// (vtkOpenGLResourceFreeCallback) is not installed, but a texture object is registered with its window by it
/// and is told through a virtual method.
class EndWatch : public vtkTextureObject
{
public:
  static EndWatch* New() { VTK_STANDARD_NEW_BODY(EndWatch); }
  vtkTypeMacro(EndWatch, vtkTextureObject);

  std::function<void(vtkWindow*)> OnEnd;

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    if (this->OnEnd)
    {
      this->OnEnd(window);
    }
    this->Superclass::ReleaseGraphicsResources(window);
  }

protected:
  EndWatch() = default;
  ~EndWatch() override = default;
};
/// Keeps a window's complaints from being printed, and its exits from being aborts, while it is tried.
class ScopedErrorSilencer
{
public:
  explicit ScopedErrorSilencer(vtkObject* object)
    : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        if (event == vtkCommand::ErrorEvent && text)
        {
          static_cast<ScopedErrorSilencer*>(self)->Text = static_cast<const char*>(text);
        }
      });
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ExitEvent })
    {
      object->AddObserver(event, this->Command);
    }
  }
  ~ScopedErrorSilencer() { this->Object->RemoveObserver(this->Command); }
  ScopedErrorSilencer(const ScopedErrorSilencer&) = delete;
  ScopedErrorSilencer& operator=(const ScopedErrorSilencer&) = delete;

  std::string Text;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
};
}

#endif
