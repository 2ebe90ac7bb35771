/**
 * @class   vtkComputeContext
 * @brief   one OpenGL context in which compute shaders in double precision run
 *
 * The context is that of a given vtkRenderWindow, so that results can stay where a renderer uses them, or one
 * of its own: on the X display, or without any display by surfaceless EGL. Start() makes it. If there is
 * none, the reason is a status, and nothing is printed or aborted. OpenGL is not linked: the first Start() of
 * the process loads the library smRenderingOpenGL, which lies next to this module's; without it there is no
 * context.
 *
 * Everything of this module that owns a GL name (sm::ComputeBuffer, sm::ComputeProgram) is tied to a context
 * and to its generation. When the window ends, is finalized or releases its resources, the context frees
 * the names while they can be freed, the status becomes LOST and the generation changes: objects of
 * the old generation have no content. Objects may be released in any order.
 *
 * A given window is referenced weakly, so a filter that holds a context inside that window's pipeline makes
 * no reference loop.
 *
 * When the process exits by the thread that started a context, the context is stopped before OpenGL's driver
 * ends, so that its owner may be a static object or be never destroyed.
 *
 * Not thread safe: a context is used by one thread at a time, and a window's by the thread that renders.
 *
 * @sa sm::ContextScope
 */
#ifndef vtkComputeContext_h
#define vtkComputeContext_h

#include "smRenderingComputeModule.h"
#include "vtkObject.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace sm
{
struct ContextResources;
}

class SMRENDERINGCOMPUTE_EXPORT vtkComputeContext : public vtkObject
{
public:
  static vtkComputeContext* New();
  vtkTypeMacro(vtkComputeContext, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The source of the context. AUTOMATIC tries the given window, then an own context on the X display, then
   * surfaceless EGL, of a GPU before a software renderer's, and uses the first that has OpenGL 4.3 with
   * double precision. If none has, the status is the highest one of all attempts, in the order NO_CONTEXT,
   * NO_COMPUTE, NO_DOUBLES. */
  enum SourceType
  {
    AUTOMATIC = 0,
    WINDOW = 1,
    X = 2,
    EGL = 3
  };

  enum StatusType
  {
    NOT_STARTED = 0, ///< Start() was not called since the source was set
    READY = 1,       ///< usable
    NO_CONTEXT = 2,  ///< no OpenGL context could be made or made current
    NO_COMPUTE = 3,  ///< OpenGL below 4.3: no compute shaders
    NO_DOUBLES = 4,  ///< no arithmetic in double precision, or a wrong one
    LOST = 5         ///< was READY, then its window ended; Start() tries anew
  };

  /** Invoked by filters before they compile shaders, which takes seconds where the driver does not have them
   * from an earlier run. */
  enum EventType
  {
    COMPILE_EVENT = 1001 // above vtkCommand::UserEvent
  };

  ///@{
  /** The wanted source. Default: AUTOMATIC. Values outside the enumeration are clamped. A change ends the
   * present context. */
  void SetSource(int source);
  virtual int GetSource();
  ///@}

  ///@{
  /** The window whose context is to be used, or null (default). Held weakly. AUTOMATIC and WINDOW use it; X
   * and EGL ignore it. A window that was never opened is opened by Start(); one that was finalized is not
   * opened again: then AUTOMATIC takes an own context, WINDOW reports NO_CONTEXT. A
   * vtkGenericOpenGLRenderWindow must be able to make its context current. A change ends the present context.
   */
  void SetWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetWindow();
  ///@}

  /** Treats contexts as if they had at most this OpenGL version, for tests of what happens on old drivers:
   * an own EGL context is requested with it, others are compared with it. Default: 0 0, no limit. A
   * change ends the present context. */
  void SetMaximumVersion(int major, int minor);

  /** Makes the context if there is none and returns the status. Cheap when READY; any other status is tried
   * anew. Leaves the thread's current context as it was. Never aborts, never prints. */
  int Start();

  /**
   * Like Start(), but never makes a context of a software renderer: returns whether the context is READY and
   * that of a GPU. A negative result is kept until source, window or version change.
   */
  bool StartOnGPU();

  /** Frees everything made in the context and releases it; the status becomes NOT_STARTED. */
  void Stop();

  /** The present status; never tries to make a context. */
  virtual int GetStatus();
  /** "not-started", "ready", "no-context", "no-compute", "no-doubles" or "lost". */
  const char* GetStatusAsString();

  /** Returns sentences for users: the sources that were tried, why each failed, and remedies. Empty when
   * READY. */
  std::string GetReason();

  /** GL_RENDERER of the context, empty when not READY. */
  std::string GetRenderer();
  /** GL_VERSION of the context, empty when not READY. */
  std::string GetVersionString();
  /** "window", "x" or "egl"; empty when not READY. */
  std::string GetSourceName();

  /** The window whose context is used: the given one or an own one that shows nothing; null when not READY.
   * The own EGL one can render a scene off screen. */
  vtkOpenGLRenderWindow* GetRenderWindow();

  /** Identifies the GL context within the process. 0 when not READY. Changes when the context ended:
   * GL names of another generation no longer exist. */
  vtkTypeUInt64 GetGeneration();

  /** True if the context is that of a software renderer (llvmpipe, SwiftShader, ...) by its name. */
  bool IsSoftware();

  /** True if the driver takes subnormal numbers (below 2.3e-308) for 0, as GLSL allows and Mesa 26.1's
   * llvmpipe does: an operation is then off by up to so much. False when not READY. */
  bool FlushesSubnormals();

  ///@{
  /** Limits of the context: bytes of a shader storage block, alignment in bytes of a bound range's offset,
   * and work groups along one axis of a dispatch. 0 when not READY. */
  vtkTypeInt64 GetMaximumStorageBlockSize();
  int GetStorageOffsetAlignment();
  int GetMaximumWorkGroupCount();
  ///@}

  ///@{
  /**
   * Bytes of GPU memory that the buffers of this module hold in the OpenGL context now, and the largest value
   * since its first use. Contexts of the same window share the OpenGL context, and each reports the sum. 0
   * when not READY.
   */
  vtkTypeInt64 GetAllocatedBytes();
  vtkTypeInt64 GetPeakAllocatedBytes();
  ///@}

  ///@{
  /** Dispatches since the context object was made or the counters were reset. */
  vtkTypeUInt64 GetNumberOfDispatches();
  void ResetCounters();
  ///@}

#ifndef __VTK_WRAP__
  /** State shared with the buffers and programs made in the context. For this module's own classes. */
  const std::shared_ptr<sm::ContextResources>& GetResources() const
  {
    return this->Resources;
  }
#endif

protected:
  vtkComputeContext();
  ~vtkComputeContext() override;

private:
  vtkComputeContext(const vtkComputeContext&) = delete;
  void operator=(const vtkComputeContext&) = delete;

  class vtkInternals;

  std::shared_ptr<sm::ContextResources> Resources;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
