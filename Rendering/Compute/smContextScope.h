/**
 * @file smContextScope.h
 * @brief A scope in which a compute context is current; at its end the previous context and bindings are
 * restored
 */
#ifndef smContextScope_h
#define smContextScope_h

#include "smRenderingComputeModule.h"

#include <memory>

class vtkComputeContext;

namespace sm
{
class WindowScope;

/**
 * Makes the context current for the life of the object, whatever is current on the thread: a GLX context, an
 * EGL context or none, for a filter's Update() may run in the middle of another window's Render().
 *
 * Saved on entry and restored at the end: the current context with its drawables and its API; within our
 * context the current program (VTK's shader cache knows it again too), the indexed shader storage
 * bindings 0 to 7, the generic shader storage, uniform, copy-read, copy-write and dispatch-indirect
 * bindings. Of these the bindings are not restored in a window that the context made for itself, unless the
 * scope is inside another one. Compute code must not change any other state.
 *
 * Inside the scope of an EGL context no X window may render or be deleted: VTK would make its GLX context
 * current in addition to the EGL context, which is an X error that ends the process. Scopes nest, of one
 * context or of several. The context may end inside the scope; then the previous context is restored all the
 * same.
 */
class SMRENDERINGCOMPUTE_EXPORT ContextScope
{
public:
  /** `context` must be READY (call Start() before), or the scope is false and changes nothing. */
  explicit ContextScope(vtkComputeContext* context);
  ~ContextScope();
  ContextScope(const ContextScope&) = delete;
  ContextScope& operator=(const ContextScope&) = delete;

  /** True when the context was made current. */
  explicit operator bool() const;

  /** True when this thread is inside a scope of `context`, or of another one of the same window, and its
   * OpenGL context is current. */
  static bool IsInside(vtkComputeContext* context);

private:
  std::unique_ptr<WindowScope> Entered;
};
}

#endif
