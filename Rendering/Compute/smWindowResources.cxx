#include "smWindowResources.h"

#include <algorithm>
#include <mutex>

namespace sm
{
namespace
{
struct Registry
{
  std::mutex Mutex;
  std::unordered_map<vtkOpenGLRenderWindow*, std::weak_ptr<WindowResources>> Windows;
};

Registry& GetRegistry()
{
  static auto* registry = new Registry; // outlives all statics
  return *registry;
}
}

WindowResources::WindowResources(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

WindowResources::~WindowResources()
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  const auto found = registry.Windows.find(this->Window);
  // Another window may have been made at the same address meanwhile, with resources of its own.
  if (found != registry.Windows.end() && found->second.expired())
  {
    registry.Windows.erase(found);
  }
}

std::shared_ptr<WindowResources> WindowResources::Get(vtkOpenGLRenderWindow* window)
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  std::weak_ptr<WindowResources>& known = registry.Windows[window];
  std::shared_ptr<WindowResources> resources = known.lock();
  if (!resources)
  {
    resources = std::make_shared<WindowResources>(window);
    known = resources;
  }
  return resources;
}

void WindowResources::AddBytes(std::size_t bytes)
{
  this->AllocatedBytes += bytes;
  this->PeakBytes = std::max(this->PeakBytes, this->AllocatedBytes);
}
}
