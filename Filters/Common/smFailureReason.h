/**
 * @file smFailureReason.h
 * @brief Exceptions as reasons that users read, and calls that report a lack of memory instead of throwing
 */
#ifndef smFailureReason_h
#define smFailureReason_h

#include <exception>
#include <new>
#include <system_error>

namespace sm
{
/// The reason for a std::bad_alloc.
constexpr const char* InsufficientMemory = "there is not enough memory";

/// Returns true if there was no memory for the stack of a thread, or no more threads are allowed.
inline bool IsLackOfThreads(const std::system_error& failure)
{
  return failure.code() == std::errc::resource_unavailable_try_again;
}

/// Runs `work`, which fails only for lack of memory; returns false if it throws.
template <typename Work>
bool HasMemoryFor(const Work& work) noexcept
{
  try
  {
    work();
    return true;
  }
  catch (...)
  {
    return false;
  }
}

/// Returns the reason for an exception of any type, valid as long as the exception lives.
inline const char* GetReason(const std::exception_ptr& failure) noexcept
{
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const std::bad_alloc&)
  {
    return InsufficientMemory;
  }
  catch (const std::system_error& error)
  {
    return IsLackOfThreads(error) ? InsufficientMemory : error.what();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  catch (...)
  {
    return "an exception of an unknown type was thrown";
  }
}
}

#endif
