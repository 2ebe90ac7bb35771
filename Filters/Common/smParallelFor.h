/**
 * @file smParallelFor.h
 * @brief A loop on VTK's threads that hands exceptions to its caller; not installed
 */
#ifndef smParallelFor_h
#define smParallelFor_h

#include "Detail/smWorkerThreads.h"

#include "vtkSMPTools.h"

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

namespace sm
{
/**
 * Calls work(begin, end) for disjoint parts of [0, count) on as many threads as vtkSMPTools has, and returns
 * when all of them are done. A part has `grain` indices; see RunLoop().
 *
 * With vtkSMPTools alone an exception that leaves `work` ends the process. Here the first exception is stored
 * and rethrown in the calling thread; parts that have not begun by then are skipped, so the results of the
 * loop are incomplete.
 */
template <class F>
void ParallelFor(std::size_t count, std::size_t grain, F&& work)
{
  std::exception_ptr first;
  std::mutex mutex;
  std::atomic<bool> hasFailed{ false };
  RunLoop(count, grain,
    [&](std::size_t begin, std::size_t end)
    {
      if (hasFailed)
      {
        return;
      }
      try
      {
        work(begin, end);
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
