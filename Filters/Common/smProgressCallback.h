/**
 * @file smProgressCallback.h
 * @brief Callbacks by which long computations report progress and learn that they should stop
 */
#ifndef smProgressCallback_h
#define smProgressCallback_h

#include <functional>

namespace sm
{
/// Gets the fraction of the work that is done, from 0 to 1; returns false to stop the work. An empty one
/// means: never stop.
using ProgressCallback = std::function<bool(double)>;
/// Returns false to stop the work.
using ContinueCallback = std::function<bool()>;
}

#endif
