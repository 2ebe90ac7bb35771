/**
 * @file smContextResources.h
 * @brief State that a compute context shares with the buffers and programs made in it; not installed
 *
 * The object lives as long as the context or one of the owners of names. The context frees all names when it
 * ends, so an owner only has to compare generations to know if its name still exists.
 */
#ifndef smContextResources_h
#define smContextResources_h

#include "Detail/smTransferStage.h"
#include "smRenderingComputeModule.h"

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

struct SMRENDERINGCOMPUTE_EXPORT ContextResources
{
  /// The context; null after it was deleted.
  vtkComputeContext* Context = nullptr;
  /// Number of the GL context, unique in the process; 0: there is none at present.
  std::uint64_t Generation = 0;
  std::uint64_t Dispatches = 0;
  /// Shared with the other contexts of the window; null when there is no GL context at present.
  std::shared_ptr<WindowResources> Window;

  std::int64_t MaximumStorageBlockSize = 0;
  int StorageOffsetAlignment = 0;
  int MaximumWorkGroupCount[2] = { 0, 0 };
  /// True for a software renderer, which has few lanes, and whose copies are copies within the host. Tests
  /// set it to false, so that what is for a GPU is done there, too.
  bool IsSoftware = true;
  /// Made by the first transfer of the generation.
  std::unique_ptr<TransferStage> Stage;

  /// Names of buffers with the bytes of their stores, and names of programs.
  std::unordered_map<unsigned int, std::size_t> Buffers;
  std::unordered_set<unsigned int> Programs;

  /// Callbacks for the end of the generation, by the addresses of their owners. A callback may erase its own
  /// entry.
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
