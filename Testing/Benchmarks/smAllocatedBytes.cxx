#include "smAllocatedBytes.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace
{
/// Only a program that asks counts.
std::atomic<bool> IsCounting{ false };
std::atomic<long long> Bytes{ 0 };
}

long long smtest::GetAllocatedBytes()
{
  IsCounting = true;
  return Bytes;
}

// They replace those of the standard library, in the program and in all its libraries. Where only one of a
// pair is inlined, GCC sees a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  if (IsCounting)
  {
    Bytes += static_cast<long long>(size);
  }
  if (void* memory = std::malloc(size > 0 ? size : 1))
  {
    return memory;
  }
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
