/**
 * @file vtkComputeContextInternals.h
 * @brief Search for an OpenGL context, and detection of its end; not installed
 */
#ifndef vtkComputeContextInternals_h
#define vtkComputeContextInternals_h

#include "smWindowWatch.h"
#include "vtkComputeContext.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkComputeContext::vtkInternals
{
public:
  explicit vtkInternals(vtkComputeContext* self)
    : Self(self)
  {
    this->Deleted->SetClientData(this);
    this->Deleted->SetCallback([](vtkObject*, unsigned long, void* internals, void*)
      { static_cast<vtkInternals*>(internals)->WindowIsDeleted(); });
  }

  vtkComputeContext* Self;
  vtkWeakPointer<vtkRenderWindow> Given;
  bool WasGiven = false;
  /// True after the given window was READY once; a window that was closed since is not opened again.
  bool WasOpened = false;
  vtkSmartPointer<vtkOpenGLRenderWindow> Own;
  /// The window in use while READY. It never dangles, because EndWatch and DeleteEvent reset it before the
  /// window is destroyed.
  vtkOpenGLRenderWindow* Used = nullptr;
  vtkSmartPointer<sm::EndWatch> Watch;
  vtkNew<vtkCallbackCommand> Deleted;
  int MaximumVersion[2] = { 0, 0 };
  std::string Reason;
  std::string Renderer;
  std::string Version;
  const char* SourceName = "";

  /// True while only contexts of a GPU are accepted.
  bool OnlyGPU = false;
  /// Modification time of the context with which no GPU was found.
  vtkMTimeType FoundNoGPU = 0;

  /// Makes a context and sets the status to READY, or to the highest status of all attempts. Returns the
  /// status.
  int Search(bool onlyGPU);
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
    this->Reason += (this->Reason.empty() ? "" : " ") + std::string(label) + ": " + what + ".";
    return status;
  }
};

#endif
