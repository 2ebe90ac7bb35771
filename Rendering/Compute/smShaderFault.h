/**
 * @file smShaderFault.h
 * @brief Faults of shaders on purpose, for tests of what guards against them; not installed
 */
#ifndef smShaderFault_h
#define smShaderFault_h

#include "smRenderingComputeModule.h"

#include <set>
#include <string>

namespace sm
{
/// Names of the shaders (ShaderSource::GetName()) that are assembled, from now on, with arrays that hold
/// floats instead of doubles, as NVIDIA's compiler makes them. None is by default. Not thread safe.
SMRENDERINGCOMPUTE_EXPORT std::set<std::string>& GetFaultyShaders();

/// The factor by which every shader, also on the CPU, multiplies its samples in the runs that follow, which
/// proves that results come from them. 1 by default. Not thread safe.
SMRENDERINGCOMPUTE_EXPORT double& GetSampleFactor();
}

#endif
