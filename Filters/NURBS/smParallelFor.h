/**
 * @file smParallelFor.h
 * @brief A loop on VTK's threads that hands exceptions to its caller; not installed
 */
#ifndef smParallelFor_h
#define smParallelFor_h

#include "vtkSMPTools.h"

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

namespace sm
{
/**
 * Calls work(begin, end) for disjoint parts of [0, count) on the threads of vtkSMPTools, and returns when all of them are done. A
 * part has about `grain` indices; 0 leaves the choice to VTK.
 *
 * With vtkSMPTools alone an exception that leaves `work` ends the process. Here the first exception is stored and rethrown in the calling
 * thread; parts that have not begun by then are skipped, so the results of the loop are incomplete.
 */
template <class F>
void ParallelFor(std::size_t count, std::size_t grain, F&& work)
{
  std::exception_ptr first;
  std::mutex mutex;
  std::atomic<bool> hasFailed{ false };
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), static_cast<vtkIdType>(grain),
    [&](vtkIdType begin, vtkIdType end)
    {
      if (hasFailed)
      {
        return;
      }
      try
      {
        work(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!hasFailed)
        {
          first = std::current_exception();
          hasFailed = true;
        }
      }
    });
  if (first)
  {
    std::rethrow_exception(first);
  }
}
}

#endif
