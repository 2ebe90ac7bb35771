/**
 * @file smTransferStage.h
 * @brief Memory of the host from which buffers are filled without the driver's own copies; not installed
 */
#ifndef smTransferStage_h
#define smTransferStage_h

#include <cstddef>

namespace sm
{
struct ContextResources;

/**
 * A buffer that stays mapped, from which the GPU copies: glBufferSubData() moves 1.2 GB/s on an NVIDIA H200 (Documentation/Drivers.md). Memory
 * for it takes the time of copying a third of it, so that it is made for large uploads only.
 *
 * Belongs to one context, which must be current; the context's end frees it. Without GL_ARB_buffer_storage there is no memory.
 */
class TransferStage
{
public:
  ///@{
  /// Limits of the bytes of one upload: smaller ones are as fast without it.
  static constexpr std::size_t MinimumBytes = std::size_t{ 1 } << 19;
  static constexpr std::size_t MaximumBytes = std::size_t{ 1 } << 24;
  ///@}

  explicit TransferStage(ContextResources& resources)
    : Resources(resources)
  {
  }

  /// Returns memory for an upload of so many bytes, which must be passed to Upload() before the next call; null if there is none.
  void* BeginUpload(std::size_t bytes);
  /// Copies what was written to that memory to a buffer, from `offset` on.
  void Upload(unsigned int buffer, std::size_t offset);

private:
  bool Map(std::size_t bytes);

  ContextResources& Resources;
  unsigned int Name = 0;
  unsigned char* Memory = nullptr;
  std::size_t Capacity = 0;
  /// The upload that was begun last. Memory from the beginning to its end may still be read by copies.
  std::size_t Begin = 0, Bytes = 0;
};
}

#endif
