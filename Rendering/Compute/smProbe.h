/**
 * @file smProbe.h
 * @brief Test that a driver computes in double precision; not installed
 */
#ifndef smProbe_h
#define smProbe_h

#include <string>

class vtkComputeContext;

namespace sm
{
/// Runs one tiny dispatch in the context, which must be READY, and compares its doubles with the CPU's. On
/// failure `complaint` continues a sentence that starts with the driver's name. Not counted as a dispatch.
bool ProbeDoubles(vtkComputeContext* context, std::string& complaint);
}

#endif
