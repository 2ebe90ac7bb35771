/**
 * @file smWindowResources.h
 * @brief State that all compute contexts of one window share, because they share its OpenGL context
 */
#ifndef smWindowResources_h
#define smWindowResources_h

#include "smRenderingComputeModule.h"

#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>

class vtkOpenGLRenderWindow;

namespace sm
{
/**
 * Owned by all READY vtkComputeContexts of the window together, and deleted with the last of them. Used by
 * the thread that uses the OpenGL context; only Get() is thread safe.
 */
struct SMRENDERINGCOMPUTE_EXPORT WindowResources
{
  explicit WindowResources(vtkOpenGLRenderWindow* window);
  ~WindowResources();
  WindowResources(const WindowResources&) = delete;
  WindowResources& operator=(const WindowResources&) = delete;

  /// Returns the resources of `window`, which are made if there are none.
  static std::shared_ptr<WindowResources> Get(vtkOpenGLRenderWindow* window);

  void AddBytes(std::size_t bytes);

  /// True for a window that a compute context made for itself.
  bool IsOwn = false;
  /// Number of open ContextScopes of the window's contexts.
  int ScopeDepth = 0;
  /// True after the test of the driver's double precision has passed, which is run once per OpenGL context.
  bool HasRightDoubles = false;
  /// True if that test found that subnormal numbers are 0.
  bool FlushesSubnormals = false;
  /// Bytes of the stores of all buffers: now, and the largest value so far.
  std::size_t AllocatedBytes = 0;
  std::size_t PeakBytes = 0;

  /// Caches of other modules, by name, for data on the GPU that several users of one window share. Each cache
  /// is owned by its users.
  std::unordered_map<std::string, std::weak_ptr<void>> Caches;

private:
  vtkOpenGLRenderWindow* Window;
};
}

#endif
