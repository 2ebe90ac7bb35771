#include "smReadyContexts.h"

#include "smOpenGLLibrary.h"
#include "vtkComputeContext.h"

#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace sm
{
namespace
{
struct ReadyContexts
{
  std::mutex Mutex;
  /// The contexts, each with the thread that started it.
  std::map<vtkComputeContext*, std::thread::id> Contexts;
  bool IsRegistered = false;
  pid_t Process = 0;
};

ReadyContexts& GetReadyContexts()
{
  static auto* ready = new ReadyContexts; // outlives all statics
  return *ready;
}

void StopContexts()
{
  ReadyContexts& ready = GetReadyContexts();
  std::map<vtkComputeContext*, std::thread::id> contexts;
  {
    const std::lock_guard<std::mutex> lock(ready.Mutex);
    if (ready.Process != getpid())
    {
      return; // this process is a fork, which shares the connection to the display
    }
    contexts = ready.Contexts;
  }
  for (const auto& [context, thread] : contexts)
  {
    // Stopping one context may have deleted another one.
    bool isReady = false;
    {
      const std::lock_guard<std::mutex> lock(ready.Mutex);
      isReady = ready.Contexts.count(context) != 0;
    }
    // A context of another thread may be in use.
    if (isReady && thread == std::this_thread::get_id() && GetOpenScopes() == 0)
    {
      context->Stop();
    }
  }
}
}

void AddReadyContext(vtkComputeContext* context)
{
  ReadyContexts& ready = GetReadyContexts();
  const std::lock_guard<std::mutex> lock(ready.Mutex);
  ready.Contexts[context] = std::this_thread::get_id();
  if (!ready.IsRegistered)
  {
    // Functions that the driver has registered by now are called after this one.
    ready.IsRegistered = std::atexit(StopContexts) == 0;
    ready.Process = getpid();
  }
}

void RemoveReadyContext(vtkComputeContext* context)
{
  ReadyContexts& ready = GetReadyContexts();
  const std::lock_guard<std::mutex> lock(ready.Mutex);
  ready.Contexts.erase(context);
}
}
