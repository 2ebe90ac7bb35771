/**
 * @file smWindowWatch.h
 * @brief Observers of a render window: of the release of its GL resources, and of its error messages; not
 * installed
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
/// Is notified when a window releases its graphics resources, with the window's context current. The header
/// of VTK's class for this purpose, vtkOpenGLResourceFreeCallback, is not installed. A texture object
/// registers one with its window, and is notified by the virtual method ReleaseGraphicsResources().
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
/// During its lifetime error messages of a window are not printed, and errors for which VTK would abort the
/// process do not.
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
