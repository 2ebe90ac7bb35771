/**
 * @file smParallelFor.h
 * @brief A loop on several threads that hands exceptions to its caller; not installed
 */
#ifndef smParallelFor_h
#define smParallelFor_h

#include "smFiltersNURBSModule.h"

#include "vtkSMPTools.h" // for the number of threads, which some grains depend on

#include <cstddef>
#include <functional>

namespace sm
{
/**
 * Calls work(begin, end) for disjoint parts of [0, count), and returns when all of them are done. A part has about `grain` indices; 0
 * leaves the choice to the loop. The first exception is rethrown in the calling thread; parts that have not begun by then are skipped, so
 * that the results of the loop are incomplete.
 *
 * The application chooses backend and number of threads by vtkSMPTools. With STDThread, VTK up to 9.2 starts and ends its threads in
 * every loop, which takes longer than the work of a small edit; here they wait for the next loop, and the calling thread
 * works with them. A loop within a loop, and one that begins during another thread's, runs in its calling thread. Other
 * backends run their own loop.
 */
SMFILTERSNURBS_EXPORT void ParallelFor(
  std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work);
}

#endif
