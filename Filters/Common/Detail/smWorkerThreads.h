/**
 * @file smWorkerThreads.h
 * @brief Threads that wait for loops; not installed
 *
 * The backend STDThread of vtkSMPTools starts and joins its threads in every loop (VTK 9.1 and 9.2), which
 * takes a millisecond with 16 threads: as long as the integration of a small part. TBB, the default of
 * Debian's VTK 9.6, waits for ever when memory is exhausted (TBB 2023.1), and has no threads after fork().
 */
#ifndef smWorkerThreads_h
#define smWorkerThreads_h

#include "smFiltersCommonModule.h"

#include <cstddef>
#include <functional>

namespace sm
{
/// Part of a loop: the indices [begin, end).
using LoopPart = std::function<void(std::size_t begin, std::size_t end)>;

/**
 * Calls part(begin, end) for the parts of [0, count) with `grain` indices each (0: a quarter of each
 * thread's share), on as many threads as vtkSMPTools would use; the backend Sequential has one. Within a
 * part, and while another thread runs a loop, all of it is one part in the calling thread. `part` must not
 * throw. The threads belong to the process that started them: after fork() the child starts its own.
 */
SMFILTERSCOMMON_EXPORT void RunLoop(std::size_t count, std::size_t grain, const LoopPart& part);
}

#endif
