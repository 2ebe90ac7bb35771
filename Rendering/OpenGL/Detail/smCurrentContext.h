/**
 * @file smCurrentContext.h
 * @brief The GLX or EGL context that is current on the thread, saved and restored; not installed
 */
#ifndef smCurrentContext_h
#define smCurrentContext_h

#include "smRenderingOpenGLModule.h"

class vtkOpenGLRenderWindow;

namespace sm
{
/// Saves the thread's current context of either kind, with display, drawables and EGL's API. X and EGL types
/// are kept as plain pointers and numbers, because their headers define macros such as `None` and `Status`.
class CurrentContext
{
public:
  CurrentContext();

  /// Makes the saved context current again, or none if there was none. Does nothing if it still is current.
  /// Returns false if it could not be made current, for example because it was destroyed meanwhile.
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

/// Makes the window's context current. Releases a current context of the other kind (GLX or EGL) first.
bool MakeWindowCurrent(vtkOpenGLRenderWindow* window);

/// Returns the function of OpenGL, for example glBindBuffer(), for contexts of either kind.
void* GetOpenGLFunction(const char* name);

/// Makes an X window on the display of GetXDisplay(), which is closed and never shown.
vtkOpenGLRenderWindow* NewXWindow(void* display);

/// The process's own connection to the X display, opened at the first call and never closed: an X server that
/// resets when its last client leaves would disconnect the next one. Returns null, with a reason, if there is
/// no display or it has no GLX with a usable configuration; the next call tries again. Thread safe.
SMRENDERINGOPENGL_EXPORT void* GetXDisplay(const char*& reason);
}

#endif
