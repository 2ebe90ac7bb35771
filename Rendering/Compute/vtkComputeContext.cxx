#include "vtkComputeContext.h"

#include "Detail/smCurrentContext.h"
#include "Detail/vtkComputeContextInternals.h"
#include "smContextResources.h"
#include "smWindowResources.h"
#include "vtkEGLSurfacelessRenderWindow.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkComputeContext);

vtkComputeContext::vtkComputeContext()
  : Resources(std::make_shared<sm::ContextResources>())
  , Internals(new vtkInternals(this))
{
  this->Resources->Context = this;
}

vtkComputeContext::~vtkComputeContext()
{
  this->Stop();
  this->Resources->Context = nullptr;
}

void vtkComputeContext::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << this->Source << "\n"
     << indent << "Status: " << this->GetStatusAsString() << "\n"
     << indent << "Reason: " << this->Internals->Reason << "\n"
     << indent << "SourceName: " << this->Internals->SourceName << "\n"
     << indent << "Renderer: " << this->Internals->Renderer << "\n"
     << indent << "VersionString: " << this->Internals->Version << "\n"
     << indent << "Generation: " << this->Resources->Generation << "\n"
     << indent << "AllocatedBytes: " << this->GetAllocatedBytes() << "\n"
     << indent << "PeakAllocatedBytes: " << this->GetPeakAllocatedBytes() << "\n"
     << indent << "Dispatches: " << this->Resources->Dispatches << "\n";
}

void vtkComputeContext::SetSource(int source)
{
  source = std::min(std::max(source, static_cast<int>(AUTOMATIC)), static_cast<int>(EGL));
  if (source != this->Source)
  {
    this->Stop();
    this->Source = source;
    this->Modified();
  }
}

void vtkComputeContext::SetWindow(vtkRenderWindow* window)
{
  if (window != this->Internals->Given || (!window && this->Internals->WasGiven))
  {
    this->Stop();
    this->Internals->Given = window;
    this->Internals->WasGiven = window != nullptr;
    this->Internals->WasOpened = false;
    this->Modified();
  }
}

vtkRenderWindow* vtkComputeContext::GetWindow()
{
  return this->Internals->Given;
}

void vtkComputeContext::SetMaximumVersion(int major, int minor)
{
  int* maximum = this->Internals->MaximumVersion;
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
  // EGL may have a GPU even if the X display has none.
  if (this->Status != READY && !this->Internals->Given && this->Source == AUTOMATIC &&
    vtkEGLSurfacelessRenderWindow::MayHaveGPU())
  {
    this->StartOnGPU();
  }
  return this->Status == READY ? READY : this->Internals->Search(false);
}

bool vtkComputeContext::StartOnGPU()
{
  vtkInternals& internals = *this->Internals;
  if (this->Status == READY)
  {
    return !this->IsSoftware();
  }
  if (internals.FoundNoGPU != this->GetMTime() && internals.Search(true) != READY)
  {
    internals.FoundNoGPU = this->GetMTime();
  }
  return this->Status == READY;
}

void vtkComputeContext::Stop()
{
  vtkInternals& internals = *this->Internals;
  if (internals.Own && internals.Own->IsCurrent())
  {
    // After rendering with our own window its context may be current; it is released, so that no scope
    // restores it after its end.
    internals.Own->ReleaseCurrent();
  }
  const sm::CurrentContext::Guard guard;
  if (internals.Used)
  {
    internals.End(sm::MakeWindowCurrent(internals.Used), NOT_STARTED);
  }
  internals.Detach();
  internals.Own = nullptr;
  internals.Reason.clear();
  this->Status = NOT_STARTED;
}

const char* vtkComputeContext::GetStatusAsString()
{
  static const char* const names[] = { "not-started", "ready", "no-context", "no-compute", "no-doubles",
    "lost" };
  return names[this->Status];
}

std::string vtkComputeContext::GetReason()
{
  return this->Internals->Reason;
}

std::string vtkComputeContext::GetRenderer()
{
  return this->Internals->Renderer;
}

std::string vtkComputeContext::GetVersionString()
{
  return this->Internals->Version;
}

std::string vtkComputeContext::GetSourceName()
{
  return this->Internals->SourceName;
}

vtkOpenGLRenderWindow* vtkComputeContext::GetRenderWindow()
{
  return this->Internals->Used;
}

vtkTypeUInt64 vtkComputeContext::GetGeneration()
{
  return this->Resources->Generation;
}

bool vtkComputeContext::IsSoftware()
{
  return vtkEGLSurfacelessRenderWindow::IsSoftware(this->Internals->Renderer);
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
