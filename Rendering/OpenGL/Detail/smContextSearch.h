/**
 * @file smContextSearch.h
 * @brief Search for an OpenGL context, and detection of its end; not installed
 */
#ifndef smContextSearch_h
#define smContextSearch_h

#include "smOpenGLLibrary.h"
#include "smWindowWatch.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"

#include <string>

namespace sm
{
class ContextSearch : public WindowSource
{
public:
  explicit ContextSearch(ContextState& state)
    : State(state)
  {
    this->Deleted->SetClientData(this);
    this->Deleted->SetCallback([](vtkObject*, unsigned long, void* search, void*)
      { static_cast<ContextSearch*>(search)->WindowIsDeleted(); });
  }

  int Search(bool onlyGPU) override;
  void Stop() override;

private:
  /// Each tries one source and returns READY or another status; the reasons are collected.
  int TryWindow();
  int TryX();
  int TryEGL();
  int Use(vtkOpenGLRenderWindow* window, const char* name, const char* label);
  void Adopt(vtkOpenGLRenderWindow* window);
  void End(bool current, int status);
  void Detach();
  void WindowIsDeleted();

  int Fail(const char* label, const std::string& what, int status)
  {
    this->State.Reason += (this->State.Reason.empty() ? "" : " ") + std::string(label) + ": " + what + ".";
    return status;
  }

  ContextState& State;
  vtkSmartPointer<vtkOpenGLRenderWindow> Own;
  vtkSmartPointer<EndWatch> Watch;
  vtkNew<vtkCallbackCommand> Deleted;
  /// True while only contexts of a GPU are accepted.
  bool OnlyGPU = false;
};
}

#endif
