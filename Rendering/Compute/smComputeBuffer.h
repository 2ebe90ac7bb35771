/**
 * @file smComputeBuffer.h
 * @brief A shader storage buffer that frees itself in its own context
 */
#ifndef smComputeBuffer_h
#define smComputeBuffer_h

#include "smRenderingComputeModule.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

class vtkComputeContext;

namespace sm
{
struct ContextResources;

/**
 * Owns one GL buffer. The context must have been started. Every method except Bind() may be called outside a
 * ContextScope (it enters one); inside a scope is faster. A method that fails returns false, sets GetError(),
 * and leaves the buffer unchanged; Allocate() leaves it empty.
 *
 * When the context ended since the buffer was filled, the content is gone: GetSize() is 0, IsLost() is true
 * until the next Allocate() or Upload(), which makes a new store in the context's present generation.
 */
class SMRENDERINGCOMPUTE_EXPORT ComputeBuffer
{
public:
  /** A buffer of no size in no context; every operation fails. */
  ComputeBuffer();
  explicit ComputeBuffer(vtkComputeContext* context);
  ~ComputeBuffer();
  ComputeBuffer(ComputeBuffer&& other) noexcept;
  ComputeBuffer& operator=(ComputeBuffer&& other) noexcept;
  ComputeBuffer(const ComputeBuffer&) = delete;
  ComputeBuffer& operator=(const ComputeBuffer&) = delete;

  /**
   * Makes the size `bytes`; the content is undefined afterwards. A store that is large enough is kept, until
   * the last UsesBeforeShrinking calls all needed less than a quarter of it: it is then replaced by one of
   * the largest size they needed. So a single small use between large ones does not release the store.
   */
  bool Allocate(std::size_t bytes);
  static constexpr int UsesBeforeShrinking = 8;

  /** Copies from the host. With offset 0 the buffer grows when it is smaller; else the range must be inside.
   */
  bool Upload(const void* data, std::size_t bytes, std::size_t offset = 0);

  /** Makes the size that of `values` and copies them. */
  template <typename T>
  bool Upload(const std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values go to the GPU");
    return this->Allocate(values.size() * sizeof(T)) &&
      this->Upload(values.data(), values.size() * sizeof(T));
  }

  /** Makes the size that of `count` values, which fill(values) writes, from the first to the last and without
   * reading them. */
  template <typename T, typename FillFunction>
  bool Fill(std::size_t count, const FillFunction& fill)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values go to the GPU");
    if (!this->Allocate(count * sizeof(T)))
    {
      return false;
    }
    if (void* memory = this->BeginStaging(count * sizeof(T)))
    {
      fill(static_cast<T*>(memory));
      return this->EndStaging();
    }
    // Uninitialized, so that the threads of `fill` share the cost of new pages.
    const std::unique_ptr<T[]> values(new T[count]);
    fill(values.get());
    return this->Upload(values.get(), count * sizeof(T));
  }

  /** Copies to the host; waits for the dispatches that write it. The range must be inside. */
  bool Read(void* data, std::size_t bytes, std::size_t offset = 0);

  /** Makes every byte zero. */
  bool Clear();

  /** Binds [offset, offset + bytes) to a shader storage binding point; bytes 0: up to the end. Inside a
   * ContextScope only. The offset must be a multiple of vtkComputeContext::GetStorageOffsetAlignment() and
   * the range at most GetMaximumStorageBlockSize(). A buffer of size 0 binds a small valid range. */
  bool Bind(unsigned int binding, std::size_t offset = 0, std::size_t bytes = 0);

  /** Returns the size in bytes of the last Allocate() or Upload(); 0 if the context has ended since. */
  std::size_t GetSize() const;

  /** Returns the size of the store in bytes, which may exceed GetSize(); 0 if the context has ended since. */
  std::size_t GetCapacity() const;

  /** Returns true if the store was made in a context that has ended. */
  bool IsLost() const;

  /** Frees the store; the buffer can be used again. */
  void Free();

  /** Returns the reason of the last failure. */
  const std::string& GetError() const { return this->Error; }

  ///@{
  /** GL buffers, and bytes of their stores, that exist in the process. Thread safe. */
  static long GetLiveCount();
  static std::int64_t GetLiveBytes();
  ///@}

private:
  bool Fail(const std::string& what);
  /// Returns mapped memory for a content of so many bytes, inside a ContextScope and if the driver's own
  /// copies are slow; else null.
  void* BeginStaging(std::size_t bytes);
  bool EndStaging();
  bool Create(std::size_t bytes);
  std::size_t ChooseCapacity(std::size_t bytes);
  /// Runs copy(offset, bytes) in the context, if the range is inside and not empty.
  template <typename Copy>
  bool Transfer(const char* what, std::size_t bytes, std::size_t offset, const Copy& copy);

  std::shared_ptr<ContextResources> Resources;
  std::uint64_t Generation = 0;
  unsigned int Name = 0;
  std::size_t Size = 0;
  std::size_t Capacity = 0;
  // Calls of Allocate() in a row that needed less than a quarter of the store, and the largest of these
  // needs.
  int SmallUses = 0;
  std::size_t MaxSmallUse = 0;
  std::string Error;
};
}

#endif
