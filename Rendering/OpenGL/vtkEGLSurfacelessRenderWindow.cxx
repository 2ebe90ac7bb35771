#include "vtkEGLSurfacelessRenderWindow.h"

#include "Detail/smCurrentContext.h"
#include "Detail/smLoader.h"
#include "smOpenGLLibrary.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Excludes the headers of X and their macros; no native platform is needed here.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace
{
bool HasWord(const char* words, const char* word)
{
  const std::size_t length = std::strlen(word);
  for (const char* at = words ? std::strstr(words, word) : nullptr; at; at = std::strstr(at + length, word))
  {
    if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
    {
      return true;
    }
  }
  return false;
}

struct Candidate
{
  EGLDisplay Display;
  const char* Label;
};

/// Collects the displays of all EGL devices, those with hardware and those with software renderers.
void GetDeviceDisplays(std::vector<Candidate>& hardware, std::vector<Candidate>& software)
{
  const auto queryDevices =
    reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto queryString =
    reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  const auto getDisplay =
    reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EGLint count = 0;
  if (!queryDevices || !queryString || !getDisplay || !queryDevices(0, nullptr, &count) || count <= 0)
  {
    return;
  }
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!queryDevices(count, devices.data(), &count))
  {
    return;
  }
  devices.resize(static_cast<std::size_t>(count));
  for (EGLDeviceEXT device : devices)
  {
    const bool soft = HasWord(queryString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    const EGLDisplay display = getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display != EGL_NO_DISPLAY)
    {
      (soft ? software : hardware).push_back({ display, soft ? "software device" : "device" });
    }
  }
}
}

class vtkEGLSurfacelessRenderWindow::vtkInternals
{
public:
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
  std::string Renderer;
  int MaximumVersion[2] = { 0, 0 };
  std::string Reason;
  std::vector<sm::CurrentContext> Stack;
  /// The context that was current before MakeCurrent().
  std::optional<sm::CurrentContext> Displaced;

  /// Makes the context on a display. On failure it adds the reason to Reason. The display is never
  /// terminated, because other code in the process may use it.
  bool Create(const Candidate& candidate);
  bool Fail(const Candidate& candidate, const char* what)
  {
    this->Reason += (this->Reason.empty() ? "" : "; ") + std::string(candidate.Label) + ": " + what;
    return false;
  }
  bool MakeCurrent() const
  {
    eglBindAPI(EGL_OPENGL_API);
    return eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Context) == EGL_TRUE;
  }
  void Destroy()
  {
    if (this->Context != EGL_NO_CONTEXT)
    {
      eglDestroyContext(this->Display, this->Context);
    }
    this->Context = EGL_NO_CONTEXT;
    this->Display = EGL_NO_DISPLAY;
  }
};

bool vtkEGLSurfacelessRenderWindow::vtkInternals::Create(const Candidate& candidate)
{
  EGLint eglMajor = 0;
  EGLint eglMinor = 0;
  if (!eglInitialize(candidate.Display, &eglMajor, &eglMinor))
  {
    return this->Fail(candidate, "cannot be initialized");
  }
  const char* extensions = eglQueryString(candidate.Display, EGL_EXTENSIONS);
  const bool modern = eglMajor > 1 || eglMinor >= 5;
  if (!HasWord(extensions, "EGL_KHR_surfaceless_context") ||
    !(modern || HasWord(extensions, "EGL_KHR_create_context")) || !eglBindAPI(EGL_OPENGL_API))
  {
    return this->Fail(candidate, "has no surfaceless OpenGL contexts");
  }
  EGLConfig configuration = nullptr; // EGL_NO_CONFIG_KHR
  if (!HasWord(extensions, "EGL_KHR_no_config_context"))
  {
    const EGLint wanted[] = { EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
      EGL_NONE };
    EGLint count = 0;
    if (!eglChooseConfig(candidate.Display, wanted, &configuration, 1, &count) || count == 0)
    {
      return this->Fail(candidate, "has no configuration for OpenGL");
    }
  }
  static const std::pair<int, int> versions[] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 }, { 4, 1 },
    { 4, 0 }, { 3, 3 }, { 3, 2 } };
  const std::pair<int, int> maximum(this->MaximumVersion[0], this->MaximumVersion[1]);
  for (const std::pair<int, int>& version : versions)
  {
    if (maximum.first > 0 && version > maximum)
    {
      continue;
    }
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version.first, EGL_CONTEXT_MINOR_VERSION,
      version.second, EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    this->Context = eglCreateContext(candidate.Display, configuration, EGL_NO_CONTEXT, attributes);
    if (this->Context != EGL_NO_CONTEXT)
    {
      break;
    }
  }
  if (this->Context == EGL_NO_CONTEXT)
  {
    return this->Fail(candidate, "makes no OpenGL core context");
  }
  this->Display = candidate.Display;
  if (!this->MakeCurrent())
  {
    this->Destroy();
    return this->Fail(candidate, "its context cannot be made current");
  }
  // OpenGL's functions are not loaded yet.
  const auto getString = reinterpret_cast<const GLubyte* (*)(GLenum)>(eglGetProcAddress("glGetString"));
  const GLubyte* renderer = getString ? getString(GL_RENDERER) : nullptr;
  this->Renderer = renderer ? reinterpret_cast<const char*>(renderer) : "";
  sm::CurrentContext::ReleaseEGL();
  return true;
}

