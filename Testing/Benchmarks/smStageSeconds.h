/**
 * @file smStageSeconds.h
 * @brief Seconds of the processor that our stages take, from a STEP file to its mass properties on the CPU
 * backend
 */
#ifndef smStageSeconds_h
#define smStageSeconds_h

#include "smJson.h"

#include <string>
#include <vector>

namespace smtest
{
/// The stages, in their order.
const std::vector<std::string>& GetStageNames();

/**
 * Reads a file and computes its mass properties at a tolerance of 1e-9, with vtkSMPTools' backend as it is,
 * the integrals `repeats` times. `seconds` gets a number per stage, for the integrals the minimum; `result`
 * the faces of all parts, the points and triangles of their meshes, the status, volume and centre with their
 * bounds, and evaluations. All are the processor's seconds, of all threads together: in a program with this
 * function vtkTimerLog::GetUniversalTime() is the processor's time.
 */
void MeasureStages(const std::string& path, int repeats, sm::Json& seconds, sm::Json& result);
}

#endif
