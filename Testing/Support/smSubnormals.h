/**
 * @file smSubnormals.h
 * @brief Tests of shaders that need a driver with subnormal numbers
 */
#ifndef smSubnormals_h
#define smSubnormals_h

#include "smTesting.h"

#include "vtkComputeContext.h"
#include "vtkNew.h"

#include <cstdio>

namespace smtest
{
/// Returns true, and prints the reason, if the driver takes subnormal numbers for 0, so that variants and
/// gradients are left to the CPU.
inline bool FlushesSubnormals()
{
  vtkNew<vtkComputeContext> context;
  const bool isReady = context->Start() == vtkComputeContext::READY;
  if (isReady && context->FlushesSubnormals())
  {
    std::printf("SKIP %s takes subnormal numbers for 0\n", context->GetRenderer().c_str());
    return true;
  }
  return false;
}
}

#endif