vtkStandardNewMacro(vtkEGLSurfacelessRenderWindow);

vtkEGLSurfacelessRenderWindow::vtkEGLSurfacelessRenderWindow()
  : Internals(new vtkInternals)
{
  // There is no framebuffer 0 to blit to.
  this->FrameBlitMode = NoBlit;
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->MultiSamples = 0;
  this->DirectStatus = 1;
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
}

vtkEGLSurfacelessRenderWindow::~vtkEGLSurfacelessRenderWindow()
{
  this->Finalize();
  // The destructor of the superclass finalizes again; the renderers must not refer to this window then.
  vtkRenderer* renderer = nullptr;
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while ((renderer = this->Renderers->GetNextRenderer(iterator)))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

void vtkEGLSurfacelessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << this->Internals->Context << "\n"
     << indent << "Renderer: " << this->Internals->Renderer << "\n"
     << indent << "MaximumVersion: " << this->Internals->MaximumVersion[0] << " "
     << this->Internals->MaximumVersion[1] << "\n"
     << indent << "Reason: " << this->Internals->Reason << "\n";
}

void vtkEGLSurfacelessRenderWindow::SetMaximumVersion(int major, int minor)
{
  if (this->Internals->MaximumVersion[0] != major || this->Internals->MaximumVersion[1] != minor)
  {
    this->Internals->MaximumVersion[0] = major;
    this->Internals->MaximumVersion[1] = minor;
    this->Modified();
  }
}

std::string vtkEGLSurfacelessRenderWindow::GetReason()
{
  return this->Internals->Reason;
}

bool vtkEGLSurfacelessRenderWindow::IsSoftware(const std::string& renderer)
{
  return sm::IsSoftwareRenderer(renderer);
}

bool vtkEGLSurfacelessRenderWindow::MayHaveGPU()
{
  if (!HasWord(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_platform_device"))
  {
    return true;
  }
  std::vector<Candidate> hardware;
  std::vector<Candidate> software;
  GetDeviceDisplays(hardware, software);
  return !hardware.empty();
}

bool vtkEGLSurfacelessRenderWindow::CreateContext()
{
  vtkInternals& internals = *this->Internals;
  if (internals.Context != EGL_NO_CONTEXT)
  {
    return true;
  }
  internals.Reason.clear();
  const char* clientExtensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto getDisplay =
    reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!HasWord(clientExtensions, "EGL_EXT_platform_base") || !getDisplay)
  {
    internals.Reason = "this EGL library has no platforms";
    return false;
  }
  const sm::CurrentContext::Guard guard;
  sm::CurrentContext::ReleaseGLX();

  const Candidate surfaceless = { HasWord(clientExtensions, "EGL_MESA_platform_surfaceless")
      ? getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
      : EGL_NO_DISPLAY,
    "surfaceless platform" };
  const bool made = surfaceless.Display != EGL_NO_DISPLAY && internals.Create(surfaceless);
  const char* forced = std::getenv("LIBGL_ALWAYS_SOFTWARE");
  const bool wantSoftware =
    forced && *forced && std::strcmp(forced, "0") != 0 && std::strcmp(forced, "false") != 0;
  if (made && (wantSoftware || !IsSoftware(internals.Renderer)))
  {
    return true;
  }

  std::vector<Candidate> hardware;
  std::vector<Candidate> software;
  if (HasWord(clientExtensions, "EGL_EXT_platform_device"))
  {
    GetDeviceDisplays(hardware, software);
  }
  if (made)
  {
    // There is already a software context, so only hardware devices are tried.
    software.clear();
  }
  vtkInternals present = internals;
  hardware.insert(hardware.end(), software.begin(), software.end());
  for (const Candidate& candidate : hardware)
  {
    internals.Context = EGL_NO_CONTEXT;
    if (internals.Create(candidate) && !(made && IsSoftware(internals.Renderer)))
    {
      present.Destroy();
      internals.Reason.clear();
      return true;
    }
    internals.Destroy();
  }
  internals.Context = present.Context;
  internals.Display = present.Display;
  internals.Renderer = present.Renderer;
  if (made)
  {
    internals.Reason.clear();
  }
  else if (internals.Reason.empty())
  {
    internals.Reason = "EGL has neither the surfaceless platform nor devices";
  }
  return made;
}

void vtkEGLSurfacelessRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized || !this->IsCurrent())
  {
    return;
  }
  const std::string problem = sm::LoadOpenGL(eglGetProcAddress);
