/**
 * @file smOCCTFailure.h
 * @brief Converts exceptions of OpenCASCADE to sentences
 */
#ifndef smOCCTFailure_h
#define smOCCTFailure_h

#include "smCatchFailure.h"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <new>
#include <string>

namespace sm
{
/// Runs `work` as CatchFailure() does, also where OpenCASCADE throws.
template <class Work>
std::string CatchKernelFailure(const Work& work)
{
  std::string reason;
  const std::string other = CatchFailure(
    [&]
    {
      try
      {
        work();
      }
      catch (const Standard_OutOfMemory&)
      {
        throw std::bad_alloc();
      }
      catch (const Standard_Failure& failure)
      {
        const char* text = failure.GetMessageString();
        reason = std::string("OpenCASCADE raised ") + failure.DynamicType()->Name() +
          (text && *text ? ": " : "") + (text ? text : "");
      }
    });
  return reason.empty() ? other : reason;
}
}

#endif
