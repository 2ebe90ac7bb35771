/**
 * @file smUninitializedVector.h
 * @brief A vector whose new elements are not set before they are written; not installed
 */
#ifndef smUninitializedVector_h
#define smUninitializedVector_h

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace sm
{
/// Leaves elements of trivial types uninitialized that are made without a value.
template <class T>
class UninitializedAllocator : public std::allocator<T>
{
public:
  template <class U>
  struct rebind
  {
    using other = UninitializedAllocator<U>;
  };

  UninitializedAllocator() = default;
  template <class U>
  explicit UninitializedAllocator(const UninitializedAllocator<U>&)
  {
  }

  template <class U>
  void construct(U* place)
  {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// resize() touches no memory of trivial types, so that the threads that write large arrays share the cost
/// of new pages.
template <class T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;
}

#endif
