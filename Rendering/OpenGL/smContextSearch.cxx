#include "Detail/smContextSearch.h"

#include "Detail/smCurrentContext.h"
#include "smContextResources.h"
#include "smOpenGL.h"
#include "smProbe.h"
#include "smReadyContexts.h"
#include "smWindowResources.h"
#include "vtkComputeContext.h"
#include "vtkEGLSurfacelessRenderWindow.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace
{
using Context = vtkComputeContext;

std::string GetString(GLenum name)
{
  const GLubyte* text = sm::GL::GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

bool HasExtension(const char* wanted)
{
  GLint count = 0;
  sm::GL::GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const GLubyte* name = sm::GL::GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (name && std::strcmp(reinterpret_cast<const char*>(name), wanted) == 0)
    {
      return true;
    }
  }
  return false;
}

/// Returns true if the window has initialized OpenGL; before that vtkOpenGLRenderWindow states version 2.0.
bool IsInitialized(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  return major > 2;
}
}

namespace sm
{
int ContextSearch::Search(bool onlyGPU)
{
  const CurrentContext::Guard guard;
  // An own X window that was closed must not end while an EGL context is current.
  CurrentContext::ReleaseEGL();
  this->Detach();
  this->Own = nullptr;
  this->State.Reason.clear();
  this->OnlyGPU = onlyGPU;

  const int source = this->State.Source;
  const bool automatic = source == Context::AUTOMATIC;
  int status = Context::NOT_STARTED;
  const auto attempt = [&](bool wanted, int (ContextSearch::*method)())
  {
    if (wanted && status != Context::READY)
    {
      const int result = (this->*method)();
      status = result == Context::READY ? Context::READY : std::max(status, result);
    }
  };
  attempt(source == Context::WINDOW || (automatic && this->State.Given), &ContextSearch::TryWindow);
  attempt(source == Context::X || automatic, &ContextSearch::TryX);
  attempt(source == Context::EGL || automatic, &ContextSearch::TryEGL);
  this->State.Status = status;
  if (status == Context::READY)
  {
    this->State.Reason.clear();
  }
  else
  {
    this->State.Reason +=
      " Install or choose an OpenGL driver with version 4.3 and double precision: a graphics "
      "card's own, or Mesa's llvmpipe (libgl1-mesa-dri, with libegl1 where there is no display).";
  }
  return status;
}

void ContextSearch::Stop()
{
  if (this->Own && this->Own->IsCurrent())
  {
    // After rendering with our own window its context may be current; it is released, so that no scope
    // restores it after its end.
    this->Own->ReleaseCurrent();
  }
  const CurrentContext::Guard guard;
  if (this->State.Used)
  {
    this->End(MakeWindowCurrent(this->State.Used), Context::NOT_STARTED);
  }
  this->Detach();
  this->Own = nullptr;
}

int ContextSearch::TryWindow()
{
  static const char* const label = "Given window";
  if (!this->State.Given)
  {
    return this->Fail(label,
      this->State.WasGiven ? "it no longer exists; give another one" : "none was given; call SetWindow()",
      Context::NO_CONTEXT);
  }
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(this->State.Given);
  if (!window)
  {
    return this->Fail(label, std::string(this->State.Given->GetClassName()) + " is not an OpenGL window",
      Context::NO_CONTEXT);
  }
  static const char* const closed = "it was closed; render into it again";
  // An X window without a display would abort the process in Initialize(), and VTK 9.6 warns in IsCurrent().
  if (window->IsA("vtkXOpenGLRenderWindow") && !window->GetGenericDisplayId())
  {
    const char* reason = closed;
    void* display = this->State.WasOpened ? nullptr : GetXDisplay(reason);
    if (!display)
    {
      return this->Fail(label, reason, Context::NO_CONTEXT);
    }
    window->SetDisplayId(display);
  }
  const ScopedErrorSilencer silencer(window);
  if (!MakeWindowCurrent(window) && !this->State.WasOpened)
  {
    window->Initialize();
    MakeWindowCurrent(window);
  }
  if (!window->IsCurrent())
  {
    return this->Fail(label,
      this->State.WasOpened
        ? closed
        : "its context cannot be made current; a vtkGenericOpenGLRenderWindow needs observers of "
          "WindowMakeCurrentEvent and WindowIsCurrentEvent",
      Context::NO_CONTEXT);
  }
  if (!IsInitialized(window))
  {
    window->OpenGLInit();
  }
  if (!IsInitialized(window))
  {
    return this->Fail(label, "OpenGL could not be initialized. " + silencer.Text, Context::NO_CONTEXT);
  }
  const int status = this->Use(window, "window", label);
  this->State.WasOpened = this->State.WasOpened || status == Context::READY;
  return status;
}

int ContextSearch::TryX()
{
  static const char* const label = "X display";
  const char* reason = "";
  void* display = GetXDisplay(reason);
  if (!display)
  {
    return this->Fail(label, reason, Context::NO_CONTEXT);
  }
  auto window = vtkSmartPointer<vtkOpenGLRenderWindow>::Take(NewXWindow(display));
  int status = Context::NO_CONTEXT;
  {
    const ScopedErrorSilencer silencer(window);
    window->Initialize();
    if (!MakeWindowCurrent(window) || !IsInitialized(window))
    {
      status =
        this->Fail(label, "no OpenGL 3.2 context could be made. " + silencer.Text, Context::NO_CONTEXT);
    }
    else
    {
      this->Own = window;
      status = this->Use(window, "x", label);
    }
  }
  if (status != Context::READY)
  {
    this->Own = nullptr;
  }
  return status;
}

int ContextSearch::TryEGL()
{
  static const char* const label = "EGL";
  vtkNew<vtkEGLSurfacelessRenderWindow> window;
  window->SetMaximumVersion(this->State.MaximumVersion[0], this->State.MaximumVersion[1]);
  if (this->OnlyGPU && !vtkEGLSurfacelessRenderWindow::MayHaveGPU())
  {
    return this->Fail(label, "no device is a GPU", Context::NO_CONTEXT);
  }
  if (!window->CreateContext())
  {
    return this->Fail(label, window->GetReason(), Context::NO_CONTEXT);
  }
  int status = Context::NO_CONTEXT;
  {
    const ScopedErrorSilencer silencer(window);
    window->Initialize();
    if (!MakeWindowCurrent(window) || !IsInitialized(window))
    {
      status = this->Fail(label, "OpenGL could not be initialized. " + silencer.Text, Context::NO_CONTEXT);
    }
    else
    {
      this->Own = window;
      status = this->Use(window, "egl", label);
    }
  }
  if (status != Context::READY)
  {
    this->Own = nullptr;
  }
  return status;
}

int ContextSearch::Use(vtkOpenGLRenderWindow* window, const char* name, const char* label)
{
  GL::Load(GetOpenGLFunction);
  GL::DrainErrors();
  GLint major = 0;
  GLint minor = 0;
  GL::GetIntegerv(GL_MAJOR_VERSION, &major);
  GL::GetIntegerv(GL_MINOR_VERSION, &minor);
  std::string limit;
  if (this->State.MaximumVersion[0] > 0 &&
    std::make_pair(major, minor) >
      std::make_pair(this->State.MaximumVersion[0], this->State.MaximumVersion[1]))
  {
    major = this->State.MaximumVersion[0];
    minor = this->State.MaximumVersion[1];
    limit = ", limited by SetMaximumVersion()";
  }
  const std::string renderer = GetString(GL_RENDERER);
  if (this->OnlyGPU && vtkEGLSurfacelessRenderWindow::IsSoftware(renderer))
  {
    return this->Fail(label, renderer + " is a software renderer", Context::NO_CONTEXT);
  }
  if (std::make_pair(major, minor) < std::make_pair(4, 3) || !GL::DispatchCompute || !GL::GetInteger64i_v)
  {
    const char* forced = std::getenv("MESA_GL_VERSION_OVERRIDE");
    if (forced && *forced)
    {
      limit += std::string(", with MESA_GL_VERSION_OVERRIDE=") + forced + " in the environment";
    }
    return this->Fail(label,
      "OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " (" + renderer + ")" + limit +
        " has no compute shaders; they need OpenGL 4.3",
      Context::NO_COMPUTE);
  }
  if (!HasExtension("GL_ARB_gpu_shader_fp64"))
  {
    return this->Fail(
      label, renderer + " has no double precision (GL_ARB_gpu_shader_fp64)", Context::NO_DOUBLES);
  }

  this->Adopt(window);
  std::string complaint;
  bool& isProbed = this->State.Resources->Window->HasRightDoubles;
  isProbed = isProbed ||
    ProbeConstructs(this->State.Context, this->State.Resources->Window->FlushesSubnormals, complaint);
  if (!isProbed)
  {
    this->End(true, Context::NO_DOUBLES);
    this->Detach();
    return this->Fail(label, renderer + " " + complaint, Context::NO_DOUBLES);
  }
  this->State.Resources->IsSoftware = vtkEGLSurfacelessRenderWindow::IsSoftware(renderer);
  this->State.Renderer = renderer;
  this->State.Version = GetString(GL_VERSION);
  this->State.SourceName = name;
  return Context::READY;
}

void ContextSearch::Adopt(vtkOpenGLRenderWindow* window)
{
  ContextResources& resources = *this->State.Resources;
  GLint64 bytes = 0;
  GL::GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  resources.MaximumStorageBlockSize = bytes;
  GLint value = 0;
  GL::GetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &value);
  resources.StorageOffsetAlignment = std::max(value, 1);
  for (GLuint axis = 0; axis < 2; ++axis)
  {
    GL::GetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &value);
    resources.MaximumWorkGroupCount[axis] = value;
  }
  resources.Window = WindowResources::Get(window);
  resources.Window->IsOwn = resources.Window->IsOwn || window == this->Own;
  resources.Generation = ContextResources::NewGeneration();
  this->State.Used = window;
  this->State.Status = Context::READY;
  AddReadyContext(this->State.Context);
  this->Watch = vtkSmartPointer<EndWatch>::New();
  this->Watch->OnEnd = [this](vtkWindow* ended)
  {
    vtkRenderWindow* renderWindow = vtkRenderWindow::SafeDownCast(ended);
    this->End(renderWindow && renderWindow->IsCurrent(), Context::LOST);
  };
  this->Watch->SetContext(window);
  window->AddObserver(vtkCommand::DeleteEvent, this->Deleted);
}

void ContextSearch::End(bool current, int status)
{
  if (this->State.Status != Context::READY)
  {
    return;
  }
  this->State.Resources->End(current);
  this->State.Status = status;
  RemoveReadyContext(this->State.Context);
  this->State.Used->RemoveObserver(this->Deleted);
  this->State.Used = nullptr;
  this->State.Renderer.clear();
  this->State.Version.clear();
  this->State.SourceName = "";
  if (status == Context::LOST)
  {
    this->State.Reason =
      "The window whose OpenGL context was used has closed. Start() tries to get another context.";
  }
}

/// Stops observing the window. Must not be called from the callback of the EndWatch.
void ContextSearch::Detach()
{
  if (this->Watch)
  {
    this->Watch->OnEnd = nullptr;
    this->Watch->SetContext(nullptr);
    this->Watch = nullptr;
  }
}

/// Handles DeleteEvent, before the destructor of the window: its observers, one of which may make it current,
/// still work.
void ContextSearch::WindowIsDeleted()
{
  if (this->State.Used)
  {
    const CurrentContext::Guard guard;
    this->End(MakeWindowCurrent(this->State.Used), Context::LOST);
    this->Detach();
  }
}
}
