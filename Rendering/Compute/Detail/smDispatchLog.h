/**
 * @file smDispatchLog.h
 * @brief A file that lists which compute programs ran, and on which driver; not installed
 */
#ifndef smDispatchLog_h
#define smDispatchLog_h

#include <string>

class vtkComputeContext;

namespace sm
{
/// Appends "PROGRAM<tab>RENDERER<tab>VERSION" to the file that the environment variable
/// SOLIDMOMENTS_DISPATCH_LOG names, once for each program and renderer of the process. Leaves out the
/// start-up probe. Does nothing without the variable. Several processes may share one file: a line is written
/// by one call. A file that cannot be written is ignored. Thread safe.
void LogDispatch(vtkComputeContext* context, const std::string& program);
}

#endif
