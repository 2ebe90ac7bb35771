/**
 * @file smProcessResources.h
 * @brief Resources of the process: memory, threads, open files. Linux with glibc
 */
#ifndef smProcessResources_h
#define smProcessResources_h

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <malloc.h>
#include <unistd.h>

namespace smtest
{
struct ProcessResources
{
  /// Bytes that malloc has given out and not got back; to the byte, but blind to what others map (a driver's
  /// compiled shaders).
  double Heap = 0.0;
  /// Bytes in memory: everything, in pages, and what malloc keeps for later.
  double Resident = 0.0;
  long Threads = 0;
  long Files = 0;
};

inline ProcessResources GetProcessResources()
{
  ProcessResources now;
  // Free pages of the heap are not memory in use.
  malloc_trim(0);
  const struct mallinfo2 heap = mallinfo2();
  now.Heap = static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
  std::size_t total = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  now.Resident = static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const auto count = [](const char* folder)
  {
    const std::filesystem::directory_iterator entries(folder);
    return static_cast<long>(std::distance(begin(entries), end(entries)));
  };
  now.Threads = count("/proc/self/task");
  now.Files = count("/proc/self/fd");
  return now;
}
}

#endif
