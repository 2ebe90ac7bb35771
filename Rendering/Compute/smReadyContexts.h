/**
 * @file smReadyContexts.h
 * @brief Stops contexts when the process exits
 *
 * When the process exits, the contexts that are READY are stopped before the OpenGL driver ends: who still owns one then, as
 * ParaView's session does after Python's sys.exit(), may end later, and an X error would end the process. Stopped are those
 * that the exiting thread started, unless exit() was called in the midst of a dispatch; not those that a fork inherited.
 */
#ifndef smReadyContexts_h
#define smReadyContexts_h

class vtkComputeContext;

namespace sm
{
/// From the thread that uses the context. Thread safe.
void AddReadyContext(vtkComputeContext* context);
/// Once it is not READY any more. Thread safe.
void RemoveReadyContext(vtkComputeContext* context);
}

#endif
