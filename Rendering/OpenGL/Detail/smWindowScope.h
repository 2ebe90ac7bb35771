/**
 * @file smWindowScope.h
 * @brief The state that a ContextScope saves and restores; not installed
 */
#ifndef smWindowScope_h
#define smWindowScope_h

#include "smOpenGLLibrary.h"

namespace sm
{
/// See OpenGLLibrary::EnterScope().
std::unique_ptr<WindowScope> EnterWindowScope(vtkComputeContext* context);
}

#endif
