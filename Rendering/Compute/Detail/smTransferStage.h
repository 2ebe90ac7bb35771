/**
 * @file smTransferStage.h
 * @brief Memory of the host from which the GPU fills buffers in the order of its commands; not installed
 */
#ifndef smTransferStage_h
#define smTransferStage_h

#include <cstddef>

namespace sm
{
/**
 * A buffer that stays mapped, from which the GPU copies. With NVIDIA's driver glBufferSubData() overtakes
 * compute shaders that still read the buffer, although OpenGL executes commands in their order: the second
 * half of a work list was evaluated in place of the first. It also moves only 1.2 GB/s (H200, driver
 * 580.159.04, Documentation/Drivers.md).
 *
 * Belongs to one context, which must be current. Without GL_ARB_buffer_storage there is no memory.
 */
class TransferStage
{
public:
  /// Largest number of bytes of one upload.
  static constexpr std::size_t MaximumBytes = std::size_t{ 1 } << 24;

  /// Returns memory for an upload of so many bytes, which must be passed to Upload() before the next call;
  /// null if there is none.
  void* BeginUpload(std::size_t bytes);
  /// Copies what was written to that memory to a buffer, from `offset` on.
  void Upload(unsigned int buffer, std::size_t offset);

  /// Frees the memory, in the current context.
  void Free();

private:
  bool Map(std::size_t bytes);

  unsigned int Name = 0;
  unsigned char* Memory = nullptr;
  std::size_t Capacity = 0;
  /// The upload that was begun last. Copies may still read the memory from the beginning to its end.
  std::size_t Begin = 0, Bytes = 0;
};
}

#endif
