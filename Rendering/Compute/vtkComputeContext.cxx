#include "vtkComputeContext.h"

#include "smContextResources.h"
#include "smOpenGLLibrary.h"
#include "smWindowResources.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

vtkStandardNewMacro(vtkComputeContext);

class vtkComputeContext::vtkInternals
{
public:
  sm::ContextState State;
  /// Null before the first Start(), and without the library for OpenGL.
  std::unique_ptr<sm::WindowSource> Windows;
  /// Modification time of the context with which no GPU was found.
  vtkMTimeType FoundNoGPU = 0;

  /// Returns the library for OpenGL, or null with a reason in the state.
  sm::OpenGLLibrary* GetLibrary()
  {
    std::string reason;
    sm::OpenGLLibrary* const library = sm::GetOpenGLLibrary(reason);
    if (!library)
    {
      this->State.Status = NO_CONTEXT;
      this->State.Reason = reason;
    }
    else if (!this->Windows)
    {
      this->Windows = library->NewSource(this->State);
    }
    return library;
  }

  int Search(bool onlyGPU)
  {
    return this->GetLibrary() ? this->Windows->Search(onlyGPU) : this->State.Status;
  }
};

vtkComputeContext::vtkComputeContext()
  : Resources(std::make_shared<sm::ContextResources>())
  , Internals(new vtkInternals)
{
  this->Resources->Context = this;
  this->Internals->State.Context = this;
  this->Internals->State.Resources = this->Resources;
}

vtkComputeContext::~vtkComputeContext()
{
  this->Stop();
  this->Resources->Context = nullptr;
}

void vtkComputeContext::PrintSelf(ostream& os, vtkIndent indent)
{
  const sm::ContextState& state = this->Internals->State;
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << state.Source << "\n"
     << indent << "Status: " << this->GetStatusAsString() << "\n"
     << indent << "Reason: " << state.Reason << "\n"
     << indent << "SourceName: " << state.SourceName << "\n"
     << indent << "Renderer: " << state.Renderer << "\n"
     << indent << "VersionString: " << state.Version << "\n"
     << indent << "Generation: " << this->Resources->Generation << "\n"
     << indent << "AllocatedBytes: " << this->GetAllocatedBytes() << "\n"
     << indent << "PeakAllocatedBytes: " << this->GetPeakAllocatedBytes() << "\n"
     << indent << "Dispatches: " << this->Resources->Dispatches << "\n";
}

void vtkComputeContext::SetSource(int source)
{
  source = std::min(std::max(source, static_cast<int>(AUTOMATIC)), static_cast<int>(EGL));
  if (source != this->Internals->State.Source)
  {
    this->Stop();
    this->Internals->State.Source = source;
    this->Modified();
  }
}

int vtkComputeContext::GetSource()
{
  return this->Internals->State.Source;
}

void vtkComputeContext::SetWindow(vtkRenderWindow* window)
{
  sm::ContextState& state = this->Internals->State;
  if (window != state.Given || (!window && state.WasGiven))
  {
    this->Stop();
    state.Given = window;
    state.WasGiven = window != nullptr;
    state.WasOpened = false;
    this->Modified();
  }
}

vtkRenderWindow* vtkComputeContext::GetWindow()
{
  return this->Internals->State.Given;
}

void vtkComputeContext::SetMaximumVersion(int major, int minor)
{
  int* maximum = this->Internals->State.MaximumVersion;
  if (maximum[0] != major || maximum[1] != minor)
  {
    this->Stop();
    maximum[0] = major;
    maximum[1] = minor;
    this->Modified();
  }
}

int vtkComputeContext::Start()
{
  const sm::ContextState& state = this->Internals->State;
  if (state.Status == READY)
  {
    return READY;
  }
  // EGL may have a GPU even if the X display has none.
  sm::OpenGLLibrary* const library = this->Internals->GetLibrary();
  if (library && !state.Given && state.Source == AUTOMATIC && library->MayHaveGPU())
  {
    this->StartOnGPU();
  }
  return state.Status == READY ? READY : this->Internals->Search(false);
}

bool vtkComputeContext::StartOnGPU()
{
  vtkInternals& internals = *this->Internals;
  if (internals.State.Status == READY)
  {
    return !this->IsSoftware();
  }
  if (internals.FoundNoGPU != this->GetMTime() && internals.Search(true) != READY)
  {
    internals.FoundNoGPU = this->GetMTime();
  }
  return internals.State.Status == READY;
}

void vtkComputeContext::Stop()
{
  vtkInternals& internals = *this->Internals;
  if (internals.Windows)
  {
    internals.Windows->Stop();
  }
  internals.State.Reason.clear();
  internals.State.Status = NOT_STARTED;
}

int vtkComputeContext::GetStatus()
{
  return this->Internals->State.Status;
}

const char* vtkComputeContext::GetStatusAsString()
{
  static const char* const names[] = { "not-started", "ready", "no-context", "no-compute", "no-doubles",
    "lost" };
  return names[this->GetStatus()];
}

std::string vtkComputeContext::GetReason()
{
  return this->Internals->State.Reason;
}

std::string vtkComputeContext::GetRenderer()
{
  return this->Internals->State.Renderer;
}

std::string vtkComputeContext::GetVersionString()
{
  return this->Internals->State.Version;
}

std::string vtkComputeContext::GetSourceName()
{
  return this->Internals->State.SourceName;
}

vtkOpenGLRenderWindow* vtkComputeContext::GetRenderWindow()
{
  return this->Internals->State.Used;
}

vtkTypeUInt64 vtkComputeContext::GetGeneration()
{
  return this->Resources->Generation;
}

bool vtkComputeContext::IsSoftware()
{
  return sm::IsSoftwareRenderer(this->Internals->State.Renderer);
}

bool vtkComputeContext::FlushesSubnormals()
{
  return this->Resources->Window && this->Resources->Window->FlushesSubnormals;
}

vtkTypeInt64 vtkComputeContext::GetMaximumStorageBlockSize()
{
  return this->Resources->MaximumStorageBlockSize;
}

int vtkComputeContext::GetStorageOffsetAlignment()
{
  return this->Resources->StorageOffsetAlignment;
}

int vtkComputeContext::GetMaximumWorkGroupCount()
{
  return std::min(this->Resources->MaximumWorkGroupCount[0], this->Resources->MaximumWorkGroupCount[1]);
}

vtkTypeInt64 vtkComputeContext::GetAllocatedBytes()
{
  const auto& window = this->Resources->Window;
  return window ? static_cast<vtkTypeInt64>(window->AllocatedBytes) : 0;
}

vtkTypeInt64 vtkComputeContext::GetPeakAllocatedBytes()
{
  const auto& window = this->Resources->Window;
  return window ? static_cast<vtkTypeInt64>(window->PeakBytes) : 0;
}

vtkTypeUInt64 vtkComputeContext::GetNumberOfDispatches()
{
  return this->Resources->Dispatches;
}

void vtkComputeContext::ResetCounters()
{
  this->Resources->Dispatches = 0;
}
