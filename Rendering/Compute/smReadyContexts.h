/**
 * @file smReadyContexts.h
 * @brief Stops contexts when the process exits; not installed
 *
 * When the process exits, the contexts that are READY are stopped before the OpenGL driver is unloaded. Their
 * owners may be destroyed later, as ParaView's session is after Python's sys.exit(), and freeing a context
 * then would be an X error, which ends the process. Only contexts that the exiting thread started are
 * stopped, none if exit() was called inside a ContextScope, and none in a forked process.
 */
#ifndef smReadyContexts_h
#define smReadyContexts_h

#include "smRenderingComputeModule.h"

class vtkComputeContext;

namespace sm
{
/// Registers a context; call it from the thread that uses the context. Thread safe.
SMRENDERINGCOMPUTE_EXPORT void AddReadyContext(vtkComputeContext* context);
/// Removes a context that is not READY any more. Thread safe.
SMRENDERINGCOMPUTE_EXPORT void RemoveReadyContext(vtkComputeContext* context);
}

#endif
