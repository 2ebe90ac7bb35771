/**
 * @file smShaderFault.h
 * @brief A fault of drivers on purpose, for tests of what guards against it; not installed
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
}

#endif
