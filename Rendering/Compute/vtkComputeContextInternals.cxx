#include "Detail/vtkComputeContextInternals.h"

#include "Detail/smCurrentContext.h"
#include "Detail/smOpenGL.h"
#include "Detail/smReadyContexts.h"
#include "smContextResources.h"
#include "smProbe.h"
#include "smWindowResources.h"
#include "vtkEGLSurfacelessRenderWindow.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace
{
std::string GetString(GLenum name)
{
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

bool HasExtension(const char* wanted)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const GLubyte* name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
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

int vtkComputeContext::vtkInternals::Search(bool onlyGPU)
{
  const sm::CurrentContext::Guard guard;
  // An own X window that was closed must not end while an EGL context is current.
  sm::CurrentContext::ReleaseEGL();
  this->Detach();
  this->Own = nullptr;
  this->Reason.clear();
  this->OnlyGPU = onlyGPU;

  const int source = this->Self->Source;
  const bool automatic = source == AUTOMATIC;
  int status = NOT_STARTED;
  const auto attempt = [&](bool wanted, int (vtkInternals::*method)())
  {
    if (wanted && status != READY)
    {
      const int result = (this->*method)();
      status = result == READY ? READY : std::max(status, result);
    }
  };
  attempt(source == WINDOW || (automatic && this->Given), &vtkInternals::TryWindow);
  attempt(source == X || automatic, &vtkInternals::TryX);
  attempt(source == EGL || automatic, &vtkInternals::TryEGL);
  this->Self->Status = status;
  if (status == READY)
  {
    this->Reason.clear();
  }
  else
  {
    this->Reason +=
      " Install or choose an OpenGL driver with version 4.3 and double precision: a graphics "
      "card's own, or Mesa's llvmpipe (libgl1-mesa-dri, with libegl1 where there is no display).";
  }
  return status;
}

int vtkComputeContext::vtkInternals::TryWindow()
{
  static const char* const label = "Given window";
  if (!this->Given)
  {
    return this->Fail(label,
      this->WasGiven ? "it no longer exists; give another one" : "none was given; call SetWindow()",
      NO_CONTEXT);
  }
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(this->Given);
  if (!window)
  {
    return this->Fail(
      label, std::string(this->Given->GetClassName()) + " is not an OpenGL window", NO_CONTEXT);
  }
  const sm::ScopedErrorSilencer silencer(window);
  if (!sm::MakeWindowCurrent(window) && !this->WasOpened)
  {
    // An X window without a display would abort the process.
    if (window->IsA("vtkXOpenGLRenderWindow") && !window->GetGenericDisplayId())
    {
      const char* reason = "";
      void* display = sm::GetXDisplay(reason);
      if (!display)
      {
        return this->Fail(label, reason, NO_CONTEXT);
      }
      window->SetDisplayId(display);
    }
    window->Initialize();
    sm::MakeWindowCurrent(window);
  }
  if (!window->IsCurrent())
  {
    return this->Fail(label,
      this->WasOpened
        ? "it was closed; render into it again"
        : "its context cannot be made current; a vtkGenericOpenGLRenderWindow needs observers of "
          "WindowMakeCurrentEvent and WindowIsCurrentEvent",
      NO_CONTEXT);
  }
  if (!IsInitialized(window))
  {
    window->OpenGLInit();
  }
  if (!IsInitialized(window))
  {
    return this->Fail(label, "OpenGL could not be initialized. " + silencer.Text, NO_CONTEXT);
  }
  const int status = this->Use(window, "window", label);
  this->WasOpened = this->WasOpened || status == READY;
  return status;
}

int vtkComputeContext::vtkInternals::TryX()
{
  static const char* const label = "X display";
  const char* reason = "";
  void* display = sm::GetXDisplay(reason);
  if (!display)
  {
    return this->Fail(label, reason, NO_CONTEXT);
  }
  auto window = vtkSmartPointer<vtkOpenGLRenderWindow>::Take(sm::NewXWindow(display));
  int status = NO_CONTEXT;
  {
    const sm::ScopedErrorSilencer silencer(window);
    window->Initialize();
    if (!sm::MakeWindowCurrent(window) || !IsInitialized(window))
    {
      status = this->Fail(label, "no OpenGL 3.2 context could be made. " + silencer.Text, NO_CONTEXT);
    }
    else
    {
      this->Own = window;
      status = this->Use(window, "x", label);
    }
  }
  if (status != READY)
  {
    this->Own = nullptr;
  }
  return status;
}

int vtkComputeContext::vtkInternals::TryEGL()
{
  static const char* const label = "EGL";
  vtkNew<vtkEGLSurfacelessRenderWindow> window;
  window->SetMaximumVersion(this->MaximumVersion[0], this->MaximumVersion[1]);
  if (this->OnlyGPU && !vtkEGLSurfacelessRenderWindow::MayHaveGPU())
  {
    return this->Fail(label, "no device is a GPU", NO_CONTEXT);
  }
  if (!window->CreateContext())
  {
    return this->Fail(label, window->GetReason(), NO_CONTEXT);
  }
  int status = NO_CONTEXT;
  {
    const sm::ScopedErrorSilencer silencer(window);
    window->Initialize();
    if (!sm::MakeWindowCurrent(window) || !IsInitialized(window))
    {
      status = this->Fail(label, "OpenGL could not be initialized. " + silencer.Text, NO_CONTEXT);
    }
    else
    {
      this->Own = window;
      status = this->Use(window, "egl", label);
    }
  }
  if (status != READY)
  {
    this->Own = nullptr;
  }
  return status;
}

int vtkComputeContext::vtkInternals::Use(vtkOpenGLRenderWindow* window, const char* name, const char* label)
{
  sm::DrainErrors();
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  std::string limit;
  if (this->MaximumVersion[0] > 0 &&
    std::make_pair(major, minor) > std::make_pair(this->MaximumVersion[0], this->MaximumVersion[1]))
  {
    major = this->MaximumVersion[0];
    minor = this->MaximumVersion[1];
    limit = ", limited by SetMaximumVersion()";
  }
  const std::string renderer = GetString(GL_RENDERER);
  if (this->OnlyGPU && vtkEGLSurfacelessRenderWindow::IsSoftware(renderer))
  {
    return this->Fail(label, renderer + " is a software renderer", NO_CONTEXT);
  }
  if (std::make_pair(major, minor) < std::make_pair(4, 3) || !glDispatchCompute || !glGetInteger64i_v)
  {
    const char* forced = std::getenv("MESA_GL_VERSION_OVERRIDE");
    if (forced && *forced)
    {
      limit += std::string(", with MESA_GL_VERSION_OVERRIDE=") + forced + " in the environment";
    }
    return this->Fail(label,
      "OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " (" + renderer + ")" + limit +
        " has no compute shaders; they need OpenGL 4.3",
      NO_COMPUTE);
  }
  if (!HasExtension("GL_ARB_gpu_shader_fp64"))
  {
    return this->Fail(label, renderer + " has no double precision (GL_ARB_gpu_shader_fp64)", NO_DOUBLES);
  }

  this->Adopt(window);
  std::string complaint;
  bool& isProbed = this->Self->Resources->Window->HasRightDoubles;
  isProbed =
    isProbed || sm::ProbeConstructs(this->Self, this->Self->Resources->Window->FlushesSubnormals, complaint);
  if (!isProbed)
  {
    this->End(true, NO_DOUBLES);
    this->Detach();
    return this->Fail(label, renderer + " " + complaint, NO_DOUBLES);
  }
  this->Self->Resources->IsSoftware = vtkEGLSurfacelessRenderWindow::IsSoftware(renderer);
  this->Renderer = renderer;
  this->Version = GetString(GL_VERSION);
  this->SourceName = name;
  return READY;
}

void vtkComputeContext::vtkInternals::Adopt(vtkOpenGLRenderWindow* window)
{
  sm::ContextResources& resources = *this->Self->Resources;
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  resources.MaximumStorageBlockSize = bytes;
  GLint value = 0;
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &value);
  resources.StorageOffsetAlignment = std::max(value, 1);
  for (GLuint axis = 0; axis < 2; ++axis)
  {
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &value);
    resources.MaximumWorkGroupCount[axis] = value;
  }
  resources.Window = sm::WindowResources::Get(window);
  resources.Generation = sm::ContextResources::NewGeneration();
  this->Used = window;
  this->Self->Status = READY;
  sm::AddReadyContext(this->Self);
  this->Watch = vtkSmartPointer<sm::EndWatch>::New();
  this->Watch->OnEnd = [this](vtkWindow* ended)
  {
    vtkRenderWindow* renderWindow = vtkRenderWindow::SafeDownCast(ended);
    this->End(renderWindow && renderWindow->IsCurrent(), LOST);
  };
  this->Watch->SetContext(window);
  window->AddObserver(vtkCommand::DeleteEvent, this->Deleted);
}

void vtkComputeContext::vtkInternals::End(bool current, int status)
{
  if (this->Self->Status != READY)
  {
    return;
  }
  this->Self->Resources->End(current);
  this->Self->Status = status;
  sm::RemoveReadyContext(this->Self);
  this->Used->RemoveObserver(this->Deleted);
  this->Used = nullptr;
  this->Renderer.clear();
  this->Version.clear();
  this->SourceName = "";
  if (status == LOST)
  {
    this->Reason =
      "The window whose OpenGL context was used has closed. Start() tries to get another context.";
  }
}

/// Stops observing the window. Must not be called from the callback of the EndWatch.
void vtkComputeContext::vtkInternals::Detach()
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
void vtkComputeContext::vtkInternals::WindowIsDeleted()
{
  if (this->Used)
  {
    const sm::CurrentContext::Guard guard;
    this->End(sm::MakeWindowCurrent(this->Used), LOST);
    this->Detach();
  }
}
