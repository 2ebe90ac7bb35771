/**
 * @file smFailureReason.h
 * @brief Reasons for exceptions, as users read them
 */
#ifndef smFailureReason_h
#define smFailureReason_h

#include <exception>
#include <new>

namespace sm
{
/// The reason for a std::bad_alloc.
constexpr const char* InsufficientMemory = "there is not enough memory";

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
