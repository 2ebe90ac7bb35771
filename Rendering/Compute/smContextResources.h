/**
 * @file smContextResources.h
 * @brief State that a compute context shares with the buffers and programs made in it; not installed
 *
 * It outlives whichever ends first. The context frees all names when it ends, so an owner of a name has to
 * compare generations only.
 */
#ifndef smContextResources_h
#define smContextResources_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <unordered_map>
#include <unordered_set>

class vtkComputeContext;

namespace sm
{
struct WindowResources;

struct ContextResources
{
  /// Null once the context object is gone.
  vtkComputeContext* Context = nullptr;
  /// 0: no GL context at present. Never used twice in the process.
  std::uint64_t Generation = 0;
  std::uint64_t Dispatches = 0;
  /// Shared with the other contexts of the window; null when there is no GL context at present.
  std::shared_ptr<WindowResources> Window;

  std::int64_t MaximumStorageBlockSize = 0;
  int StorageOffsetAlignment = 0;
  int MaximumWorkGroupCount[2] = { 0, 0 };

  /// Names of buffers with the bytes of their stores, and names of programs.
  std::unordered_map<unsigned int, std::size_t> Buffers;
  std::unordered_set<unsigned int> Programs;

  /// Called when the generation ends, by their owners' addresses: a callback may erase its own entry.
  std::map<const void*, std::function<void()>> AtEnd;

  void AddBuffer(unsigned int name, std::size_t bytes);
  void AddProgram(unsigned int name);

  /// Deletes one name; the context must be current.
  void FreeBuffer(unsigned int name);
  void FreeProgram(unsigned int name);

  /// Ends the generation. Deletes all names when `current` says that the context is current.
  void End(bool current);

  static std::uint64_t NewGeneration();
  static long GetLiveBuffers();
  static std::int64_t GetLiveBytes();
  static long GetLivePrograms();
};
}

#endif
