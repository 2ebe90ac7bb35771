/**
 * @file smCurrentContext.h
 * @brief The GLX or EGL context that is current on the thread, saved and restored; not installed
 */
#ifndef smCurrentContext_h
#define smCurrentContext_h

#include "smRenderingComputeModule.h"

class vtkOpenGLRenderWindow;

namespace sm
{
/// Saves the thread's current context of either kind, with display, drawables and EGL's API. X and EGL types
/// are kept as plain pointers and numbers, for their headers define macros like `None` and `Status`.
class CurrentContext
{
public:
  CurrentContext();

  /// Makes it current again, or nothing when nothing was. Cheap when it is still current. False when the
  /// context could not be made current, e.g. because it was destroyed meanwhile.
  bool Restore() const;

  /// Restores `saved` at the end of a scope.
  class Guard;

  static void ReleaseGLX();
  static void ReleaseEGL();

private:
  void* GLXCurrentContext;
  void* GLXCurrentDisplay;
  unsigned long GLXCurrentDraw;
  unsigned long GLXCurrentRead;
  unsigned int EGLCurrentApi;
  void* EGLCurrentContext;
  void* EGLCurrentDisplay;
  void* EGLCurrentDraw;
  void* EGLCurrentRead;
};

class CurrentContext::Guard
{
public:
  Guard() = default;
  ~Guard() { this->Saved.Restore(); }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

private:
  CurrentContext Saved;
};

/// Number of ContextScopes open on this thread.
int& GetOpenScopes();

/// Makes the window's context current, releasing a context of the other kind when that stands in the way.
bool MakeWindowCurrent(vtkOpenGLRenderWindow* window);

/// A new X window, closed and never shown, on the display of GetXDisplay().
vtkOpenGLRenderWindow* NewXWindow(void* display);

/// The process's own connection to the X display, opened at the first call and never closed: a server that
/// resets with its last client would take down the next one. Null with a reason when there is no display or it
/// has no GLX with a usable configuration; a failure is tried anew at the next call. Thread safe.
SMRENDERINGCOMPUTE_EXPORT void* GetXDisplay(const char*& reason);
}

#endif
