/**
 * @file smOpenGLLibrary.h
 * @brief What the library smRenderingOpenGL does for compute contexts; not installed
 *
 * OpenGL and VTK's classes for it bring some 50 other libraries. Few runs need them, so that this module does
 * not link them: GetOpenGLLibrary() loads the library at the first call, when a context is started. It is of
 * the same version of SolidMoments and VTK.
 */
#ifndef smOpenGLLibrary_h
#define smOpenGLLibrary_h

#include "smRenderingComputeModule.h"

#include "vtkVersionMacros.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>

class vtkComputeContext;
class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace sm
{
struct ContextResources;

/// The settings and the state of a vtkComputeContext, which its WindowSource changes.
struct ContextState
{
  vtkComputeContext* Context = nullptr;
  std::shared_ptr<ContextResources> Resources;
  int Source = 0;
  int Status = 0;
  vtkWeakPointer<vtkRenderWindow> Given;
  bool WasGiven = false;
  /// True after the given window was READY once; a window that was closed since is not opened again.
  bool WasOpened = false;
  int MaximumVersion[2] = { 0, 0 };
  /// The window in use while READY. It never dangles, because the source resets it before the window is
  /// destroyed.
  vtkOpenGLRenderWindow* Used = nullptr;
  std::string Reason;
  std::string Renderer;
  std::string Version;
  const char* SourceName = "";
};

/// Gets an OpenGL window for one context, and observes its end.
class WindowSource
{
public:
  virtual ~WindowSource() = default;
  /// Makes a context and sets the status to READY, or to the highest status of all attempts. Returns the
  /// status. With `onlyGPU` contexts of software renderers are not accepted.
  virtual int Search(bool onlyGPU) = 0;
  /// Frees everything made in the context, and releases the window.
  virtual void Stop() = 0;
};

/// A scope in which a context is current; its destructor ends it.
class WindowScope
{
public:
  virtual ~WindowScope() = default;
};

class OpenGLLibrary
{
public:
  virtual ~OpenGLLibrary() = default;
  /// Returns true if EGL lists a device of a GPU, or cannot list devices.
  virtual bool MayHaveGPU() = 0;
  /// `state` outlives the source.
  virtual std::unique_ptr<WindowSource> NewSource(ContextState& state) = 0;
  /// Returns null, and changes nothing, if the context is not READY or cannot be made current.
  virtual std::unique_ptr<WindowScope> EnterScope(vtkComputeContext* context) = 0;
};

/// The name of the library's LibraryEntryFunction (smOnDemandLibrary.h), whose content is an OpenGLLibrary.
constexpr const char* OpenGLEntryName = "smGetOpenGLEntry";
#define SM_OPENGL_LIBRARY_VERSION SOLIDMOMENTS_VERSION " for VTK " VTK_VERSION

/// Returns the library, with an empty reason; null, with the reason in sentences for users, if it cannot be
/// loaded. Loads it at the first call, and tries anew after a failure. It is never unloaded. Thread safe.
SMRENDERINGCOMPUTE_EXPORT OpenGLLibrary* GetOpenGLLibrary(std::string& reason);

/// Returns true if `renderer`, a GL_RENDERER string, is a known software renderer, for example Mesa's
/// llvmpipe.
SMRENDERINGCOMPUTE_EXPORT bool IsSoftwareRenderer(const std::string& renderer);

/// Number of ContextScopes open on this thread.
SMRENDERINGCOMPUTE_EXPORT int& GetOpenScopes();
}

#endif