#ifdef SM_HAS_GLEW
  this->GlewInitValid = problem.empty();
#endif
  for (int i = 0; problem.empty() && i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
  if (!problem.empty())
  {
    vtkErrorMacro("The OpenGL loader failed ("
      << problem << "). Check the OpenGL driver that EGL chose: " << this->Internals->Renderer << ".");
    return;
  }
  this->Initialized = true;
  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = glGetError() == GL_NO_ERROR ? range[1] : 1.0f;
}

void vtkEGLSurfacelessRenderWindow::Initialize()
{
  if (!this->Initialized && this->CreateContext())
  {
    const sm::CurrentContext::Guard guard;
    this->MakeCurrent();
    this->OpenGLInit();
  }
}

void vtkEGLSurfacelessRenderWindow::Finalize()
{
  if (this->Internals->Context == EGL_NO_CONTEXT)
  {
    return;
  }
  this->ReleaseGraphicsResources(this);
  if (this->IsCurrent())
  {
    this->ReleaseCurrent();
  }
  this->Internals->Destroy();
  this->Initialized = false;
}

void vtkEGLSurfacelessRenderWindow::Render()
{
  const sm::CurrentContext::Guard guard;
  this->Initialize();
  if (!this->Initialized)
  {
    vtkErrorMacro("Nothing can be rendered without an OpenGL context: " << this->Internals->Reason
                                                                        << ". Install an EGL driver.");
    return;
  }
  this->Superclass::Render();
}

int vtkEGLSurfacelessRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  const int result = this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right);
  // Code that reads pixels calls MakeCurrent() first (vtkWindowToImageFilter), and does not restore the
  // previous context afterwards.
  if (sm::GetOpenScopes() == 0 && this->Internals->Displaced)
  {
    this->Internals->Displaced->Restore();
    this->Internals->Displaced.reset();
  }
  return result;
}

void vtkEGLSurfacelessRenderWindow::MakeCurrent()
{
  if (this->Internals->Context != EGL_NO_CONTEXT && !this->IsCurrent())
  {
    this->Internals->Displaced.emplace();
    sm::CurrentContext::ReleaseGLX();
    this->Internals->MakeCurrent();
  }
}

bool vtkEGLSurfacelessRenderWindow::IsCurrent()
{
  return this->Internals->Context != EGL_NO_CONTEXT && eglGetCurrentContext() == this->Internals->Context;
}

void vtkEGLSurfacelessRenderWindow::ReleaseCurrent()
{
  if (this->IsCurrent())
  {
    sm::CurrentContext::ReleaseEGL();
    this->Internals->Displaced.reset();
  }
}

void vtkEGLSurfacelessRenderWindow::PushContext()
{
  this->Internals->Stack.emplace_back();
  this->MakeCurrent();
}

void vtkEGLSurfacelessRenderWindow::PopContext()
{
  if (!this->Internals->Stack.empty())
  {
    this->Internals->Stack.back().Restore();
    this->Internals->Stack.pop_back();
  }
}

int vtkEGLSurfacelessRenderWindow::SupportsOpenGL()
{
  return this->CreateContext() ? 1 : 0;
}

vtkTypeBool vtkEGLSurfacelessRenderWindow::IsDirect()
{
  return 1;
}

int vtkEGLSurfacelessRenderWindow::GetColorBufferSizes(int* rgba)
{
  // Sizes of the colour components of VTK's own framebuffers. A surfaceless context has no framebuffer 0 that
  // could be queried.
  if (!rgba)
  {
    return 0;
  }
  for (int i = 0; i < 4; ++i)
  {
    rgba[i] = 8;
  }
  return 32;
}

int vtkEGLSurfacelessRenderWindow::GetDepthBufferSize()
{
  // Likewise. VTK needs the number of depth bits for the clipping range of a camera, also before the first
  // picture, and would query framebuffer 0.
  return 32;
}

void* vtkEGLSurfacelessRenderWindow::GetGenericContext()
{
  return this->Internals->Context;
}
