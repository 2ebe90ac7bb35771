#include "Detail/smCurrentContext.h"

#include "vtkObjectFactory.h"

#include <mutex>

// Included last, because X defines common words as macros.
#include "vtkXOpenGLRenderWindow.h"
#include <EGL/egl.h>
#include <GL/glx.h>

namespace
{
/// A window on a display that stays open: VTK leaves its colour map and its last events to the end of the
/// connection.
class OwnXWindow : public vtkXOpenGLRenderWindow
{
public:
  static OwnXWindow* New();
  vtkTypeMacro(OwnXWindow, vtkXOpenGLRenderWindow);

protected:
  OwnXWindow() = default;
  ~OwnXWindow() override { this->Finalize(); }

  void DestroyWindow() override
  {
    Window ended = this->WindowId;
    // Read before the superclass resets them.
    Display* const display = this->DisplayId;
    const Colormap colors = this->ColorMap;
    this->Superclass::DestroyWindow();
    if (!ended || !display)
    {
      return;
    }
    if (colors)
    {
      XFreeColormap(display, colors);
      this->ColorMap = 0;
    }
    // Removes the events of this window from the queue, which nothing else reads. Events of other windows on
    // this connection remain.
    XSync(display, False);
    XEvent event;
    const auto isOfWindow = [](Display*, XEvent* of, XPointer window) -> Bool
    { return of->xany.window == *reinterpret_cast<Window*>(window) ? True : False; };
    while (XCheckIfEvent(display, &event, isOfWindow, reinterpret_cast<XPointer>(&ended)))
    {
    }
  }

private:
  OwnXWindow(const OwnXWindow&) = delete;
  void operator=(const OwnXWindow&) = delete;
};
vtkStandardNewMacro(OwnXWindow);
}

namespace sm
{
CurrentContext::CurrentContext()
  : GLXCurrentContext(glXGetCurrentContext())
  , GLXCurrentDisplay(glXGetCurrentDisplay())
  , GLXCurrentDraw(glXGetCurrentDrawable())
  , GLXCurrentRead(glXGetCurrentReadDrawable())
  , EGLCurrentApi(eglQueryAPI())
  , EGLCurrentContext(eglGetCurrentContext())
  , EGLCurrentDisplay(eglGetCurrentDisplay())
  , EGLCurrentDraw(eglGetCurrentSurface(EGL_DRAW))
  , EGLCurrentRead(eglGetCurrentSurface(EGL_READ))
{
}

bool CurrentContext::Restore() const
{
  bool done = true;
  if (eglGetCurrentContext() != this->EGLCurrentContext && !this->EGLCurrentContext)
  {
    ReleaseEGL();
  }
  if (this->GLXCurrentContext)
  {
    if (glXGetCurrentContext() != this->GLXCurrentContext ||
      glXGetCurrentDrawable() != this->GLXCurrentDraw || glXGetCurrentReadDrawable() != this->GLXCurrentRead)
    {
      ReleaseEGL();
      done = glXMakeContextCurrent(static_cast<Display*>(this->GLXCurrentDisplay), this->GLXCurrentDraw,
        this->GLXCurrentRead, static_cast<GLXContext>(this->GLXCurrentContext));
    }
  }
  else
  {
    ReleaseGLX();
  }
  if (this->EGLCurrentApi != EGL_NONE)
  {
    eglBindAPI(this->EGLCurrentApi);
  }
  if (this->EGLCurrentContext &&
    (eglGetCurrentContext() != this->EGLCurrentContext ||
      eglGetCurrentSurface(EGL_DRAW) != this->EGLCurrentDraw ||
      eglGetCurrentSurface(EGL_READ) != this->EGLCurrentRead))
  {
    done = eglMakeCurrent(this->EGLCurrentDisplay, this->EGLCurrentDraw, this->EGLCurrentRead,
             this->EGLCurrentContext) == EGL_TRUE;
  }
  return done;
}

void CurrentContext::ReleaseGLX()
{
  if (glXGetCurrentContext())
  {
    glXMakeContextCurrent(glXGetCurrentDisplay(), None, None, nullptr);
  }
}

void CurrentContext::ReleaseEGL()
{
  if (eglGetCurrentContext() != EGL_NO_CONTEXT)
  {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

void* GetOpenGLFunction(const char* name)
{
  auto function = glXGetProcAddress(reinterpret_cast<const GLubyte*>(name));
  function = function ? function : eglGetProcAddress(name);
  return reinterpret_cast<void*>(function);
}

bool MakeWindowCurrent(vtkOpenGLRenderWindow* window)
{
  if (window->IsCurrent())
  {
    return true;
  }
  // glXMakeCurrent() while an EGL context is current causes an X error, which ends the process.
  // eglMakeCurrent() while a GLX context is current only fails.
  CurrentContext::ReleaseEGL();
  window->MakeCurrent();
  if (!window->IsCurrent())
  {
    CurrentContext::ReleaseGLX();
    window->MakeCurrent();
  }
  return window->IsCurrent();
}

vtkOpenGLRenderWindow* NewXWindow(void* display)
{
  OwnXWindow* window = OwnXWindow::New();
  window->SetDisplayId(display);
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  return window;
}

namespace
{
/// Opens the X display. Returns null, with a reason, if there is no display or its GLX has no usable
/// configuration.
Display* OpenDisplayWithGLX(const char*& reason)
{
  Display* opened = XOpenDisplay(nullptr);
  if (!opened)
  {
    reason = "no X display could be opened";
    return nullptr;
  }
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (!XQueryExtension(opened, "GLX", &opcode, &event, &error))
  {
    XCloseDisplay(opened);
    reason = "the X server has no GLX";
    return nullptr;
  }
  // The minimum configuration that vtkXOpenGLRenderWindow accepts; without one it aborts the process.
  static const int wanted[] = { GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT, GLX_RENDER_TYPE, GLX_RGBA_BIT,
    GLX_RED_SIZE, 1, GLX_GREEN_SIZE, 1, GLX_BLUE_SIZE, 1, GLX_ALPHA_SIZE, 1, GLX_DEPTH_SIZE, 1, None };
  int count = 0;
  GLXFBConfig* configurations = glXChooseFBConfig(opened, DefaultScreen(opened), wanted, &count);
  if (configurations)
  {
    XFree(configurations);
  }
  if (count == 0)
  {
    XCloseDisplay(opened);
    reason = "the X server's GLX has no usable configuration";
    return nullptr;
  }
  return opened;
}
}

void* GetXDisplay(const char*& reason)
{
  // Contexts of several threads may ask at the same time.
  static std::mutex mutex;
  static Display* display = nullptr;
  const std::lock_guard<std::mutex> lock(mutex);
  display = display ? display : OpenDisplayWithGLX(reason);
  return display;
}
}
