/**
 * @file smBackendComparison.h
 * @brief The CPU and OpenGL compute the same
 */
#ifndef smBackendComparison_h
#define smBackendComparison_h

#include "smTestPipeline.h"

namespace smtest
{
/// Runs the file of the reader on both: values agree within the sum of both bounds, and to `relative` where
/// it is not 0. `asDevice`: by the ways that are for a GPU, also where OpenGL is a software renderer.
void CompareBackends(vtkSTEPReader* reader, double relative, bool asDevice = false);
}

#endif
