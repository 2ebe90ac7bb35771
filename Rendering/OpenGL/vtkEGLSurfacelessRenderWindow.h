/**
 * @class   vtkEGLSurfacelessRenderWindow
 * @brief   a render window that needs no display: surfaceless EGL
 *
 * Renders into VTK's own framebuffers; vtkWindowToImageFilter reads them back. The context is an OpenGL core
 * profile of the highest version the driver has, from 4.6 down to 3.2. Mesa's surfaceless platform is
 * tried first. When that is a software renderer, or absent, the EGL devices with a hardware driver are
 * tried, unless LIBGL_ALWAYS_SOFTWARE is set; then the remaining devices.
 *
 * The class needs no X server and no windowing library, and it stands in for vtkEGLRenderWindow,
 * which Debian's VTK lacks.
 *
 * GLX and EGL exclude each other on a thread: an X window that makes its context current while an EGL context
 * is current ends the process with an X error. So MakeCurrent() releases a current GLX context first, and
 * Initialize(), Render() and reading pixels (also after MakeCurrent(), as vtkWindowToImageFilter does)
 * restore what was current before. Other callers of MakeCurrent() in programs with X windows must call
 * ReleaseCurrent() afterwards, or use sm::ContextScope.
 *
 * Not thread safe.
 */
#ifndef vtkEGLSurfacelessRenderWindow_h
#define vtkEGLSurfacelessRenderWindow_h

#include "smRenderingOpenGLModule.h"
#include "vtkGenericOpenGLRenderWindow.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class SMRENDERINGOPENGL_EXPORT vtkEGLSurfacelessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkEGLSurfacelessRenderWindow* New();
  vtkTypeMacro(vtkEGLSurfacelessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Returns true if EGL lists a device of a GPU, or cannot list devices. Makes no context. */
  static bool MayHaveGPU();

  /** Returns true if `renderer`, a GL_RENDERER string, is a known software renderer, for example Mesa's
   * llvmpipe. */
  static bool IsSoftware(const std::string& renderer);

  /** Requests at most this OpenGL version. Default: 0 0, the highest. Read when the context is made. A driver
   * may give a later, compatible version. */
  void SetMaximumVersion(int major, int minor);

  /**
   * Makes the context unless there is one. Returns false, with GetReason(), if that fails. Never prints. Does
   * not make the context current.
   */
  bool CreateContext();

  /** Returns the reason why CreateContext() failed; empty if it did not. */
  std::string GetReason();

  void Initialize() override;
  void Finalize() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void ReleaseCurrent() override;
  void PushContext() override;
  void PopContext() override;
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  int GetColorBufferSizes(int* rgba) override;
  int GetDepthBufferSize() override;
  void OpenGLInitContext() override;
  /** The EGLContext, null when there is none. */
  void* GetGenericContext() override;

protected:
  int ReadPixels(const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right) override;

  vtkEGLSurfacelessRenderWindow();
  ~vtkEGLSurfacelessRenderWindow() override;

private:
  vtkEGLSurfacelessRenderWindow(const vtkEGLSurfacelessRenderWindow&) = delete;
  void operator=(const vtkEGLSurfacelessRenderWindow&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
