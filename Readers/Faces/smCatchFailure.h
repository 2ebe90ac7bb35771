/**
 * @file smCatchFailure.h
 * @brief Converts exceptions to sentences
 */
#ifndef smCatchFailure_h
#define smCatchFailure_h

#include "smFailureReason.h"

#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace sm
{
/**
 * Runs `work`. Returns the reason for an exception, or an empty string. A lack of memory is not a property of
 * the shape that is processed: std::bad_alloc is thrown, also if a thread could not be started.
 */
template <class Work>
std::string CatchFailure(const Work& work)
{
  try
  {
    work();
    return {};
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::system_error& failure)
  {
    if (IsLackOfThreads(failure))
    {
      throw std::bad_alloc();
    }
    return failure.what();
  }
  catch (const std::exception& failure)
  {
    return failure.what();
  }
}

/// The same for methods that VTK calls, which must not throw: a lack of memory, and an exception of any other
/// type, is a reason, too.
template <class Work>
std::string CatchEverything(const Work& work)
{
  try
  {
    return CatchFailure(work);
  }
  catch (const std::bad_alloc&)
  {
    return InsufficientMemory;
  }
  catch (...)
  {
    return "an exception of an unknown type was thrown";
  }
}
}

#endif
