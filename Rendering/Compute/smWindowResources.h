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
 * Held by every READY vtkComputeContext of the window, and gone with the last of them. Used by the thread that uses the
 * OpenGL context; only Get() is thread safe.
 */
struct SMRENDERINGCOMPUTE_EXPORT WindowResources
{
  explicit WindowResources(vtkOpenGLRenderWindow* window);
  ~WindowResources();
  WindowResources(const WindowResources&) = delete;
  WindowResources& operator=(const WindowResources&) = delete;

  /// The resources of `window`; made when nobody holds any.
  static std::shared_ptr<WindowResources> Get(vtkOpenGLRenderWindow* window);

  void AddBytes(std::size_t bytes);

  /// Open ContextScopes of the window's contexts.
  int ScopeDepth = 0;
  /// Set once the driver's arithmetic in double precision was found right: it is tried once per OpenGL context.
  bool HasRightDoubles = false;
  /// Bytes of the stores of all buffers now, and the most at a time.
  std::size_t AllocatedBytes = 0;
  std::size_t PeakBytes = 0;

  /// Caches of other modules, by name: what several users of one window keep on the GPU together. Each is owned by its users.
  std::unordered_map<std::string, std::weak_ptr<void>> Caches;

private:
  vtkOpenGLRenderWindow* Window;
};
}

#endif
