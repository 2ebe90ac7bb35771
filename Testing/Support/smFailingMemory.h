/**
 * @file smFailingMemory.h
 * @brief operator new that counts allocations and lets one of them fail, for programs that test a shortage of
 * memory
 *
 * Replaces the standard library's in all libraries of the program: include it in one source file of a
 * program.
 */
#ifndef smFailingMemory_h
#define smFailingMemory_h

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <set>

namespace smtest
{
/// Allocations by operator new while `IsCounting`; the one with the number `Failing` fails. 0: none does.
struct FailingMemory
{
  /// The first allocation of so many bytes ends the counting, unless it fails: it shows that there is memory
  /// for VTK's containers, which do not survive an operator new that fails in them.
  std::size_t LastSize = SIZE_MAX;
  std::atomic<bool> IsCounting{ false };
  std::atomic<long> Allocations{ 0 };
  std::atomic<long> Failing{ 0 };

  void Begin(long failing)
  {
    this->Allocations = 0;
    this->Failing = failing;
    this->IsCounting = true;
  }
  /// Ends the counting; returns the number of allocations since Begin().
  long End()
  {
    this->IsCounting = false;
    return this->Allocations;
  }
};

inline FailingMemory failingMemory;

/// Numbers of allocations: the first, the last, and some evenly spread ones between them.
inline std::set<long> ChooseAllocations(long count, long ends, long between)
{
  std::set<long> chosen;
  for (long i = 1; i <= std::min(count, ends); ++i)
  {
    chosen.insert(i);
    chosen.insert(count + 1 - i);
  }
  for (long i = 1; i <= between; ++i)
  {
    chosen.insert(std::max(1L, i * count / (between + 1)));
  }
  return chosen;
}

inline void* Allocate(std::size_t size)
{
  const bool isFailing = failingMemory.IsCounting && ++failingMemory.Allocations == failingMemory.Failing;
  if (!isFailing && size >= failingMemory.LastSize)
  {
    failingMemory.End();
  }
  void* memory = isFailing ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}
}

void* operator new(std::size_t size)
{
  return smtest::Allocate(size);
}
void* operator new[](std::size_t size)
{
  return smtest::Allocate(size);
}
// Inlined alone, without the operator new above, they are a mismatched pair in GCC's eyes.
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

#endif
