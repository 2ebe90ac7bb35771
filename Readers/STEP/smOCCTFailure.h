/**
 * @file smOCCTFailure.h
 * @brief Exceptions of OpenCASCADE and of our own as sentences
 */
#ifndef smOCCTFailure_h
#define smOCCTFailure_h

#include "smFailureReason.h"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace sm
{
/**
 * Runs `work`. Returns why it threw an exception, an empty string when it threw none. A lack of memory is no property of the shape in
 * hand and goes on to the caller, as std::bad_alloc also where OpenCASCADE raised Standard_OutOfMemory, or a thread could not be started.
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
  catch (const Standard_OutOfMemory&)
  {
    throw std::bad_alloc();
  }
  catch (const std::system_error& failure)
  {
    if (IsLackOfThreads(failure))
    {
      throw std::bad_alloc();
    }
    return failure.what();
  }
  catch (const Standard_Failure& failure)
  {
    const char* text = failure.GetMessageString();
    return std::string("OpenCASCADE raised ") + failure.DynamicType()->Name() + (text && *text ? ": " : "") +
      (text ? text : "");
  }
  catch (const std::exception& failure)
  {
    return failure.what();
  }
}

/// The same at the edge to VTK, which no exception may cross: a lack of memory is a reason here, and so is an exception of any other type.
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
